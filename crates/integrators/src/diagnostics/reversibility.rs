//! The symmetry of an integrator in time.

use crate::error::StepError;
use crate::integrators::trajectories::integrator::Integrator;
use lie_poisson::{BlockScales, Real, State};

/// Returns |Φ₋ₕ(Φₕ(z)) − z| relative to the size of z: the defect of one step forwards and one step back.
///
/// It is round-off for symmetric methods, and of order hᵖ⁺¹ for other methods of order p. It is NaN if a difference is
/// NaN. The momenta μ are compared, since states are defined only up to a motion along fibres. For
/// [`Direct`](crate::Direct) integrators μ is the state. The defect is the largest over the [blocks](State::BLOCKS) of
/// μ, such as Π and Γ, of the length of the difference divided by that of the block of μ before or after the step,
/// whichever is larger. It does not depend on units. Over SIMD lanes it is the largest over all lanes.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed., Def. V.1.4.
///
/// # Errors
/// Returns the [`StepError`] of a step that fails.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::reversibility_defect;
/// use collective_integrators::{Direct, RungeKutta, from_fn};
/// use nalgebra::Vector2;
/// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
/// let defect = |s| reversibility_defect(&Direct::new(s, pendulum), &Vector2::new(1.0, 0.5), 0.1);
/// assert!(defect(RungeKutta::implicit_midpoint())? < 1e-15);
/// assert!(defect(RungeKutta::rk4())? > 1e-9);
/// # Ok::<(), collective_integrators::StepError>(())
/// ```
pub fn reversibility_defect<T: Real, I: Integrator<T>>(
    integrator: &I,
    state: &I::State,
    step: f64,
) -> Result<f64, StepError> {
    let mut workspace = integrator.workspace();
    let there = integrator.step(state, step, &mut workspace)?.point;
    let back = integrator.step(&there, -step, &mut workspace)?.point;
    let (mut apart, mu) = (integrator.momentum(&back), integrator.momentum(state));
    let mut sizes = BlockScales::of(&mu);
    sizes.include(&integrator.momentum(&there));
    apart.subtract_in_place(&mu);
    Ok(sizes.largest(&apart).max_abs())
}
