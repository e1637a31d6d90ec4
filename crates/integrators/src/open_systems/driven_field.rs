//! Orbit fields with the time as a coordinate: [`DrivenField`].

use crate::vector_field::VectorField;
use lie_poisson::{InTime, OrbitField, Pair, Point, PoissonSpace, Real, Time};

/// The vector field dμ/dt = Λ(μ) ξ(μ, t), dt/dt = 1 of an orbit field ξ, with states (μ, t).
///
/// Any scheme integrates it; in general it does not conserve the Casimirs, which [`Driven`](crate::Driven) does.
///
/// # Example
/// The field ξ = cos t e₃ turns a spin by the angle −sin t:
/// ```
/// use collective_integrators::{Direct, DrivenField, RungeKutta, Start};
/// use lie_poisson::{Covector, LiePoisson, OrbitField, Pair, Real, So3, Time};
/// use nalgebra::Vector3;
/// struct Turn;
/// impl<T: Real> OrbitField<LiePoisson<So3>, T> for Turn {
///     fn element(&self, _: &Covector<Vector3<T>>, time: T) -> Vector3<T> {
///         Vector3::new(T::zero(), T::zero(), time.cos())
///     }
/// }
/// let field = DrivenField { space: LiePoisson::minus(So3), field: Turn };
/// let start = Pair(Covector(Vector3::x()), Time(0.0));
/// let Pair(Covector(pi), Time(t)) = Direct::new(RungeKutta::gauss(4)?, field).after(&start, 0.1, 20)?.momentum;
/// let angle = t.sin();
/// assert!((pi - Vector3::new(angle.cos(), -angle.sin(), 0.0)).norm() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DrivenField<P, X> {
    /// The Poisson space with its bracket.
    pub space: P,
    /// The field ξ(μ, t).
    pub field: X,
}

impl<P, X, T> VectorField<T> for DrivenField<P, X>
where
    P: PoissonSpace,
    X: OrbitField<P, T>,
    T: Real,
{
    type Point = Point<InTime<P>, T>;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, Pair(mu, t): &Self::Point) -> Self::Point {
        let xi = self.field.element(mu, t.0);
        Pair(self.space.hamiltonian_vector::<T>(mu, &xi), Time(T::one()))
    }
}
