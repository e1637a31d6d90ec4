//! Vector spaces that exist over every scalar: [`VectorSpace`].

use crate::numbers::real::Real;
use crate::spaces::vector::Vector;
use nalgebra::SVector;
use num_complex::Complex;

/// A point z of the space P over the scalar `T`.
pub type Point<P, T = f64> = <P as VectorSpace>::Point<T>;

/// A covector on the space P, such as a differential dh(z), over the scalar `T`.
pub type Differential<P, T = f64> = <Point<P, T> as Vector>::Dual;

/// A real vector space that exists over every scalar at once, as the domain of formulas over [`Real`].
///
/// ```
/// use generic_scalars::{DualNumber, Point, RealSpace};
/// let z: Point<RealSpace<2>> = nalgebra::Vector2::new(1.0, 2.0);
/// let w: Point<RealSpace<2>, DualNumber> = z.map(DualNumber::variable);
/// # assert_eq!(w.y.value_without_derivative(), 2.0);
/// ```
pub trait VectorSpace: Clone {
    /// The type of a point over the scalar `T`.
    type Point<T: Real>: Vector<Scalar = T>;
}

/// The real vector space R^N.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RealSpace<const N: usize>;

impl<const N: usize> VectorSpace for RealSpace<N> {
    type Point<T: Real> = SVector<T, N>;
}

/// The space C^N as a real vector space of dimension 2N, with ⟨ψ, χ⟩ = Re(ψ∗χ).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ComplexSpace<const N: usize>;

impl<const N: usize> VectorSpace for ComplexSpace<N> {
    type Point<T: Real> = SVector<Complex<T>, N>;
}
