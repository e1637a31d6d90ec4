//! The table `[[sweep.axes]]`: a number that varies, and how.

use super::parameter::Parameter;
use crate::errors::SweepError;
use crate::vocabulary::brief::number;
use serde::{Deserialize, Serialize};

/// The table `[[sweep.axes]]`: a grid by `from`, `to` and `count`, or random values by `uniform` or `normal`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct AxisConfig {
    /// The parameter that is varied.
    pub parameter: Parameter,
    /// The first value of a grid.
    pub from: Option<f64>,
    /// The last value of a grid.
    pub to: Option<f64>,
    /// The number of values of a grid.
    pub count: Option<u32>,
    /// The least and the largest random value.
    pub uniform: Option<[f64; 2]>,
    /// The mean and the standard deviation of random values.
    pub normal: Option<[f64; 2]>,
    /// Whether the vector that contains the parameter is scaled to length 1 afterwards.
    #[serde(default)]
    pub normalise: bool,
}

/// The rule by which the values of an axis are chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Spread {
    Grid { from: f64, to: f64, count: u32 },
    Uniform { from: f64, to: f64 },
    Normal { mean: f64, deviation: f64 },
}

/// An axis of a sweep that has been checked.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SweepAxis {
    pub parameter: Parameter,
    pub spread: Spread,
    pub normalise: bool,
}

impl AxisConfig {
    /// Checks the keys and returns the axis.
    ///
    /// # Errors
    /// If it does not have exactly the keys of one kind, with finite numbers.
    pub(crate) fn axis(&self) -> Result<SweepAxis, SweepError> {
        let Self { ref parameter, from, to, count, uniform, normal, normalise } = *self;
        let wrong = |needs: String| SweepError::Axis { parameter: parameter.name(), needs };
        let spread = match (from, to, count, uniform, normal) {
            (Some(from), Some(to), Some(count), None, None) => Spread::Grid { from, to, count },
            (None, None, None, Some([from, to]), None) => Spread::Uniform { from, to },
            (None, None, None, None, Some([mean, deviation])) => Spread::Normal { mean, deviation },
            _ => return Err(wrong("either from, to and count, or uniform, or normal".into())),
        };
        let numbers = [from, to].into_iter().flatten();
        let mut numbers = numbers.chain(uniform.into_iter().chain(normal).flatten());
        if let Some(value) = numbers.find(|value| !value.is_finite()) {
            return Err(wrong(format!("finite numbers, got {value}")));
        }
        match spread {
            Spread::Grid { count: 0, .. } => {
                return Err(wrong("a count of at least 1, got 0".into()));
            }
            Spread::Normal { deviation, .. } if deviation < 0.0 => {
                return Err(wrong(format!(
                    "a standard deviation that is not negative, got {}",
                    number(deviation)
                )));
            }
            _ => {}
        }
        let is_component = matches!(parameter, Parameter::Top(top) if top.is_component());
        if normalise && !is_component {
            return Err(wrong("no normalise: it is not a component of a unit vector".into()));
        }
        Ok(SweepAxis { parameter: parameter.clone(), spread, normalise })
    }
}

impl SweepAxis {
    /// Returns whether the values are a grid.
    pub fn is_grid(&self) -> bool {
        matches!(self.spread, Spread::Grid { .. })
    }
}
