//! The convergence test of iterations, in each lane by itself: [`ConvergenceTest`].

use lie_poisson::{Mask, Real};

/// The bound on the expected next change, as a multiple of the size of the stage derivatives. If the expectation is
/// below it, the current change is the last one.
///
/// The expectation assumes that the observed ratios continue. The remaining error has the same sign in every step. It
/// would become visible in runs of 10⁸ compensated steps, but refinement removes it there.
const EXPECTED: f64 = f64::EPSILON / 32.0;

/// The multiple of the size of the stage derivatives below which a change is none. No later change matters, although
/// changes may go on decreasing down to the least positive number.
const NOTHING: f64 = f64::EPSILON * f64::EPSILON;

/// The multiple of the size of the stage derivatives below which ratios of changes are noise.
///
/// They come from round-off and say nothing about the rate of convergence.
const NOISE: f64 = 4.0 * f64::EPSILON;

/// The multiple of the size of the stage derivatives below which a growing change is at the floor at once: a few
/// roundings.
const FEW_ROUNDINGS: f64 = 8.0 * f64::EPSILON;

/// The round-off of evaluating a vector field, relative to its size, with room for cancellation in it.
pub(crate) const ROUND_OFF: f64 = 1024.0 * f64::EPSILON;

/// The multiple of the size of the stage derivatives below which an iteration that no longer improves is accepted.
///
/// It covers the round-off of a vector field and that of its argument, which may be large although the field is small.
pub(crate) const FLOOR: f64 = 8.0 * ROUND_OFF;

/// The number of sweeps without a new least change after which an iteration no longer improves.
///
/// Changes of a converging iteration rise and fall if q drives p and p drives q with different strengths. A single
/// larger change therefore says nothing.
const PATIENCE: f64 = 4.0;

/// The multiple of the size of the stage derivatives within which a solution is near the guess.
pub(crate) const NEAR: f64 = 0.5;

/// The multiple of the first change within which a solution is near the guess for an iteration that contracts. The sum of
/// the changes is below it if they contract by a sixteenth from one to the next on average.
const CONTRACTING: f64 = 16.0;

/// The changes of an iteration, watched until they are round-off, in each lane as if there were no others.
pub(crate) struct ConvergenceTest<T> {
    previous: T,
    least: T,
    /// The last two ratios of a change to the one before it, above round-off.
    ratios: Ratios<T>,
    /// The expected size of the last change.
    expected: T,
    /// The number of sweeps since the least change.
    stalled: T,
    /// Whether there has been a change.
    has_begun: bool,
    /// The first change, and the sum of all.
    first: T,
    path: T,
}

/// The last two ratios of changes in an iteration.
pub(crate) type Ratios<T> = [T; 2];

/// Returns the ratios with which an iteration begins before any change has been measured.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn unknown<T: Real>() -> Ratios<T> {
    [T::from_f64(f64::INFINITY); 2]
}

impl<T: Real> ConvergenceTest<T> {
    /// Creates a watch for an iteration that is expected to have the given ratios of changes.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn new(ratios: Ratios<T>) -> Self {
        let infinity = T::from_f64(f64::INFINITY);
        let (stalled, first, path) = (T::zero(), T::zero(), T::zero());
        Self {
            previous: infinity,
            least: infinity,
            ratios,
            expected: infinity,
            stalled,
            has_begun: false,
            first,
            path,
        }
    }

    /// Returns the lanes in which the iteration has gone astray: the sum of its changes is larger than half the size of
    /// the stages, and larger than a contraction makes it from the first change.
    ///
    /// Stage equations may have several solutions. The one of the state is near a good guess, and an iteration that
    /// contracts finds it. Another one is found by an iteration whose changes first grow.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn is_astray(&self, size: T) -> T::Mask {
        let near = self.path.at_most(size * NEAR);
        if near.all() {
            return T::Mask::from_bool(false);
        }
        near.or(self.path.at_most(self.first * CONTRACTING)).not()
    }

    /// Returns the sum of the changes.
    pub(crate) fn path(&self) -> T {
        self.path
    }

    /// Returns the last two ratios of changes.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn ratios(&self) -> Ratios<T> {
        self.ratios
    }

    /// Returns the lanes in which a change is the last meaningful one, for stages of the given size.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn converged(&mut self, change: T, size: T) -> T::Mask {
        // A change that is not a number ends the iteration in its lane.
        let better = self.least.at_most(change).not();
        self.stalled = T::select(better, T::zero(), self.stalled + 1.0);
        self.least = T::select(better, change, self.least);
        self.path += change;
        if self.has_begun {
            let says = (size * NOISE).at_most(change);
            let ratio = change / self.previous;
            self.ratios = [
                T::select(says, self.ratios[1], self.ratios[0]),
                T::select(says, ratio, self.ratios[1]),
            ];
        } else {
            self.has_begun = true;
            self.first = change;
        }
        // Changes may rise and fall: the larger of two ratios counts.
        let least = T::select(self.expected.at_most(change), self.expected, change);
        self.expected = least * self.ratios[0].larger(self.ratios[1]);
        let small = change.at_most(size * FEW_ROUNDINGS);
        let last = small.and(self.expected.at_most(size * EXPECTED));
        let unchanged = change.at_most(size * NOTHING);
        let grows = self.previous.at_most(change).and(small);
        let stalls = T::from_f64(PATIENCE).at_most(self.stalled);
        let at_floor = stalls.and(change.at_most(size * FLOOR));
        self.previous = change;
        // Each of them bounds the change by a multiple of the size.
        unchanged.or(last).or(grows).or(at_floor).and(is_finite(size))
    }
}

