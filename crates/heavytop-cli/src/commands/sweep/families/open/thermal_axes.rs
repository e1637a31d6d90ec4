//! The friction and the temperature of the members of a sweep.

use crate::configuration::{Config, ForceParameter, Parameter, Spread, SweepAxis};
use crate::errors::SweepError;

/// Checks that no member of a grid has a temperature without a friction, which would make the temperature void.
///
/// # Errors
/// Returns [`SweepError::Axis`] for the axis on which there is one.
pub(super) fn require_thermal(config: &Config, axes: &[SweepAxis]) -> Result<(), SweepError> {
    let axis = |of: &ForceParameter| {
        axes.iter().find(|axis| matches!(&axis.parameter, Parameter::Force(force) if force == of))
    };
    let (of_friction, of_temperature) =
        (axis(&ForceParameter::Friction), axis(&ForceParameter::Temperature));
    let friction = match of_friction {
        Some(axis) => ends(axis)[0],
        None => config.damping.as_ref().and_then(|damping| damping.friction),
    };
    let temperature = match of_temperature {
        Some(axis) => ends(axis)[1],
        None => config.noise.as_ref().and_then(|noise| noise.temperature),
    };
    let (Some(friction), Some(temperature)) = (friction, temperature) else { return Ok(()) };
    if friction != 0.0 || temperature <= 0.0 {
        return Ok(());
    }
    let needs = match of_friction {
        Some(_) => format!("numbers above 0 beside noise.temperature = {temperature}, got 0"),
        None => format!("damping.friction above 0 for temperatures up to {temperature}, got 0"),
    };
    let parameter = of_friction.or(of_temperature).map(|axis| axis.parameter.name());
    parameter.map_or(Ok(()), |parameter| Err(SweepError::Axis { parameter, needs }))
}

/// Returns the least and the largest number of an axis; of random ones there is none.
pub(super) fn ends(axis: &SweepAxis) -> [Option<f64>; 2] {
    match axis.spread {
        Spread::Grid { from, count: 1, .. } => [Some(from); 2],
        Spread::Grid { from, to, .. } => [Some(from.min(to)), Some(from.max(to))],
        Spread::Uniform { from, to } => [None, Some(from.max(to))],
        Spread::Normal { mean, .. } => [None, Some(mean)],
    }
}
