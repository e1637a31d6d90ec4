//! The plan of a sweep: the family of its members, and the values of the axes for each, by its number.

use super::families::array_family::ArrayFamily;
use super::families::course::Course;
use super::families::family::Family;
use super::families::open::open_family::OpenFamily;
use super::families::system_family::SystemFamily;
use super::families::top_family::TopFamily;
use crate::configuration::{
    Column, Config, Integration, Parameter, Spread, SweepAxis, SweepConfig, SystemConfig,
    SystemTable,
};
use crate::errors::{Error, SweepError};
use crate::runs::Schedule;
use lie_poisson_runs::step_angle::usual_step;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The largest number of members; more must be a typing error.
const MOST_MEMBERS: f64 = 1e9;

/// The number of members whose fastest rates choose the step.
const TRIED: u64 = 64;

/// The columns of the table besides those of axes and observables.
pub(super) const INDEX: &str = "index";
pub(super) const FAILURE: &str = "failure";

/// A sweep whose configuration has been checked.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub family: Arc<dyn Family>,
    pub axes: Vec<SweepAxis>,
    /// The columns of all observables.
    pub columns: Vec<Column>,
    pub course: Course,
    /// The number of members.
    pub members: u64,
    seed: u64,
    /// The configuration with every key that was left out and plays a part.
    pub config: Config,
}

impl Plan {
    /// Reads the sweep of the tops or of the system that a configuration asks for.
    ///
    /// # Errors
    /// If the sweep makes no sense for any member.
    pub fn new(config: &Config) -> Result<Self, Error> {
        let system = config.system()?;
        let mut sweep = config.sweep.clone().unwrap_or_default();
        // The numbers of a system have names of its own, of which none varies by default.
        let own = || if system.is_some() { Vec::new() } else { SweepConfig::axes_of_tops() };
        let axes = &*sweep.axes.get_or_insert_with(own);
        let axes = axes.iter().map(|axis| axis.axis()).collect::<Result<Vec<_>, _>>()?;
        require_some(&axes, &sweep)?;
        let members = number_of_members(&axes, sweep.count)?;
        let (family, integration): (Arc<dyn Family>, _) = match system {
            Some(table) => match table.array_system()? {
                Some(system) => {
                    config.require_closed()?;
                    let (family, integration) = ArrayFamily::new((table, system), config, &axes)?;
                    (Arc::new(family), integration)
                }
                None if config.is_open()? || opens(table, &axes) => {
                    let (family, integration) = OpenFamily::new(config, &axes)?;
                    (Arc::new(family), integration)
                }
                None => {
                    let (family, integration) = SystemFamily::new(table, config, &axes)?;
                    (Arc::new(family), integration)
                }
            },
            None if config.is_open()? => {
                let (family, integration) = OpenFamily::new(config, &axes)?;
                (Arc::new(family), integration)
            }
            None => {
                let (family, integration) = TopFamily::new(config, &axes)?;
                (Arc::new(family), integration)
            }
        };
        let (observables, seed) = (sweep.observables.clone(), sweep.seed);
        let columns = observables.iter().map(|observable| family.columns(*observable));
        let columns = columns.collect::<Result<Vec<_>, _>>()?.concat();
        require_different_names(&axes, &columns)?;
        let integration = match config.integrator.step {
            Some(_) => integration,
            None => {
                let has_end = config.integrator.end.is_some();
                with_step(integration, &*family, (&axes, seed), (members, has_end))
            }
        };
        let schedule = Schedule::new(integration.step, integration.end)?;
        let course = Course { schedule, observables };
        let integrator = integration.into();
        let config = Config { integrator, sweep: Some(sweep), ..config.clone() };
        Ok(Self { family, axes, columns, course, members, seed, config })
    }

    /// Returns the word for several members.
    pub fn nouns(&self) -> &'static str {
        self.family.nouns()[1]
    }

    /// Returns the values of the axes for a member. In a grid the last axis runs fastest.
    ///
    /// The values depend on the configuration and the number alone. Each member draws random values from a ChaCha8
    /// stream of its own.
    pub fn parameters(&self, number: u64) -> Vec<f64> {
        parameters(&self.axes, self.seed, number)
    }
}

