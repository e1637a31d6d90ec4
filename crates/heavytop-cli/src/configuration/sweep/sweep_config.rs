//! The table `[sweep]`: which motions, and which observables of them.

use super::axis_config::AxisConfig;
use super::observable::Observable;
use super::parameter::Parameter;
use super::top_parameter::TopParameter;
use crate::configuration::top::Quantity;
use serde::{Deserialize, Serialize};

/// The table `[sweep]`: which motions, and which observables of them.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct SweepConfig {
    /// The quantities that are measured for each motion.
    pub observables: Vec<Observable>,
    /// The number of motions, where the axes are random.
    pub count: Option<u32>,
    /// The seed of the random numbers.
    pub seed: u64,
    /// The parameters that are varied, and how; without them, for a top, a grid of 32 × 32 angular momenta.
    pub axes: Option<Vec<AxisConfig>>,
}

impl Default for SweepConfig {
    fn default() -> Self {
        Self { observables: vec![Observable::Megno], count: None, seed: 0, axes: None }
    }
}

impl SweepConfig {
    /// Returns the axes of a sweep of tops that gives none: a grid of 32 × 32 angular momenta.
    pub(crate) fn axes_of_tops() -> Vec<AxisConfig> {
        let axis = |i| AxisConfig {
            parameter: Parameter::Top(TopParameter::AngularMomentum(i)),
            from: Some(Quantity::Number(-4.0)),
            to: Some(Quantity::Number(4.0)),
            count: Some(32),
            uniform: None,
            normal: None,
            normalise: false,
        };
        vec![axis(0), axis(2)]
    }
}
