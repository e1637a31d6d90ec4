//! Brownian motions that are functions of time: [`BrownianPaths`].

use crate::open_systems::paths::normal_quantile::{probability, quantile, quantiles};
use crate::open_systems::paths::philox::philox;
use lie_poisson::Real;
use smallvec::SmallVec;
use thiserror::Error;

/// Brownian motions W(t), each the same whenever it is looked at.
///
/// A seed, the number of a path and that of a component determine W: it is no sequence of random numbers, but a function of
/// time. So a run has the same noise with any number of threads and lanes, and after it was resumed; and a run with half the
/// step has the noise of the run with the whole step, with what happens between added (a Brownian bridge).
///
/// Time is counted in intervals, which are usually the steps of a run. Their increments are normal numbers of the variance of
/// an interval; those of halves, quarters, … follow by bridges, down to 2⁻²⁴ of an interval.
///
/// An increment over a time h is cut at ±b√h with a bound b. Then the stage equations of a step that is short enough always
/// have a solution which the iteration finds, while a normal number, however rarely, is larger than any step can take.
/// The bound is 6 if none is given, which changes the variance of an increment by 4e-9 of it; [`with_bound`](Self::with_bound)
/// gives another.
///
/// Sources: Salmon, Moraes, Dror & Shaw, *Parallel random numbers: as easy as 1, 2, 3*, SC'11 (2011), for the numbers; Milstein,
/// Repin & Tretyakov, *Numerical methods for stochastic systems preserving symplectic structure*, SIAM J. Numer. Anal. 40
/// (2002), §2.1, for the bound.
///
/// # Example
/// ```
/// use collective_integrators::BrownianPaths;
/// let paths = BrownianPaths::new(1, 0.1)?; // the seed, and an interval of 0.1 s
/// let increment = |from: f64, to: f64| {
///     let mut increment = [0.0; 3];
///     paths.write_increments(7, from, to, &mut increment); // of path 7
///     increment
/// };
/// let (whole, first, second) = (increment(4.0, 5.0), increment(4.0, 4.5), increment(4.5, 5.0));
/// for ((whole, first), second) in whole.iter().zip(first).zip(second) {
///     assert!((first + second - whole).abs() < 1e-15);
/// }
/// assert!(BrownianPaths::new(1, f64::NAN).is_err());
/// # Ok::<(), collective_integrators::BrownianError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BrownianPaths {
    seed: u64,
    interval: f64,
    bound: f64,
}

/// The reason why there are no such Brownian motions.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BrownianError {
    /// The length of an interval is not positive or not finite.
    #[error("the interval of a Brownian motion must be a positive number, it is {interval}")]
    Interval {
        /// The rejected length.
        interval: f64,
    },
    /// The bound of increments is below 1 or not a number.
    #[error("the bound of the increments must be 1 standard deviation or more, it is {bound}")]
    Bound {
        /// The rejected bound.
        bound: f64,
    },
}

/// The number of halvings after which a path goes straight.
const HALVINGS: u32 = 24;

/// The bound of an increment, in standard deviations, if none is given.
const BOUND: f64 = 6.0;

/// Distinguishes these numbers from others of the same seed.
const PURPOSE: u64 = 0x4272_6F77_6E69_616E;

impl BrownianPaths {
    /// Creates the Brownian motions of a seed, whose intervals are so long.
    ///
    /// # Errors
    /// Returns [`BrownianError::Interval`] for a length that is not positive and finite.
    pub fn new(seed: u64, interval: f64) -> Result<Self, BrownianError> {
        match interval > 0.0 && interval.is_finite() {
            true => Ok(Self { seed, interval, bound: BOUND }),
            false => Err(BrownianError::Interval { interval }),
        }
    }

    /// Returns these with another bound of the increments, in standard deviations; ∞ for none. Milstein, Repin & Tretyakov
    /// take √(2ℓ |ln h|) with ℓ ≥ 2, for a step h in units of the time of the motion, which keeps the order of every method of
    /// mean-square order up to ℓ/2.
    ///
    /// # Errors
    /// Returns [`BrownianError::Bound`] for a bound below 1 or one that is not a number.
    pub fn with_bound(self, bound: f64) -> Result<Self, BrownianError> {
        match bound >= 1.0 {
            true => Ok(Self { bound, ..self }),
            false => Err(BrownianError::Bound { bound }),
        }
    }

    /// Returns the length of an interval.
    #[must_use]
    pub const fn interval(&self) -> f64 {
        self.interval
    }

