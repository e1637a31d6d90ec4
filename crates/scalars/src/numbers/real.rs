//! The scalar: [`Real`], implemented by `f64`, dual numbers and lanes.

use crate::Mask;
use crate::numbers::stumpff::stumpff;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};
use num_traits::NumAssign;

/// A real number, or something that computes like one.
///
/// Every formula of these crates is polynomial, up to √, ln and the exponentials of a Lie group.
/// Code written once over `T: Real` therefore runs on
///
/// * `f64`: one trajectory;
/// * [`DualNumber`](crate::DualNumber): exact derivatives, for differentials, tangent maps and
///   Poisson defects;
/// * [`DefaultLanes`](crate::DefaultLanes) and the other [`Lanes`](crate::Lanes): several
///   trajectories at once.
///
/// A branch is taken lane by lane: [`at_most`](Self::at_most) compares,
/// [`select`](Self::select) chooses.
///
/// There is no fused multiply-add: fused and unfused results differ, and each operation on lanes
/// must return the same bits as on `f64`. [`Lanes`](crate::Lanes) has one.
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
/// assert_eq!((energy.value, energy.derivative), (4.5, 3.0));
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
    /// What a comparison returns, a truth value for each lane.
    type Mask: Mask;

    /// The constant `x`.
    fn from_f64(x: f64) -> Self;

    /// √x. NaN for x < 0, as for `f64`.
    fn sqrt(self) -> Self;

    /// The natural logarithm ln x.
    fn ln(self) -> Self;

    /// The angle of the point (x, y), y = `self`, in (−π, π].
    fn atan2(self, x: Self) -> Self;

    /// The Stumpff function of order k,
    ///
    /// ```text
    /// c_k(x) = Σ_{j≥0} (−x)^j / (k + 2j)!
    /// ```
    ///
    /// so that c₀(θ²) = cos θ, c₁(θ²) = sin θ / θ, c₂(θ²) = (1 − cos θ)/θ², and
    /// c₀(−θ²) = cosh θ, c₁(−θ²) = sinh θ / θ. They are entire: exponentials on SO(3), SU(2),
    /// SE(3) and SL(2, R) are written with them, without a small-angle branch.
    /// Identities: `c_k = 1/k! − x c_{k+2}` and `c_k′ = ½(k c_{k+2} − c_{k+1})`.
    ///
    /// Accurate to a few units of round-off for orders k ≤ 12, to some k/2 units beyond; from
    /// k = 171 on 1/k! is below the smallest numbers, and so is c_k. A derivative loses k/2 units
    /// more to the difference in the second identity.
    ///
    /// Source: K. Stumpff, *Himmelsmechanik* I (1959), §41.
    fn stumpff(self, order: u32) -> Self;

    /// Where x ≤ `bound`, lane by lane; false where either is NaN. By the values alone for dual
    /// numbers.
    fn at_most(self, bound: Self) -> Self::Mask;

    /// `yes` where the mask is true, `no` elsewhere, bit for bit. The one branch that a formula
    /// over all scalars can take.
    #[must_use]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// |x|, lane by lane; for a dual number the larger of |x| and |x′|, as a constant.
    #[must_use]
    fn magnitude(self) -> Self;

    /// The largest |x| over all lanes and parts; NaN as soon as one of them is NaN.
    fn max_abs(self) -> f64;

    /// The larger of two, lane by lane; NaN where either is NaN. By the values alone for dual
    /// numbers.
    #[must_use]
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self::select(self.at_most(self), self.maximum(other), self)
    }

    /// The larger of two, lane by lane; `other` where they are equal or either is NaN, so that a
    /// NaN may be lost. One instruction where [`larger`](Self::larger) takes several. By the values
    /// alone for dual numbers.
    ///
    /// ```
    /// use generic_scalars::Real;
    /// assert!(1.0.maximum(f64::NAN).is_nan() && f64::NAN.maximum(1.0) == 1.0);
    /// ```
    #[must_use]
    #[inline(always)]
    fn maximum(self, other: Self) -> Self {
        let above = self.at_most(other).not().and(self.at_most(self)).and(other.at_most(other));
        Self::select(above, self, other)
    }

    /// `yes` where x ≥ 0, `no` elsewhere, also where x is NaN; lane by lane.
    #[must_use]
    #[inline(always)]
    fn select_nonnegative(self, yes: Self, no: Self) -> Self {
        Self::select(Self::from_f64(0.0).at_most(self), yes, no)
    }

    /// Whether |x| ≤ `bound` in every lane and every part. False as soon as one of them is NaN.
    #[inline(always)]
    fn all_below(self, bound: f64) -> bool {
        self.magnitude().at_most(Self::from_f64(bound)).all()
    }
}

/// The larger of two numbers, NaN if either is: `f64::max` and `a > b` would drop it.
#[must_use]
#[inline]
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

impl Real for f64 {
    type Mask = bool;

    #[inline]
    fn from_f64(x: f64) -> Self {
        x
    }

    #[inline]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn ln(self) -> Self {
        self.ln()
    }

    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }

    fn stumpff(self, order: u32) -> Self {
        stumpff(self, order)
    }

    #[inline]
    fn at_most(self, bound: Self) -> bool {
        self <= bound
    }

    #[inline]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline]
    fn magnitude(self) -> Self {
        self.abs()
    }

    #[inline]
    fn max_abs(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn maximum(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
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
