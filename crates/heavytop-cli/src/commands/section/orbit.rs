//! The points of one start.

use super::settings::Settings;
use crate::Error;
use crate::runs::Task;
use crate::supervision::TileOptions;
use crate::supervision::tiled_run::interrupted;
use collective_integrators::Start;
use lie_poisson::Se3Dual;
use nalgebra::Vector2;

/// A point of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// When, s; 0 for the start itself.
    pub time: f64,
    /// (Π, Γ)
    pub mu: Se3Dual,
    /// (x, y)
    pub plane: Vector2<f64>,
}

/// A start and its returns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Orbit {
    /// The number of the start, from 1.
    pub number: usize,
    /// The start comes first.
    pub crossings: Vec<Crossing>,
}

/// A start with its returns, and why it could not be followed further if it could not.
///
/// Starts know nothing of each other, so that no bit depends on the number of threads.
pub(super) fn orbit(
    settings: &Settings,
    options: &TileOptions<'_>,
    number: usize,
    start: &Se3Dual,
) -> (Orbit, Option<Error>) {
    let mut orbit = Orbit { number, crossings: Vec::new() };
    let task = Follow { settings, options, start, orbit: &mut orbit };
    let failure = settings.method.integrate(&settings.section.level().top, task).err();
    (orbit, failure)
}

/// The task of following a start.
struct Follow<'a> {
    settings: &'a Settings,
    options: &'a TileOptions<'a>,
    start: &'a Se3Dual,
    orbit: &'a mut Orbit,
}

impl Task for Follow<'_> {
    type Output = ();

    fn perform<I: Start<Momentum = Se3Dual>>(self, integrator: &I) -> Result<(), Error> {
        let Self { settings: Settings { section, method, step, steps, .. }, start, .. } = self;
        let Orbit { number, crossings } = self.orbit;
        let crossing = |time: f64, mu: Se3Dual| Crossing { time, mu, plane: section.plane(&mu) };
        crossings.push(crossing(0.0, *start));
        let returns = section.crossings(integrator, start, *step, *steps)?;
        for event in returns.take(self.settings.crossings) {
            if self.options.stopped() {
                return Err(interrupted());
            }
            let sample = event.map_err(|source| Error::Crossing {
                formulation: method.formulation().name(),
                scheme: method.scheme().name(),
                start: *number,
                source,
            })?;
            crossings.push(crossing(sample.time, sample.momentum));
        }
        Ok(())
    }
}
