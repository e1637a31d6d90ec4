//! The plan of a sweep: the parameters of each top, by its number.

use crate::Error;
use crate::configuration::{
    BodyConfig, Column, Config, InitialConfig, Integration, Observable, Spread, SweepAxis,
};
use crate::errors::SweepError;
use crate::runs::Schedule;
use crate::runs::step_angle::require_sane_step;
use heavytop::HeavyTop;
use heavytop::methods::{Formulation, Method, Scheme};
use lie_poisson::Se3Dual;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::f64::consts::TAU;

/// The largest number of tops; more must be a typing error.
const MOST_TOPS: f64 = 1e9;

/// A sweep whose configuration has been checked.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plan {
    pub body: BodyConfig,
    pub initial: InitialConfig,
    pub axes: Vec<SweepAxis>,
    pub observables: Vec<Observable>,
    pub method: Method,
    pub schedule: Schedule,
    /// The number of tops.
    pub tops: u64,
    pub seed: u64,
}

impl Plan {
    /// Returns the configuration with every key that was left out and plays a part.
    pub fn complete(config: &Config) -> Config {
        let integrator = config.integrator.or(Integration {
            formulation: Formulation::Reduced,
            scheme: Scheme::Gauss(4),
            step: 0.1,
            ..Integration::default()
        });
        let sweep = config.sweep.clone().unwrap_or_default();
        Config { integrator: integrator.into(), sweep: Some(sweep), ..config.clone() }
    }

    /// Reads the sweep that a complete configuration asks for.
    ///
    /// # Errors
    /// If the sweep makes no sense for any top.
    pub fn new(config: &Config) -> Result<Self, Error> {
        let sweep = config.sweep.clone().unwrap_or_default();
        let axes = sweep.axes.iter().map(|axis| axis.axis()).collect::<Result<Vec<_>, _>>()?;
        require_consistent(&axes, &sweep.observables)?;
        let tops = number_of_tops(&axes, sweep.count)?;
        let of_momentum = |axis: &&SweepAxis| axis.parameter.is_angular_momentum();
        if let (Some(_), Some(axis)) =
            (config.initial.angular_velocity, axes.iter().find(of_momentum))
        {
            return Err(SweepError::Velocity { axis: axis.parameter.name() }.into());
        }
        // What no axis changes is either right or wrong for every top.
        if !axes.iter().any(|axis| axis.parameter.is_of_body()) {
            config.top()?;
        }
        if axes.iter().all(|axis| axis.parameter.is_of_body()) {
            config.start()?;
        }
        let integration = config.integrator.or(Integration::default());
        Ok(Self {
            body: config.body,
            initial: config.initial,
            axes,
            observables: sweep.observables.clone(),
            method: integration.method()?,
            schedule: Schedule::new(integration.step, integration.end)?,
            tops,
            seed: sweep.seed,
        })
    }

    /// Returns the columns of all observables.
    pub fn columns(&self) -> impl Iterator<Item = &'static Column> {
        self.observables.iter().flat_map(|observable| observable.columns())
    }

    /// Returns the values of the axes for a top. In a grid the last axis runs fastest.
    ///
    /// The values depend on the configuration and the number alone. Each top draws random values from a ChaCha8
    /// stream of its own.
    pub fn parameters(&self, number: u64) -> Vec<f64> {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        random.set_stream(number);
        let mut rest = number;
        let value = |axis: &SweepAxis| match axis.spread {
            Spread::Grid { from, to, count } => {
                let (count, last) = (u64::from(count), u64::from(count.max(2) - 1));
                let along = (rest % count) as f64 / last as f64;
                rest /= count;
                // At both ends the value is exactly the configured one.
                from * (1.0 - along) + to * along
            }
            Spread::Uniform { from, to } => {
                let along = uniform(&mut random);
                from * (1.0 - along) + to * along
            }
            Spread::Normal { mean, deviation } => mean + deviation * normal(&mut random),
        };
        let mut values: Vec<f64> = self.axes.iter().rev().map(value).collect();
        values.reverse();
        values
    }

    /// Returns the top and its start at these values of the axes.
    ///
    /// # Errors
    /// If there is no such top or no such start, or the top turns too far in a step.
    pub fn top(&self, values: &[f64]) -> Result<(HeavyTop, Se3Dual), Error> {
        let (mut body, mut initial) = (self.body, self.initial);
        for azimuths in [false, true] {
            let axes = self.axes.iter().zip(values);
            for (axis, value) in axes.filter(|(axis, _)| axis.parameter.is_azimuth() == azimuths) {
                axis.parameter.set(*value, &mut body, &mut initial);
            }
        }
        for axis in self.axes.iter().filter(|axis| axis.normalise) {
            axis.parameter.normalise(&mut body, &mut initial);
        }
        let config = Config { body, initial, ..Config::default() };
        let (top, start) = (config.top()?, config.start()?);
        require_sane_step(&top, &start, self.schedule.step)?;
        Ok((top, start))
    }
}

