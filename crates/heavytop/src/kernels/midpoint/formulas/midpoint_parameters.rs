//! The parameters of tops: of one in registers, or of many in SIMD lanes.

use super::components::{Components, each};
use super::in_register::{InRegister, Stored};
use crate::tops::top::HeavyTop;
use lie_poisson::{FourLanes, Lanes, larger};

/// The bound of the error after the correction of a guess, as a multiple of |a|, below which the guess is accepted.
const FLOOR: f64 = 2.0 * f64::EPSILON;

/// The square of the bound for 2d instead of d.
pub(super) const SQUARED_FLOOR: f64 = 4.0 * FLOOR * FLOOR;

/// Returns the numbers of a top that a step depends on, with the step size h.
#[inline]
pub(super) fn numbers(top: &HeavyTop, step: f64) -> [f64; 7] {
    let (i, f) = (top.inverse_inertia(), top.force::<f64>());
    [i.x, i.y, i.z, f.x, f.y, f.z, step]
}

/// The parameters of a top that a step depends on, with the step size h as a factor.
#[derive(Clone, Copy, Debug)]
pub(super) struct MidpointParameters<V, T> {
    /// The diagonal of (h/4) I⁻¹.
    pub rate: V,
    /// The scaled force (h/4) γ of the weight.
    pub force: V,
    /// The first number of the bound κ|d| of the error after a correction d of a guess.
    ///
    /// κ² = (`turning_rate` |a|⁴ + `kick_rate`) [`SQUARED_FLOOR`] includes the terms that
    /// [`Guess::end`](super::guess::Guess::end) omits.
    pub turning_rate: T,
    pub kick_rate: T,
    /// The square of the size below which |a| is no measure of round-off.
    pub least_square: T,
}

impl<T: Lanes> MidpointParameters<Components<T>, T> {
    /// Gathers the parameters of the tops: lane i is `top(i)`, with |Γ|² = `square(i)`.
    #[cfg_attr(optimised, inline(always))]
    pub fn gather(
        top: impl Fn(usize) -> HeavyTop,
        square: impl Fn(usize) -> f64,
        step: f64,
    ) -> Self {
        let inverse = each!(k => T::from_lanes(|i| top(i).inverse_inertia()[k]));
        let kick = T::from_lanes(|i| kick(&top(i), square(i), step));
        Self {
            rate: each!(k => inverse[k] * (0.25 * step)),
            force: each!(k => T::from_lanes(|i| top(i).force::<f64>()[k]) * (0.25 * step)),
            turning_rate: T::from_lanes(|i| turning(&top(i))) / SQUARED_FLOOR,
            kick_rate: kick * (25.0 / 32.0 / SQUARED_FLOOR),
            least_square: kick * (1.0 / 64.0),
        }
    }
}

impl MidpointParameters<Stored, f64> {
    /// Creates the parameters of one top, with |Γ|² = `square`.
    pub fn stored(top: &HeavyTop, square: f64, step: f64) -> Self {
        let one = MidpointParameters::<Components<f64>, f64>::gather(|_| *top, |_| square, step);
        let stored = |[x, y, z]: Components<f64>| [x, y, z, 0.0];
        Self {
            rate: stored(one.rate),
            force: stored(one.force),
            turning_rate: one.turning_rate,
            kick_rate: one.kick_rate,
            least_square: one.least_square,
        }
    }

    /// Loads each parameter into a register.
    #[cfg_attr(optimised, inline(always))]
    pub fn load<T: FourLanes>(&self) -> MidpointParameters<InRegister<T>, T> {
        MidpointParameters {
            rate: InRegister::load(&self.rate),
            force: InRegister::load(&self.force),
            turning_rate: T::from_f64(self.turning_rate),
            kick_rate: T::from_f64(self.kick_rate),
            least_square: T::from_f64(self.least_square),
        }
    }
}

/// Returns the largest inverse moment max 1/I_i.
fn largest_inverse(top: &HeavyTop) -> f64 {
    top.inverse_inertia().iter().fold(0.0, |largest, &x| larger(largest, x.abs()))
}

/// Returns the squared rate (h² |γ| |Γ| / I_min)² of the kick.
fn kick(top: &HeavyTop, square: f64, step: f64) -> f64 {
    let part = step * step * largest_inverse(top);
    part * part * top.force::<f64>().norm_squared() * square
}

/// Returns the rate 2 (6ρ)² of the rotation, with ρ = I_max/I_min.
fn turning(top: &HeavyTop) -> f64 {
    let least = top.inverse_inertia().iter().fold(f64::INFINITY, |least, &x| least.min(x.abs()));
    let ratio = largest_inverse(top) / least;
    72.0 * ratio * ratio
}
