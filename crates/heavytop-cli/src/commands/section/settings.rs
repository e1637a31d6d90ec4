//! The settings of a section: energy level, surface, starts and integrator.

use crate::Error;
use crate::configuration::{Config, Integration, SectionConfig};
use crate::runs::step_angle::MOST_TURN;
use heavytop::methods::{Formulation, Method, Scheme};
use heavytop::{EnergyLevel, HeavyTop, Invariant, Section, Surface};

/// The largest turn of any body on the energy level in one step, rad, if the configuration gives no step. The Gauss
/// method of order 8 then conserves the energy to a relative error of some 1e-11.
const TURN: f64 = 0.5;

/// The largest number of points; more must be a typing error.
const MOST_POINTS: f64 = 1e7;

/// The largest number of steps for each start; more must be a typing error.
const MOST_STEPS: f64 = 1e12;

/// A section, and how its points are computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Settings {
    pub section: Section,
    pub method: Method,
    /// The time step, s.
    pub step: f64,
    /// The time for which a start is followed at most, up to a step, s.
    pub longest: f64,
    /// The number of steps for each start.
    pub steps: usize,
    /// The number of returns of each start.
    pub crossings: usize,
    /// The number of starts.
    pub starts: usize,
    pub seed: u64,
}

impl Settings {
    /// Reads the section that the configuration asks for.
    ///
    /// # Errors
    /// If there is no such section.
    pub fn new(config: &Config) -> Result<Self, Error> {
        let (top, initial) = (config.top()?, config.start()?);
        let settings = config.section.unwrap_or_default();
        let of_initial = |invariant: Invariant| invariant.value(&top, &initial);
        let level = EnergyLevel {
            top,
            energy: settings.energy.unwrap_or(of_initial(Invariant::Energy)),
            vertical_momentum: settings
                .vertical_momentum
                .unwrap_or(of_initial(Invariant::VerticalMomentum)),
        };
        let SectionConfig { surface: coordinate, level: value, direction, seed, .. } = settings;
        let section = Section::new(level, Surface { coordinate, level: value, direction })?;

        let rate = fastest(&top, level.energy);
        let Integration { formulation, scheme, step, tolerance, .. } =
            config.integrator.or(Integration {
                formulation: Formulation::Reduced,
                scheme: Scheme::Gauss(4),
                step: TURN / rate,
                ..Integration::default()
            });
        let method = Method::new(formulation, scheme, tolerance)?;
        for (name, value) in [("step", step), ("longest", settings.longest)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::OutOfRange { name, range: "positive and finite", value });
            }
        }
        if step * rate > MOST_TURN {
            return Err(Error::AbsurdStep { step, angle: step * rate, most: MOST_TURN });
        }
        let steps = (settings.longest / step).ceil();
        if steps > MOST_STEPS {
            return Err(Error::TooManySteps { steps, most: MOST_STEPS });
        }
        let (starts, crossings) = (settings.starts, settings.crossings);
        for (name, value) in [("starts", starts), ("crossings", crossings)] {
            if value == 0 {
                return Err(Error::OutOfRange { name, range: "at least 1", value: 0.0 });
            }
        }
        let points = f64::from(starts) * f64::from(crossings);
        if points > MOST_POINTS {
            let (name, range) = ("starts × crossings", "at most 1e7");
            return Err(Error::OutOfRange { name, range, value: points });
        }
        let (starts, crossings, steps) = (starts as usize, crossings as usize, steps as usize);
        let longest = settings.longest;
        Ok(Self { section, method, step, longest, steps, crossings, starts, seed })
    }

    /// Returns the configuration with every key that was left out and plays a part.
    pub fn complete(&self, config: &Config) -> Config {
        let Self { section, method, step, .. } = self;
        let (formulation, scheme) = (method.formulation(), method.scheme());
        let own = Integration { formulation, scheme, step: *step, ..Integration::default() };
        let section = SectionConfig {
            energy: Some(section.level().energy),
            vertical_momentum: Some(section.level().vertical_momentum),
            ..config.section.unwrap_or_default()
        };
        let integrator = config.integrator.or(own).into();
        Config { integrator, section: Some(section), ..config.clone() }
    }
}

/// Returns an upper bound of the angular velocity on the energy level and of the frequency of a pendulum: √(2(E + m g
/// l)/I) + √(m g l/I), I the least moment, 1/s.
fn fastest(top: &HeavyTop, energy: f64) -> f64 {
    let (weight, moment) = (top.weight_moment(), top.inertia().min());
    let kinetic = (energy + weight).max(0.0);
    (2.0 * kinetic / moment).sqrt() + (weight / moment).sqrt()
}
