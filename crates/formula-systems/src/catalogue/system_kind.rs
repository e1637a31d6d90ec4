//! A system by name: [`SystemKind`].

use crate::algebras::system_algebra::SystemAlgebra;
use crate::error::FormulaSystemError;
use crate::systems::formula_system::FormulaSystem;
use lie_poisson_formulas::{Coordinates, Parameters};

/// A system by name: its algebra, its Hamiltonian in parameters, and what they mean.
///
/// # Example
/// ```
/// use lie_poisson_formula_systems::SystemKind;
/// use lie_poisson_formulas::Parameters;
/// let kind = SystemKind::named("body-with-rotors")?;
/// let parameters = Parameters::new().vector("I", &[1.0, 2.0, 3.0])?.vector("J", &[0.1, 0.2])?;
/// let body = kind.system(&parameters)?;
/// // dΠ/dt = Π × Ω; the rotors keep their angular momenta.
/// let rate = body.rate(&[1.0, 0.0, 3.0, 0.5, 0.4])?;
/// let omega = [(1.0 - 0.5) / 1.0, (0.0 - 0.4) / 2.0, 3.0 / 3.0];
/// let expected = [-3.0 * omega[1], 3.0 * omega[0] - omega[2], omega[1], 0.0, 0.0];
/// assert!(rate.iter().zip(expected).all(|(x, y)| (x - y).abs() < 1e-15));
/// assert!(kind.system(&Parameters::new()).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SystemKind {
    /// The name of the system.
    pub name: &'static str,
    /// What the system is, in a few words.
    pub about: &'static str,
    /// The vectors of coordinates with their dimensions; 1 makes a scalar.
    pub coordinates: &'static [(&'static str, usize)],
    /// The brackets of pairs of coordinates that are not zero.
    pub brackets: &'static [(&'static str, &'static str)],
    /// The Hamiltonian, a formula in the coordinates and the parameters.
    pub hamiltonian: &'static str,
    /// The parameters.
    pub parameters: &'static [Parameter],
}

/// A parameter of a system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// The name in the Hamiltonian.
    pub name: &'static str,
    /// The number of components of a vector; `None` for a number.
    pub components: Option<usize>,
    /// What it is, with its unit.
    pub about: &'static str,
}

impl SystemKind {
    /// Returns the system with these parameters, and its Casimirs.
    ///
    /// # Errors
    /// Those of [`require_parameters`](Self::require_parameters).
    pub fn system(&self, parameters: &Parameters) -> Result<FormulaSystem, FormulaSystemError> {
        self.require_parameters(parameters)?;
        let algebra = self.algebra()?;
        FormulaSystem::new(algebra, self.hamiltonian, parameters)?.with_found_casimirs()
    }

    /// Returns the algebra of the system.
    ///
    /// # Errors
    /// If the file of the system describes none.
    pub fn algebra(&self) -> Result<SystemAlgebra, FormulaSystemError> {
        let named = |all: Coordinates, (name, dimension): &(&str, usize)| match dimension {
            1 => all.scalar(name),
            dimension => all.vector(name, *dimension),
        };
        let coordinates = self.coordinates.iter().try_fold(Coordinates::new(), named)?;
        SystemAlgebra::of_brackets(coordinates, self.brackets.iter().copied(), &Parameters::new())
    }

    /// Checks that the parameters are those of the system.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::KindParameter`] if a parameter is missing, has another number of components, or is none
    /// of the system.
    pub fn require_parameters(&self, parameters: &Parameters) -> Result<(), FormulaSystemError> {
        let wrong = |name: &str| FormulaSystemError::KindParameter {
            kind: self.name,
            name: name.to_owned(),
            has: self.parameters.iter().map(Parameter::described).collect(),
        };
        let given: Vec<(&str, Option<usize>)> = parameters.shapes().collect();
        let is_given = |own: &&Parameter| given.contains(&(own.name, own.components));
        if let Some(missing) = self.parameters.iter().find(|own| !is_given(own)) {
            return Err(wrong(missing.name));
        }
        let is_own = |name: &str| self.parameters.iter().any(|own| own.name == name);
        given.iter().find(|(name, _)| !is_own(name)).map_or(Ok(()), |(name, _)| Err(wrong(name)))
    }
}

impl Parameter {
    fn described(&self) -> String {
        let Self { name, components, about } = self;
        let shape = components.map_or_else(String::new, |count| format!(" of {count} numbers"));
        format!("{name}{shape} ({about})")
    }
}
