//! Half a step of the collective midpoint rule for tops, from a guess of a = (h/4) Ωₘ.

use super::components::TopState;
use super::midpoint_parameters::MidpointParameters;
use super::register_vector::{CyclicShifts, MaskOf, RegisterVector, add_cross};
use lie_poisson::{Lanes, Mask, Real};

/// The bound, as a multiple of |a|, below which a correction that no longer shrinks is round-off.
const ROUND_OFF: f64 = 128.0 * f64::EPSILON;

/// The greatest |2d|² of a correction. The end of a step is correct to the first order in 4d, and its lengths to |4d|².
const LARGEST_CHANGE: f64 = f64::EPSILON / 4.0;

/// The rotation R_a, stored as the matrix W = (R_a − 1)/2n and the factor 2n, n = 1/(1+|a|²).
///
/// The entries of W have the size of |a|, so that their rounding errors, and those of W v, are small against those of
/// the vectors that are rotated.
struct HalfTurn<V: RegisterVector> {
    /// The entries (i, i) of the diagonal.
    diagonal: V,
    /// The entries (i, i+1) above it, cyclically.
    next: V,
    /// The entries (i, i−1) below it, cyclically.
    previous: V,
    /// The factor 2n of W.
    scale: V::Scalar,
}

impl<V: RegisterVector> HalfTurn<V> {
    /// Creates the matrix W = a aᵀ − |a|² − [a]× of a, where [a]× v = a×v, from the squares of the components of a and
    /// their sum |a|².
    ///
    /// The division is under way while vectors are multiplied by W.
    #[cfg_attr(optimised, inline(always))]
    fn new(a: V, turned: CyclicShifts<V>, squares: V, square: V::Scalar) -> Self {
        Self {
            diagonal: squares.minus(V::uniform(square)),
            next: a.multiply_add(turned.next, turned.previous),
            previous: a.multiply_subtract(turned.previous, turned.next),
            scale: V::Scalar::from_f64(2.0) / (square + 1.0),
        }
    }

    /// Returns the rotated vector R_a v.
    #[cfg_attr(optimised, inline(always))]
    fn apply(&self, v: V, turned: CyclicShifts<V>) -> V {
        let sum = self.next.multiply_add(turned.next, self.diagonal.times(v));
        let change = self.previous.multiply_add(turned.previous, sum);
        V::uniform(self.scale).multiply_add(change, v)
    }
}

/// Returns where a squared change |2d|² is small enough for the end of a step.
#[cfg_attr(optimised, inline(always))]
fn is_small<T: Real>(change: T) -> T::Mask {
    change.at_most(T::from_f64(LARGEST_CHANGE))
}

/// The first half of a step, with a guess of a.
pub(super) struct Guess<V: RegisterVector> {
    a: V,
    /// The square |a|² of the guess.
    square: V::Scalar,
    half_turn: HalfTurn<V>,
    /// The vector f of [`new`](Self::new).
    force: CyclicShifts<V>,
    /// The number α of [`new`](Self::new), in every component.
    along: V,
    /// The vector X of [`new`](Self::new).
    middle: V,
    /// The correction 2d, where a − d is nearer to the solution.
    correction: V,
}

impl<V: RegisterVector> Guess<V> {
    /// Computes the residual r = a − (h/4) I⁻¹Πₘ of a guess and its correction d.
    ///
    /// In terms of Π₀ and Γ₀, with n = 1/(1+|a|²),
    ///
    /// ```text
    /// f = ¼ h (γ − γ×a),  α = ¼ h a·γ
    /// X = R_a ( Π₀ + 2n (Γ₀×f − α Γ₀) ),  Πₘ = n X,
    /// ```
    ///
    /// and the correction is d = (1 − M)⁻¹r ≈ r + M r by the leading part 1 − M of the derivative, M r =
    /// (h/4) I⁻¹ (2 Πₘ×r).
    #[cfg_attr(optimised, inline(always))]
    pub fn new(top: &MidpointParameters<V, V::Scalar>, start: &TopState<V>, a: V) -> Self {
        let (squares, turned) = (a.times(a), CyclicShifts::new(a));
        let square = squares.sum();
        let half_turn = HalfTurn::new(a, turned, squares, square);
        let scale = V::uniform(half_turn.scale);
        let force = CyclicShifts::new(add_cross(top.force, turned, CyclicShifts::new(top.force)));
        let along = V::uniform(a.dot(top.force));
        let (gamma, across) = (start.vertical, CyclicShifts::new(start.vertical));
        let torque = across.previous.multiply_add(force.next, along.times(gamma));
        let torque = across.next.multiply_subtract(force.previous, torque);
        let kicked = scale.multiply_add(torque, start.momentum);
        let middle = half_turn.apply(kicked, CyclicShifts::new(kicked));
        let rate = top.rate.times(scale);
        let residual = rate.negative_multiply_add(middle, a.plus(a));
        let (x, r) = (CyclicShifts::new(middle), CyclicShifts::new(residual));
        let cross = x.next.multiply_subtract(r.previous, x.previous.times(r.next));
        let correction = rate.multiply_add(cross, residual);
        Self { a, square, half_turn, force, along, middle, correction }
    }

    /// Returns the squared change |2d|².
    #[cfg_attr(optimised, inline(always))]
    pub fn change(&self) -> V::Scalar {
        self.correction.dot(self.correction)
    }

    /// Returns where the error of a − d, at most κ|d|, is at the floor; false where something is NaN.
    #[cfg_attr(optimised, inline(always))]
    pub fn converged(&self, top: &MidpointParameters<V, V::Scalar>) -> MaskOf<V> {
        let rate = (self.square * self.square).multiply_add(top.turning_rate, top.kick_rate);
        let (change, size) = (self.change(), self.square + top.least_square);
        (change * rate).at_most(size).and(is_small(change))
    }

