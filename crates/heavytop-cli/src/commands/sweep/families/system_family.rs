//! A family of motions of a Lie–Poisson system.

use super::course::Course;
use super::family::{Family, drift_columns, end_columns, own_integration, shared_columns};
use super::gauge::{Gauge, Quantity, in_columns};
use super::measured_motion::measure;
use super::varied_number::{VariedNumber, VariedNumbers, component};
use crate::configuration::{Column, Config, Integration, Observable, SweepAxis, SystemConfig};
use crate::errors::{Error, SweepError};
use crate::pictures::caption::{self, number, vector_of};
use crate::pictures::symbols::symbol;
use heavytop::methods::Method;
use lie_poisson_formula_systems::FormulaSystem;
use lie_poisson_runs::Model;
use lie_poisson_runs::step_angle::require_run;

/// Motions of a system, whose parameters or initial states differ.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::sweep) struct SystemFamily {
    table: SystemConfig,
    /// The system with the configured parameters.
    system: FormulaSystem,
    /// The configured initial state.
    start: Vec<f64>,
    numbers: VariedNumbers,
    /// Whether all members have the same algebra.
    has_one_algebra: bool,
    method: Method,
}

impl SystemFamily {
    /// The observables of systems.
    const OBSERVABLES: [Observable; 6] = [
        Observable::FinalState,
        Observable::InvariantDrift,
        Observable::RelativeDrift,
        Observable::Lyapunov,
        Observable::Megno,
        Observable::Sali,
    ];

    /// Reads the motions that the axes describe, and the integrator with what `[integrator]` leaves out.
    ///
    /// # Errors
    /// If there is no system with the configured parameters and initial state, or an axis varies no number of it.
    pub fn new(
        table: &SystemConfig,
        config: &Config,
        axes: &[SweepAxis],
    ) -> Result<(Self, Integration), Error> {
        let system = table.formula_system()?;
        let (start, algebra) = (table.start(&system)?, system.algebra());
        let numbers = VariedNumbers::of(axes, table, Some(algebra.coordinates()))?;
        let varied = numbers.iter().filter_map(VariedNumber::parameter);
        let has_one_algebra = !table.brackets_contain(varied);
        let own = own_integration(SystemConfig::formulation_of_many(algebra));
        let integration = config.integrator.or(own);
        let Integration { formulation, scheme, tolerance, .. } = integration;
        let method = algebra.method(formulation, scheme, tolerance)?;
        // Structure constants, which may be a long text, do not vary.
        let table = SystemConfig { structure_constants: None, ..table.clone() };
        Ok((Self { table, system, start, numbers, has_one_algebra, method }, integration))
    }

    /// Returns the system and its initial state at these values of the axes.
    ///
    /// # Errors
    /// If there is no such system, its orbits have another dimension, so that it has another number of Casimirs, or its
    /// motion turns too far in a step.
    fn system(&self, values: &[f64], step: f64) -> Result<(FormulaSystem, Vec<f64>), Error> {
        let (mut table, mut start) = (self.table.clone(), self.start.clone());
        self.numbers.set(values, &mut table, &mut start);
        let is_same = self.numbers.iter().all(|varied| varied.parameter().is_none());
        let system = match is_same {
            true => self.system.clone(),
            false => table.formula_system_near(&self.system)?,
        };
        // A start that is given by positions, say, depends on the parameters.
        start = table.start(&system)?;
        self.numbers.set(values, &mut table, &mut start);
        // Whether a Casimir is a polynomial may depend on the parameters; how many there are, on the kind of the algebra.
        let independent = |system: &FormulaSystem| {
            system.casimirs().len() + system.missing_casimirs().unwrap_or_default()
        };
        let (found, expected) = (independent(&system), independent(&self.system));
        if found != expected {
            return Err(SweepError::Casimirs { found, expected }.into());
        }
        require_run(&system, &self.method, (&start, step))?;
        Ok((system, start))
    }

    /// Returns whether the steps from the configured start descend to the dual of the algebra.
    fn descends(&self) -> bool {
        // A method whose steps fail to be made is refused where they are made.
        self.system.descends(&self.method, &self.start).unwrap_or(true)
    }

    /// Returns the names of h and of the Casimirs.
    fn conserved(&self) -> impl Iterator<Item = String> {
        let casimirs = (1..=self.system.casimirs().len()).map(|i| format!("c{i}"));
        ["h".to_owned()].into_iter().chain(casimirs)
    }

