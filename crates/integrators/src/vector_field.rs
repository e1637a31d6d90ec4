//! Vector fields: what a scheme integrates.

use core::marker::PhantomData;
use lie_poisson::{Hamiltonian, Point, PoissonSpace, Real, Vector};
use momentum_map::{CollectiveHamiltonian, PoissonMap, SourcePoint};

/// An autonomous vector field ż = X(z), over the scalar `T`.
pub trait VectorField<T: Real = f64> {
    /// z
    type Point: Vector<Scalar = T>;

    /// X(z)
    fn at(&self, z: &Self::Point) -> Self::Point;
}

/// The collective vector field X_{h∘M} on the source of M.
impl<M, H, T> VectorField<T> for CollectiveHamiltonian<M, H>
where
    M: PoissonMap,
    H: Hamiltonian<M::Target, T>,
    T: Real,
{
    type Point = SourcePoint<M, T>;

    #[inline]
    fn at(&self, z: &Self::Point) -> Self::Point {
        self.vector_field(z)
    }
}

/// The Hamiltonian vector field X_h = Λ dh on a Poisson space, such as the Lie–Poisson equations
/// μ̇ = ad∗_{dh} μ on 𝔤∗ with the minus bracket.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HamiltonianField<P, H> {
    /// The space with its bracket.
    pub space: P,
    /// h
    pub hamiltonian: H,
}

impl<P, H, T> VectorField<T> for HamiltonianField<P, H>
where
    P: PoissonSpace,
    H: Hamiltonian<P, T>,
    T: Real,
{
    type Point = Point<P, T>;

    #[inline]
    fn at(&self, z: &Self::Point) -> Self::Point {
        self.space.hamiltonian_vector::<T>(z, &self.hamiltonian.differential(z))
    }
}

/// The vector field of a closure.
///
/// ```
/// use collective_integrators::{VectorField, from_fn};
/// use nalgebra::Vector2;
/// let oscillator = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
/// assert_eq!(oscillator.at(&Vector2::new(1.0, 2.0)), Vector2::new(2.0, -1.0));
/// ```
pub fn from_fn<V: Vector, F: Fn(&V) -> V>(field: F) -> FromFn<V, F> {
    FromFn { field, point: PhantomData }
}

/// See [`from_fn`].
#[derive(Clone, Copy, Debug)]
pub struct FromFn<V, F> {
    field: F,
    point: PhantomData<fn() -> V>,
}

impl<T: Real, V: Vector<Scalar = T>, F: Fn(&V) -> V> VectorField<T> for FromFn<V, F> {
    type Point = V;

    #[inline]
    fn at(&self, z: &V) -> V {
        (self.field)(z)
    }
}
