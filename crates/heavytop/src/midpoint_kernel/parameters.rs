//! The parameters of tops, in lanes.

use super::components::{Components, each};
use lie_poisson::{Lanes, larger};
use nalgebra::Vector3;

/// What a step needs to know of one top, whose differential is dh = (I⁻¹Π, γ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Top {
    /// The diagonal of I⁻¹.
    pub inverse_inertia: Vector3<f64>,
    /// γ
    pub force: Vector3<f64>,
}

impl Top {
    /// No top: no step settles.
    pub const NONE: Self = Self {
        inverse_inertia: Vector3::new(f64::NAN, f64::NAN, f64::NAN),
        force: Vector3::new(f64::NAN, f64::NAN, f64::NAN),
    };
}

/// The same in each lane, with the step size h worked in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parameters<T> {
    /// 2 I_{i+1}/I_i
    pub next_ratio: Components<T>,
    /// 2 I_{i−1}/I_i
    pub previous_ratio: Components<T>,
    /// The diagonal of (h/8) I⁻¹.
    pub rate: Components<T>,
    /// (h/4) γ
    pub force: Components<T>,
    /// A correction d of a guess leaves an error of at most κ|d|, with
    /// κ² = `turning_rate` |a|⁴ + `kick_rate`, what [`Guess::end`](super::guess::Guess::end) leaves
    /// out included.
    pub turning_rate: T,
    pub kick_rate: T,
    /// The square of the size below which |a| does not measure round-off.
    pub least_square: T,
}

impl<T: Lanes> Parameters<T> {
    /// Lane i is `top(i)`, with |Γ|² = `square(i)`.
    #[inline(always)]
    pub fn gather(top: impl Fn(usize) -> Top, square: impl Fn(usize) -> f64, step: f64) -> Self {
        let inverse = each!(k => T::from_lanes(|i| top(i).inverse_inertia[k]));
        let kick = T::from_lanes(|i| kick(&top(i), square(i), step));
        Self {
            next_ratio: each!(k => (inverse[k] + inverse[k]) / inverse[(k + 1) % 3]),
            previous_ratio: each!(k => (inverse[k] + inverse[k]) / inverse[(k + 2) % 3]),
            rate: each!(k => inverse[k] * (0.125 * step)),
            force: each!(k => T::from_lanes(|i| top(i).force[k]) * (0.25 * step)),
            turning_rate: T::from_lanes(|i| turning(&top(i))),
            kick_rate: kick * (25.0 / 32.0),
            least_square: kick * (1.0 / 64.0),
        }
    }
}

impl Parameters<f64> {
    /// The same in every lane.
    #[inline(always)]
    pub fn splat<T: Lanes>(&self) -> Parameters<T> {
        let vector = |v: &Components<f64>| each!(k => T::from_f64(v[k]));
        Parameters {
            next_ratio: vector(&self.next_ratio),
            previous_ratio: vector(&self.previous_ratio),
            rate: vector(&self.rate),
            force: vector(&self.force),
            turning_rate: T::from_f64(self.turning_rate),
            kick_rate: T::from_f64(self.kick_rate),
            least_square: T::from_f64(self.least_square),
        }
    }
}

/// max 1/I_i
fn largest_inverse(top: &Top) -> f64 {
    top.inverse_inertia.iter().fold(0.0, |largest, &x| larger(largest, x.abs()))
}

/// (h² |γ| |Γ| / I_min)²
fn kick(top: &Top, square: f64, step: f64) -> f64 {
    let part = step * step * largest_inverse(top);
    part * part * top.force.norm_squared() * square
}

/// 2 (6ρ)², ρ = I_max/I_min.
fn turning(top: &Top) -> f64 {
    let least = top.inverse_inertia.iter().fold(f64::INFINITY, |least, &x| least.min(x.abs()));
    let ratio = largest_inverse(top) / least;
    72.0 * ratio * ratio
}
