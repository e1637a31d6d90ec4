//! The samples of a run that are visited, whatever its integrator.

use super::moment::Saved;
use super::pace::Pace;
use super::schedule::Schedule;
use crate::Error;
use collective_integrators::{Integrator, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::Vector;

/// Passes the step, the time, the momentum and the state of samples to `visit`: from the start on, or from the first one
/// after a saved state, those that the pace visits.
///
/// # Errors
/// If the start has no lift, the saved state does not fit, a step fails, or `visit` fails.
pub(super) fn visit_samples<I, V>(
    integrator: &I,
    start: &<I as Integrator>::Momentum,
    (pace, from): (Pace, Option<&Saved>),
    (formulation, scheme): (Formulation, SchemeName),
    mut visit: V,
) -> Result<(), Error>
where
    I: Start<State: Vector>,
    V: FnMut(u64, f64, &I::Momentum, &I::State) -> Result<(), Error>,
{
    let Schedule { step, steps } = pace.schedule;
    let (mut trajectory, made) = match from {
        None => (integrator.trajectory(start, step)?, 0),
        Some(Saved { step: made, state }) => {
            let (expected, found) = (I::State::DIM, state.len());
            if expected != found {
                return Err(Error::SavedState { expected, found });
            }
            let coordinate = |i: usize| state.get(i).copied().unwrap_or(f64::NAN);
            let state = I::State::from_coordinates(coordinate);
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
        visit(made, sample.time, &sample.momentum, &sample.state)?;
        if made >= steps {
            break;
        }
        following = made.saturating_add(1);
        visited = pace.next_visited(made);
    }
    Ok(())
}
