//! The scalar: [`Real`], implemented by `f64`, dual numbers and lanes.

use crate::Mask;
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
/// use lie_poisson::{DualNumber, Real};
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
    /// use lie_poisson::Real;
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
        let k = f64::from(order);
        // Inside this disc the terms of the series decrease from the first on.
        if self.abs() <= (k + 1.0) * (k + 2.0) {
            stumpff_series(self, order)
        } else {
            stumpff_recursion(self, order)
        }
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

/// The series, on |x| ≤ (k+1)(k+2): as many terms as are above 2⁻⁶⁰ of the first (22 for k = 12).
fn stumpff_series(x: f64, order: u32) -> f64 {
    if order >= UNDERFLOW {
        return x * 0.0;
    }
    let k = f64::from(order);
    let step = |j: u32| {
        let n = k + 2.0 * f64::from(j);
        (n - 1.0) * n
    };
    let (mut terms, mut size) = (0, 1.0);
    while size > 1e-18 {
        terms += 1;
        size *= x.abs() / step(terms);
    }
    let sum = (1..=terms).rev().fold(1.0, |tail, j| 1.0 - x * tail / step(j));
    sum / factorial(order)
}

/// The order from which 1/k! is no normal number.
const UNDERFLOW: u32 = 171;

fn stumpff_recursion(x: f64, order: u32) -> f64 {
    let root = x.abs().sqrt();
    let mut value = match (order.is_multiple_of(2), x > 0.0) {
        (true, true) => root.cos(),
        (true, false) => root.cosh(),
        (false, true) => root.sin() / root,
        (false, false) => root.sinh() / root,
    };
    let mut k = order % 2;
    while k < order && (value != 0.0 || k < UNDERFLOW) {
        value = (1.0 / factorial(k) - value) / x;
        k += 2;
    }
    value
}

fn factorial(n: u32) -> f64 {
    (1..=n.min(UNDERFLOW)).map(f64::from).product()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stumpff_functions_against_fifty_digit_values() {
        // (x, order, c_order(x)), from their series in 60-digit arithmetic.
        let table = [
            (1e-20, 3, 1.0 / 6.0),
            (0.5, 0, 0.760_244_597_075_630_2),
            (2.0, 2, 0.422_028_152_617_312_75),
            (-3.0, 1, 1.580_586_563_566_668),
            (30.0, 3, 0.037_724_215_189_836_375),
        ];
        for (x, order, expected) in table {
            let error = (Real::stumpff(x, order) / expected - 1.0).abs();
            // A handful of roundings of the recursion.
            assert!(error < 4.0 * f64::EPSILON, "c_{order}({x}): {error:e}");
        }
    }

    #[test]
    fn stumpff_functions_of_large_order() {
        // As above.
        let table = [
            (0.5, 20, 4.105_873_253_862_420_6e-19),
            (462.0, 20, 1.954_867_587_507_402e-19),
            (-462.0, 20, 1.699_691_573_580_728_4e-18),
            (2000.0, 20, 6.745_893_980_687_095e-20),
            (-2000.0, 20, 1.290_941_734_738_425_7e-14),
            (0.5, 40, 1.225_261_662_815_181_9e-48),
            (1722.0, 40, 5.976_756_654_147_745e-49),
            (-1722.0, 40, 6.432_829_663_662_85e-48),
            (2000.0, 40, 5.508_387_799_351_775e-49),
            (-2000.0, 40, 1.012_102_996_389_708e-47),
        ];
        for (x, order, expected) in table {
            let error = (Real::stumpff(x, order) / expected - 1.0).abs();
            // The roundings of k! and of k/2 steps of the recursion.
            assert!(error < f64::from(order) * f64::EPSILON, "c_{order}({x}): {error:e}");
        }
        for x in [0.0, 1.0, -1e5, 1e300] {
            for order in [1000, u32::MAX] {
                assert_eq!(crate::DualNumber::variable(x).stumpff(order).derivative, 0.0);
            }
        }
        assert!(Real::stumpff(f64::NAN, 1000).is_nan());
    }

    #[test]
    fn both_branches_agree_at_their_seam() {
        for order in 0..6_u32 {
            let seam = f64::from((order + 1) * (order + 2));
            for x in [seam, -seam] {
                let difference = stumpff_series(x, order) / stumpff_recursion(x, order) - 1.0;
                // c₀(2) = cos √2 is small against its terms: a few units are lost.
                assert!(difference.abs() < 64.0 * f64::EPSILON, "{order} {x} {difference:e}");
            }
        }
    }

    #[test]
    fn nan_is_never_below_and_never_dropped() {
        assert!(!f64::NAN.all_below(f64::INFINITY));
        assert!(larger(f64::NAN, 1.0).is_nan() && larger(1.0, f64::NAN).is_nan());
        assert_eq!(larger(1.0, 2.0), 2.0);
    }
}
