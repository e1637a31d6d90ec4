//! The table `[system]`: its keys, and the run that they ask for.

use super::numbers::Numbers;
use super::table_file::{is_table, read_table};
use crate::configuration::{Integration, IntegratorConfig};
use crate::errors::{Error, SystemTableError};
use crate::runs::{Experiment, Pace, Schedule};
use heavytop::methods::Formulation;
use lie_poisson_formula_systems::{
    FormulaSystem, FormulaSystemError, QuadraticMomenta, SystemAlgebra, SystemKind,
    matrices_of_rows, structure_table,
};
use lie_poisson_formulas::{Coordinates, Parameters};
use lie_poisson_runs::ArrayKind;
use lie_poisson_runs::step_angle::require_run;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The table `[system]`: a Lie algebra, a Hamiltonian on its dual, and the state at t = 0.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SystemConfig {
    /// The name of a system of the library, which has an algebra and a Hamiltonian.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kind: Option<String>,
    /// An algebra by expression, such as `se(3)` or `so(3)^64`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub algebra: Option<String>,
    /// The names of the coordinates of an algebra that is given by its brackets; or other symbols for those of an algebra
    /// by expression.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coordinates: Option<Vec<String>>,
    /// The sign of the bracket; minus, unless it is written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bracket: Option<Bracket>,
    /// The Hamiltonian, a formula.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hamiltonian: Option<String>,
    /// The brackets of the algebra that are not zero, such as `"K, H" = "P"`.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub brackets: BTreeMap<String, String>,
    /// The structure constants, as a text with a line `i, j, k, value` for each; a text of a single line is the path of
    /// a file with such a text.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub structure_constants: Option<String>,
    /// The matrices of representations that the expression of the algebra names, one for each coordinate of the algebra before.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub representations: BTreeMap<String, Vec<Vec<Vec<f64>>>>,
    /// The matrices of a representation of the algebra, one for each coordinate, along whose momenta p·ρq the collective
    /// formulation goes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub representation: Option<Vec<Vec<Vec<f64>>>>,
    /// The symmetric matrices of quadratic momenta, one for each coordinate, instead of a representation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub momenta: Option<Vec<Vec<Vec<f64>>>>,
    /// The numbers and vectors of numbers in the Hamiltonian and the brackets, by name.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub parameters: BTreeMap<String, Numbers>,
    /// The initial values of the coordinates, by name; those of a vector together or one by one.
    pub initial: BTreeMap<String, Numbers>,
    /// The file with the initial state of a system of arrays, instead of `initial`: an output of this program, an archive
    /// of NumPy's, or an OVF file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub initial_file: Option<String>,
    /// The checksum of that file, which the program notes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub initial_checksum: Option<u32>,
}

/// The sign of a Lie–Poisson bracket.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Bracket {
    /// {F, G} = −⟨μ, [dF, dG]⟩
    Minus,
    /// {F, G} = ⟨μ, [dF, dG]⟩
    Plus,
}

