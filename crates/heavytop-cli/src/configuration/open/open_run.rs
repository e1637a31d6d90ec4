//! The runs of open systems and of open tops.

use crate::configuration::{Config, Integration, SystemConfig};
use crate::errors::{Error, SystemTableError};
use crate::runs::{Experiment, Pace, Schedule, TopInAxes};
use heavytop::methods::Method;
use lie_poisson::nalgebra::Matrix3;
use lie_poisson_formula_systems::{OpenNames, OpenSystem, SystemAlgebra};
use lie_poisson_formulas::Parameters;
use lie_poisson_runs::step_angle::require_run;
use lie_poisson_runs::{Model, OpenTop};

/// The Hamiltonian of a top, with the rows of the inverse inertia matrix and the weight moment as a vector.
const TOP: &str = "0.5*(Pi1*(row_x·Pi) + Pi2*(row_y·Pi) + Pi3*(row_z·Pi)) + weight_moment·Gamma";

impl Config {
    /// Returns the run of the open system or the open top that the configuration asks for; `None` if it asks for a closed one.
    /// A Hamiltonian that names the time makes a system an open one.
    ///
    /// # Errors
    /// If there is no such run.
    pub(crate) fn open_run(&self) -> Result<Option<Box<Experiment>>, Error> {
        let Some(system) = self.system()? else {
            return match self.open_table() {
                Some(_) => Ok(Some(Box::new(self.open_top()?))),
                None => Ok(None),
            };
        };
        if self.open_table().is_none() && !system.depends_on_time() {
            return Ok(None);
        }
        self.require_output_of_system()?;
        Ok(Some(Box::new(self.open_system()?)))
    }

    /// Returns the algebra of a system, with or without forces.
    ///
    /// # Errors
    /// If there is no such system.
    pub(crate) fn algebra_of(&self, system: &SystemConfig) -> Result<SystemAlgebra, Error> {
        Ok(match self.open_table().is_none() && !system.depends_on_time() {
            true => system.formula_system()?.algebra().clone(),
            false => system.open_base(&self.named_inputs()?)?.0.algebra().clone(),
        })
    }

    /// Returns the run of the open system.
    fn open_system(&self) -> Result<Experiment<OpenSystem>, Error> {
        let system = self.system()?.ok_or(SystemTableError::Missing("system"))?;
        let inputs = self.named_inputs()?;
        let (base, names, hamiltonian) = system.open_base(&inputs)?;
        let start = system.start(&base)?;
        let terms = self.open_terms((&names, base.algebra().dimension()), inputs, hamiltonian)?;
        let Integration { step, .. } = self.integrator.or(Integration::default());
        self.opened(OpenSystem::new(base, terms, step)?, start, |model| model)
    }

    /// Returns the run of the open top, in the axes of `[body]`.
    fn open_top(&self) -> Result<Experiment<OpenTop>, Error> {
        if let Some(quantity) = self.output.columns.first() {
            return Err(SystemTableError::ColumnOfClosed { column: quantity.name() }.into());
        }
        let TopInAxes { top, axes, initial_attitude } = self.model()?;
        let start = TopInAxes::coordinates(&axes.state_from_principal(&self.start()?)).to_vec();
        let (turn, center) = (axes.rotation(), axes.from_principal(&top.center_of_mass()));
        let inverse = Matrix3::from_diagonal(&axes.moments().map(f64::recip));
        let inverse = turn * inverse * turn.transpose();
        if !inverse.iter().all(|entry| entry.is_finite()) {
            return Err(SystemTableError::OpenRod.into());
        }
        let vector = |all: Parameters, name: &str, values: [f64; 3]| {
            all.vector(name, &values).map_err(|source| SystemTableError::Parameter {
                table: "parameters",
                name: name.into(),
                source,
            })
        };
        let mut parameters =
            vector(Parameters::new(), "weight_moment", (center * top.weight_moment()).into())?;
        for (name, i) in [("row_x", 0), ("row_y", 1), ("row_z", 2)] {
            parameters = vector(parameters, name, inverse.row(i).transpose().into())?;
        }
        if axes.is_aligned() {
            parameters = vector(parameters, "I", axes.moments().into())?;
        }
        let (algebra, inputs) = (SystemAlgebra::named("se(3)")?, self.named_inputs()?);
        let names = OpenNames::new(algebra.clone(), &inputs, parameters)?;
        let (base, _) = names.system(TOP)?;
        let terms = self.open_terms((&names, algebra.dimension()), inputs, None)?;
        if self.torque.iter().flatten().any(|(name, _)| name != "Pi") {
            return Err(SystemTableError::TorqueOnVertical.into());
        }
        let Integration { step, .. } = self.integrator.or(Integration::default());
        let system = OpenSystem::new(base.with_found_casimirs()?, terms, step)?;
        self.opened(system, start, |system| OpenTop { system, initial_attitude })
    }

    /// Returns the run of an open system, as a model.
    fn opened<M: Model>(
        &self,
        system: OpenSystem,
        start: Vec<f64>,
        model: impl FnOnce(OpenSystem) -> M,
    ) -> Result<Experiment<M>, Error> {
        let integrator = self.integrator;
        let Integration { scheme, step, end, tolerance, .. } =
            integrator.or(Integration::default());
        let formulation = integrator.formulation.unwrap_or_else(|| system.default_formulation());
        let method: Method = system.method(formulation, scheme, tolerance)?;
        let (every, schedule) = (self.output.every, Schedule::new(step, end)?);
        if every == 0 {
            let (name, range) = ("output.every", "at least 1");
            return Err(Error::OutOfRange { name, range, value: 0.0 });
        }
        self.require_inputs(&system.terms().inputs, schedule.end())?;
        let model = model(system);
        require_run(&model, &method, (&start, step))?;
        let pace = Pace { schedule, every };
        Ok(Experiment { model, start, method, pace, attitude: self.output.has_attitude() })
    }
}
