//! The model of a system whose Hamiltonian is a formula.

use super::conserved::Conserved;
use super::model::Model;
use crate::error::RunFailure;
use collective_integrators::{AnyIntegrator, AnyTangents};
use core::ops::Range;
use heavytop::methods::Method;
use lie_poisson_formula_systems::FormulaSystem;

/// h and the Casimirs, c1, c2, …, are conserved.
impl Model for FormulaSystem {
    fn algebra_name(&self) -> String {
        self.algebra().name().into()
    }

    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        let coordinates = self.algebra().coordinates();
        let names: Vec<String> = coordinates.names().collect();
        let columns = |places: Range<usize>| names.get(places).unwrap_or_default().to_vec();
        coordinates.groups().map(|(name, places)| (name.to_owned(), columns(places))).collect()
    }

    fn conserved(&self, _start: &[f64]) -> Box<dyn Conserved + '_> {
        Box::new(Invariants(self))
    }

    fn tangent_integrator(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        Ok(self.tangent_integrator(method, start)?)
    }

    fn formula(&self, conserved: &str) -> Option<String> {
        let names = Invariants(self).names();
        let formulas = core::iter::once(self.hamiltonian()).chain(self.casimirs());
        names.iter().zip(formulas).find(|(name, _)| *name == conserved).map(|(_, f)| f.to_string())
    }

    fn descends(&self, method: &Method, start: &[f64]) -> Result<bool, RunFailure> {
        Ok(self.descends(method, start)?)
    }

    fn warning(&self, method: &Method, start: &[f64]) -> Result<Option<String>, RunFailure> {
        Ok((!self.descends(method, start)?).then(|| {
            format!(
                "warning: the steps of {}, {} by the Clebsch map of {} are not Poisson maps: the Casimirs are \
                 conserved to the order of the scheme alone",
                method.formulation(),
                method.scheme(),
                self.algebra().name()
            )
        }))
    }
}

/// The Hamiltonian and the Casimirs of a system.
struct Invariants<'a>(&'a FormulaSystem);

impl Conserved for Invariants<'_> {
    fn names(&self) -> Vec<String> {
        let casimirs = (1..=self.0.casimirs().len()).map(|i| format!("c{i}"));
        ["h".to_owned()].into_iter().chain(casimirs).collect()
    }

    fn append(&self, momentum: &[f64], values: &mut Vec<f64>) {
        values.push(self.0.hamiltonian().value_at(momentum));
        values.extend(self.0.casimirs().iter().map(|casimir| casimir.value_at(momentum)));
    }

    /// Names the formula, its part without a value, and the state.
    fn without_value(&self, momentum: &[f64]) -> String {
        let invariants = self.0.invariants(momentum);
        invariants.map_or_else(|reason| reason.to_string(), |_| "an invariant is not finite".into())
    }
}
