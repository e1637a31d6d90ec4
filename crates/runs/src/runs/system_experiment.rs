//! The run of a Lie–Poisson system whose Hamiltonian is a formula: [`SystemExperiment`].

use super::method_warning::system_warning;
use super::pace::Pace;
use super::run::{Described, Fill, Run};
use super::schedule::Schedule;
use crate::RunFailure;
use collective_integrators::diagnostics::{RunAccuracy, StepCheck};
use collective_integrators::{AnyIntegrator, AnyState, RunError};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, SystemMethod};
use serde_json::{Map, Value};
use std::ops::Range;

/// A Lie–Poisson system, its initial state, and the method and steps of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemExperiment {
    /// The system that is followed.
    pub system: FormulaSystem,
    /// The coordinates of the initial state.
    pub start: Vec<f64>,
    /// The integrator of the run.
    pub method: SystemMethod,
    /// The steps of the run, and which of them are written.
    pub pace: Pace,
}

impl SystemExperiment {
    /// Returns the names of the columns of the Casimirs.
    fn casimirs(&self) -> impl Iterator<Item = String> {
        (1..=self.system.casimirs().len()).map(|i| format!("c{i}"))
    }
}

impl Run for SystemExperiment {
    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        let coordinates = self.system.algebra().coordinates();
        let names: Vec<String> = coordinates.names().collect();
        let columns = |places: Range<usize>| names.get(places).unwrap_or_default().to_vec();
        coordinates.groups().map(|(name, places)| (name.to_owned(), columns(places))).collect()
    }

    fn conserved(&self) -> Vec<String> {
        ["h".to_owned()].into_iter().chain(self.casimirs()).collect()
    }

    fn initial(&self) -> Result<Vec<f64>, RunFailure> {
        Ok(self.system.invariants(&self.start)?)
    }

    fn has_attitude(&self) -> bool {
        false
    }

    fn method(&self) -> (Formulation, SchemeName) {
        (self.method.formulation(), self.method.scheme())
    }

    fn pace(&self) -> Pace {
        self.pace
    }

    fn begin(&self) -> Result<(AnyIntegrator, AnyState), RunFailure> {
        let integrator = self.method.integrator(&self.system, &self.start)?;
        Ok((integrator.without_tangents(), AnyState::from_slice(&self.start)))
    }

    fn rows(&self) -> Box<Fill<'_>> {
        Box::new(|row, sample| {
            let (time, mu) = (sample.time, sample.momentum.as_slice());
            row.clear();
            row.push(time);
            row.extend_from_slice(mu);
            let invariants = self.system.invariants(mu);
            row.extend(
                invariants
                    .map_err(|reason| RunFailure::NoValue { time, reason: Box::new(reason) })?,
            );
            Ok(())
        })
    }

    fn accuracy(&self, going: &dyn Fn() -> bool) -> Result<RunAccuracy, RunFailure> {
        let Schedule { step, steps } = self.pace.schedule;
        Ok(self.method.accuracy(&self.system, &self.start, (step, steps), going)?)
    }

    fn compared(
        &self,
        going: &dyn Fn() -> bool,
    ) -> Result<Result<Option<StepCheck>, RunError>, RunFailure> {
        let Schedule { step, steps } = self.pace.schedule;
        Ok(self.method.check(&self.system, &self.start, (step, steps), going)?)
    }

    fn warning(&self) -> Result<Option<String>, RunFailure> {
        system_warning(&self.method, &self.system, &self.start)
    }

    fn described(&self) -> Result<Described, RunFailure> {
        let formulas = self.system.casimirs().iter().map(|casimir| casimir.to_string().into());
        Ok(Described {
            algebra: Some(self.system.algebra().name().into()),
            hamiltonian: Some(self.system.hamiltonian().to_string()),
            descends: Some(self.method.descends(&self.system, &self.start)?),
            casimirs: Some(self.casimirs().zip(formulas).collect()),
        })
    }

    fn last(&self, row: &[f64]) -> Map<String, Value> {
        let names = self.system.algebra().coordinates().names();
        let last: Map<_, _> = names.zip(row.iter().skip(1).map(|&x| x.into())).collect();
        [("last".to_owned(), last.into())].into_iter().collect()
    }
}
