//! The runs of open systems and of open tops.

use crate::configuration::{Config, Integration, SystemConfig};
use crate::errors::{Error, SystemTableError};
use crate::runs::{Experiment, Pace, Schedule, TopInAxes};
use heavytop::methods::Method;
use lie_poisson::nalgebra::Matrix3;
use lie_poisson_formula_systems::{FormulaSystem, OpenNames, OpenSystem, SystemAlgebra};
use lie_poisson_formulas::Parameters;
use lie_poisson_runs::step_angle::require_run;
use lie_poisson_runs::{Model, OpenTop};

/// The Hamiltonian of a top, with the rows of the inverse inertia matrix and the weight moment as a vector.
const TOP: &str = "0.5*(Pi1*(row_x·Pi) + Pi2*(row_y·Pi) + Pi3*(row_z·Pi)) + weight_moment·Gamma";

/// The model of an open system or an open top.
#[derive(Clone, Debug)]
pub(crate) enum OpenModel {
    System(Box<OpenSystem>),
    Top(Box<OpenTop>),
}

impl OpenModel {
    /// Returns the system.
    pub fn system(&self) -> &OpenSystem {
        match self {
            Self::System(system) => system,
            Self::Top(top) => &top.system,
        }
    }

    /// Returns the model.
    pub fn as_model(&self) -> &dyn Model {
        match self {
            Self::System(system) => &**system,
            Self::Top(top) => &**top,
        }
    }

    /// Returns the model without its name.
    pub fn boxed(self) -> Box<dyn Model> {
        match self {
            Self::System(system) => system,
            Self::Top(top) => top,
        }
    }
}

/// An open system or an open top, its start, and the method by which it is followed.
#[derive(Clone, Debug)]
pub(crate) struct OpenStart {
    pub model: OpenModel,
    pub start: Vec<f64>,
    pub method: Method,
}

impl Config {
    /// Returns the run of the open system or the open top that the configuration asks for; `None` if it asks for a closed one.
    ///
    /// # Errors
    /// If there is no such run.
    pub(crate) fn open_run(&self) -> Result<Option<Box<Experiment>>, Error> {
        if !self.is_open()? {
            return Ok(None);
        }
        if self.system.is_some() {
            self.require_output_of_system()?;
        }
        let OpenStart { model, start, method } = self.open_start(None)?;
        let Integration { step, end, .. } = self.integrator.or(Integration::default());
        let (every, schedule) = (self.output.every, Schedule::new(step, end)?);
        if every == 0 {
            let (name, range) = ("output.every", "at least 1");
            return Err(Error::OutOfRange { name, range, value: 0.0 });
        }
        self.require_inputs(&model.system().terms().inputs, schedule.end())?;
        require_run(model.as_model(), &method, (&start, step))?;
        let (pace, attitude) = (Pace { schedule, every }, self.output.has_attitude());
        Ok(Some(match model {
            OpenModel::System(model) => {
                Box::new(Experiment { model: *model, start, method, pace, attitude })
            }
            OpenModel::Top(model) => {
                Box::new(Experiment { model: *model, start, method, pace, attitude })
            }
        }))
    }

    /// Returns whether the configuration asks for an open system or an open top. A Hamiltonian that names the time makes a system an
    /// open one.
    ///
    /// # Errors
    /// If a table of tops stands beside that of a system.
    pub(crate) fn is_open(&self) -> Result<bool, Error> {
        let in_time = self.system()?.map_or(Ok(false), SystemConfig::depends_on_time)?;
        Ok(in_time || self.open_table().is_some())
    }

    /// Returns the algebra of a system, with or without forces.
    ///
    /// # Errors
    /// If there is no such system.
    pub(crate) fn algebra_of(&self, system: &SystemConfig) -> Result<SystemAlgebra, Error> {
        Ok(match self.is_open()? {
            false => system.formula_system()?.algebra().clone(),
            true => system.open_base(&self.named_inputs()?, None)?.0.algebra().clone(),
        })
    }

    /// Returns the open system or the open top, its start, and the method of the run, of which neither the step nor the end has
    /// been checked. The Casimirs of an algebra that is the same as that of `near` are not looked for again.
    ///
    /// # Errors
    /// If there is no such system, start or method.
    pub(crate) fn open_start(&self, near: Option<&OpenModel>) -> Result<OpenStart, Error> {
        let near = near.map(|near| near.system().base());
        let (model, start) = match self.system()? {
            Some(system) => self.open_system(system, near)?,
            None => self.open_top(near)?,
        };
        self.require_named_inputs()?;
        let (integrator, system) = (self.integrator, model.system());
        let Integration { scheme, tolerance, .. } = integrator.or(Integration::default());
        let formulation = integrator.formulation.unwrap_or_else(|| system.default_formulation());
        let method = system.method(formulation, scheme, tolerance)?;
        Ok(OpenStart { model, start, method })
    }

    fn open_system(
        &self,
        system: &SystemConfig,
        near: Option<&FormulaSystem>,
    ) -> Result<(OpenModel, Vec<f64>), Error> {
        let inputs = self.named_inputs()?;
        let (base, names, hamiltonian) = system.open_base(&inputs, near)?;
        let start = system.start(&base)?;
        let terms = self.open_terms((&names, base.algebra().dimension()), inputs, hamiltonian)?;
        let system = OpenSystem::new(base, terms, self.open_step())?;
        Ok((OpenModel::System(Box::new(system)), start))
    }

    /// Returns the step of the run of an open system, below 0 towards an end below 0. It has not been checked.
    fn open_step(&self) -> f64 {
        let Integration { step, end, .. } = self.integrator.or(Integration::default());
        if end < 0.0 { -step.abs() } else { step }
    }

    /// Returns the open top, in the axes of `[body]`.
    fn open_top(&self, near: Option<&FormulaSystem>) -> Result<(OpenModel, Vec<f64>), Error> {
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
        let names = names.with_directions(&["Gamma"]);
        let base = match near {
            Some(near) => names.system_near(near, TOP)?.0,
            None => names.system(TOP)?.0.with_found_casimirs()?,
        };
        let terms = self.open_terms((&names, algebra.dimension()), inputs, None)?;
        let system = OpenSystem::new(base, terms, self.open_step())?;
        Ok((OpenModel::Top(Box::new(OpenTop { system, initial_attitude })), start))
    }
}
