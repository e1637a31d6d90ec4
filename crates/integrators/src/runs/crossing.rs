//! Sign changes of a function along a trajectory.

use crate::integrators::trajectories::integrator::{Integrator, SampleOf};
use crate::runs::event_values::{EventError, EventValues, Point, have_one_sign};
use crate::runs::root_bracketing::Bracket;

/// The direction in which g crosses zero along the trajectory.
///
/// For negative steps the trajectory runs backwards in time, and a function that grows along it falls in time. A Poincaré
/// section is a set of states, whatever the direction of a run: [`along_run`](Self::along_run) gives the direction in
/// which the run crosses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// A crossing upwards, from g < 0 to g > 0.
    Up,
    /// A crossing downwards, from g > 0 to g < 0.
    Down,
    /// A crossing in either direction.
    Both,
}

impl Direction {
    /// Returns the direction along a run with steps of size `step` of the crossings that have this direction in time.
    ///
    /// # Example
    /// ```
    /// use collective_integrators::Direction;
    /// assert_eq!(Direction::Up.along_run(0.1), Direction::Up);
    /// assert_eq!(Direction::Up.along_run(-0.1), Direction::Down);
    /// ```
    #[must_use]
    pub fn along_run(self, step: f64) -> Self {
        match self {
            Self::Up if step < 0.0 => Self::Down,
            Self::Down if step < 0.0 => Self::Up,
            same => same,
        }
    }

    /// Returns whether the way between two values of g crosses zero in this direction.
    pub(crate) fn crosses(self, before: f64, after: f64) -> bool {
        let up = before < 0.0 && after > 0.0;
        let down = before > 0.0 && after < 0.0;
        match self {
            Self::Up => up,
            Self::Down => down,
            Self::Both => up || down,
        }
    }
}

/// The largest residual of a zero, relative to the values at the ends of its bracket. The residual of a smooth zero is
/// some ε, and that of a jump is the limit of g on the side of the jump.
const RESIDUAL: f64 = 1.0 / (1 << 20) as f64;

/// The largest number of zeros that are touched on the way to a crossing within one step.
const MOST_TOUCHES: usize = 8;

/// The crossings of zero by g(μ) in the requested direction, located by steps of partial size.
#[derive(Debug)]
pub(crate) struct Crossings<'a, I: Integrator, G> {
    pub(crate) values: EventValues<'a, I, G>,
    pub(crate) direction: Direction,
}

impl<I: Integrator, G: Fn(&I::Momentum) -> f64> Crossings<'_, I, G> {
    /// Returns the crossing between two points of a step if it has the requested direction.
    pub(crate) fn between(
        &mut self,
        from: &SampleOf<I>,
        left: &Point<SampleOf<I>>,
        right: &Point<SampleOf<I>>,
    ) -> Result<Option<SampleOf<I>>, EventError> {
        let (before, after) = (left.value, right.value);
        if !self.direction.crosses(before, after) || self.values.wraps(before, after) {
            return Ok(None);
        }
        self.locate(from, left, right)
    }

    /// Locates the crossing between two points of different signs, or returns `None` if g does not go to zero there.
    fn locate(
        &mut self,
        from: &SampleOf<I>,
        left: &Point<SampleOf<I>>,
        right: &Point<SampleOf<I>>,
    ) -> Result<Option<SampleOf<I>>, EventError> {
        let (mut left, mut right) = (left.clone(), right.clone());
        for _ in 0..MOST_TOUCHES {
            let (best, ends) = self.narrow(from, &left, &right)?;
            if best.value != 0.0 && !best.value.is_nan() {
                let is_zero = self.is_zero(from, [&left, &right], best.tau, ends)?;
                return Ok(is_zero.then_some(best.sample));
            }
            let before = self.values.approach(from, best.tau, left.tau)?;
            let after = self.values.approach(from, best.tau, right.tau)?;
            let agrees = |end: f64, beside: f64| beside == 0.0 || have_one_sign(end, beside);
            // A point whose sides do not have the signs of the ends is a touch, and the crossing is elsewhere.
            match [agrees(left.value, before.beside.value), agrees(right.value, after.beside.value)]
            {
                [true, true] => {
                    return Ok((before.vanishes && after.vanishes).then_some(best.sample));
                }
                [true, false] => left = after.beside,
                [false, _] => right = before.beside,
            }
        }
        Ok(None)
    }

    /// Returns the point with the least |g| between two points of different signs, or a point without a value, and |g| at
    /// the last ends of the bracket, each on its side.
    fn narrow(
        &mut self,
        from: &SampleOf<I>,
        left: &Point<SampleOf<I>>,
        right: &Point<SampleOf<I>>,
    ) -> Result<(Point<SampleOf<I>>, [f64; 2]), EventError> {
        let mut bracket = Bracket::new(left.value, right.tau - left.tau, right.value);
        let mut best = if right.value.abs() < left.value.abs() { right } else { left }.clone();
        let mut ends = [left.value.abs(), right.value.abs()];
        while let Some(tau) = bracket.next() {
            let point = self.values.after_or_hole(from, left.tau + tau)?;
            let value = point.value;
            if value.is_nan() {
                return Ok((point, ends));
            }
            ends[usize::from(!have_one_sign(value, left.value))] = value.abs();
            if value.abs() <= best.value.abs() {
                best = point;
            }
            bracket.insert(tau, value);
        }
        Ok((best, ends))
    }

    /// Returns whether g goes to zero on both sides of a change of sign at τ.
    ///
    /// It does if the residual on each side is small compared with the values at the ends, or not larger than the effect of
    /// rounding, or if g grows with the distance, as a root does. It does not at a jump or at a pole.
    fn is_zero(
        &mut self,
        from: &SampleOf<I>,
        ends: [&Point<SampleOf<I>>; 2],
        tau: f64,
        residuals: [f64; 2],
    ) -> Result<bool, EventError> {
        let sizes = ends.map(|end| end.value.abs()).into_iter().filter(|size| size.is_finite());
        let bound = RESIDUAL * sizes.fold(0.0, f64::max);
        for (end, residual) in ends.into_iter().zip(residuals) {
            if residual <= bound {
                continue;
            }
            let rounding = ends.map(|end| self.values.rounding(end));
            // If one of the ends lies beside a jump, the effect of rounding there is the jump.
            let is_rounding = rounding.into_iter().all(|rounding| residual <= rounding);
            if !is_rounding && !self.values.approach(from, tau, end.tau)?.vanishes {
                return Ok(false);
            }
        }
        Ok(true)
    }
}
