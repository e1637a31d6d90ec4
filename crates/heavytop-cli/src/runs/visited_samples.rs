//! The samples of a run that are visited, whatever its integrator.

use super::moment::Saved;
use super::pace::Pace;
use super::schedule::Schedule;
use crate::Error;
use collective_integrators::{AnyIntegrator, AnyState, Integrator, SampleOf, Start};
use heavytop::methods::{Formulation, SchemeName};

/// Passes samples to `visit`: from the start on, or from the first one after a saved state, those that the pace visits.
///
/// # Errors
/// If the start has no lift, the saved state does not fit, a step fails, or `visit` fails.
pub(super) fn visit_samples(
    integrator: &AnyIntegrator,
    start: &AnyState,
    (pace, from): (Pace, Option<&Saved>),
    (formulation, scheme): (Formulation, SchemeName),
    mut visit: impl FnMut(SampleOf<AnyIntegrator>) -> Result<(), Error>,
) -> Result<(), Error> {
    let Schedule { step, steps } = pace.schedule;
    let (mut trajectory, made) = match from {
        None => (integrator.trajectory(start, step)?, 0),
        Some(Saved { step: made, state }) => {
            let (expected, found) = (integrator.state_dimension(), state.len());
            if expected != found {
                return Err(Error::SavedState { expected, found });
            }
            let state = AnyState::from_slice(state);
            (integrator.trajectory_resumed(state, *made, step), *made)
        }
    };
    if from.is_some() && made >= steps {
        return Ok(());
    }
    // The saved moment has been visited before.
    let mut visited = from.map_or(0, |_| pace.next_visited(made));
    let mut following = made;
    while let Some(sample) = trajectory.nth(visited.saturating_sub(following) as usize) {
        let sample = sample.map_err(|source| Error::Integration {
            formulation: formulation.name(),
            scheme: scheme.name(),
            source,
        })?;
        let made = sample.step;
        visit(sample)?;
        if made >= steps {
            break;
        }
        following = made.saturating_add(1);
        visited = pace.next_visited(made);
    }
    Ok(())
}
