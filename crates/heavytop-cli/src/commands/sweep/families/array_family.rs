//! A family of motions of a system of arrays.

use super::course::Course;
use super::family::{Family, drift_columns, end_columns, own_integration, shared_columns};
use super::measured_motion::follow;
use super::varied_number::VariedNumbers;
use crate::configuration::{Column, Config, Integration, Observable, SweepAxis, SystemConfig};
use crate::errors::{Error, SweepError, SystemTableError};
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson_runs::step_angle::require_run;
use lie_poisson_runs::{ArraySystem, Model};

/// The largest number of coordinates that are columns of a table.
const MOST_COLUMNS: usize = 256;

/// Motions of a system of arrays, whose parameters or starts differ.
#[derive(Debug)]
pub(in crate::commands::sweep) struct ArrayFamily {
    table: SystemConfig,
    /// The system with the configured parameters.
    system: ArraySystem,
    numbers: VariedNumbers,
    method: Method,
}

impl ArrayFamily {
    /// The observables of systems of arrays.
    const OBSERVABLES: [Observable; 5] = [
        Observable::FinalState,
        Observable::InvariantDrift,
        Observable::Lyapunov,
        Observable::Megno,
        Observable::Sali,
    ];

    /// Reads the motions that the axes describe, and the integrator with what `[integrator]` leaves out.
    ///
    /// # Errors
    /// If there is no system with the configured parameters and start, an axis varies no number of it, or its integrators
    /// have no tangent vectors that an observable needs.
    pub fn new(
        (table, system): (&SystemConfig, ArraySystem),
        config: &Config,
        axes: &[SweepAxis],
    ) -> Result<(Self, Integration), Error> {
        let numbers = VariedNumbers::of(axes, table, None)?;
        let start = table.array_start(&system)?;
        let observables = config.sweep.as_ref().map_or(Vec::new(), |all| all.observables.clone());
        let needs_tangents = observables.iter().any(|observable| observable.tangents() > 0);
        // Tangent vectors have no fibres in the reduced formulation.
        let mut formulations = system.formulations().to_vec();
        formulations.sort_by_key(|formulation| *formulation != Formulation::Reduced);
        let fits = |formulation: &Formulation| {
            let method = system.method(Some(*formulation), SchemeName::default(), 0.0);
            let tangents = method.map(|method| system.tangent_integrator(&method, &start).is_ok());
            !needs_tangents || tangents.unwrap_or(false)
        };
        let own = formulations.iter().find(|formulation| fits(formulation));
        let own = own.or(formulations.first()).copied().unwrap_or_default();
        let integration = config.integrator.or(own_integration(own));
        let Integration { formulation, scheme, tolerance, .. } = integration;
        let method = system.method(Some(formulation), scheme, tolerance)?;
        if needs_tangents {
            system.tangent_integrator(&method, &start)?;
        }
        Ok((Self { table: table.clone(), system, numbers, method }, integration))
    }

    /// Returns the system and its start at these values of the axes.
    ///
    /// # Errors
    /// If there is none, it has another number of coordinates than the configured one, or its motion turns too far in a step.
    fn at(&self, values: &[f64], step: f64) -> Result<(ArraySystem, Vec<f64>), Error> {
        let mut table = self.table.clone();
        self.numbers.set(values, &mut table, &mut []);
        let system = table.array_system()?.ok_or(SystemTableError::Missing("kind"))?;
        let (found, expected) = (system.dimension(), self.system.dimension());
        if found != expected {
            return Err(SweepError::OtherColumns { found, expected }.into());
        }
        let start = table.array_start(&system)?;
        require_run(&system, &self.method, (&start, step))?;
        Ok((system, start))
    }
}

/// Returns the names of what is conserved.
fn names(system: &ArraySystem) -> Vec<String> {
    system.conserved(&[]).names()
}

impl Family for ArrayFamily {
    fn nouns(&self) -> [&'static str; 2] {
        ["run", "runs"]
    }

    fn method(&self) -> &Method {
        &self.method
    }

    fn member(&self, values: &[f64], step: f64) -> Result<(Box<dyn Model>, Vec<f64>), Error> {
        let (system, start) = self.at(values, step)?;
        Ok((Box::new(system), start))
    }

    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }

    fn columns(&self, observable: Observable) -> Result<Vec<Column>, SweepError> {
        match observable {
            Observable::FinalState => {
                let (found, most) = (self.system.dimension(), MOST_COLUMNS);
                if found > most {
                    return Err(SweepError::WideState { found, most });
                }
                Ok(end_columns((&self.system as &dyn Model).columns()))
            }
            Observable::InvariantDrift => Ok(drift_columns(names(&self.system))),
            other => shared_columns(other, &Self::OBSERVABLES),
        }
    }

    fn labels(&self) -> Vec<String> {
        self.numbers.labels(None)
    }

    fn shared(&self) -> Vec<String> {
        let parameters = self.numbers.shared_parameters(&self.table);
        let start = self.numbers.shared_start(&self.table);
        [self.system.about().to_owned()].into_iter().chain(parameters).chain(start).collect()
    }

    fn casimirs(&self) -> Vec<String> {
        Vec::new()
    }

    fn measure(&self, values: &[f64], course: &Course) -> Result<Vec<Option<f64>>, Error> {
        let (system, start) = self.at(values, course.schedule.step)?;
        let (grown, drifts) = follow(&system, (&self.method, &start), course)?;
        let values = |observable: &Observable| match observable {
            Observable::Lyapunov => vec![Some(grown.lyapunov)],
            Observable::Megno => vec![Some(grown.megno)],
            Observable::Sali => vec![grown.alignment],
            // A field or a rotation leaves fewer quantities that are conserved.
            Observable::InvariantDrift => {
                let own = names(&system);
                let drift = |name: &String| {
                    let place = own.iter().position(|own| own == name)?;
                    drifts.get(place).copied()
                };
                names(&self.system).iter().map(drift).collect()
            }
            _ => {
                let mut end = grown.end.as_slice().to_vec();
                system.present(&mut end);
                end.into_iter().map(Some).collect()
            }
        };
        Ok(course.observables.iter().flat_map(values).collect())
    }
}
