//! Vectors of finite-dimensional real vector spaces, which compute by value: [`Vector`].

use crate::numbers::real::Real;
use crate::spaces::state::State;
use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};

/// A vector of a real vector space V of fixed dimension, with a standard basis e₀, e₁, ….
///
/// Elements of a Lie algebra, momenta in its dual, points of a phase space and group elements (which live in a space
/// of matrices) are all vectors in this sense. The trait is implemented for nalgebra's statically sized matrices over
/// [`Real`] and over `Complex<Real>`, and for [`Covector`](crate::Covector), [`Pair`](crate::Pair),
/// [`Power`](crate::Power) and [`Quaternion`](crate::Quaternion). Complex coordinates alternate between real and
/// imaginary parts, so that C² ≅ R⁴ is χ = (q₁+iq₂, q₃+iq₄).
///
/// The dual V∗ is a different type, paired by coordinates: ⟨α, v⟩ = Σ αᵢ vᵢ.
///
/// The operations in place are those of [`State`]. A structure of vectors of your own becomes a vector in three steps:
/// [`state_of_parts!`](crate::state_of_parts) or an implementation of [`State`],
/// [`vector_operators!`](crate::vector_operators), and the three items of this trait. A vector whose dimension is known
/// only when the program runs implements [`State`] alone.
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
    State + Copy + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> + AddAssign + SubAssign
{
    /// The dual space V∗, whose dual is V again.
    type Dual: Vector<Scalar = Self::Scalar, Dual = Self>;

    /// The dimension of V over the reals.
    const DIM: usize;

    /// Creates Σ f(i) eᵢ; `f` is called once for each i = 0, …, DIM−1, in this order.
    fn from_coordinates(f: impl FnMut(usize) -> Self::Scalar) -> Self;

    /// Returns the multiple s v.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn scaled(&self, s: Self::Scalar) -> Self {
        let mut v = *self;
        v.scale_in_place(s);
        v
    }

    /// Returns the zero vector.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn zero() -> Self {
        Self::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |_| num_traits::zero(),
        )
    }

    /// Returns the basis vector eᵢ, or zero for i ≥ DIM.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn basis(i: usize) -> Self {
        Self::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |j| if i == j { num_traits::one() } else { num_traits::zero() },
        )
    }

    /// Returns the natural pairing ⟨α, v⟩ = Σ αᵢ vᵢ, which is symmetric in the roles of V and V∗.
    #[cfg_attr(optimised, inline(always))]
    fn pairing(&self, dual: &Self::Dual) -> Self::Scalar {
        let mut sum: Self::Scalar = num_traits::zero();
        for i in 0..Self::DIM {
            sum += self.coordinate(i) * dual.coordinate(i);
        }
        sum
    }

    /// Returns the maximum norm max |vᵢ| in each SIMD lane; NaN where any coordinate is NaN.
    #[cfg_attr(optimised, inline(always))]
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

    /// Returns max |vᵢ| over all coordinates and lanes, or NaN if any of them is NaN.
    #[cfg_attr(optimised, inline(always))]
    fn max_abs(&self) -> f64 {
        self.max_norm().max_abs()
    }

    /// Returns `yes` in the lanes in which the mask is true, and `no` in the others, bit for bit.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn select(mask: <Self::Scalar as Real>::Mask, yes: &Self, no: &Self) -> Self {
        Self::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| Real::select(mask, yes.coordinate(i), no.coordinate(i)),
        )
    }
}

/// Creates the vector of `W` with coordinates f(v₀), f(v₁), …, to change the scalar or the type.
///
/// The bases correspond to each other. Missing coordinates are zero, and surplus ones are ignored.
///
/// # Example
/// ```
/// use generic_scalars::{DualNumber, map_coordinates};
/// use nalgebra::Vector2;
/// let x: Vector2<DualNumber> = map_coordinates(&Vector2::new(1.0, 2.0), DualNumber::constant);
/// assert_eq!(x.y.value_without_derivative(), 2.0);
/// ```
#[cfg_attr(optimised, inline(always))]
pub fn map_coordinates<V: Vector, W: Vector>(v: &V, f: impl Fn(V::Scalar) -> W::Scalar) -> W {
    W::from_coordinates(
        #[cfg_attr(optimised, inline(always))]
        |i| f(v.coordinate(i)),
    )
}
