//! What a run is of: [`RunSubject`].

use super::view::View;
use crate::configuration::{Config, Integration, SystemConfig};
use crate::errors::Error;
use crate::pictures::caption;
use crate::runs::Experiment;
use lie_poisson_formula_systems::SystemKind;
use lie_poisson_runs::ArraySystem;

/// What a run is of.
pub(super) enum RunSubject {
    /// A system of arrays.
    Arrays {
        system: ArraySystem,
        /// What it is, in words of a caption.
        about: Vec<String>,
    },
    /// A top, or a system by formula, whose coordinates are in arrays of numbers and vectors.
    Coordinates {
        run: Box<Experiment>,
        /// The name of a system of the library.
        kind: Option<&'static str>,
        /// What it is, in words of a caption.
        about: Vec<String>,
    },
}

impl RunSubject {
    /// Returns what the run with this configuration is of.
    ///
    /// # Errors
    /// If there is no such run.
    pub fn new(config: &Config) -> Result<Self, Error> {
        let arrays = config.system()?.map(SystemConfig::array_system).transpose()?.flatten();
        if let Some(system) = arrays {
            let about = std::iter::once(system.about().to_owned()).chain(config.forces()).collect();
            return Ok(Self::Arrays { system, about });
        }
        if let Some(run) = config.open_run()? {
            let mut about = match &config.system {
                Some(_) => vec![run.model.formula("h").unwrap_or_default()],
                None => {
                    let model = config.model()?;
                    vec![caption::top_in(&model.top, &model.axes)]
                }
            };
            about.extend(config.forces());
            return Ok(Self::Coordinates { run, kind: None, about });
        }
        let Some(table) = config.system()? else {
            let run = config.experiment()?;
            let (model, start) = (&run.model, run.model.given(&run.initial_state()));
            let about = vec![caption::top_in(&model.top, &model.axes), caption::start(&start)];
            return Ok(Self::Coordinates { run: Box::new(run), kind: None, about });
        };
        let run = table.experiment(config.integrator, config.output.every)?;
        let kind = table.kind.as_deref().and_then(|name| SystemKind::named(name).ok());
        let about = match kind {
            Some(kind) => kind.about.to_owned(),
            None => caption::hamiltonian(run.model.hamiltonian()),
        };
        let (kind, about) = (kind.map(|kind| kind.name), vec![about]);
        Ok(Self::Coordinates { run: Box::new(run), kind, about })
    }

    /// Returns how the run is drawn.
    pub fn view(&self) -> View {
        match self {
            Self::Coordinates { kind: Some("vortices"), .. } => View::Vortices,
            Self::Coordinates { kind: Some("spin-chain"), .. } => View::Chain,
            Self::Coordinates { .. } => View::Panels,
            Self::Arrays { .. } => {
                let (name, shape) = self.state();
                match (name.as_str(), shape.len()) {
                    ("omega", _) => View::Fluid,
                    ("m", _) => View::Vortices,
                    (_, 2) => View::Chain,
                    _ => View::Lattice,
                }
            }
        }
    }

    /// Returns the symbol of the array that pictures of a sample show, and its shape.
    pub fn state(&self) -> (String, Vec<usize>) {
        match self {
            Self::Arrays { system, .. } => {
                let first = system.arrays().into_iter().next();
                first.map_or_else(Default::default, |(name, shape)| (name.into(), shape))
            }
            Self::Coordinates { run, .. } => {
                let groups = run.coordinates();
                let symbol = groups.first().and_then(|(name, _)| name.split('_').next());
                let width = groups.first().map_or(0, |(_, columns)| columns.len());
                (symbol.unwrap_or_default().into(), vec![groups.len(), width])
            }
        }
    }

    /// Returns the names and the shapes of the arrays of the archive that make that array, one after the other.
    pub fn parts(&self) -> Vec<(String, Vec<usize>)> {
        match self {
            Self::Arrays { .. } => vec![self.state()],
            Self::Coordinates { run, .. } => {
                let groups = run.coordinates().into_iter();
                groups.map(|(name, columns)| (name, shape_of(&columns))).collect()
            }
        }
    }

    /// Returns the parts of a caption: what the run is of, and the method.
    pub fn caption(&self, config: &Config) -> Vec<String> {
        match self {
            Self::Arrays { system, about } => {
                let integrator = config.integrator;
                let formulation = integrator.formulation.or(system.formulations().first().copied());
                let step = integrator.step.unwrap_or(Integration::default().step);
                let (formulation, scheme) =
                    (formulation.unwrap_or_default(), integrator.scheme.unwrap_or_default());
                let method = caption::method(formulation, scheme, step);
                about.iter().cloned().chain([method]).collect()
            }
            Self::Coordinates { run, about, .. } => {
                let (method, step) = (&run.method, run.pace.schedule.step);
                let method = caption::method(method.formulation(), method.scheme(), step);
                about.iter().cloned().chain([method]).collect()
            }
        }
    }
}

/// Returns the shape of the array of some columns: a vector, or a number.
pub(super) fn shape_of(columns: &[String]) -> Vec<usize> {
    if columns.len() == 1 { Vec::new() } else { vec![columns.len()] }
}
