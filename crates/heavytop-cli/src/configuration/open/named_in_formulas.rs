//! Inputs that some formula must name.

use super::element::{Element, parts};
use crate::configuration::Config;
use crate::errors::SystemTableError;
use lie_poisson_formulas::names_in;
use std::collections::BTreeSet;

impl Config {
    /// Checks that a formula names each of the inputs, which would do nothing otherwise: the Hamiltonian, the drive, the torque, the
    /// noise, a function of `[events]`, or the surface or an axis of `[section]`. A formula such as `0*u` names u, too.
    ///
    /// # Errors
    /// If none does.
    pub(super) fn require_named_inputs(&self) -> Result<(), SystemTableError> {
        let Some(inputs) = self.inputs.as_ref().filter(|inputs| !inputs.is_empty()) else {
            return Ok(());
        };
        let named: BTreeSet<String> =
            self.formulas().iter().flat_map(|text| names_in(text)).collect();
        let is_named = |input: &String| names_in(input).iter().all(|name| named.contains(name));
        match inputs.keys().find(|input| !is_named(input)) {
            Some(input) => Err(SystemTableError::UnnamedInput { input: input.clone() }),
            None => Ok(()),
        }
    }

    /// Returns the texts of all formulas that may name inputs.
    fn formulas(&self) -> Vec<String> {
        let noise = self.noise.iter().flat_map(|noise| &noise.fields);
        let elements: Vec<&Element> = self.drive.iter().chain(&self.torque).chain(noise).collect();
        let of_elements = elements.into_iter().flat_map(parts).flat_map(|(_, texts)| texts);
        let hamiltonian = self.system.iter().filter_map(|system| system.hamiltonian.clone());
        let events = self.events.iter().flat_map(|events| events.functions.iter().cloned());
        let surface = self.section.iter().filter_map(|section| section.surface.clone());
        let axes = self.section.iter().filter_map(|section| section.axes.clone()).flatten();
        of_elements.chain(hamiltonian).chain(events).chain(surface).chain(axes).collect()
    }
}
