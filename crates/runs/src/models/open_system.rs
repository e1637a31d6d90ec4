//! The model of a system by formula that is driven, damped, noisy or forced.

use super::conserved::Conserved;
use super::model::Model;
use crate::error::RunFailure;
use collective_integrators::{AnyIntegrator, AnyTangents};
use heavytop::methods::Method;
use lie_poisson_formula_systems::OpenSystem;

/// h and the Casimirs, c1, c2, …, have columns; the motion keeps those that its forces do not change.
impl Model for OpenSystem {
    fn algebra_name(&self) -> String {
        self.base().algebra_name()
    }

    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        self.base().coordinates()
    }

    fn conserved(&self, start: &[f64]) -> Box<dyn Conserved + '_> {
        Box::new(Quantities { system: self, names: self.base().conserved(start).names() })
    }

    fn tangent_integrator(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        Ok(self.tangent_integrator(method, start)?)
    }

    /// With noise, paths converge with the strong order, which is 1 at best.
    fn order(&self, method: &Method) -> u16 {
        match self.terms().noise {
            Some(_) => 1,
            None => method.scheme().order(),
        }
    }

    fn noise_angle(&self, start: &[f64], step: f64) -> Option<f64> {
        OpenSystem::noise_angle(self, start, step)
    }

    fn move_path(&self, state: &mut [f64], on: u64) {
        OpenSystem::move_path(self, state, on);
    }

    fn noise(&self) -> Option<(u64, u64)> {
        self.terms().noise.as_ref().map(|noise| (noise.seed, noise.path))
    }

    fn append_inputs(&self, time: f64, x: &mut Vec<f64>) {
        self.terms().inputs.append(time, x);
    }

    fn supplied_rates(&self, time: f64, momentum: &[f64]) -> Option<Vec<f64>> {
        let has_rates = self.terms().noise.is_none();
        has_rates.then(|| self.supplied_rates(momentum, time).ok()).flatten()
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.next_break(time, forward)
    }

    fn formula(&self, conserved: &str) -> Option<String> {
        match (conserved, &self.terms().hamiltonian) {
            ("h", Some(hamiltonian)) => Some(hamiltonian.to_string()),
            _ => self.base().formula(conserved),
        }
    }

    fn descends(&self, method: &Method, _start: &[f64]) -> Result<bool, RunFailure> {
        Ok(self.descends(method)?)
    }
}

/// The energy and the Casimirs of an open system.
struct Quantities<'a> {
    system: &'a OpenSystem,
    names: Vec<String>,
}

impl Conserved for Quantities<'_> {
    fn names(&self) -> Vec<String> {
        self.names.clone()
    }

    fn is_kept(&self, name: &str) -> bool {
        // The energy comes first.
        let casimir = self.names.iter().skip(1).position(|own| own == name);
        match casimir.and_then(|number| self.system.base().casimirs().get(number)) {
            Some(casimir) => self.system.keeps_casimir(casimir),
            None => self.system.keeps_energy(),
        }
    }

    fn append(&self, time: f64, momentum: &[f64], values: &mut Vec<f64>) {
        values.push(self.system.energy(momentum, time));
        let casimirs = self.system.base().casimirs().iter();
        values.extend(casimirs.map(|casimir| casimir.value_at(momentum)));
    }

    fn without_value(&self, time: f64, momentum: &[f64]) -> String {
        let (mut values, names) = (Vec::new(), self.names());
        self.append(time, momentum, &mut values);
        let found = names.iter().zip(&values).find(|(_, value)| !value.is_finite());
        found.map_or("a quantity has no value".into(), |(name, value)| format!("{name} is {value}"))
    }
}