    /// Returns where the correction is round-off and no longer shrinks.
    #[cfg_attr(optimised, inline(always))]
    pub fn stalled(
        &self,
        top: &MidpointParameters<V, V::Scalar>,
        previous: V::Scalar,
    ) -> MaskOf<V> {
        let change = self.change();
        let size = self.square + top.least_square;
        let round_off = change.at_most(size * (4.0 * ROUND_OFF * ROUND_OFF));
        previous.at_most(change).and(round_off).and(is_small(change))
    }

    /// Returns the corrected guess a − d.
    #[cfg_attr(optimised, inline(always))]
    pub fn corrected(&self) -> V {
        V::uniform(V::Scalar::from_f64(0.5)).negative_multiply_add(self.correction, self.a)
    }

    /// Returns the end of the step with a − d instead of a.
    ///
    /// With G = R_a Γ₀ and Y = R_a Π₀ + h n G×γ,
    ///
    /// ```text
    /// Y = X + 2n (G×f + α G),  Γ₁ = R_a G,  Π₁ = R_a Y
    /// ```
    ///
    /// where a solves the equation. With b = a − d, R_b R_b = R_a (1 + 4n [d]×) R_a to the first order in d. With
    /// R_a = 1 + 2n W, the corrected vectors are therefore
    ///
    /// ```text
    /// Γ₁ = R_a ( Γ₀ + 2n (W Γ₀ + 2d×G) ),    Π₁ = R_a ( X + 2n (G×f + α G + 2d×Y) )
    /// ```
    ///
    /// of which the parts without d are computed before d is known. In Π₁ this omits a term 2hn² G×(γ×d). The bound κ
    /// of the error after a correction includes it.
    ///
    /// The vector 2d×G is about a unit of round-off of W Γ₀. Added to G or to W Γ₀, it would be rounded to whole units,
    /// or to none, of each component by itself. Since d depends on where the top is, these errors do not cancel,
    /// and |Γ|² would drift. It is added to the diagonal part of W Γ₀, whose unit is smaller by the factor |a|, and
    /// keeps its digits. The sum with the other part then rounds the digits of the diagonal part, which are arbitrary.
    #[cfg_attr(optimised, inline(always))]
    pub fn end(&self, start: &TopState<V>) -> TopState<V> {
        let turn = &self.half_turn;
        let scale = V::uniform(turn.scale);
        let delta = CyclicShifts::new(self.correction);
        let gamma = start.vertical;
        let shifted = CyclicShifts::new(gamma);
        let large = turn.next.multiply_add(shifted.next, turn.previous.times(shifted.previous));
        let small = turn.diagonal.times(gamma);
        let vertical = scale.multiply_add(large.plus(small), gamma);
        let across = CyclicShifts::new(vertical);
        let end = scale.multiply_add(large.plus(add_cross(small, delta, across)), gamma);
        let end = turn.apply(end, CyclicShifts::new(end));
        let torque = across.previous.multiply_subtract(self.force.next, self.along.times(vertical));
        let torque = across.next.multiply_subtract(self.force.previous, torque);
        let momentum = scale.multiply_add(torque, self.middle);
        let torque = add_cross(torque, delta, CyclicShifts::new(momentum));
        let momentum = scale.multiply_add(torque, self.middle);
        TopState { momentum: turn.apply(momentum, CyclicShifts::new(momentum)), vertical: end }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::tops::top::HeavyTop;
    use nalgebra::Vector3;

    /// A sphere turns about e₃ by the angle of a, so that the correction turns Γ by 4n d about e₃. Here that is below
    /// the unit of round-off of W Γ, and is seen in the mean over many Γ.
    #[test]
    fn corrections_below_round_off_act() {
        const COUNT: u32 = 500_000;
        let sphere = HeavyTop::free_rigid_body(Vector3::repeat(1.0)).unwrap();
        let parameters = MidpointParameters::<[f64; 3], f64>::gather(|_| sphere, |_| 1.0, 0.0625);
        let a = 0.0156;
        let guess = |vertical, momentum| {
            let start = TopState { momentum: [0.0, 0.0, momentum], vertical };
            (Guess::new(&parameters, &start, [0.0, 0.0, a]), start)
        };
        // a = (h/4) n Π, less half a unit of Π.
        let solution = a * (1.0 + a * a) / 0.015625;
        let momentum = solution * (1.0 - 0.5 * f64::EPSILON);
        let twice = guess([1.0, 0.0, 0.0], momentum).0.correction[2];
        let mut sums = [[0.0; 3]; 2];
        for n in 0..COUNT {
            let x = 0.6 + 0.2 * (f64::from(n) * 0.618).fract();
            let (mut guess, start) = guess([x, 0.1 + 1e-6 * f64::from(n), 0.5], momentum);
            let with = guess.end(&start).vertical;
            guess.correction = [0.0; 3];
            let without = guess.end(&start).vertical;
            for i in 0..3 {
                sums[0][i] += with[i] - without[i];
                sums[1][i] += without[i];
            }
        }
        let angle = 2.0 * twice / (1.0 + a * a);
        // A rounding of Γ is 60 times as large as the correction, and has another sign for another Γ.
        for (found, exact) in [(sums[0][0], -angle * sums[1][1]), (sums[0][1], angle * sums[1][0])]
        {
            assert!((found / exact - 1.0).abs() < 0.03, "{found:e} {exact:e}");
        }
        // Control: the correction is below half the unit of W Γ.
        assert!(twice > 0.0 && 0.1 * twice < 0.25 * f64::EPSILON * a);
    }
}
