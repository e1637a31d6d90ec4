//! The run of a top: [`Experiment`].

use super::method_warning::method_warning;
use super::pace::Pace;
use super::run::{Described, Fill, Run, visit_samples};
use super::schedule::Schedule;
use crate::RunFailure;
use collective_integrators::diagnostics::{RunAccuracy, StepCheck};
use collective_integrators::{AnyIntegrator, AnyState, RunError};
use heavytop::methods::{Formulation, Method, SchemeName, attitude_of};
use heavytop::{HeavyTop, Invariant, PrincipalAxes, attitude_of_vertical};
use lie_poisson::{Covector, Pair, Quaternion, Se3Dual, Vector};
use serde_json::{Map, Value};

/// A top, its initial state, and the method and steps of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// The top that is followed, in its principal axes.
    pub top: HeavyTop,
    /// The principal axes, in the axes of the output.
    pub axes: PrincipalAxes,
    /// The initial state (Π(0), Γ(0)), in the principal axes.
    pub start: Se3Dual,
    /// The integrator of the run.
    pub method: Method,
    /// The steps of the run, and which of them are written.
    pub pace: Pace,
    /// Whether the attitude is followed.
    pub attitude: bool,
}

impl Experiment {
    /// Passes moments of the run to `visit`, those of [`follow`](trait@Run#method.follow): the number of the step, the
    /// time (s), (Π, Γ) and the attitude, if it is followed, of the principal axes. The initial state comes first.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, `visit` fails, or the formulation does not determine the attitude
    /// that is asked for.
    pub fn run<E: From<RunFailure>, V>(&self, mut visit: V) -> Result<(), E>
    where
        V: FnMut(u64, f64, &Se3Dual, Option<&Quaternion>) -> Result<(), E>,
    {
        visit_samples(self, None, &mut |sample| {
            let attitude = self.attitude.then(|| attitude_of(sample.state.as_slice()));
            let momentum = momentum_of(sample.momentum.as_slice());
            visit(sample.step, sample.time, &momentum, attitude.as_ref())
        })
    }

    /// Returns the invariants that are columns of their own.
    fn invariants(&self) -> Vec<Invariant> {
        let mut invariants = self.top.invariants_from(&self.start);
        // f₃ is a component of Π in principal axes, which is a column already if these are the axes of the columns.
        if self.axes.is_aligned() && self.top.axial_component().is_some() {
            invariants.retain(|invariant| *invariant != Invariant::AxialMomentum);
        }
        invariants
    }
}

impl Run for Experiment {
    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        let vector = |name: &str| (name.into(), (1..=3).map(|i| format!("{name}{i}")).collect());
        vec![vector("Pi"), vector("Gamma")]
    }

    fn conserved(&self) -> Vec<String> {
        self.invariants().into_iter().map(|invariant| invariant.symbol().into()).collect()
    }

    fn initial(&self) -> Result<Vec<f64>, RunFailure> {
        Ok(self.invariants().into_iter().map(|f| f.value(&self.top, &self.start)).collect())
    }

    fn has_attitude(&self) -> bool {
        self.attitude
    }

    fn method(&self) -> (Formulation, SchemeName) {
        (self.method.formulation(), self.method.scheme())
    }

    fn pace(&self) -> Pace {
        self.pace
    }

    fn begin(&self) -> Result<(AnyIntegrator, AnyState), RunFailure> {
        let formulation = self.method.formulation();
        let integrator = match self.attitude {
            true => self
                .method
                .integrator_with_attitude(&self.top)?
                .ok_or(RunFailure::NoAttitude { formulation })?,
            false => self.method.integrator(&self.top)?,
        };
        Ok((integrator, AnyState::of(&self.start)))
    }

    /// The axes of the rows are those in which the top was given.
    fn rows(&self) -> Box<Fill<'_>> {
        let (axes, invariants) = (&self.axes, self.invariants());
        let turned = !axes.is_aligned();
        let turn = turn_about_the_vertical(axes, &self.start);
        Box::new(move |row, sample| {
            let momentum = momentum_of(sample.momentum.as_slice());
            let Covector(Pair(pi, gamma)) =
                if turned { axes.state_from_principal(&momentum) } else { momentum };
            row.clear();
            row.extend([sample.time, pi.x, pi.y, pi.z, gamma.x, gamma.y, gamma.z]);
            row.extend(invariants.iter().map(|f| f.value(&self.top, &momentum)));
            if self.attitude {
                let q = attitude_of(sample.state.as_slice());
                let q = if turned { turn * axes.attitude_from_principal(&q) } else { q };
                row.extend([q.scalar, q.vector.x, q.vector.y, q.vector.z]);
            }
            Ok(())
        })
    }

    fn accuracy(&self, going: &dyn Fn() -> bool) -> Result<RunAccuracy, RunFailure> {
        let Schedule { step, steps } = self.pace.schedule;
        Ok(self.method.accuracy(&self.top, &self.start, (step, steps), going)?)
    }

    fn compared(
        &self,
        going: &dyn Fn() -> bool,
    ) -> Result<Result<Option<StepCheck>, RunError>, RunFailure> {
        let Schedule { step, steps } = self.pace.schedule;
        Ok(self.method.check(&self.top, &self.start, (step, steps), going)?)
    }

    fn warning(&self) -> Result<Option<String>, RunFailure> {
        Ok(method_warning(&self.method))
    }

    fn described(&self) -> Result<Described, RunFailure> {
        Ok(Described::default())
    }

    fn last(&self, row: &[f64]) -> Map<String, Value> {
        let vector = |from: usize| row.get(from..from + 3).unwrap_or_default().into();
        [("angular_momentum", vector(1)), ("vertical", vector(4))]
            .map(|(name, values)| (name.to_owned(), values))
            .into_iter()
            .collect()
    }
}

/// Returns (Π, Γ) of its coordinates.
fn momentum_of(coordinates: &[f64]) -> Se3Dual {
    Vector::from_coordinates(|i| coordinates.get(i).copied().unwrap_or(f64::NAN))
}

/// Returns the turn about the vertical that takes the attitude of the columns, where that of the principal axes is the
/// shortest one, to the shortest one.
fn turn_about_the_vertical(axes: &PrincipalAxes, start: &Se3Dual) -> Quaternion {
    let given = axes.state_from_principal(start);
    let shortest = axes.attitude_from_principal(&attitude_of_vertical(&start.0.1));
    attitude_of_vertical(&given.0.1) * shortest.conjugate()
}