/// Returns the lanes in which a magnitude is a finite number.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn is_finite<T: Real>(magnitude: T) -> T::Mask {
    magnitude.at_most(T::from_f64(f64::MAX))
}

#[cfg(test)]
mod tests {
    use super::{ConvergenceTest, unknown};
    use lie_poisson::{DefaultLanes, Lanes, Mask, Real};

    /// Returns the number of the first change at which an iteration converges.
    fn last(changes: impl IntoIterator<Item = f64>) -> Option<usize> {
        let mut watch = ConvergenceTest::new(unknown());
        changes.into_iter().position(|change| watch.converged(change * f64::EPSILON, 1.0))
    }

    #[test]
    fn the_last_change_is_told_by_those_above_round_off() {
        let geometric = |ratio: f64| (0..).map(move |n| 1e6 * ratio.powi(n));
        // The next change would be 1e-2 roundings, unless the changes decrease more slowly.
        assert_eq!(last(geometric(0.1).take(9)), Some(7));
        assert_eq!(last(geometric(0.5).take(25)), Some(24));
        assert_eq!(last(geometric(0.5).take(24)), None);
        // Round-off of one or two units hides the end.
        assert_eq!(last([1e6, 1e4, 100.0, 1.5, 1.2]), Some(3));
        // The ratios of the iteration before are used, but current ones have more weight.
        let after = |ratio: f64, changes: [f64; 2]| {
            let mut watch = ConvergenceTest::new([ratio; 2]);
            changes.map(|change| watch.converged(change * f64::EPSILON, 1.0))
        };
        assert_eq!(after(0.03, [100.0, 3.0]), [false, false]);
        assert_eq!(after(0.01, [100.0, 1.0]), [false, true]);
        assert_eq!(after(0.01, [20.0, 6.0]), [false, false]);
        // Changes far below round-off end the iteration, whatever their ratios.
        assert_eq!(last([1e6, 1e-5, 1e-10, 1e-15, 1e-20, 1e-25]), Some(4));
        // A single ratio says nothing, and neither do changes that rise and fall.
        assert_eq!(last([1e6, 1.0]), None);
        assert_eq!(last([1e3, 4e3, 500.0, 2e3, 250.0, 1e3, 125.0, 500.0, 62.0, 250.0, 1.0]), None);
    }

    /// A solution far from the guess is accepted only from an iteration that contracts from its first change.
    #[test]
    fn changes_that_grow_lead_astray() {
        let astray = |changes: &[f64]| {
            let mut watch = ConvergenceTest::new(unknown());
            for change in changes {
                watch.converged(*change, 1.0);
            }
            watch.is_astray(1.0)
        };
        assert!(astray(&[0.01, 0.1, 0.3, 0.4, 0.1]));
        // near the guess, although the changes grow
        assert!(!astray(&[0.001, 0.01, 0.1, 0.01]));
        // far from the guess, by a contraction, and by one whose changes rise and fall
        assert!(!astray(&[1.0, 0.5, 0.25]) && !astray(&[0.1, 0.4, 0.05, 0.2, 0.02]));
    }

    /// The changes are those of a field whose argument is a thousand times larger than the field.
    #[test]
    fn an_iteration_that_stalls_is_at_the_floor_or_lost() {
        let stalls = |floor: f64| [1e9, 1.0, 1.1, 1.0, 1.1, 1.0].map(|x| x * floor);
        assert_eq!(last(stalls(3e3)), Some(5));
        assert_eq!(last(stalls(3e4)), None);
    }

    /// Four lanes end by no change, by growth at the floor, by a stall, and not at all because of a NaN.
    #[test]
    fn each_lane_is_watched_by_itself() {
        let changes = [
            [1.0, 1e-16, 1e-14, f64::NAN],
            [0.0, 1e-15, 2e-14, 0.0],
            [1.0, 1e-3, 2e-14, 1.0],
            [1.0, 1e-3, 2e-14, 1.0],
        ];
        let expected = [[false; 4], [true, true, false, true], [false; 4], [false; 4]];
        let mut together = ConvergenceTest::new(unknown());
        let mut alone = [0, 1, 2, 3].map(|_| ConvergenceTest::new(unknown()));
        for (n, changes) in changes.iter().enumerate() {
            let converged =
                together.converged(DefaultLanes::load(changes), DefaultLanes::from_f64(1.0));
            for (lane, watch) in alone.iter_mut().enumerate() {
                assert_eq!(converged.lane(lane), watch.converged(changes[lane], 1.0));
                assert_eq!(converged.lane(lane), expected[n][lane], "{n} {lane}");
            }
        }
        // the fourth sweep without a better change
        assert!(alone[2].converged(1.5e-14, 1.0) && !alone[3].converged(1.5e-3, 1.0));
    }
}
