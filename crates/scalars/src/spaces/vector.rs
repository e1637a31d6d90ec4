//! Vectors of finite-dimensional real vector spaces, given by their coordinates, and how they become states:
//! [`Vector`].

use crate::numbers::mask::Mask;
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
/// A type of your own implements this trait, and [`state_by_value!`](crate::state_by_value) derives from it what
/// integrators need. A vector whose dimension is known only when the program runs implements [`State`] alone.
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

    /// Returns the i-th coordinate, or zero for i ≥ DIM.
    fn coordinate(&self, i: usize) -> Self::Scalar;

    /// Returns the block of the i-th coordinate, a number below [`BLOCKS`](State::BLOCKS).
    ///
    /// ```
    /// use generic_scalars::{Covector, Pair, State, Vector};
    /// use nalgebra::Vector3;
    /// type Momentum = Covector<Pair<Vector3<f64>, Vector3<f64>>>; // (Π, Γ)
    /// assert_eq!(Momentum::BLOCKS, 2);
    /// assert_eq!([0, 2, 3, 5].map(Momentum::block), [0, 0, 1, 1]);
    /// ```
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn block(_i: usize) -> usize {
        0
    }

    /// Returns the multiple s v.
    #[must_use]
    fn scaled(&self, s: Self::Scalar) -> Self;

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

    /// Adds a multiple of another vector: v ← v + s x.
    #[cfg_attr(optimised, inline(always))]
    fn add_scaled(&mut self, s: Self::Scalar, x: &Self) {
        *self += x.scaled(s);
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

    /// Returns whether every coordinate is a finite number in every lane.
    #[cfg_attr(optimised, inline(always))]
    fn is_finite(&self) -> bool {
        self.max_norm().at_most(Self::Scalar::from_f64(f64::MAX)).all()
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

/// Implements [`State`] for a small type by means of its operations as a [`Vector`](crate::Vector).
///
/// The arguments are the generic parameters of the implementation in brackets, the type, its scalar and its
/// [blocks](State::Blocks).
///
/// # Example
/// ```
/// use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};
/// use generic_scalars::{Covector, State, Vector, state_by_value};
///
/// /// A length on a line.
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// struct Length(f64);
/// # impl Add for Length { type Output = Self; fn add(self, x: Self) -> Self { Self(self.0 + x.0) } }
/// # impl Sub for Length { type Output = Self; fn sub(self, x: Self) -> Self { Self(self.0 - x.0) } }
/// # impl Neg for Length { type Output = Self; fn neg(self) -> Self { Self(-self.0) } }
/// # impl AddAssign for Length { fn add_assign(&mut self, x: Self) { self.0 += x.0 } }
/// # impl SubAssign for Length { fn sub_assign(&mut self, x: Self) { self.0 -= x.0 } }
/// // with Add, Sub, Neg, AddAssign, SubAssign
/// impl Vector for Length {
///     type Dual = Covector<Self>;
///     const DIM: usize = 1;
///     fn from_coordinates(mut f: impl FnMut(usize) -> f64) -> Self { Self(f(0)) }
///     fn coordinate(&self, i: usize) -> f64 { if i == 0 { self.0 } else { 0.0 } }
///     fn scaled(&self, s: f64) -> Self { Self(s * self.0) }
/// }
/// state_by_value!([] Length, f64, (f64,));
///
/// let mut x = Length(1.0);
/// x.add_multiple(0.5, &Length(4.0));
/// assert_eq!(x, Length(3.0));
/// ```
#[macro_export]
macro_rules! state_by_value {
    ([$($parameters:tt)*] $type:ty, $scalar:ty, $blocks:ty) => {
        impl<$($parameters)*> $crate::State for $type {
            type Scalar = $scalar;
            type Blocks = $blocks;
            type Shape = ();
            type Pool = ();

            #[cfg_attr(optimised, inline(always))]
            fn dimension(&self) -> usize {
                <Self as $crate::Vector>::DIM
            }

            #[cfg_attr(optimised, inline(always))]
            fn shape(&self) {}

            #[cfg_attr(optimised, inline(always))]
            fn zeros_of((): &()) -> Self {
                <Self as $crate::Vector>::zero()
            }

            #[cfg_attr(optimised, inline(always))]
            fn take((): &mut (), _: &Self) -> Self {
                <Self as $crate::Vector>::zero()
            }

            #[cfg_attr(optimised, inline(always))]
            fn give(self, (): &mut ()) {}

            #[cfg_attr(optimised, inline(always))]
            fn assign(&mut self, x: &Self) {
                *self = *x;
            }

            #[cfg_attr(optimised, inline(always))]
            fn move_from(&mut self, other: &mut Self) {
                *self = *other;
            }

            #[cfg_attr(optimised, inline(always))]
            fn entry(&self, i: usize) -> $scalar {
                $crate::Vector::coordinate(self, i)
            }

            #[cfg_attr(optimised, inline(always))]
            fn set_entry(&mut self, i: usize, x: $scalar) {
                *self = $crate::Vector::from_coordinates(
                    #[cfg_attr(optimised, inline(always))]
                    |j| if i == j { x } else { $crate::Vector::coordinate(self, j) },
                );
            }

            #[cfg_attr(optimised, inline(always))]
            fn set_entries(&mut self, f: impl Fn(usize) -> $scalar) {
                *self = $crate::Vector::from_coordinates(f);
            }

            #[cfg_attr(optimised, inline(always))]
            fn block_of(&self, i: usize) -> usize {
                <Self as $crate::Vector>::block(i)
            }

            #[cfg_attr(optimised, inline(always))]
            fn set_zero(&mut self) {
                *self = $crate::Vector::zero();
            }

            #[cfg_attr(optimised, inline(always))]
            fn add_in_place(&mut self, x: &Self) {
                *self += *x;
            }

            #[cfg_attr(optimised, inline(always))]
            fn subtract_in_place(&mut self, x: &Self) {
                *self -= *x;
            }

            #[cfg_attr(optimised, inline(always))]
            fn subtract_from(&mut self, x: &Self) {
                *self = *x - *self;
            }

            #[cfg_attr(optimised, inline(always))]
            fn scale_in_place(&mut self, s: $scalar) {
                *self = $crate::Vector::scaled(self, s);
            }

            #[cfg_attr(optimised, inline(always))]
            fn add_multiple(&mut self, s: $scalar, x: &Self) {
                $crate::Vector::add_scaled(self, s, x);
            }

            #[cfg_attr(optimised, inline(always))]
            fn replace_where(&mut self, mask: <$scalar as $crate::Real>::Mask, x: &Self) {
                *self = $crate::Vector::select(mask, x, self);
            }

            #[cfg_attr(optimised, inline(always))]
            fn measure(&self, largest: &mut $blocks, sum: &mut $scalar) {
                for i in 0..<Self as $crate::Vector>::DIM {
                    let block = <Self as $crate::Vector>::block(i);
                    let size = $crate::Real::magnitude($crate::Vector::coordinate(self, i));
                    let most = $crate::Blocks::at(largest, block);
                    $crate::Blocks::set(largest, block, $crate::Real::maximum(size, most));
                    *sum += size;
                }
            }

            #[cfg_attr(optimised, inline(always))]
            fn measure_difference(&self, x: &Self, largest: &mut $blocks, sum: &mut $scalar) {
                $crate::State::measure(&(*self - *x), largest, sum);
            }

            #[cfg_attr(optimised, inline(always))]
            fn all_finite(&self) -> bool {
                $crate::Vector::is_finite(self)
            }
        }
    };
}
