//! Events of a run, which are zeros of functions of the momentum and the time: [`EventFunctions`].

use super::timed_integrator::{TimedIntegrator, TimedState};
use crate::error::RunFailure;
use crate::runs::experiment::Experiment;
use crate::runs::schedule::Schedule;
use collective_integrators::{AnyIntegrator, Direction, EventError, EventSearch, SampleOf, Start};
use core::ops::ControlFlow;
use lie_poisson::Pair;
use lie_poisson_formulas::Formula;

/// Functions of the momentum and the time whose zeros are found along a run, to the accuracy of the integrator.
///
/// An event is where a function goes to zero and changes its sign. A touch is none, and neither are jumps, poles and a start
/// on zero. A function that is an [angle](Formula::period) is zero once per turn.
#[derive(Clone, Debug, PartialEq)]
pub struct EventFunctions {
    /// The functions, of the coordinates in the axes of the users, and of what follows them: the time, s, and inputs
    /// ([`Model::append_inputs`](crate::Model::append_inputs)). A function may know the first of these names alone.
    pub functions: Vec<Formula>,
    /// The direction in which they pass zero, along the run.
    pub direction: Direction,
}

impl EventFunctions {
    /// Passes the events of a run to `visit` in the order in which they happen: the place of the function, and the
    /// [row](Experiment::follow) of the moment. The run ends where `visit` breaks it. Before, `step` is called with the number
    /// of each step.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, a function or a conserved quantity has no value, or `step` or `visit`
    /// fails.
    ///
    /// # Example
    /// A spherical pendulum in a vertical plane hangs straight down once in half a period of 2π√(l/g) = 2π, for small swings.
    /// ```
    /// use collective_integrators::Direction;
    /// use core::ops::ControlFlow;
    /// use heavytop::HeavyTop;
    /// use heavytop::methods::Method;
    /// use lie_poisson::Se3;
    /// use lie_poisson_formulas::{Formula, Parameters, Vocabulary};
    /// use lie_poisson_runs::{EventFunctions, Experiment, Model, Pace, RunFailure, Schedule, TopInAxes};
    /// let model = TopInAxes::from(HeavyTop::lagrange(1.0, 1.0, 1.0)?);
    /// let run = Experiment {
    ///     start: model.start(&[0.0, 0.0, 0.0, 1e-4, 0.0, -1.0])?,
    ///     method: Method::new("collective".parse()?, "gauss-8".parse()?, 0.0)?,
    ///     pace: Pace { schedule: Schedule::new(0.1, 20.0)?, every: 1 },
    ///     attitude: false,
    ///     model,
    /// };
    /// let names = Vocabulary::of(&Se3::default(), &Parameters::new())?;
    /// let functions = vec![Formula::new("Gamma1", &names)?];
    /// let (events, mut times) = (EventFunctions { functions, direction: Direction::Both }, Vec::new());
    /// events.follow(&run, |_| Ok(()), |_, row| -> Result<_, RunFailure> {
    ///     times.push(row[0]);
    ///     Ok(ControlFlow::Continue(()))
    /// })?;
    /// assert_eq!(times.len(), 6);
    /// assert!(times.windows(2).all(|pair| (pair[1] - pair[0] - std::f64::consts::PI).abs() < 1e-8));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn follow<E: From<RunFailure>>(
        &self,
        run: &Experiment,
        mut step: impl FnMut(u64) -> Result<(), E>,
        mut visit: impl FnMut(usize, &[f64]) -> Result<ControlFlow<()>, E>,
    ) -> Result<(), E> {
        let (integrator, start) = run.begin()?;
        let timed = TimedIntegrator::new(&integrator);
        let functions = self.functions.iter();
        let mut searches: Vec<_> =
            functions.map(|function| self.search(function, run, &timed)).collect();
        let (mut fill, mut row) = (run.rows(), Vec::new());
        let Schedule { step: size, steps } = run.pace.schedule;
        let samples = integrator.trajectory(&start, size).map_err(RunFailure::from)?;
        for sample in samples.take(usize::try_from(steps).unwrap_or(usize::MAX).saturating_add(1)) {
            let sample = sample.map_err(|reason| RunFailure::of_step(&run.method, reason))?;
            step(sample.step)?;
            let mut found: Vec<(usize, SampleOf<AnyIntegrator>)> = Vec::new();
            let sample = TimedIntegrator::sample(&sample);
            for (place, search) in searches.iter_mut().enumerate() {
                let events = search.observe(&sample);
                let events =
                    events.map_err(|error| self.failed(run, (place, sample.time), error))?;
                let events = events.into_iter().flatten().map(TimedIntegrator::untimed);
                found.extend(events.map(|event| (place, event)));
            }
            found.sort_by(|(_, one), (_, other)| one.time.abs().total_cmp(&other.time.abs()));
            for (place, event) in &found {
                fill(&mut row, event)?;
                if visit(*place, &row)?.is_break() {
                    return Ok(());
                }
            }
        }
        Ok(())
    }

    /// Returns the search for the zeros of one of the functions.
    fn search<'a>(
        &self,
        function: &'a Formula,
        run: &'a Experiment,
        integrator: &'a TimedIntegrator<'a>,
    ) -> EventSearch<'a, TimedIntegrator<'a>, impl Fn(&TimedState) -> f64 + use<'a>> {
        let value = |Pair(mu, time): &TimedState| {
            let mut x = mu.as_slice().to_vec();
            run.model.present(&mut x);
            run.model.append_inputs(time.0, &mut x);
            function.value_at(x.get(..function.dimension()).unwrap_or(&x))
        };
        let search = EventSearch::new(integrator, value, self.direction);
        match function.period() {
            Some(period) => search.modulo(period),
            None => search,
        }
    }

    /// Returns the error of a search in the step to this time.
    fn failed(
        &self,
        run: &Experiment,
        (place, end): (usize, f64),
        error: EventError,
    ) -> RunFailure {
        let function = self.functions.get(place).map(Formula::to_string).unwrap_or_default();
        match error {
            EventError::Integration(reason) => RunFailure::of_step(&run.method, reason),
            EventError::NotANumber { time } => RunFailure::NoEvent { function, time },
            _ => RunFailure::NoEvent { function, time: end },
        }
    }
}
