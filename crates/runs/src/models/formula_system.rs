//! The model of a system whose Hamiltonian is a formula.

use super::conserved::Conserved;
use super::model::Model;
use crate::error::RunFailure;
use collective_integrators::diagnostics::{InvariantSize, SystemScales};
use collective_integrators::{AnyIntegrator, AnyTangents};
use core::ops::Range;
use heavytop::methods::Method;
use lie_poisson_formula_systems::{FormulaSystem, ScalarFunction};

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

    fn integrator(&self, method: &Method, start: &[f64]) -> Result<AnyIntegrator, RunFailure> {
        Ok(self.integrator(method, start)?)
    }

    fn formula(&self, conserved: &str) -> Option<String> {
        let names = Invariants(self).names();
        names
            .iter()
            .zip(self.conserved_functions())
            .find(|(name, _)| *name == conserved)
            .map(|(_, f)| f.to_string())
    }

    fn descends(&self, method: &Method, start: &[f64]) -> Result<bool, RunFailure> {
        Ok(self.descends(method, start)?)
    }

    fn warning_of_end(&self, start: &[f64], end: &[f64]) -> Option<String> {
        let size = |formula: &dyn ScalarFunction, state: &[f64]| {
            let mut size = InvariantSize::new(self.blocks());
            size.include(state, &formula.differential_at(state));
            size.size()
        };
        let names = Invariants(self).names();
        let lost = names.iter().zip(self.conserved_functions()).find_map(|(name, formula)| {
            let (value, [before, after]) =
                (formula.value_at(start).abs(), [start, end].map(|state| size(formula, state)));
            let rounding = f64::EPSILON * after;
            let is_lost = rounding > MOST_ROUNDING * value && after > GROWN * before;
            (is_lost && value > 0.0).then_some((name, value, after, rounding))
        });
        lost.map(|(name, value, size, rounding)| {
            format!(
                "warning: {name}, of size {value:.1e}, is at the end a difference of terms of {size:.0e}, and rounding \
                 alone changes it by {rounding:.0e}: what depends on it is not right there; end the run earlier"
            )
        })
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

/// The rounding error of a conserved quantity, relative to its value, from which on users are warned.
const MOST_ROUNDING: f64 = 1e-4;

/// The factor by which the terms of a conserved quantity must have grown. What is small from the start on, as Π·Γ may be, has
/// not lost its digits along the motion.
const GROWN: f64 = 1e4;

/// The Hamiltonian and the Casimirs of a system.
struct Invariants<'a>(&'a FormulaSystem);

impl Conserved for Invariants<'_> {
    fn names(&self) -> Vec<String> {
        let casimirs = (1..=self.0.casimirs().len()).map(|i| format!("c{i}"));
        ["h".to_owned()].into_iter().chain(casimirs).collect()
    }

    fn append(&self, _time: f64, momentum: &[f64], values: &mut Vec<f64>) {
        values.extend(self.0.conserved_functions().map(|function| function.value_at(momentum)));
    }

    /// Names the formula, its part without a value, and the state.
    fn without_value(&self, _time: f64, momentum: &[f64]) -> String {
        let invariants = self.0.invariants(momentum);
        invariants.map_or_else(|reason| reason.to_string(), |_| "an invariant is not finite".into())
    }
}
