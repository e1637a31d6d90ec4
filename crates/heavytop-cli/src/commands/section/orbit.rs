//! The orbit of one start: its points on the section.

use super::settings::Settings;
use crate::Error;
use crate::supervision::TileOptions;
use crate::supervision::tiled_run::interrupted;
use collective_integrators::Start;
use heavytop::methods::Task;
use lie_poisson::{Se3Dual, Vector};
use nalgebra::Vector2;

/// A point of a Poincaré section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// The time of the crossing, s; 0 for the start itself.
    pub time: f64,
    /// The state (Π, Γ) at the crossing.
    pub mu: Se3Dual,
    /// The coordinates (x, y) in the plane of the section.
    pub plane: Vector2<f64>,
}

/// The start of an orbit and its returns to the section.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Orbit {
    /// The number of the start, from 1.
    pub number: usize,
    /// The points of the orbit; the start comes first.
    pub crossings: Vec<Crossing>,
}

/// Follows a start, and returns its orbit, with the error if it could not be followed to the end.
///
/// Starts are independent of each other, so that no bit depends on the number of threads.
pub(super) fn orbit(
    settings: &Settings,
    options: &TileOptions<'_>,
    number: usize,
    start: &Se3Dual,
) -> (Orbit, Option<Error>) {
    let mut orbit = Orbit { number, crossings: Vec::new() };
    let task = Follow { settings, options, start, orbit: &mut orbit };
    let followed = settings.method.integrate(&settings.section.level().top, task);
    let failure = followed.map_err(Error::from).flatten().err();
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
    type Output = Result<(), Error>;

    fn perform<I: Start<State: Vector, Momentum = Se3Dual>>(
        self,
        integrator: &I,
    ) -> Result<(), Error> {
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
