//! A run of a Lie–Poisson system, row by row.

use super::system_algebra::SystemAlgebra;
use super::system_integrator::{SystemMethod, SystemTask};
use crate::Error;
use crate::runs::moment::{Coordinates, Saved};
use crate::runs::pace::Pace;
use collective_integrators::Start;
use heavytop::methods::{Formulation, Scheme};
use lie_poisson::Vector;
use lie_poisson_formulas::Formula;
use nalgebra::SVector;

/// A Lie–Poisson system, its initial state, and the method and steps of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemExperiment {
    algebra: SystemAlgebra,
    hamiltonian: Formula,
    casimirs: Vec<Formula>,
    start: Vec<f64>,
    method: SystemMethod,
    pace: Pace,
}

/// A moment of a run: the step, and the row with the time, the coordinates, h and the Casimirs.
#[derive(Clone, Copy)]
pub struct SystemMoment<'a> {
    /// The number of steps made.
    pub step: u64,
    /// The numbers of the row.
    pub row: &'a [f64],
    state: &'a dyn Coordinates,
}

impl SystemMoment<'_> {
    /// Returns the data from which the run continues after this moment.
    #[must_use]
    pub fn saved(&self) -> Saved {
        Saved { step: self.step, state: self.state.coordinates() }
    }
}

impl SystemExperiment {
    /// Creates the run of a Hamiltonian from a start, with a formulation, a scheme and the tolerance of its stage equations.
    ///
    /// # Errors
    /// If the algebra does not have the formulation with the scheme, or the tolerance is negative or not finite.
    pub fn new(
        algebra: SystemAlgebra,
        (hamiltonian, casimirs): (Formula, Vec<Formula>),
        start: Vec<f64>,
        (formulation, scheme, tolerance): (Formulation, Scheme, f64),
        pace: Pace,
    ) -> Result<Self, Error> {
        let method = SystemMethod { formulation, scheme, tolerance };
        method.require(&algebra)?;
        if !(tolerance >= 0.0 && tolerance.is_finite()) {
            let range = "finite and not negative";
            return Err(Error::OutOfRange { name: "tolerance", range, value: tolerance });
        }
        Ok(Self { algebra, hamiltonian, casimirs, start, method, pace })
    }

    /// Returns the algebra.
    #[must_use]
    pub fn algebra(&self) -> &SystemAlgebra {
        &self.algebra
    }

    /// Returns the Hamiltonian.
    #[must_use]
    pub fn hamiltonian(&self) -> &Formula {
        &self.hamiltonian
    }

    /// Returns the Casimirs that are written.
    #[must_use]
    pub fn casimirs(&self) -> &[Formula] {
        &self.casimirs
    }

    /// Returns the formulation: where the scheme is applied.
    #[must_use]
    pub fn formulation(&self) -> Formulation {
        self.method.formulation
    }

    /// Returns the scheme of the method.
    #[must_use]
    pub fn scheme(&self) -> Scheme {
        self.method.scheme
    }

    /// Returns the steps, and which of them are written.
    #[must_use]
    pub fn pace(&self) -> Pace {
        self.pace
    }

    /// Returns the number of coordinates of the state that the integrator advances.
    ///
    /// # Errors
    /// If there is no such integrator.
    pub fn dimension(&self) -> Result<usize, Error> {
        self.method.integrate(&self.algebra, &self.hamiltonian, &self.start, Dimension)
    }

    /// Passes the rows of the run to `visit`, from the initial one or from the first after a saved one: those that are
    /// written, those of a step whose number is a multiple of [`CHECKPOINT`](collective_integrators::CHECKPOINT), and the
    /// last one.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, `visit` fails, or the saved state does not fit.
    pub fn follow<V>(&self, from: Option<&Saved>, visit: V) -> Result<(), Error>
    where
        V: FnMut(&SystemMoment<'_>) -> Result<(), Error>,
    {
        let task = Follow { experiment: self, from, visit };
        self.method.integrate(&self.algebra, &self.hamiltonian, &self.start, task)
    }

    /// Returns the initial values of h and of the Casimirs.
    #[must_use]
    pub fn initial_invariants(&self) -> Vec<f64> {
        let mut row = Vec::new();
        // The formulas are in as many coordinates as the state is wide.
        match self.algebra.width() {
            3 => self.fill(&mut row, 0.0, &self.start::<3>()),
            6 => self.fill(&mut row, 0.0, &self.start::<6>()),
            10 => self.fill(&mut row, 0.0, &self.start::<10>()),
            _ => self.fill(&mut row, 0.0, &self.start::<15>()),
        }
        row.split_off(self.algebra.dimension() + 1)
    }

    /// Returns the initial state, completed by zeros.
    fn start<const N: usize>(&self) -> SVector<f64, N> {
        Vector::from_coordinates(|i| self.start.get(i).copied().unwrap_or(0.0))
    }

    /// Replaces `row` by the row of a momentum.
    fn fill<M: Vector<Scalar = f64>>(&self, row: &mut Vec<f64>, time: f64, mu: &M) {
        row.clear();
        row.push(time);
        row.extend((0..self.algebra.dimension()).map(|i| mu.coordinate(i)));
        row.push(self.hamiltonian.value(mu));
        row.extend(self.casimirs.iter().map(|casimir| casimir.value(mu)));
    }
}

/// The task of counting the coordinates of a state.
struct Dimension;

impl SystemTask for Dimension {
    type Output = usize;

    fn perform<I>(self, _: &I) -> Result<usize, Error>
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        Ok(I::State::DIM)
    }
}

/// The task of following an experiment.
struct Follow<'a, V> {
    experiment: &'a SystemExperiment,
    from: Option<&'a Saved>,
    visit: V,
}

impl<V: FnMut(&SystemMoment<'_>) -> Result<(), Error>> SystemTask for Follow<'_, V> {
    type Output = ();

    fn perform<I>(mut self, integrator: &I) -> Result<(), Error>
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        let SystemExperiment { start, pace, .. } = self.experiment;
        let (step, steps) = (pace.schedule.step, pace.schedule.steps);
        let start = I::Momentum::from_coordinates(|i| start.get(i).copied().unwrap_or(0.0));
        let (mut trajectory, made) = match self.from {
            None => (integrator.trajectory(&start, step)?, 0),
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
        if self.from.is_some() && made >= steps {
            return Ok(());
        }
        let mut visited = self.from.map_or(0, |_| pace.next_visited(made));
        let (mut following, mut row) = (made, Vec::new());
        while let Some(sample) = trajectory.nth(visited.saturating_sub(following) as usize) {
            let sample = sample.map_err(|source| Error::Integration {
                formulation: self.experiment.formulation().name(),
                scheme: self.experiment.scheme().name(),
                source,
            })?;
            let made = sample.step;
            // The map of the lift of the start equals the start only up to rounding; the start itself is reported.
            let momentum = if made == 0 { &start } else { &sample.momentum };
            self.experiment.fill(&mut row, sample.time, momentum);
            (self.visit)(&SystemMoment { step: made, row: &row, state: &sample.state })?;
            if made >= steps {
                break;
            }
            following = made.saturating_add(1);
            visited = pace.next_visited(made);
        }
        Ok(())
    }
}
