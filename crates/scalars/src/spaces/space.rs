//! Vector spaces as families over the scalars.

use crate::{Real, Vector};
use nalgebra::SVector;
use num_complex::Complex;

/// z ∈ P over the scalar `T`.
pub type Point<P, T = f64> = <P as VectorSpace>::Point<T>;

/// A covector on P, such as a differential dh(z), over the scalar `T`.
pub type Differential<P, T = f64> = <Point<P, T> as Vector>::Dual;

/// A real vector space, known over every scalar at once: what a formula that is generic over
/// [`Real`] is defined on.
///
/// ```
/// use generic_scalars::{DualNumber, Point, RealSpace};
/// let z: Point<RealSpace<2>> = nalgebra::Vector2::new(1.0, 2.0);
/// let w: Point<RealSpace<2>, DualNumber> = z.map(DualNumber::variable);
/// # assert_eq!(w.y.value, 2.0);
/// ```
pub trait VectorSpace: Clone {
    /// A point over the scalar `T`.
    type Point<T: Real>: Vector<Scalar = T>;
}

/// R^N.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RealSpace<const N: usize>;

impl<const N: usize> VectorSpace for RealSpace<N> {
    type Point<T: Real> = SVector<T, N>;
}

/// C^N as a real vector space of dimension 2N, with ⟨ψ, χ⟩ = Re(ψ∗χ).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ComplexSpace<const N: usize>;

impl<const N: usize> VectorSpace for ComplexSpace<N> {
    type Point<T: Real> = SVector<Complex<T>, N>;
}
