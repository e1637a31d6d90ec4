//! What moves in a family of motions with forces: [`Subject`].

use crate::commands::sweep::families::family::Family;
use crate::commands::sweep::families::top_family::TopFamily;
use crate::commands::sweep::families::varied_number::{VariedNumber, VariedNumbers};
use crate::configuration::{Config, IntegratorConfig, OpenModel, SweepAxis};
use crate::errors::Error;
use crate::pictures::caption;

/// A top or a system, with the numbers of it that axes vary.
#[derive(Debug)]
pub(super) enum Subject {
    Top(Box<TopFamily>),
    System {
        numbers: VariedNumbers,
        /// Whether all members have the same algebra.
        has_one_algebra: bool,
    },
}

impl Subject {
    /// Reads the numbers that the axes vary.
    ///
    /// # Errors
    /// If an axis varies no number of the top or of the system.
    pub fn new(config: &Config, model: &OpenModel, axes: &[SweepAxis]) -> Result<Self, Error> {
        let Some(table) = config.system()? else {
            // The method is that of the motion with forces.
            let alone = Config { integrator: IntegratorConfig::default(), ..config.clone() };
            return Ok(Self::Top(Box::new(TopFamily::new(&alone, axes)?.0)));
        };
        let coordinates = model.system().base().algebra().coordinates();
        let numbers = VariedNumbers::of(axes, table, Some(coordinates))?;
        let varied = numbers.iter().filter_map(VariedNumber::parameter);
        let has_one_algebra = !table.brackets_contain(varied);
        Ok(Self::System { numbers, has_one_algebra })
    }

    /// Sets the numbers of a configuration to values.
    pub fn set(&self, values: &[f64], config: &mut Config) {
        match (self, &mut config.system) {
            (Self::Top(tops), _) => (config.body, config.initial) = tops.tables(values),
            (Self::System { numbers, .. }, Some(table)) => numbers.set(values, table, &mut []),
            _ => {}
        }
    }

    /// Sets the coordinates of a start that axes vary to values.
    pub fn set_start(&self, values: &[f64], start: &mut [f64]) {
        if let Self::System { numbers, .. } = self {
            numbers.set(values, &mut Default::default(), start);
        }
    }

    /// Returns the words for a member and for several.
    pub const fn nouns(&self) -> [&'static str; 2] {
        match self {
            Self::Top(_) => ["top", "tops"],
            Self::System { .. } => ["run", "runs"],
        }
    }

    /// Returns the family of tops, if the members are tops.
    pub fn tops(&self) -> Option<&TopFamily> {
        match self {
            Self::Top(tops) => Some(tops),
            Self::System { .. } => None,
        }
    }

    /// Returns the symbols of the numbers that axes vary.
    pub fn labels(&self, model: &OpenModel) -> Vec<String> {
        match self {
            Self::Top(tops) => tops.labels(),
            Self::System { numbers, .. } => {
                numbers.labels(Some(model.system().base().algebra().coordinates()))
            }
        }
    }

    /// Returns what all members share, in the words of a caption.
    pub fn shared(&self, config: &Config, model: &OpenModel) -> Vec<String> {
        match (self, &config.system) {
            (Self::System { numbers, .. }, Some(table)) => {
                let system = model.system();
                let own = system.base().hamiltonian();
                let hamiltonian = system.terms().hamiltonian.as_ref().unwrap_or(own);
                let parameters = numbers.shared_parameters(table);
                let start = numbers.shared_start(table);
                [caption::hamiltonian(hamiltonian)]
                    .into_iter()
                    .chain(parameters)
                    .chain(start)
                    .collect()
            }
            (subject, _) => subject.tops().map(Family::shared).unwrap_or_default(),
        }
    }

    /// Returns the Casimirs of all members, as formulas; none where they differ, and of tops.
    pub fn casimirs(&self, model: &OpenModel) -> Vec<String> {
        match self {
            Self::System { has_one_algebra: true, .. } => {
                model.system().base().casimirs().iter().map(ToString::to_string).collect()
            }
            _ => Vec::new(),
        }
    }
}
