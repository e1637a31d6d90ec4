//! The table `[system]` of a system whose Hamiltonian depends on the time or on inputs.

use super::system_config::{Bracket, SystemConfig};
use crate::errors::Error;
use lie_poisson_formula_systems::{FormulaSystem, KeplerOrbit, NamedInputs, OpenNames, SystemKind};
use lie_poisson_formulas::{Formula, Parameters};

impl SystemConfig {
    /// Returns whether the Hamiltonian depends on the time.
    ///
    /// # Errors
    /// Those of [`orbit`](Self::orbit).
    pub(crate) fn depends_on_time(&self) -> Result<bool, Error> {
        Ok(self.orbit()?.is_some() || self.names_time())
    }

    /// Returns the ellipse on which a system by name goes about a centre, if it goes about one.
    ///
    /// # Errors
    /// If a parameter is missing, or has a value that it cannot have.
    pub(crate) fn orbit(&self) -> Result<Option<KeplerOrbit>, Error> {
        match self.known_kind() {
            Some(kind) => Ok(kind.orbit(&self.parameters()?)?),
            None => Ok(None),
        }
    }

    /// Returns the parameters that formulas may name, with the rate and the tide of a circle about a centre.
    ///
    /// # Errors
    /// Those of [`orbit`](Self::orbit).
    pub(crate) fn named_parameters(&self) -> Result<Parameters, Error> {
        let parameters = self.parameters()?;
        match self.known_kind() {
            Some(kind) => Ok(kind.with_circle(parameters)?),
            None => Ok(parameters),
        }
    }

    /// Returns whether the Hamiltonian depends on the time with some values of a parameter, and with others not.
    pub(crate) fn opens_with(&self, parameter: &str) -> bool {
        self.known_kind().is_some_and(|kind| kind.opens_with(parameter))
    }

    /// Returns the system by formula that the table names, if it is one.
    fn known_kind(&self) -> Option<&'static SystemKind> {
        self.kind.as_ref().and_then(|name| SystemKind::named(name).ok())
    }

    /// Returns whether the formula of the Hamiltonian has the time `t` in it, which is neither a parameter nor a coordinate.
    fn names_time(&self) -> bool {
        let is_part = |c: char| c.is_alphanumeric() || c == '_';
        let mut words = self.hamiltonian.iter().flat_map(|text| text.split(|c| !is_part(c)));
        let is_coordinate = |name: &String| name == NamedInputs::TIME;
        words.any(|word| word == NamedInputs::TIME)
            && !self.parameters.contains_key(NamedInputs::TIME)
            && !self.coordinates.iter().flatten().any(is_coordinate)
    }

    /// Returns the system of the table as it is at t = 0, the names of its formulas, and the Hamiltonian if it depends on the
    /// time or on an input. The Casimirs of an algebra that is the same as that of `near` are not looked for again.
    ///
    /// # Errors
    /// If there is no such system.
    pub(crate) fn open_base(
        &self,
        inputs: &NamedInputs,
        near: Option<&FormulaSystem>,
    ) -> Result<(FormulaSystem, OpenNames, Option<Formula>), Error> {
        let parameters = self.parameters()?;
        if let Some(kind) = self.system_kind()? {
            return Ok(OpenNames::of_kind(kind, parameters, inputs, near)?);
        }
        if let Some(near) = near.map_or(Ok(None), |near| self.near_if_same(near, &parameters))? {
            let names = OpenNames::new(near.algebra().clone(), inputs, parameters)?;
            let (base, hamiltonian) = names.system_near(near, self.hamiltonian()?)?;
            return Ok((base, names, hamiltonian));
        }
        let names = OpenNames::new(self.algebra(&parameters)?, inputs, parameters)?;
        let (base, hamiltonian) = names.system(self.hamiltonian()?)?;
        let base = match self.bracket {
            Some(Bracket::Plus) => base.with_plus_bracket()?,
            _ => base,
        };
        Ok((base.with_found_casimirs()?, names, hamiltonian))
    }
}
