//! Finite-dimensional real vector spaces, by their coordinates.

use crate::{Blocks, Real};
use core::fmt::Debug;
use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};

/// A vector of a real vector space V of fixed dimension, with a standard basis e₀, …, e_{DIM−1}.
///
/// Elements of a Lie algebra, momenta in its dual, points of a phase space and group elements
/// (which live in a space of matrices) are all vectors in this sense. Implemented for nalgebra's
/// statically sized matrices over [`Real`] and over `Complex<Real>` (real and imaginary parts
/// alternate, so that C² ≅ R⁴ is χ = (q₁+iq₂, q₃+iq₄)), for [`Covector`](crate::Covector), [`Pair`](crate::Pair),
/// [`Power`](crate::Power) and [`Quaternion`](crate::Quaternion).
///
/// The dual V∗ is a different type, paired by coordinates: ⟨α, v⟩ = Σ αᵢ vᵢ.
///
/// # Example
/// ```
/// use generic_scalars::{Covector, Vector};
/// use nalgebra::Vector3;
/// let velocity = Vector3::new(1.0, 2.0, 3.0);
/// let momentum = Covector(Vector3::new(0.0, 0.5, 1.0));
/// assert_eq!(momentum.pairing(&velocity), 4.0);
/// ```
pub trait Vector:
    Copy
    + Debug
    + PartialEq
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// The real numbers in use.
    type Scalar: Real;

    /// The dual space V∗; V∗∗ = V.
    type Dual: Vector<Scalar = Self::Scalar, Dual = Self>;

    /// dim V over the reals.
    const DIM: usize;

    /// One number for each block of coordinates: `(Self::Scalar,)` where all coordinates have one unit and one
    /// scale, a pair for the two parts of a vector such as (q, p), whose units differ.
    ///
    /// Where numbers are judged small or large, as in the convergence tests of implicit methods, each block is
    /// compared with itself, so that no result depends on units.
    type Blocks: Blocks<Self::Scalar>;

    /// The number of blocks of coordinates.
    const BLOCKS: usize = <Self::Blocks as Blocks<Self::Scalar>>::COUNT;

    /// Σ f(i) eᵢ. `f` is called once for each i = 0, …, DIM−1, in this order.
    fn from_coordinates(f: impl FnMut(usize) -> Self::Scalar) -> Self;

    /// The i-th coordinate; zero for i ≥ DIM.
    fn coordinate(&self, i: usize) -> Self::Scalar;

    /// The block of the i-th coordinate, a number below [`BLOCKS`](Self::BLOCKS).
    ///
    /// ```
    /// use generic_scalars::{Covector, Pair, Vector};
    /// use nalgebra::Vector3;
    /// type Momentum = Covector<Pair<Vector3<f64>, Vector3<f64>>>; // (Π, Γ)
    /// assert_eq!(Momentum::BLOCKS, 2);
    /// assert_eq!([0, 2, 3, 5].map(Momentum::block), [0, 0, 1, 1]);
    /// ```
    #[must_use]
    #[inline(always)]
    fn block(_i: usize) -> usize {
        0
    }

    /// s v.
    #[must_use]
    fn scaled(&self, s: Self::Scalar) -> Self;

    /// 0 ∈ V.
    #[must_use]
    #[inline]
    fn zero() -> Self {
        Self::from_coordinates(|_| num_traits::zero())
    }

    /// The basis vector eᵢ; zero for i ≥ DIM.
    #[must_use]
    #[inline]
    fn basis(i: usize) -> Self {
        Self::from_coordinates(|j| if i == j { num_traits::one() } else { num_traits::zero() })
    }

    /// v ← v + s x.
    #[inline]
    fn add_scaled(&mut self, s: Self::Scalar, x: &Self) {
        *self += x.scaled(s);
    }

    /// The natural pairing ⟨α, v⟩ = Σ αᵢ vᵢ, which is symmetric in the roles of V and V∗.
    #[inline]
    fn pairing(&self, dual: &Self::Dual) -> Self::Scalar {
        let mut sum: Self::Scalar = num_traits::zero();
        for i in 0..Self::DIM {
            sum += self.coordinate(i) * dual.coordinate(i);
        }
        sum
    }

    /// The maximum norm ‖v‖_∞ = max |vᵢ|, lane by lane; NaN where any coordinate is.
    #[inline]
    fn max_norm(&self) -> Self::Scalar {
        let (mut most, mut sum): (Self::Scalar, Self::Scalar) =
            (num_traits::zero(), num_traits::zero());
        for i in 0..Self::DIM {
            let size = self.coordinate(i).magnitude();
            most = size.maximum(most);
            sum += size;
        }
        // The sum keeps a NaN that the maximum loses.
        Real::select(sum.at_most(sum), most, sum)
    }

    /// max |vᵢ| over coordinates and lanes; NaN if any is NaN.
    #[inline]
    fn max_abs(&self) -> f64 {
        self.max_norm().max_abs()
    }

    /// `yes` in the lanes in which the mask is true, `no` in the others, bit for bit.
    #[must_use]
    #[inline]
    fn select(mask: <Self::Scalar as Real>::Mask, yes: &Self, no: &Self) -> Self {
        Self::from_coordinates(|i| Real::select(mask, yes.coordinate(i), no.coordinate(i)))
    }

    /// Whether every coordinate is a finite number, in every lane.
    #[inline]
    fn is_finite(&self) -> bool {
        self.max_abs().is_finite()
    }
}

/// The vector of `W` with coordinates f(v₀), f(v₁), …: a change of scalar or of type that
/// respects the bases. Missing coordinates are zero, surplus ones are dropped.
///
/// # Example
/// ```
/// use generic_scalars::{DualNumber, map_coordinates};
/// use nalgebra::Vector2;
/// let x: Vector2<DualNumber> = map_coordinates(&Vector2::new(1.0, 2.0), DualNumber::constant);
/// assert_eq!(x.y.value, 2.0);
/// ```
#[inline]
pub fn map_coordinates<V: Vector, W: Vector>(v: &V, f: impl Fn(V::Scalar) -> W::Scalar) -> W {
    W::from_coordinates(|i| f(v.coordinate(i)))
}