    /// Writes the increments of the components 0, 1, … of a path from one time to another, which are counted in intervals.
    /// They are NaN for times that are not finite.
    pub fn write_increments(&self, path: u64, from: f64, to: f64, increments: &mut [f64]) {
        let length = (to - from).abs();
        if !length.is_finite() {
            increments.fill(f64::NAN);
            return;
        }
        let scale = if to < from { -self.interval.sqrt() } else { self.interval.sqrt() };
        let bound = self.bound * length.sqrt();
        for (block, increments) in (0..).zip(increments.chunks_mut(4)) {
            let components = (path, block, increments.len());
            let raw = self.raw(components, from.min(to), from.max(to));
            for (increment, raw) in increments.iter_mut().zip(raw) {
                *increment = raw.clamp(-bound, bound) * scale;
            }
        }
    }

    /// Returns the increments of a path over a time, for intervals of the length 1, of as many of the four components of a block
    /// as are wanted.
    #[inline]
    fn raw(&self, components: (u64, u64, usize), from: f64, to: f64) -> [f64; 4] {
        let (first, last) = (from.floor(), to.floor());
        let (late, early) = (to - last, from - first);
        let mut sum = [0.0; 4];
        let mut add = |sign: f64, increments: [f64; 4]| {
            sum.iter_mut().zip(increments).for_each(|(sum, x)| *sum += sign * x);
        };
        let mut interval = first;
        while interval < last {
            add(1.0, self.node(components, interval, 0));
            interval += 1.0;
        }
        if late > 0.0 {
            add(1.0, self.within(components, last, late));
        }
        if early > 0.0 {
            add(-1.0, self.within(components, first, early));
        }
        sum
    }

    /// Returns the increments from the beginning of an interval to a fraction of it, by bridges.
    fn within(&self, components: (u64, u64, usize), interval: f64, mut fraction: f64) -> [f64; 4] {
        let mut passed = [0.0; 4];
        let mut whole = self.node(components, interval, 0);
        let (mut node, mut deviation) = (1_u64, 0.5_f64);
        for _ in 0..HALVINGS {
            if fraction == 0.0 {
                return passed;
            }
            let bridge = self.node(components, interval, node);
            let is_late = fraction >= 0.5;
            for ((whole, bridge), passed) in whole.iter_mut().zip(bridge).zip(&mut passed) {
                let first = 0.5 * *whole + deviation * bridge;
                *passed += if is_late { first } else { 0.0 };
                *whole = if is_late { *whole - first } else { first };
            }
            (node, fraction) = (2 * node + u64::from(is_late), 2.0 * fraction);
            fraction -= if is_late { 1.0 } else { 0.0 };
            deviation *= core::f64::consts::FRAC_1_SQRT_2;
        }
        passed.iter_mut().zip(whole).for_each(|(passed, whole)| *passed += fraction * whole);
        passed
    }

    /// Returns the normal numbers of an interval, and of its halves, quarters, …, which are numbered from 1; zeros for the
    /// components that are not wanted.
    #[inline]
    fn node(&self, (path, block, wanted): (u64, u64, usize), interval: f64, node: u64) -> [f64; 4] {
        let mut numbers = [0.0; 4];
        let bits = self.bits((path, block), interval, node);
        for (number, bits) in numbers.iter_mut().zip(bits).take(wanted) {
            *number = quantile(probability(bits));
        }
        numbers
    }

    #[inline]
    fn bits(&self, (path, block): (u64, u64), interval: f64, node: u64) -> [u64; 4] {
        philox([self.seed, PURPOSE], [(interval as i64).cast_unsigned(), path, node, block])
    }

    /// Writes the increments of the components 0, 1, … over one interval in each lane, those of
    /// [`write_increments`](Self::write_increments). A lane has the number of its path, and the beginning of its interval.
    #[cfg_attr(optimised, inline(always))]
    pub(in crate::open_systems) fn write_whole<T: Real>(
        &self,
        lanes: &[(u64, f64)],
        increments: &mut [T],
    ) {
        let (zero, scale) = (T::zero(), self.interval.sqrt());
        let (least, most) = (T::from_f64(-self.bound), T::from_f64(self.bound));
        for (block, increments) in (0..).zip(increments.chunks_mut(4)) {
            let bits: SmallVec<[[u64; 4]; MOST_LANES]> =
                lanes.iter().map(|(path, begin)| self.bits((*path, block), *begin, 0)).collect();
            for (component, increment) in increments.iter_mut().enumerate() {
                let mut of_lanes = bits.iter().map(|bits| probability(bits[component]));
                let p = zero.lane_by_lane(zero, |_, _| of_lanes.next().unwrap_or(f64::NAN));
                let x = quantiles(p);
                let x = T::select(x.at_most(most), x, most);
                *increment = T::select(least.at_most(x), x, least) * scale;
            }
        }
    }
}

/// The largest number of lanes for which nothing is allocated.
pub(in crate::open_systems) const MOST_LANES: usize = 16;
