//! The settings of a section: what it is of, and how far its starts are followed.

use super::problems::limits::Limits;
use super::problems::open_problem::OpenProblem;
use super::problems::section_problem::SectionProblem;
use super::problems::system_problem::SystemProblem;
use super::problems::top_problem::TopProblem;
use crate::configuration::{Config, Integration, PlaneLimits, SectionConfig};
use crate::errors::Error;
use crate::formats::run_table::require_distinct;
use lie_poisson_runs::{MOST_STEPS, RunFailure, directed_step};
use std::sync::Arc;

/// The largest number of points; more must be a typing error.
const MOST_POINTS: f64 = 1e7;

/// A section, and how its points are computed.
#[derive(Clone, Debug)]
pub(super) struct Settings {
    pub problem: Arc<dyn SectionProblem>,
    pub limits: Limits,
    /// The part of the plane that the picture shows.
    pub plane: PlaneLimits,
}

impl Settings {
    /// Reads the section of the top or of the system that the configuration asks for.
    ///
    /// # Errors
    /// If there is no such section.
    pub fn of(config: &Config) -> Result<Self, Error> {
        let section = config.section.clone().unwrap_or_default();
        let problem: (Arc<dyn SectionProblem>, _) = if config.is_open()? {
            let (problem, own) = OpenProblem::new(config, &section)?;
            (Arc::new(problem), own)
        } else if config.system.is_some() {
            let (problem, own) = SystemProblem::new(config, &section)?;
            (Arc::new(problem), own)
        } else {
            let (problem, own) = TopProblem::new(config, &section)?;
            (Arc::new(problem), own)
        };
        Self::new(config, &section, problem)
    }

    /// Reads how far the starts of a problem are followed; `own` stands for what `[integrator]` leaves out.
    ///
    /// # Errors
    /// If a number makes no sense.
    fn new(
        config: &Config,
        settings: &SectionConfig,
        (problem, own): (Arc<dyn SectionProblem>, Integration),
    ) -> Result<Self, Error> {
        let (Integration { step, end, .. }, longest) =
            (config.integrator.or(own), settings.longest);
        // The starts are followed as far as `longest` says, and the end says in which direction.
        let step = directed_step(step, end)?;
        if !(longest > 0.0 && longest.is_finite()) {
            let (name, range) = ("section.longest", "positive and finite");
            return Err(Error::OutOfRange { name, range, value: longest });
        }
        problem.require_step(step)?;
        let steps = (longest / step.abs()).ceil();
        if steps > MOST_STEPS {
            return Err(RunFailure::TooManySteps { steps, most: MOST_STEPS }.into());
        }
        let given = u32::try_from(settings.states.len()).unwrap_or(u32::MAX);
        let starts = if given > 0 { given } else { settings.starts };
        let (crossings, seed) = (settings.crossings, settings.seed);
        for (name, value) in [("section.starts", starts), ("section.crossings", crossings)] {
            if value == 0 {
                return Err(Error::OutOfRange { name, range: "at least 1", value: 0.0 });
            }
        }
        let points = f64::from(starts) * f64::from(crossings);
        if points > MOST_POINTS {
            return Err(Error::TooManyPoints { points, most: MOST_POINTS });
        }
        let (starts, crossings, steps) = (starts as usize, crossings as usize, steps as usize);
        let limits = Limits { step, longest, steps, crossings, starts, seed };
        settings.limits.require(problem.drawing(&limits).abscissa.1)?;
        let settings = Self { problem, limits, plane: settings.limits };
        require_distinct(settings.header().split(',')).map_err(Error::from)?;
        Ok(settings)
    }

    /// Returns the names of the columns of the points.
    pub fn header(&self) -> String {
        format!("start,crossing,t,{},x,y", self.problem.columns().join(","))
    }

    /// Returns the configuration with every key that was left out and plays a part.
    pub fn complete(&self, config: &Config) -> Config {
        let method = self.problem.method();
        let (formulation, scheme) = (method.formulation(), method.scheme());
        let step = self.limits.step;
        let own = Integration { formulation, scheme, step, ..Integration::default() };
        let section = self.problem.complete(config.section.clone().unwrap_or_default());
        let integrator = config.integrator.or(own).into();
        Config { integrator, section: Some(section), ..config.clone() }
    }
}