impl SystemConfig {
    /// Returns the run that the table asks for, with the keys of `[integrator]` and the n of which every n-th step is
    /// written.
    ///
    /// # Errors
    /// If there is no such run.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::configuration::Config;
    /// let config: Config = toml::from_str(r#"
    ///     [system]
    ///     algebra = "so(3)"
    ///     hamiltonian = "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2"
    ///     initial = { Pi = [1.0, 2.0, 0.5] }
    ///
    ///     [integrator]
    ///     end = 10.0
    /// "#)?;
    /// let experiment = config.system_experiment()?.ok_or("no system")?;
    /// assert_eq!(experiment.model.casimirs()[0].to_string(), "|Pi|^2");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn experiment(
        &self,
        integrator: IntegratorConfig,
        every: u64,
    ) -> Result<Experiment<FormulaSystem>, Error> {
        let system = self.formula_system()?;
        let start = self.start(&system)?;
        let Integration { scheme, step, end, tolerance, .. } =
            integrator.or(Integration::default());
        let formulation = system.algebra().default_formulation();
        let formulation = integrator.formulation.unwrap_or(formulation);
        let method = system.algebra().method(formulation, scheme, tolerance)?;
        system.invariants(&start)?;
        require_run(&system, &method, (&start, step))?;
        let pace = Pace { schedule: Schedule::new(step, end)?, every };
        Ok(Experiment { model: system, start, method, pace, attitude: false })
    }

    /// Returns the system of the table, with its Casimirs.
    ///
    /// # Errors
    /// If there is no such system.
    pub(crate) fn formula_system(&self) -> Result<FormulaSystem, Error> {
        let parameters = self.parameters()?;
        if let Some(kind) = self.system_kind()? {
            return Ok(kind.system(&parameters)?);
        }
        let algebra = self.algebra(&parameters)?;
        let system = FormulaSystem::new(algebra, self.hamiltonian()?, &parameters)?;
        let system = match self.bracket {
            Some(Bracket::Plus) => system.with_plus_bracket()?,
            _ => system,
        };
        Ok(system.with_found_casimirs()?)
    }

    /// Returns the system of the library that the table names.
    ///
    /// # Errors
    /// If there is none of this name, or the table has an algebra or a Hamiltonian, too.
    pub(super) fn system_kind(&self) -> Result<Option<&'static SystemKind>, Error> {
        let Some(name) = &self.kind else { return Ok(None) };
        if self.is_described() {
            return Err(SystemTableError::TwoSystems.into());
        }
        match (self.array_kind(), SystemKind::named(name)) {
            (Some(kind), _) => Err(SystemTableError::OnlySimulated { kind: kind.name }.into()),
            (None, Ok(kind)) => Ok(Some(kind)),
            (None, Err(FormulaSystemError::NoKind { name, mut kinds })) => {
                let is_new = |kind: &&ArrayKind| SystemKind::named(kind.name).is_err();
                let arrays = ArrayKind::ALL.iter().filter(is_new);
                kinds.extend(arrays.map(|kind| format!("{} ({})", kind.name, kind.about)));
                Err(FormulaSystemError::NoKind { name, kinds }.into())
            }
            (None, Err(error)) => Err(error.into()),
        }
    }

    /// Returns whether the table has an algebra or a Hamiltonian of its own.
    pub(super) fn is_described(&self) -> bool {
        self.algebra.is_some()
            || self.coordinates.is_some()
            || self.hamiltonian.is_some()
            || self.structure_constants.is_some()
            || self.bracket.is_some()
            || self.representation.is_some()
            || !self.representations.is_empty()
            || self.momenta.is_some()
            || !self.brackets.is_empty()
    }

    /// Returns the text of the Hamiltonian.
    ///
    /// # Errors
    /// If the key is missing.
    pub(super) fn hamiltonian(&self) -> Result<&str, SystemTableError> {
        self.hamiltonian.as_deref().ok_or(SystemTableError::Missing("hamiltonian"))
    }

    /// Returns the system of the table, in which parameters may differ from those of `base`. The Casimirs of an algebra
    /// that is the same are not looked for again.
    ///
    /// # Errors
    /// If there is no such system.
    pub(crate) fn formula_system_near(&self, base: &FormulaSystem) -> Result<FormulaSystem, Error> {
        let parameters = self.parameters()?;
        if let Some(kind) = self.system_kind()? {
            return Ok(kind.system_near(base, &parameters)?);
        }
        match self.near_if_same(base, &parameters)? {
            Some(base) => Ok(base.with_hamiltonian(self.hamiltonian()?, &parameters)?),
            None => self.formula_system(),
        }
    }

    /// Returns a system of the table with other parameters, if its algebra is that of these parameters.
    pub(super) fn near_if_same<'a>(
        &self,
        base: &'a FormulaSystem,
        parameters: &Parameters,
    ) -> Result<Option<&'a FormulaSystem>, Error> {
        // Parameters of an algebra are in its brackets.
        let is_same = self.brackets.is_empty() || self.algebra(parameters)? == *base.algebra();
        Ok(is_same.then_some(base))
    }

    /// Returns whether the brackets contain one of these parameters.
    pub(crate) fn brackets_contain<'a>(&self, parameters: impl Iterator<Item = &'a str>) -> bool {
        let mut without = self.clone();
        parameters.for_each(|name| drop(without.parameters.remove(name)));
        // Brackets that can be read without a parameter do not contain it.
        !self.brackets.is_empty()
            && without
                .parameters()
                .map_err(Error::from)
                .and_then(|rest| without.algebra(&rest))
                .is_err()
    }

    /// Returns the formulation by which many motions on an algebra are followed unless one is asked for: reduced, where
    /// tangent vectors have no fibres, or that of [`SystemAlgebra::default_formulation`].
    pub(crate) fn formulation_of_many(algebra: &SystemAlgebra) -> Formulation {
        let mut formulations = algebra.formulations();
        match formulations.any(|formulation| formulation == Formulation::Reduced) {
            true => Formulation::Reduced,
            false => algebra.default_formulation(),
        }
    }

    /// Returns the coordinates of the initial state.
    ///
    /// # Errors
    /// If a coordinate has no value, or something else has one.
    pub(crate) fn start(&self, system: &FormulaSystem) -> Result<Vec<f64>, Error> {
        if self.initial_file.is_some() {
            return Err(SystemTableError::NoStartFile.into());
        }
        if let Some(kind) = self.system_kind()? {
            let given = named_numbers("initial", &self.initial)?;
            if let Some(start) = kind.coordinates(&self.parameters()?, &given) {
                return Ok(start?);
            }
        }
        let values = self.initial.iter();
        let values = values.map(|(name, numbers)| (name.as_str(), numbers.values()));
        Ok(system.algebra().state(values)?)
    }

    /// Returns the parameters of formulas.
    ///
    /// # Errors
    /// If a name cannot be that of a parameter.
    pub(crate) fn parameters(&self) -> Result<Parameters, SystemTableError> {
        named_numbers("parameters", &self.parameters)
    }

    /// Returns the algebra, with the momenta of its own.
    ///
    /// # Errors
    /// If there is no such algebra, or the momenta are no Poisson map to its dual.
    pub(super) fn algebra(&self, parameters: &Parameters) -> Result<SystemAlgebra, Error> {
        let algebra = self.algebra_alone(parameters)?;
        let momenta = match (&self.representation, &self.momenta) {
            (None, None) => return Ok(algebra),
            (Some(matrices), None) => QuadraticMomenta::of_rows(matrices, true),
            (None, Some(matrices)) => QuadraticMomenta::of_rows(matrices, false),
            (Some(_), Some(_)) => return Err(SystemTableError::TwoRealisations.into()),
        };
        Ok(algebra.with_realisation(momenta?)?)
    }

    /// Returns the algebra by name, of the brackets, or of the structure constants.
    fn algebra_alone(&self, parameters: &Parameters) -> Result<SystemAlgebra, Error> {
        let has_brackets = !self.brackets.is_empty();
        match (&self.algebra, &self.structure_constants) {
            (Some(name), None) if !has_brackets => {
                let given = self.representations.iter();
                let given = given.map(|(name, rows)| Ok((name.clone(), matrices_of_rows(rows)?)));
                let given = given.collect::<Result<_, FormulaSystemError>>()?;
                let algebra = SystemAlgebra::named_with(name, &given)?;
                let Some(symbols) = &self.coordinates else { return Ok(algebra) };
                let symbols: Vec<&str> = symbols.iter().map(String::as_str).collect();
                Ok(algebra.with_symbols(&symbols)?)
            }
            (None, Some(constants)) if !has_brackets => self.of_table(constants),
            (None, None) => {
                let missing = "algebra, or coordinates and brackets,";
                let coordinates = self.coordinates()?.ok_or(SystemTableError::Missing(missing))?;
                let texts = self.brackets.iter();
                let brackets = texts.map(|(key, text)| (key.as_str(), text.as_str()));
                Ok(SystemAlgebra::of_brackets(coordinates, brackets, parameters)?)
            }
            _ => Err(SystemTableError::TwoAlgebras.into()),
        }
    }

    /// Returns the algebra of structure constants; without names, the coordinates are those of a vector `mu`.
    fn of_table(&self, constants: &str) -> Result<SystemAlgebra, Error> {
        let text = if is_table(constants) {
            constants.to_owned()
        } else {
            read_table(constants.as_ref())?
        };
        let entries = structure_table(&text).map_err(SystemTableError::StructureConstants)?;
        let dimension = entries.iter().flat_map(|entry| [entry.i, entry.j, entry.k]).max();
        let dimension = dimension.map_or(0, |last| last + 1);
        let coordinates = match self.coordinates()? {
            Some(coordinates) => coordinates,
            None if dimension == 0 => return Err(SystemTableError::Missing("coordinates").into()),
            None => Coordinates::new()
                .vector("mu", dimension)
                .map_err(FormulaSystemError::Coordinates)?,
        };
        Ok(SystemAlgebra::of_entries(coordinates, entries)?)
    }

    /// Replaces the path of the structure constants by the table in the file, so that the configuration says everything
    /// by itself, and returns the path of the file that was read. A path is relative to `folder`.
    ///
    /// # Errors
    /// If the file cannot be read, has more than a mebibyte, or is not text.
    pub(crate) fn read_structure_constants(
        &mut self,
        folder: &Path,
    ) -> Result<Option<PathBuf>, Error> {
        let path = self.structure_constants.as_mut().filter(|text| !is_table(text));
        path.map(|constants| {
            let path = folder.join(&constants);
            *constants = read_table(&path)?;
            Ok(path)
        })
        .transpose()
    }

    /// Returns the coordinates by their names, if there are names.
    fn coordinates(&self) -> Result<Option<Coordinates>, FormulaSystemError> {
        let names = self.coordinates.as_ref();
        let scalars = names.map(|names| Coordinates::scalars(names.iter().map(String::as_str)));
        scalars.transpose().map_err(FormulaSystemError::Coordinates)
    }
}

/// Returns the numbers of a table of `[system]`, by name.
fn named_numbers(
    table: &'static str,
    numbers: &BTreeMap<String, Numbers>,
) -> Result<Parameters, SystemTableError> {
    numbers.iter().try_fold(Parameters::new(), |all, (name, numbers)| {
        let added = match numbers {
            Numbers::One(value) => all.number(name, *value),
            Numbers::Many(values) => all.vector(name, values),
        };
        added.map_err(|source| SystemTableError::Parameter { table, name: name.clone(), source })
    })
}