/// Returns whether an axis varies a parameter with some values of which the Hamiltonian depends on the time.
fn opens(table: &SystemConfig, axes: &[SweepAxis]) -> bool {
    axes.iter().any(|axis| match &axis.parameter {
        Parameter::System(number) => {
            number.table == SystemTable::Parameters && table.opens_with(&number.name)
        }
        _ => false,
    })
}

/// Returns an integrator whose step is not too long for the members that are tried, spread over all of them. Those that do not
/// exist have no say. An end that is left out comes with the step, so that the number of steps stays.
fn with_step(
    integration: Integration,
    family: &dyn Family,
    (axes, seed): (&[SweepAxis], u64),
    (members, has_end): (u64, bool),
) -> Integration {
    let tried = TRIED.min(members);
    let last = (members.saturating_sub(1), tried.saturating_sub(1).max(1));
    let numbers = (0..tried).map(|n| n * last.0 / last.1);
    let rates = numbers.filter_map(|n| family.fastest_rate(&parameters(axes, seed, n)).ok());
    let fastest = rates.filter(|rate| rate.is_finite()).fold(0.0, f64::max);
    let Integration { step, end, .. } = integration;
    let shorter = usual_step(step.abs(), end, fastest).copysign(step);
    let end = if has_end { end } else { end * (shorter / step) };
    Integration { step: shorter, end, ..integration }
}

/// Returns the values of the axes for a member: [`Plan::parameters`].
fn parameters(axes: &[SweepAxis], seed: u64, number: u64) -> Vec<f64> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
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
    let mut values: Vec<f64> = axes.iter().rev().map(value).collect();
    values.reverse();
    values
}

/// Checks that there are axes and observables, none of these twice.
fn require_some(axes: &[SweepAxis], sweep: &SweepConfig) -> Result<(), SweepError> {
    let observables = &sweep.observables;
    if axes.is_empty() {
        return Err(SweepError::NoAxes);
    }
    if observables.is_empty() {
        return Err(SweepError::NoObservables);
    }
    if observables.iter().enumerate().any(|(n, o)| observables[..n].contains(o)) {
        return Err(SweepError::Twice);
    }
    Ok(())
}

/// Checks that no two columns of the table have one name: coordinates of a system may have any.
fn require_different_names(axes: &[SweepAxis], columns: &[Column]) -> Result<(), SweepError> {
    let axes = axes.iter().map(|axis| axis.parameter.name());
    let names = [INDEX, FAILURE].map(String::from).into_iter().chain(axes);
    let mut names: Vec<String> = names.chain(columns.iter().map(|c| c.name.clone())).collect();
    names.sort();
    match names.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(SweepError::SameColumn { name: pair[0].clone() }),
        None => Ok(()),
    }
}

fn number_of_members(axes: &[SweepAxis], count: Option<u32>) -> Result<u64, SweepError> {
    let counts = axes.iter().filter_map(|axis| match axis.spread {
        Spread::Grid { count, .. } => Some(f64::from(count)),
        _ => None,
    });
    let runs = match axes.iter().filter(|axis| axis.is_grid()).count() {
        0 => f64::from(count.filter(|count| *count > 0).ok_or(SweepError::Count)?),
        grids if grids < axes.len() => return Err(SweepError::Mixed),
        _ if count.is_some() => return Err(SweepError::Count),
        _ => counts.product(),
    };
    if runs > MOST_MEMBERS {
        return Err(SweepError::TooMany { runs, most: MOST_MEMBERS });
    }
    Ok(runs as u64)
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
        let values: Vec<Vec<f64>> = (0..plan.members).map(|n| plan.parameters(n)).collect();
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
        let values: Vec<Vec<f64>> = (0..plan.members).map(|n| plan.parameters(n)).collect();
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
}
