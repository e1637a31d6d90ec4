//! The table `[[sweep.axes]]`: a number that varies, and how.

use super::parameter::Parameter;
use crate::configuration::top::Quantity;
use crate::errors::SweepError;
use crate::vocabulary::brief::{number, text};
use serde::{Deserialize, Serialize};

/// The table `[[sweep.axes]]`: a grid by `from`, `to` and `count`, or random values by `uniform` or `normal`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct AxisConfig {
    /// The parameter that is varied.
    pub parameter: Parameter,
    /// The first value of a grid; an angle may be a text with its unit.
    pub from: Option<Quantity>,
    /// The last value of a grid; an angle may be a text with its unit.
    pub to: Option<Quantity>,
    /// The number of values of a grid.
    pub count: Option<u32>,
    /// The least and the largest random value.
    pub uniform: Option<[Quantity; 2]>,
    /// The mean and the standard deviation of random values.
    pub normal: Option<[Quantity; 2]>,
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
        let Self { parameter, count, normalise, .. } = self;
        let (count, normalise) = (*count, *normalise);
        let wrong = |needs: String| SweepError::Axis { parameter: parameter.name(), needs };
        let value = |quantity: &Quantity| self.value(quantity).map_err(wrong);
        let [from, to] = [&self.from, &self.to].map(|end| end.as_ref().map(value).transpose());
        let (from, to) = (from?, to?);
        let pair = |ends: &Option<[Quantity; 2]>| {
            let ends = ends.as_ref().map(|[one, other]| Ok([value(one)?, value(other)?]));
            ends.transpose()
        };
        let (uniform, normal) = (pair(&self.uniform)?, pair(&self.normal)?);
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
        let is_force = matches!(parameter, Parameter::Force(force) if force.is_never_negative());
        let least = match spread {
            Spread::Grid { from, to, .. } | Spread::Uniform { from, to } => from.min(to),
            // Members of a normal distribution are refused one by one.
            Spread::Normal { .. } => 0.0,
        };
        if is_force && least < 0.0 {
            return Err(wrong(format!("numbers of at least 0, got {}", number(least))));
        }
        let is_component = matches!(parameter, Parameter::Top(top) if top.is_component());
        if normalise && !is_component {
            return Err(wrong("no normalise: it is not a component of a unit vector".into()));
        }
        Ok(SweepAxis { parameter: parameter.clone(), spread, normalise })
    }
}

impl AxisConfig {
    /// Returns a value of the axis, an angle in radians.
    ///
    /// # Errors
    /// Returns what is needed, if an angle has no known unit or is outside its range, or another value is a text.
    fn value(&self, quantity: &Quantity) -> Result<f64, String> {
        let angle = match &self.parameter {
            Parameter::Top(parameter) => parameter.angle(),
            Parameter::System(_) | Parameter::Force(_) => None,
        };
        match (angle, quantity) {
            (Some(_), Quantity::Number(value)) if !value.is_finite() => Ok(*value),
            (Some(range), quantity) => {
                range.radians(quantity).map_err(|what| format!("an angle: it {what}"))
            }
            (None, Quantity::Number(value)) => Ok(*value),
            (None, Quantity::Text(written)) => Err(format!("numbers, got `{}`", text(written))),
        }
    }
}

impl SweepAxis {
    /// Returns whether the values are a grid.
    pub fn is_grid(&self) -> bool {
        matches!(self.spread, Spread::Grid { .. })
    }
}