fn require_consistent(axes: &[SweepAxis], observables: &[Observable]) -> Result<(), SweepError> {
    if axes.is_empty() {
        return Err(SweepError::NoAxes);
    }
    if observables.is_empty() {
        return Err(SweepError::NoObservables);
    }
    if observables.iter().enumerate().any(|(n, o)| observables[..n].contains(o)) {
        return Err(SweepError::Twice);
    }
    for (n, axis) in axes.iter().enumerate() {
        if let Some(other) = axes[..n].iter().find(|other| other.clashes(axis)) {
            let (first, second) = (other.parameter.name(), axis.parameter.name());
            return Err(SweepError::Clash { first, second });
        }
    }
    Ok(())
}

fn number_of_tops(axes: &[SweepAxis], count: Option<u32>) -> Result<u64, SweepError> {
    let counts = axes.iter().filter_map(|axis| match axis.spread {
        Spread::Grid { count, .. } => Some(f64::from(count)),
        _ => None,
    });
    let tops = match axes.iter().filter(|axis| axis.is_grid()).count() {
        0 => f64::from(count.filter(|count| *count > 0).ok_or(SweepError::Count)?),
        grids if grids < axes.len() => return Err(SweepError::Mixed),
        _ if count.is_some() => return Err(SweepError::Count),
        _ => counts.product(),
    };
    if tops > MOST_TOPS {
        return Err(SweepError::TooMany { tops, most: MOST_TOPS });
    }
    Ok(tops as u64)
}

/// Draws a uniform random number in [0, 1).
fn uniform(random: &mut ChaCha8Rng) -> f64 {
    (random.next_u64() >> 11) as f64 * 0.5_f64.powi(53)
}

/// Draws a normal random number with mean 0 and variance 1.
///
/// Source: G. E. P. Box & M. E. Muller, *A note on the generation of random normal deviates*,
/// Ann. Math. Statist. 29 (1958). By `libm`: the same bits on every machine.
fn normal(random: &mut ChaCha8Rng) -> f64 {
    let (first, second) = (1.0 - uniform(random), uniform(random));
    libm::sqrt(-2.0 * libm::log(first)) * libm::cos(TAU * second)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn plan(text: &str) -> Plan {
        Plan::new(&toml::from_str(text).unwrap()).unwrap()
    }

    #[test]
    fn grids_are_in_row_major_order_and_have_their_ends() {
        let plan = plan(
            "[[sweep.axes]]\nparameter = 'body.mass'\nfrom = 1\nto = 2\ncount = 2\n\
             [[sweep.axes]]\nparameter = 'body.length'\nfrom = 0.1\nto = 0.7\ncount = 3",
        );
        let values: Vec<Vec<f64>> = (0..plan.tops).map(|n| plan.parameters(n)).collect();
        let expected = [[1.0, 0.1], [1.0, 0.4], [1.0, 0.7], [2.0, 0.1], [2.0, 0.4], [2.0, 0.7]];
        assert!(
            values
                .iter()
                .flatten()
                .zip(expected.as_flattened())
                .all(|(a, b)| (a - b).abs() < 1e-15)
        );
        assert_eq!((values[0][1], values[5][1]), (0.1, 0.7));
    }

    /// The mean and the variance of 4000 tops are known to 1/√4000 = 1.6 %; the bounds are five times that.
    #[test]
    fn random_tops_have_their_distribution_and_know_nothing_of_each_other() {
        let text = "sweep.count = 4000\nsweep.axes = [{ parameter = 'body.mass', normal = [3, 0.5] }, \
                    { parameter = 'body.length', uniform = [1, 2] }]";
        let plan = plan(text);
        let values: Vec<Vec<f64>> = (0..plan.tops).map(|n| plan.parameters(n)).collect();
        let moments = |axis: usize| {
            let n = values.len() as f64;
            let mean = values.iter().map(|v| v[axis]).sum::<f64>() / n;
            (mean, values.iter().map(|v| (v[axis] - mean).powi(2)).sum::<f64>() / n)
        };
        let ((mean, variance), (middle, width)) = (moments(0), moments(1));
        assert!((mean - 3.0).abs() < 0.04 && (variance / 0.25 - 1.0).abs() < 0.12);
        assert!((middle - 1.5).abs() < 0.03 && (width * 12.0 - 1.0).abs() < 0.1);
        assert!(values.iter().all(|v| (1.0..2.0).contains(&v[1])));
        // Top 7 of a longer sweep is the same; with another seed it is another one.
        let longer = self::plan(&text.replace("4000", "5000"));
        assert_eq!(longer.parameters(7), values[7]);
        assert_ne!(self::plan(&format!("sweep.seed = 1\n{text}")).parameters(7), values[7]);
        assert_ne!(values[7], values[8]);
    }

    #[test]
    fn the_inclination_is_set_before_the_azimuth() {
        let plan = plan(
            "initial.vertical = [0, 0, 1]\nsweep.axes = [\
             { parameter = 'initial.vertical.azimuth', from = 1.5, to = 1.5, count = 1 }, \
             { parameter = 'initial.vertical.inclination', from = 0.5, to = 0.5, count = 1 }]",
        );
        let gamma = plan.top(&plan.parameters(0)).unwrap().1.0.1;
        assert!(
            (gamma.y.atan2(gamma.x) - 1.5).abs() < 1e-15 && (gamma.z.acos() - 0.5).abs() < 1e-15
        );
    }
}
