//! Half a step of the collective midpoint rule for tops, from a guess of a = (h/4) Ωₘ.

use super::components::TopState;
use super::midpoint_parameters::MidpointParameters;
use super::register_vector::{CyclicShifts, MaskOf, RegisterVector, add_cross};
use lie_poisson::{Lanes, Mask, Real};

/// The bound of the error after the correction, as a multiple of |a|, below which a guess is accepted.
const FLOOR: f64 = 2.0 * f64::EPSILON;

/// The bound, as a multiple of |a|, below which a correction that no longer shrinks is round-off.
const ROUND_OFF: f64 = 128.0 * f64::EPSILON;

/// The greatest |4d|² of a correction. The end of a step is correct to the first order in 4d, and its lengths to |4d|².
const LARGEST_CHANGE: f64 = f64::EPSILON;

/// The rotation R_a, stored as the matrix R_a − 1.
///
/// Its entries have the size of |a|, so that their rounding errors are small against those of the vectors
/// that it rotates.
struct HalfTurn<V: RegisterVector> {
    /// The entries (i, i) of the diagonal.
    diagonal: V,
    /// The entries (i, i+1) above it, cyclically.
    next: V,
    /// The entries (i, i−1) below it, cyclically.
    previous: V,
    /// The factor 2n of the matrix, n = 1/(1+|a|²).
    scale: V::Scalar,
}

impl<V: RegisterVector> HalfTurn<V> {
    /// Creates the matrix R_a − 1 = 2n (a aᵀ − |a|² − [a]×) of a, where [a]× v = a×v.
    ///
    /// The factors of n are computed while the division is under way.
    #[inline(always)]
    fn new(a: V, turned: CyclicShifts<V>, square: V::Scalar) -> Self {
        let scale = V::Scalar::from_f64(2.0) / (square + 1.0);
        let twice = V::uniform(scale);
        Self {
            diagonal: twice.times(a.multiply_subtract(a, V::uniform(square))),
            next: twice.times(a.multiply_add(turned.next, turned.previous)),
            previous: twice.times(a.multiply_subtract(turned.previous, turned.next)),
            scale,
        }
    }

    /// Returns the rotated vector R_a v.
    #[inline(always)]
    fn apply(&self, v: V, turned: CyclicShifts<V>) -> V {
        let sum = self.next.multiply_add(turned.next, self.diagonal.multiply_add(v, v));
        self.previous.multiply_add(turned.previous, sum)
    }
}

/// Returns where a squared change |4d|² is small enough for the end of a step.
#[inline(always)]
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
    /// The correction 4d, where a − d is nearer to the solution.
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
    /// (h/4) I⁻¹ (2 Πₘ×r) = 2 I⁻¹((I a)×r).
    #[inline(always)]
    pub fn new(top: &MidpointParameters<V, V::Scalar>, start: &TopState<V>, a: V) -> Self {
        let (square, turned) = (a.times(a).sum(), CyclicShifts::new(a));
        let half_turn = HalfTurn::new(a, turned, square);
        let scale = V::uniform(half_turn.scale);
        let force = CyclicShifts::new(add_cross(top.force, turned, CyclicShifts::new(top.force)));
        let along = V::uniform(a.dot(top.force));
        let (gamma, across) = (start.vertical, CyclicShifts::new(start.vertical));
        let torque = across.previous.multiply_add(force.next, along.times(gamma));
        let torque = across.next.multiply_subtract(force.previous, torque);
        let kicked = scale.multiply_add(torque, start.momentum);
        let middle = half_turn.apply(kicked, CyclicShifts::new(kicked));
        let four = V::uniform(V::Scalar::from_f64(4.0));
        let residual = top.rate.times(scale).negative_multiply_add(middle, four.times(a));
        let spin = CyclicShifts {
            next: top.next_ratio.times(turned.next),
            previous: top.previous_ratio.times(turned.previous),
        };
        let correction = add_cross(residual, spin, CyclicShifts::new(residual));
        Self { a, square, half_turn, force, along, middle, correction }
    }

    /// Returns the squared change |4d|².
    #[inline(always)]
    pub fn change(&self) -> V::Scalar {
        self.correction.dot(self.correction)
    }

    /// Returns where the error of a − d, at most κ|d|, is at the floor; false where something is NaN.
    #[inline(always)]
    pub fn converged(&self, top: &MidpointParameters<V, V::Scalar>) -> MaskOf<V> {
        let rate = (self.square * self.square).multiply_add(top.turning_rate, top.kick_rate);
        let (change, size) = (self.change(), self.square + top.least_square);
        (change * rate).at_most(size * (16.0 * FLOOR * FLOOR)).and(is_small(change))
    }

    /// Returns where the correction is round-off and the iteration no longer improves.
    #[inline(always)]
    pub fn stalled(
        &self,
        top: &MidpointParameters<V, V::Scalar>,
        previous: V::Scalar,
    ) -> MaskOf<V> {
        let change = self.change();
        let size = self.square + top.least_square;
        let round_off = change.at_most(size * (16.0 * ROUND_OFF * ROUND_OFF));
        previous.at_most(change).and(round_off).and(is_small(change))
    }

    /// Returns the corrected guess a − d.
    #[inline(always)]
    pub fn corrected(&self) -> V {
        V::uniform(V::Scalar::from_f64(0.25)).negative_multiply_add(self.correction, self.a)
    }

    /// Returns the end of the step with a − d instead of a.
    ///
    /// With G = R_a Γ₀ and Y = R_a Π₀ + h n G×γ,
    ///
    /// ```text
    /// Y = X + 2n (G×f + α G),  Γ₁ = R_a G,  Π₁ = R_a Y
    /// ```
    ///
    /// where a solves the equation. With b = a − d, R_b R_b = R_a (1 + 4n [d]×) R_a to the first order in d.
    /// The parts that do not depend on d can therefore be computed before d is known:
    ///
    /// ```text
    /// Γ₁ = R_a (G + 4d×G),    Π₁ = R_a (Y + 4d×Y)
    /// ```
    ///
    /// This omits 4(1 − n) d and, in Π₁, a term 2hn² G×(γ×d). The bound κ of the error after a correction
    /// includes both.
    #[inline(always)]
    pub fn end(&self, start: &TopState<V>) -> TopState<V> {
        let turn = &self.half_turn;
        let vertical = turn.apply(start.vertical, CyclicShifts::new(start.vertical));
        let across = CyclicShifts::new(vertical);
        let torque = across.previous.multiply_subtract(self.force.next, self.along.times(vertical));
        let torque = across.next.multiply_subtract(self.force.previous, torque);
        let momentum = V::uniform(turn.scale).multiply_add(torque, self.middle);
        let delta = CyclicShifts::new(self.correction);
        let vertical = add_cross(vertical, delta, across);
        let momentum = add_cross(momentum, delta, CyclicShifts::new(momentum));
        TopState {
            momentum: turn.apply(momentum, CyclicShifts::new(momentum)),
            vertical: turn.apply(vertical, CyclicShifts::new(vertical)),
        }
    }
}
