//! The measurement of errors and computing times.

use crate::errors::Error;
use crate::runs::{Experiment, TopInAxes};
use crate::supervision::Watch;
use collective_integrators::{AnyIntegrator, AnyState, IntegrationError, Start};
use heavytop::methods::{Formulation, Method, SchemeName};
use heavytop::{HeavyTop, Invariant};
use lie_poisson::{BlockScales, Se3Dual, State, Vector, larger};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The largest distance between two references, relative to their size, at which they count as certain.
const CERTAIN: f64 = 1e-11;

/// The time for which a run is repeated in each pass.
const LEAST: Duration = Duration::from_millis(5);

/// The invariants whose deviations are measured: h, f₁ and f₂.
const QUANTITIES: [Invariant; 3] =
    [Invariant::Energy, Invariant::VerticalSquared, Invariant::VerticalMomentum];

/// The reference solution at the end of the interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reference {
    /// The end of the interval, s.
    pub end: f64,
    /// The state (Π, Γ) at the end.
    pub point: Se3Dual,
    /// The largest |Π| and the largest |Γ| of the motion, in whose units errors are measured.
    pub sizes: BlockScales<Se3Dual>,
    /// The distance from the solution with the double step, in these units.
    pub uncertainty: f64,
}

/// A run with its error, its computing time and its deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Measurement {
    /// The integrator of the run.
    pub method: Method,
    /// The time step, s.
    pub step: f64,
    /// The end of the run, s.
    pub end: f64,
    /// The results of the run; all are NaN where a step had no result.
    pub outcome: Outcome,
}

/// The results of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Outcome {
    /// The 2-norm of the error of (Π, Γ) at the end, with Π and Γ relative to the sizes of the motion.
    pub error: f64,
    /// The errors of Π (kg m²/s) and of Γ at the end.
    pub parts: [f64; 2],
    /// The larger of the errors of Π and of Γ, relative to the sizes of the motion.
    pub relative: f64,
    /// Computing time per simulated time: the least of several repetitions.
    pub seconds: f64,
    /// The largest deviations of h, f₁ and f₂.
    pub deviations: [f64; 3],
}

impl Outcome {
    const FAILED: Self = Self {
        error: f64::NAN,
        parts: [f64::NAN; 2],
        relative: f64::NAN,
        seconds: f64::NAN,
        deviations: [f64::NAN; QUANTITIES.len()],
    };

    /// Replaces the computing time by that of another pass if that one is shorter.
    pub fn refine(&mut self, other: &Self) {
        self.seconds = self.seconds.min(other.seconds);
    }
}

impl Reference {
    /// Computes the reference after `steps` steps of the experiment.
    ///
    /// The method is the Gauss method of order 16 without a lift, with half the step of the experiment.
    ///
    /// # Errors
    /// If the result with the whole step differs, or the command shall end.
    pub fn new(
        experiment: &Experiment<TopInAxes>,
        steps: u64,
        watch: &Watch<'_>,
    ) -> Result<Self, Error> {
        let step = experiment.pace.schedule.step;
        let mut sizes = BlockScales::of(&experiment.initial_state());
        let gauss = Method::new(Formulation::Reduced, SchemeName::Gauss(8), 0.0)?;
        let mut end = |halvings: u64| {
            let mut experiment = experiment.clone();
            experiment.method = gauss;
            experiment.attitude = false;
            // The sizes are those of all states.
            experiment.pace.every = 1;
            experiment.pace.schedule.step = step / halvings as f64;
            experiment.pace.schedule.steps = steps * halvings;
            let mut end = experiment.initial_state();
            experiment.run(|_, _, mu, _| {
                end = *mu;
                sizes.include(mu);
                watch.require_going()
            })?;
            Ok::<_, Error>(end)
        };
        let (coarse, point) = (end(1)?, end(2)?);
        let uncertainty = sizes.norm(&(coarse - point));
        if uncertainty <= CERTAIN {
            Ok(Self { end: steps as f64 * step, point, sizes, uncertainty })
        } else {
            Err(Error::Reference { uncertainty, most: CERTAIN })
        }
    }
}

/// What an integrator is measured on.
pub(super) struct Measure<'a> {
    /// The top to follow.
    pub top: &'a HeavyTop,
    /// The initial state (Π(0), Γ(0)).
    pub start: &'a Se3Dual,
    /// The number of steps until the end.
    pub steps: u64,
    /// The reference solution at the end.
    pub reference: &'a Reference,
}

