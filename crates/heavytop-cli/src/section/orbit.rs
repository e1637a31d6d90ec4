//! The points of one start.

use super::settings::Settings;
use crate::Error;
use crate::integrators::Task;
use collective_integrators::Start;
use lie_poisson::Se3Dual;
use nalgebra::Vector2;
use rayon::prelude::*;

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
#[derive(Debug)]
pub(super) struct Orbit {
    /// The start comes first.
    pub crossings: Vec<Crossing>,
    /// Why it could not be followed further.
    pub failure: Option<Error>,
}

/// All starts with their returns, in order; `done` is told of each, on any thread.
///
/// Starts know nothing of each other, so that no bit depends on the number of threads.
pub(super) fn orbits(
    settings: &Settings,
    starts: &[Se3Dual],
    done: impl Fn() + Sync,
) -> Result<Vec<Orbit>, Error> {
    let follow = |(index, start): (usize, &Se3Dual)| {
        let task = Follow { settings, number: index + 1, start };
        let orbit = settings.method.integrate(&settings.section.level().top, task);
        done();
        orbit
    };
    let orbits: Vec<Result<Orbit, Error>> = starts.par_iter().enumerate().map(follow).collect();
    orbits.into_iter().collect()
}

/// The task of following a start.
struct Follow<'a> {
    settings: &'a Settings,
    /// From 1.
    number: usize,
    start: &'a Se3Dual,
}

impl Task for Follow<'_> {
    type Output = Orbit;

    fn perform<I: Start<Momentum = Se3Dual>>(self, integrator: &I) -> Result<Orbit, Error> {
        let Self { settings: Settings { section, method, step, steps, .. }, number, start } = self;
        let crossing = |time: f64, mu: Se3Dual| Crossing { time, mu, plane: section.plane(&mu) };
        let mut crossings = vec![crossing(0.0, *start)];
        let returns = section.crossings(integrator, start, *step, *steps)?;
        for event in returns.take(self.settings.crossings) {
            match event {
                Ok(sample) => crossings.push(crossing(sample.time, sample.momentum)),
                Err(source) => {
                    let formulation = method.formulation().name();
                    let scheme = method.scheme().name();
                    let failure = Error::Crossing { formulation, scheme, start: number, source };
                    return Ok(Orbit { crossings, failure: Some(failure) });
                }
            }
        }
        Ok(Orbit { crossings, failure: None })
    }
}
