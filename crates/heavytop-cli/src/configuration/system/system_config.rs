//! The table `[system]`: its keys, and the run that they ask for.

use super::bracket_texts::entries;
use super::numbers::Numbers;
use crate::Error;
use crate::configuration::{Integration, IntegratorConfig};
use crate::errors::SystemError;
use crate::runs::{Pace, Schedule, SystemAlgebra, SystemExperiment, WIDEST};
use heavytop::methods::Formulation;
use lie_poisson_formulas::{
    Coordinates, DimensionTask, Formula, Parameters, PolynomialCasimirs, StructureEntry,
    Vocabulary, find_casimirs, for_dimension, structure_constants,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The table `[system]`: a Lie algebra, a Hamiltonian on its dual, and the state at t = 0.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SystemConfig {
    /// The name of an algebra of the library, such as `se(3)`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub algebra: Option<String>,
    /// The names of the coordinates of an algebra that is given by its brackets.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coordinates: Option<Vec<String>>,
    /// The Hamiltonian, a formula.
    pub hamiltonian: String,
    /// The brackets of the algebra that are not zero, such as `"K, H" = "P"`.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub brackets: BTreeMap<String, String>,
    /// The numbers and vectors of numbers in the Hamiltonian and the brackets, by name.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub parameters: BTreeMap<String, Numbers>,
    /// The initial values of the coordinates, by name; those of a vector together or one by one.
    pub initial: BTreeMap<String, Numbers>,
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
    /// assert_eq!(experiment.casimirs()[0].to_string(), "|Pi|^2");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn experiment(
        &self,
        integrator: IntegratorConfig,
        every: u64,
    ) -> Result<SystemExperiment, Error> {
        let parameters = self.parameters()?;
        let algebra = self.algebra(&parameters)?;
        let named = |key: &str| {
            let key = key.to_owned();
            move |source| SystemError::Name { key, source }
        };
        let formula = |key: &str, text: &str, names: &Vocabulary| {
            Formula::new(text, names)
                .map_err(|source| SystemError::Formula { key: key.into(), source })
        };
        if self.hamiltonian.trim().is_empty() {
            return Err(SystemError::Missing("hamiltonian").into());
        }
        let names = algebra.vocabulary(&parameters).map_err(named("parameters"))?;
        let hamiltonian = formula("hamiltonian", &self.hamiltonian, &names)?;
        let found = casimirs(&algebra)?;
        let plain = algebra.vocabulary(&Parameters::new()).map_err(named("coordinates"))?;
        let casimirs = found.formulas().iter().map(|c| formula("brackets", &c.to_string(), &plain));
        let casimirs = casimirs.collect::<Result<Vec<_>, _>>()?;
        let start = self.start(&algebra.coordinates)?;
        let Integration { formulation, scheme, step, end, tolerance } =
            integrator.or(Integration::default());
        let formulation = integrator.formulation.unwrap_or(match self.algebra.as_deref() {
            Some("so(3)" | "su(2)" | "se(3)") => formulation,
            _ => Formulation::Direct,
        });
        let pace = Pace { schedule: Schedule::new(step, end)?, every };
        let method = (formulation, scheme, tolerance);
        SystemExperiment::new(algebra, (hamiltonian, casimirs), start, method, pace)
    }

    fn parameters(&self) -> Result<Parameters, SystemError> {
        self.parameters.iter().try_fold(Parameters::new(), |all, (name, numbers)| {
            let added = match numbers {
                Numbers::One(value) => all.number(name, *value),
                Numbers::Many(values) => all.vector(name, values),
            };
            added.map_err(|source| SystemError::Name { key: format!("parameters.{name}"), source })
        })
    }

    /// Returns the algebra by name, or of the brackets.
    fn algebra(&self, parameters: &Parameters) -> Result<SystemAlgebra, SystemError> {
        let Some(name) = &self.algebra else {
            let names = self.coordinates.as_ref();
            let names =
                names.ok_or(SystemError::Missing("algebra, or coordinates and brackets,"))?;
            if names.is_empty() || names.len() > WIDEST {
                return Err(SystemError::Dimension { count: names.len(), most: WIDEST });
            }
            let coordinates = Coordinates::scalars(names.iter().map(String::as_str))
                .map_err(|source| SystemError::Name { key: "coordinates".into(), source })?;
            let entries = entries(&coordinates, parameters, &self.brackets)?;
            return Ok(SystemAlgebra::of_table(coordinates, entries));
        };
        if self.coordinates.is_some() || !self.brackets.is_empty() {
            return Err(SystemError::TwoAlgebras);
        }
        SystemAlgebra::named(name).ok_or_else(|| SystemError::NoAlgebra {
            name: name.clone(),
            names: SystemAlgebra::NAMES.to_vec(),
        })
    }

    /// Returns the coordinates of the initial state.
    fn start(&self, coordinates: &Coordinates) -> Result<Vec<f64>, SystemError> {
        let mut start = vec![None; coordinates.dimension()];
        for (name, numbers) in &self.initial {
            let places = coordinates.places(name).ok_or_else(|| SystemError::NoCoordinate {
                name: name.clone(),
                names: coordinates.names().collect::<Vec<_>>().join(", "),
            })?;
            let values = numbers.values();
            let wrong = |needed: String| SystemError::WrongValue { name: name.clone(), needed };
            if values.len() != places.len() {
                return Err(wrong(match places.len() {
                    1 => "one number".into(),
                    count => format!("an array of {count} numbers"),
                }));
            }
            if values.iter().any(|value| !value.is_finite()) {
                return Err(wrong("finite numbers".into()));
            }
            for (entry, value) in start.iter_mut().skip(places.start).zip(values) {
                *entry = Some(*value);
            }
        }
        let missing = coordinates.names().zip(&start).filter(|(_, value)| value.is_none());
        let missing: Vec<String> = missing.map(|(name, _)| name).collect();
        if missing.is_empty() {
            Ok(start.into_iter().flatten().collect())
        } else {
            Err(SystemError::NoValue { names: missing.join(", ") })
        }
    }
}

/// Finds the Casimirs of an algebra, and checks that its brackets are those of one.
fn casimirs(algebra: &SystemAlgebra) -> Result<PolynomialCasimirs, SystemError> {
    let dimension = algebra.dimension();
    let task = Find { entries: &algebra.entries, coordinates: &algebra.coordinates };
    for_dimension(dimension, task)
        .unwrap_or(Err(SystemError::Dimension { count: dimension, most: WIDEST }))
}

/// The search for the Casimirs of a table.
struct Find<'a> {
    entries: &'a [StructureEntry],
    coordinates: &'a Coordinates,
}

impl DimensionTask for Find<'_> {
    type Output = Result<PolynomialCasimirs, SystemError>;

    fn run<const N: usize>(self) -> Self::Output {
        let table = structure_constants::<N>(self.entries).map_err(SystemError::Brackets)?;
        Ok(find_casimirs(&table, self.coordinates)?)
    }
}
