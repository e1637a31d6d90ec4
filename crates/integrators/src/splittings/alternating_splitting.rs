//! Two exact flows by turns, with any coefficients.

use crate::{AlternatingSubsteps, ExactFlows, Integrator, StateIsMomentum, Step, StepError};
use lie_poisson::Real;

/// The exact flows of two parts, run by turns for the fractions of the step that
/// [`AlternatingSubsteps`] gives:
///
/// ```text
/// Ψ_h = φ_2^{b_m h} ∘ φ_1^{a_m h} ∘ … ∘ φ_2^{b_1 h} ∘ φ_1^{a_1 h}
/// ```
///
/// It fails only where the result is not finite. Of flows beyond the second no use is made.
///
/// # Example
/// ```
/// use collective_integrators::{AlternatingSplitting, AlternatingSubsteps, ExactFlows, Start};
/// use nalgebra::Vector2;
///
/// /// The pendulum: q̇ = p, then ṗ = −sin q.
/// struct Pendulum;
/// impl ExactFlows for Pendulum {
///     type Point = Vector2<f64>;
///     const COUNT: usize = 2;
///     fn flow(&self, index: usize, t: f64, z: &Vector2<f64>) -> Vector2<f64> {
///         match index {
///             0 => Vector2::new(z.x + t * z.y, z.y),
///             1 => Vector2::new(z.x, z.y - t * z.x.sin()),
///             _ => *z,
///         }
///     }
/// }
/// let energy = |z: &Vector2<f64>| 0.5 * z.y * z.y - z.x.cos();
/// let scheme = AlternatingSplitting::new(Pendulum, AlternatingSubsteps::blanes_moan6());
/// let z = Vector2::new(1.0, 0.0);
/// for sample in scheme.trajectory(&z, 0.2)?.take(100) {
///     assert!((energy(&sample?.state) - energy(&z)).abs() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AlternatingSplitting<E> {
    flows: E,
    substeps: AlternatingSubsteps,
}

impl<E> AlternatingSplitting<E> {
    /// The flows with these coefficients.
    pub const fn new(flows: E, substeps: AlternatingSubsteps) -> Self {
        Self { flows, substeps }
    }

    /// The flows.
    pub const fn flows(&self) -> &E {
        &self.flows
    }

    /// The coefficients.
    pub const fn substeps(&self) -> &AlternatingSubsteps {
        &self.substeps
    }
}

impl<T: Real, E: ExactFlows<T>> Integrator<T> for AlternatingSplitting<E> {
    type State = E::Point;
    type Momentum = E::Point;
    type Workspace = ();

    fn workspace(&self) {}

    #[inline]
    fn step(&self, z: &E::Point, step: f64, (): &mut ()) -> Result<Step<E::Point>, StepError> {
        let flow = |index: usize, fraction: f64, z: E::Point| {
            if fraction == 0.0 { z } else { self.flows.flow(index, fraction * step, &z) }
        };
        let (a, b) = (self.substeps.first(), self.substeps.second());
        let point = a.iter().zip(b).fold(*z, |z, (&a, &b)| flow(1, b, flow(0, a, z)));
        Step { point, iterations: 0 }.finite()
    }

    fn momentum(&self, z: &E::Point) -> E::Point {
        *z
    }
}

impl<E> StateIsMomentum for AlternatingSplitting<E> {}