    /// Returns what all members share of the initial state, in the words of a caption.
    fn shared_start(&self) -> Vec<String> {
        if self.numbers.iter().any(|varied| matches!(varied, VariedNumber::Start(..))) {
            return self.numbers.shared_start(&self.table);
        }
        self.shared_coordinates().collect()
    }

    /// Returns the coordinates of the initial state that all members share, in the words of a caption.
    fn shared_coordinates(&self) -> impl Iterator<Item = String> {
        let coordinates = self.system.algebra().coordinates();
        coordinates.groups().filter_map(|(name, places)| {
            let values = self.start.get(places.clone()).unwrap_or_default();
            let varied = |i: usize| {
                let varied = VariedNumber::Coordinate(places.start + i);
                self.numbers.contain(&varied).then(|| component(name, i))
            };
            let name = symbol(name);
            match values {
                [_] if varied(0).is_some() => None,
                [value] => Some(format!("{name}(0) = {}", number(*value))),
                values => vector_of(&format!("{name}(0)"), values, varied),
            }
        })
    }
}

impl Family for SystemFamily {
    fn nouns(&self) -> [&'static str; 2] {
        ["run", "runs"]
    }

    fn method(&self) -> &Method {
        &self.method
    }

    fn member(&self, values: &[f64], step: f64) -> Result<(Box<dyn Model>, Vec<f64>), Error> {
        let (system, start) = self.system(values, step)?;
        Ok((Box::new(system), start))
    }

    fn warnings(&self) -> Vec<String> {
        // A method whose steps fail to be made has no warning, and the rows say why.
        self.system.warning(&self.method, &self.start).ok().flatten().into_iter().collect()
    }

    fn columns(&self, observable: Observable) -> Result<Vec<Column>, SweepError> {
        match observable {
            Observable::FinalState => Ok(end_columns(self.system.algebra().coordinates().names())),
            Observable::InvariantDrift => Ok(drift_columns(self.conserved())),
            lifted if lifted.tangents() > 0 && !self.descends() => Err(SweepError::Lifted {
                observable: lifted.name(),
                formulation: self.method.formulation().name(),
            }),
            Observable::RelativeDrift => {
                let column = |name: String| {
                    let label = format!("relative deviation of {}", symbol(&name));
                    Column::logarithmic(&format!("relative_drift_{name}"), &label)
                };
                Ok(self.conserved().map(column).collect())
            }
            other => shared_columns(other, &Self::OBSERVABLES),
        }
    }

    fn labels(&self) -> Vec<String> {
        let coordinates = self.system.algebra().coordinates();
        self.numbers.labels(Some(coordinates))
    }

    fn shared(&self) -> Vec<String> {
        let hamiltonian = caption::hamiltonian(self.system.hamiltonian());
        let casimirs = self.casimirs().into_iter();
        let casimirs = self.conserved().skip(1).zip(casimirs);
        let casimirs =
            casimirs.map(|(name, text)| format!("{} = {}", symbol(&name), caption::formula(text)));
        let numbers =
            self.numbers.shared_parameters(&self.table).into_iter().chain(self.shared_start());
        [hamiltonian].into_iter().chain(casimirs).chain(numbers).collect()
    }

    fn casimirs(&self) -> Vec<String> {
        let shared = self.system.casimirs().iter().filter(|_| self.has_one_algebra);
        shared.map(ToString::to_string).collect()
    }

    fn measure(&self, values: &[f64], course: &Course) -> Result<Vec<Option<f64>>, Error> {
        let (system, start) = self.system(values, course.schedule.step)?;
        let casimirs = in_columns(system.casimir_degrees(), self.system.casimir_degrees());
        let casimirs = casimirs.into_iter().map(|place| system.casimirs().get(place?));
        let casimirs = casimirs.map(|casimir| casimir.map(|casimir| casimir as &dyn Quantity));
        let hamiltonian = Some(system.hamiltonian() as &dyn Quantity);
        let quantities = std::iter::once(hamiltonian).chain(casimirs).collect();
        let wants_sizes = course.observables.contains(&Observable::RelativeDrift);
        let mut gauge = Gauge::new(&system, quantities, (&start, wants_sizes));
        let measured = measure(&system, (&self.method, &start), &mut gauge, course)?;
        if let Some(state) = gauge.undefined() {
            system.invariants(state)?;
        }
        Ok(measured)
    }
}