impl Measure<'_> {
    /// Measures the integrator of a method.
    ///
    /// # Errors
    /// If there is no such integrator, or no state represents the start.
    pub(super) fn of(&self, method: &Method) -> Result<Outcome, Error> {
        let integrator = &method.integrator(self.top)?;
        let initial = self.values(self.start);
        let mut deviations = [0.0; QUANTITIES.len()];
        let last = self.follow(integrator, |mu| {
            for ((most, value), initial) in deviations.iter_mut().zip(self.values(mu)).zip(initial)
            {
                *most = larger(*most, (value - initial).abs());
            }
        })?;
        // A run that breaks down has no time to measure.
        let Ok(last) = last else { return Ok(Outcome::FAILED) };

        // The timed run reads (Π, Γ) after each step, as users do, and no more.
        let (begin, mut least) = (Instant::now(), Duration::MAX);
        while least == Duration::MAX || begin.elapsed() < LEAST {
            let run = Instant::now();
            let repeated = self.follow(integrator, |mu| {
                black_box(mu);
            })?;
            least = least.min(run.elapsed());
            black_box(&repeated.is_ok());
        }
        let (error, sizes) = (last - self.reference.point, &self.reference.sizes);
        let parts = BlockScales::of(&error);
        Ok(Outcome {
            error: sizes.norm(&error),
            parts: [parts.at(0), parts.at(1)],
            relative: sizes.largest(&error),
            seconds: least.as_secs_f64() / self.reference.end.abs(),
            deviations,
        })
    }

    fn values(&self, mu: &Se3Dual) -> [f64; QUANTITIES.len()] {
        QUANTITIES.map(|quantity| quantity.value(self.top, mu))
    }

    /// Follows a run to its last (Π, Γ), unless a step fails; `visit` receives every state.
    fn follow(
        &self,
        integrator: &AnyIntegrator,
        mut visit: impl FnMut(&Se3Dual),
    ) -> Result<Result<Se3Dual, IntegrationError>, Error> {
        let step = self.reference.end / self.steps as f64;
        let (mut last, start) = (*self.start, AnyState::of(self.start));
        for sample in integrator.trajectory(&start, step)?.take(self.steps as usize + 1) {
            match sample {
                Ok(sample) => last = Vector::from_coordinates(|i| sample.momentum.coordinate(i)),
                Err(failure) => return Ok(Err(failure)),
            }
            visit(&last);
        }
        Ok(Ok(last))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::Config;
    use std::error::Error as Failure;

    /// Measures methods after 40 steps, with masses, lengths and times in these units: the numbers without a unit, and those
    /// with one in their units.
    fn measured([mass, length, time]: [f64; 3]) -> Result<Vec<[f64; 7]>, Box<dyn Failure>> {
        let moment = mass * length * length;
        let (momentum, energy) = (moment / time, moment / time / time);
        let of = |values: [f64; 3], unit: f64| format!("{:?}", values.map(|x| x * unit));
        let text = format!(
            "initial = {{ angular_momentum = {}, vertical = [0.0, 0.8, 0.6] }}\n\
             integrator = {{ step = {:?}, end = {:?} }}\n\
             [body]\ninertia = {}\nmass = {:?}\ngravity = {:?}\nlength = {:?}\n\
             center_of_mass = [0.6, 0.0, 0.8]",
            of([1.2, -0.7, 2.3], momentum),
            0.05 * time,
            2.0 * time,
            of([1.0, 1.4, 2.1], moment),
            0.7 * mass,
            9.81 * length / time / time,
            0.2 * length,
        );
        let experiment = toml::from_str::<Config>(&text)?.experiment()?;
        let (top, start, steps) = (&experiment.model.top, &experiment.initial_state(), 40);
        let reference = Reference::new(&experiment, steps, &Watch::default())?;
        let mut found = Vec::new();
        for (formulation, scheme) in [
            (Formulation::Direct, SchemeName::Rk4),
            (Formulation::Direct, SchemeName::ExplicitMidpoint),
            (Formulation::Collective, SchemeName::Rk4),
        ] {
            let method = Method::new(formulation, scheme, 0.0)?;
            let task = Measure { top, start, steps, reference: &reference };
            let Outcome { error, parts: [pi, gamma], relative, deviations: [h, f1, f2], .. } =
                task.of(&method)?;
            found.push([error, relative, pi / momentum, gamma, h / energy, f1, f2 / momentum]);
        }
        Ok(found)
    }

    #[test]
    fn errors_are_the_same_in_all_units() -> Result<(), Box<dyn Failure>> {
        let reference = measured([1.0; 3])?;
        let sizes = [1e-30, 1e-15, 1e-6, 1e6, 1e15, 1e30];
        for units in sizes.into_iter().flat_map(|s| [[s, 1.0, 1.0], [1.0, s, 1.0], [1.0, 1.0, s]]) {
            for (found, reference) in measured(units)?.iter().zip(&reference) {
                // All of them are errors above 1e-8, where rounding changes them by 1e-7.
                let near = |(a, b): (&f64, &f64)| (a / b - 1.0).abs() < 1e-5;
                assert!(found.iter().zip(reference).all(near), "{units:?} {found:?} {reference:?}");
            }
        }
        Ok(())
    }

    /// Control: the norm of the error of all six numbers is that of Π in the one unit, and that of Γ in the other.
    #[test]
    fn the_norm_of_all_coordinates_depends_on_units() -> Result<(), Box<dyn Failure>> {
        let norm = |mass: f64| -> Result<f64, Box<dyn Failure>> {
            let [_, _, pi, gamma, ..] = measured([mass, 1.0, 1.0])?[0];
            Ok((pi * mass).hypot(gamma) / mass.hypot(1.0))
        };
        assert!((norm(1e-9)? / norm(1e9)? - 1.0).abs() > 0.01);
        Ok(())
    }
}
