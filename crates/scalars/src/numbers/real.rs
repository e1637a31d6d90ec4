//! The scalar trait [`Real`], implemented by `f64`, dual numbers and lanes.

use crate::numbers::mask::Mask;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};
use num_traits::NumAssign;

/// A scalar that computes like a real number: `f64`, a dual number, or SIMD lanes.
///
/// Every formula of these crates is polynomial, except for √, ln and the exponentials of a Lie group. Your own
/// energies may also use exp, sin, cos and tanh. Code that is written once over `T: Real` runs on
///
/// * `f64`: one trajectory;
/// * [`DualNumber`](crate::DualNumber): exact derivatives, for differentials, tangent maps and Poisson defects;
/// * [`DefaultLanes`](crate::DefaultLanes) and the other [`Lanes`](crate::Lanes), SIMD lanes: several trajectories in
///   one register.
///
/// A branch is taken lane by lane: [`at_most`](Self::at_most) compares, [`select`](Self::select) chooses.
///
/// A scalar of your own implements each function by means of the functions of its parts. Only formulas such as
/// [`powi`](Self::powi) and [`larger`](Self::larger) are provided, since no formula for the others is accurate for
/// all arguments.
///
/// The trait has no fused multiply-add: fused and unfused results differ, and each operation on lanes must be
/// bit-identical to that on `f64`. [`Lanes`](crate::Lanes) has a fused multiply-add.
///
/// # Example
/// ```
/// use generic_scalars::{DualNumber, Real};
///
/// fn kinetic_energy<T: Real>(speed: T) -> T {
///     speed * speed * 0.5
/// }
/// // d(v²/2)/dv = v
/// let energy = kinetic_energy(DualNumber::variable(3.0));
/// assert_eq!((energy.value_without_derivative(), energy.derivative()), (4.5, 3.0));
/// ```
pub trait Real:
    Copy
    + Debug
    + PartialEq
    + Send
    + Sync
    + 'static
    + NumAssign
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// Whether a method over this scalar handles rare cases that are slow, such as a stage iteration that has not
    /// converged.
    ///
    /// It is `false` for the register lanes that [`dispatch_unfused`](crate::dispatch_unfused) passes to a task.
    /// There a method may fail in a rare case, and the caller then repeats its work over another scalar.
    ///
    /// ```
    /// use generic_scalars::{DefaultLanes, DualNumber, Real};
    /// assert!(f64::HAS_SLOW_PATHS && DefaultLanes::HAS_SLOW_PATHS && DualNumber::<f64>::HAS_SLOW_PATHS);
    /// ```
    const HAS_SLOW_PATHS: bool = true;

    /// The type of the result of a comparison: one truth value for each lane.
    type Mask: Mask;

    /// Converts the number `x` to a constant of this type.
    fn from_f64(x: f64) -> Self;

    /// Returns the number as `f64` if the type is `f64`, and `None` for every other type.
    ///
    /// Code over all scalars can use it to take a faster path for plain numbers. The compiler removes the test.
    ///
    /// ```
    /// use generic_scalars::{DualNumber, Real};
    /// assert_eq!((Real::as_f64(2.5), DualNumber::constant(2.5).as_f64()), (Some(2.5), None));
    /// ```
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn as_f64(self) -> Option<f64> {
        None
    }

    /// Returns the number with all derivatives zero if the type has derivatives, and `None` for every other type.
    ///
    /// The values of an equation do not depend on the derivatives: code over all scalars can use it to solve for the values
    /// first.
    ///
    /// ```
    /// use generic_scalars::{DualNumber, Real};
    /// let x = DualNumber::variable(2.5);
    /// assert_eq!((x.without_derivative(), 2.5.without_derivative()), (Some(DualNumber::constant(2.5)), None));
    /// ```
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn without_derivative(self) -> Option<Self> {
        None
    }

    /// Returns f(x, y) for the values of two numbers, lane by lane in the order of the lanes, as a constant: the function is
    /// taken to have no derivative, as one that is piecewise constant. It is NaN for a scalar of one's own without this method.
    ///
    /// It is for what no formula says: a search in a table, a random number with a given index.
    ///
    /// ```
    /// use generic_scalars::{DualNumber, Real};
    /// let whole = DualNumber::variable(2.5).lane_by_lane(DualNumber::constant(1.0), |x, y| x.floor() + y);
    /// assert_eq!(whole, DualNumber::constant(3.0));
    /// ```
    #[must_use]
    #[inline]
    fn lane_by_lane(self, other: Self, mut f: impl FnMut(f64, f64) -> f64) -> Self {
        let values = self.as_f64().zip(other.as_f64());
        Self::from_f64(values.map_or(f64::NAN, |(x, y)| f(x, y)))
    }

    /// Returns the square root √x; NaN for x < 0, as for `f64`.
    fn sqrt(self) -> Self;

    /// Returns the natural logarithm ln x.
    fn ln(self) -> Self;

    /// Returns the angle of the point (x, y), where y is `self`, in [−π, π]. As for `f64`, it is π for y = 0 and
    /// −π for y = −0 if x < 0.
    fn atan2(self, x: Self) -> Self;

    /// Returns the exponential function exp x.
    ///
    /// ```
    /// use generic_scalars::{DualNumber, Real};
    /// fn morse<T: Real>(x: T) -> T {
    ///     (-(-x).exp() + 1.0).powi(2)
    /// }
    /// // d/dx (1 − exp(−x))² = 2 (1 − exp(−x)) exp(−x)
    /// let (x, e) = (DualNumber::variable(0.5), (-0.5_f64).exp());
    /// assert!((morse(x).derivative() - 2.0 * (1.0 - e) * e).abs() < 1e-15);
    /// ```
    #[must_use]
    fn exp(self) -> Self;

    /// Returns sin x, for x in radians, to a unit in the last place.
    ///
    /// Up to |x| = 2²⁰ it is made of sums, products and comparisons, so that the value is bit-identical on every platform and in
    /// each lane. Beyond that it is that of the standard library, which does not promise this.
    ///
    /// ```
    /// use generic_scalars::{DefaultLanes, Lanes, Real};
    /// let x = DefaultLanes::load(&[0.5, -1.0, 10.0, 1e5]);
    /// assert!((0..4).all(|i| x.sin().lane(i) == Real::sin(x.lane(i))));
    /// ```
    #[must_use]
    fn sin(self) -> Self;

    /// Returns cos x, for x in radians, with the accuracy and the bits of [`sin`](Self::sin).
    #[must_use]
    fn cos(self) -> Self;

    /// Returns the hyperbolic tangent tanh x.
    ///
    /// The derivative of a dual number is accurate for all x, even where tanh x rounds to ±1.
    #[must_use]
    fn tanh(self) -> Self;

    /// Returns the integer power xⁿ, with x⁰ = 1 for every x, even for NaN.
    ///
    /// The result is a product by repeated squaring, or its reciprocal for n < 0, with about |n| units of round-off.
    /// For n < 0 it is 0 where x⁻ⁿ overflows. In code over all scalars the value is bit-identical for each of them
    /// and on every platform. The inherent method `f64::powi` does not promise this.
    ///
    /// ```
    /// use generic_scalars::{DualNumber, Real};
    /// let power = DualNumber::variable(2.0).powi(-3);
    /// assert_eq!((power.value_without_derivative(), power.derivative()), (0.125, -0.1875));
    /// ```
    #[must_use]
    #[inline]
    fn powi(self, n: i32) -> Self {
        let (mut left, mut square, mut power) = (n.unsigned_abs(), self, Self::one());
        while left > 0 {
            if left % 2 == 1 {
                power *= square;
            }
            left /= 2;
            // The square after the last factor might overflow.
            if left > 0 {
                square *= square;
            }
        }
        if n < 0 { Self::one() / power } else { power }
    }

    /// Returns the Stumpff function cₖ(x) of order k:
    ///
    /// ```text
    /// cₖ(x) = 1/k! − x/(k+2)! + x²/(k+4)! − …
    /// ```
    ///
    /// so that c₀(θ²) = cos θ, c₁(θ²) = sin θ / θ, c₂(θ²) = (1 − cos θ)/θ², and c₀(−θ²) = cosh θ, c₁(−θ²) =
    /// sinh θ / θ. The functions are entire. With them, exponentials on SO(3), SU(2), SE(3) and SL(2, R)
    /// need no small-angle branch. They satisfy cₖ = 1/k! − x cₖ₊₂ and cₖ′ = ½(k cₖ₊₂ − cₖ₊₁).
    ///
    /// The result is accurate to a few units of round-off for orders k ≤ 12, and to about k/2 units for
    /// higher orders. From k = 171 on, 1/k! is below the smallest normal number, and so is cₖ. A derivative
    /// loses another k/2 units to the difference in its formula.
    ///
    /// Source: K. Stumpff, *Himmelsmechanik* I (1959), §41.
    fn stumpff(self, order: u32) -> Self;

    /// Returns the mask of the lanes in which x ≤ `bound`; false where either is NaN. Dual numbers compare
    /// their values alone.
    fn at_most(self, bound: Self) -> Self::Mask;

    /// Returns `yes` where the mask is true and `no` elsewhere, bit for bit. It is the only branch available to a
    /// formula over all scalars.
    #[must_use]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// Returns |x|, lane by lane; for a dual number the larger of |x| and |x′|, as a constant.
    #[must_use]
    fn magnitude(self) -> Self;

    /// Returns the largest |x| over all lanes and parts, or NaN if any of them is NaN.
    fn max_abs(self) -> f64;

    /// Returns the larger of two numbers, lane by lane, and NaN where either is NaN. Dual numbers compare
    /// their values alone.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn larger(self, other: Self) -> Self {
        Self::select(self.at_most(self), self.maximum(other), self)
    }

    /// Returns the larger of two numbers, lane by lane, by one instruction that may lose a NaN.
    ///
    /// The result is `other` where the two are equal or either is NaN. [`larger`](Self::larger) keeps NaN
    /// but takes several instructions. Dual numbers compare their values alone.
    ///
    /// ```
    /// use generic_scalars::Real;
    /// assert!(1.0.maximum(f64::NAN).is_nan() && f64::NAN.maximum(1.0) == 1.0);
    /// ```
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn maximum(self, other: Self) -> Self {
        let above = self.at_most(other).not().and(self.at_most(self)).and(other.at_most(other));
        Self::select(above, self, other)
    }

    /// Returns `yes` where x ≥ 0, and `no` where x < 0 or x is NaN, lane by lane.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn select_nonnegative(self, yes: Self, no: Self) -> Self {
        Self::select(Self::from_f64(0.0).at_most(self), yes, no)
    }

    /// Returns whether |x| ≤ `bound` in every lane and every part; false if any of them is NaN.
    #[cfg_attr(optimised, inline(always))]
    fn all_below(self, bound: f64) -> bool {
        self.magnitude().at_most(Self::from_f64(bound)).all()
    }
}

/// Returns the larger of two numbers, or NaN if either is NaN. (`f64::max` or a test `a > b` would lose the NaN.)
#[must_use]
#[inline]
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nan_is_never_below_and_never_dropped() {
        assert!(!f64::NAN.all_below(f64::INFINITY));
        assert!(larger(f64::NAN, 1.0).is_nan() && larger(1.0, f64::NAN).is_nan());
        assert_eq!(larger(1.0, 2.0), 2.0);
    }
}
