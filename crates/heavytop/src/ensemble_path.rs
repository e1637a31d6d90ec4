//! What an ensemble does with a top that its lanes cannot advance.

use collective_integrators::{IntegrationError, Integrator, Start, StepError};
use lie_poisson::Se3Dual;

/// The state by `steps` steps, or as far as they go.
#[cold]
pub(crate) fn advance_one<I>(
    integrator: &I,
    state: &mut Se3Dual,
    step: f64,
    steps: u64,
) -> Result<(), IntegrationError>
where
    I: Integrator<Momentum = Se3Dual> + Start,
{
    let error = |n: u64, source| IntegrationError { step: n, time: (n - 1) as f64 * step, source };
    let mut workspace = integrator.workspace();
    let mut z = integrator.start(state).map_err(|_| error(1, StepError::NotFinite))?;
    for n in 1..=steps {
        z = integrator.step(&z, step, &mut workspace).map_err(|source| error(n, source))?.point;
        *state = integrator.momentum(&z);
    }
    Ok(())
}
