//! A Hamiltonian system without special structure: [`GenericSystem`].

use crate::vector_field::HamiltonianField;
use lie_poisson::{Automatic, Covector, Energy, Real, RealSpace};
use momentum_map::{Cotangent, CotangentBundle};
use nalgebra::Vector2;

/// A Hamiltonian system on T∗R² that is not separable and has no symmetry:
///
/// ```text
/// H(q, p) = ½(q₁² + 1)(p₁² + 1) + ½p₂² + ½q₂² + ⅒q₂⁴ + ³⁄₁₀ q₁q₂p₂
/// ```
///
/// [`MeasuredScheme`](super::MeasuredScheme) measures a scheme on it.
///
/// # Example
/// ```
/// use collective_integrators::{VectorField, laws::GenericSystem};
/// let z = GenericSystem::start::<f64>();
/// // dq₂/dt = p₂ + ³⁄₁₀ q₁q₂
/// assert_eq!(GenericSystem::field().at(&z).q.y, 0.6 + 0.3 * 0.3 * -0.4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GenericSystem;

impl GenericSystem {
    /// Returns the phase space T∗R² with dq ∧ dp.
    #[must_use]
    pub const fn space() -> CotangentBundle<RealSpace<2>> {
        CotangentBundle(RealSpace)
    }

    /// Creates the Hamiltonian vector field dq/dt = ∂H/∂p, dp/dt = −∂H/∂q, over every scalar.
    #[must_use]
    pub const fn field() -> HamiltonianField<CotangentBundle<RealSpace<2>>, Automatic<Self>> {
        HamiltonianField { space: Self::space(), hamiltonian: Automatic(Self) }
    }

    /// Returns the point q = (0.3, −0.4), p = (0.5, 0.6), from which schemes are measured.
    #[must_use]
    pub fn start<T: Real>() -> Cotangent<Vector2<T>> {
        let vector = |x, y| Vector2::new(T::from_f64(x), T::from_f64(y));
        Cotangent::new(vector(0.3, -0.4), Covector(vector(0.5, 0.6)))
    }
}

impl Energy for GenericSystem {
    type Space = CotangentBundle<RealSpace<2>>;

    fn energy<T: Real>(&self, z: &Cotangent<Vector2<T>>) -> T {
        let (q, Covector(p)) = (&z.q, &z.p);
        let square = |x: T| x * x;
        (square(q.x) + 1.0) * (square(p.x) + 1.0) * 0.5
            + square(p.y) * 0.5
            + square(q.y) * 0.5
            + square(square(q.y)) * 0.1
            + q.x * q.y * p.y * 0.3
    }
}
