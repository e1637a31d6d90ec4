//! A family of tops.

use super::course::Course;
use super::family::{Family, own_integration, require_apart};
use super::fixed_values::fixed_values;
use super::gauge::{Gauge, Quantity};
use super::measured_motion::measure;
use crate::configuration::{
    BodyConfig, Column, Config, Inertia, InitialConfig, Integration, Observable, Parameter,
    SweepAxis, TopParameter,
};
use crate::errors::{Error, SweepError};
use heavytop::Invariant;
use heavytop::methods::{Formulation, Method};
use lie_poisson::Se3Dual;
use lie_poisson_runs::step_angle::{fastest_rate_of_top, require_sane_step};
use lie_poisson_runs::{Model, TopInAxes};

/// Tops whose parameters or initial states differ.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::sweep) struct TopFamily {
    body: BodyConfig,
    initial: InitialConfig,
    /// The parameter of each axis, and whether its unit vector is scaled to length 1.
    parameters: Vec<(TopParameter, bool)>,
    method: Method,
    /// What the configuration says against its body, if no axis changes the body.
    body_warning: Option<String>,
    /// Whether an axis changes the body, and its mass and length are known.
    judges_bodies: bool,
}

impl TopFamily {
    /// Reads the tops that the axes describe, and the integrator with what `[integrator]` leaves out.
    ///
    /// # Errors
    /// If the family makes no sense for any top.
    pub fn new(config: &Config, axes: &[SweepAxis]) -> Result<(Self, Integration), Error> {
        let parameter = |axis: &SweepAxis| match &axis.parameter {
            Parameter::Top(parameter) => Ok((*parameter, axis.normalise)),
            other => Err(SweepError::OfAnother {
                parameter: other.name(),
                of: other.table(),
                has: "vary a number of [body] or [initial]".into(),
            }),
        };
        let parameters = axes.iter().map(parameter).collect::<Result<Vec<_>, _>>()?;
        require_apart(axes, &parameters, |(one, _), (other, _)| one.clashes(*other))?;
        let of_momentum = parameters.iter().find(|(parameter, _)| parameter.is_angular_momentum());
        if let (Some(_), Some((parameter, _))) = (config.initial.angular_velocity, of_momentum) {
            return Err(SweepError::Velocity { axis: parameter.name().into() }.into());
        }
        let of_velocity = parameters.iter().find(|(parameter, _)| parameter.is_angular_velocity());
        if let (None, Some((parameter, _))) = (config.initial.angular_velocity, of_velocity) {
            return Err(SweepError::Momentum { axis: parameter.name().into() }.into());
        }
        config.require_position()?;
        let body = &config.body;
        for (parameter, _) in &parameters {
            let axis = || parameter.name().to_owned();
            match (parameter, body.inertia) {
                (TopParameter::Inertia(_), Inertia::Matrix(_)) => {
                    return Err(SweepError::Matrix { axis: axis() }.into());
                }
                // m = g = l = 1 is as good as any where m g l is 1.
                _ if parameter.is_factor() && body.weight_moment.is_some_and(|w| w != 1.0) => {
                    return Err(SweepError::Weight { axis: axis() }.into());
                }
                _ => {}
            }
        }
        // What no axis changes is either right or wrong for every top.
        if !parameters.iter().any(|(parameter, _)| parameter.is_of_body()) {
            config.top()?;
        }
        if parameters.iter().all(|(parameter, _)| parameter.is_of_body()) {
            config.start()?;
        }
        let integration = config.integrator.or(own_integration(Formulation::Reduced));
        let (body, initial, method) = (config.body, config.initial, integration.method()?);
        let is_varied = parameters.iter().any(|(parameter, _)| parameter.is_of_body());
        let body_warning = config.body_warning().filter(|_| !is_varied);
        let is_set = |key: &str| parameters.iter().any(|(parameter, _)| parameter.name() == key);
        let judges_bodies = is_varied && config.gives_position(is_set);
        let family = Self { body, initial, parameters, method, body_warning, judges_bodies };
        Ok((family, integration))
    }

    /// Returns the top and its start, in principal axes, at these values of the axes of the sweep.
    ///
    /// # Errors
    /// If there is no such top or no such start, or the top turns too far in a step (s).
    pub fn top(&self, values: &[f64], step: f64) -> Result<(TopInAxes, Se3Dual), Error> {
        let (body, initial) = self.tables(values);
        let config = Config { body, initial, ..Config::default() };
        let (model, start) = (config.model()?, config.start()?);
        require_sane_step(&model, &TopInAxes::coordinates(&start), step)?;
        Ok((model, start))
    }

    /// Returns the tables `[body]` and `[initial]` at these values of the axes.
    pub(super) fn tables(&self, values: &[f64]) -> (BodyConfig, InitialConfig) {
        let (mut body, mut initial) = (self.body, self.initial);
        for azimuths in [false, true] {
            for ((parameter, _), value) in self.parameters.iter().zip(values) {
                if parameter.is_azimuth() == azimuths {
                    parameter.set(*value, &mut body, &mut initial);
                }
            }
        }
        for (parameter, _) in self.parameters.iter().filter(|(_, normalise)| *normalise) {
            parameter.normalise(&mut body, &mut initial);
        }
        (body, initial)
    }

    /// Returns whether the unit vector of a parameter is scaled to length 1.
    fn is_scaled(&self, (parameter, normalise): (TopParameter, bool)) -> bool {
        let in_table =
            if parameter.is_of_body() { self.body.normalise } else { self.initial.normalise };
        parameter.is_component() && (normalise || in_table)
    }
}

impl Family for TopFamily {
    fn nouns(&self) -> [&'static str; 2] {
        ["top", "tops"]
    }

    fn method(&self) -> &Method {
        &self.method
    }

    fn member(&self, values: &[f64], step: f64) -> Result<(Box<dyn Model>, Vec<f64>), Error> {
        let (model, start) = self.top(values, step)?;
        Ok((Box::new(model), TopInAxes::coordinates(&start).to_vec()))
    }

    /// Returns an upper bound on the energy level of the start: a top that is let go at rest will fall.
    fn fastest_rate(&self, values: &[f64]) -> Result<f64, Error> {
        let (model, start) = self.top(values, 0.0)?;
        Ok(fastest_rate_of_top(&model.top, Invariant::Energy.value(&model.top, &start)))
    }

    fn warnings(&self) -> Vec<String> {
        let of_method = TopInAxes::method_warning(&self.method);
        let warnings = [of_method, self.body_warning.clone()];
        warnings.into_iter().flatten().collect()
    }

    fn judges_members(&self) -> bool {
        self.judges_bodies
    }

    fn impossibility(&self, values: &[f64]) -> Option<String> {
        self.tables(values).0.impossibility().map(|reason| reason.to_string())
    }

    fn columns(&self, observable: Observable) -> Result<Vec<Column>, SweepError> {
        Ok(observable.columns())
    }

    fn labels(&self) -> Vec<String> {
        let label = |of: &(TopParameter, bool)| {
            let before = if self.is_scaled(*of) { ", before scaling to length 1" } else { "" };
            of.0.label() + before
        };
        self.parameters.iter().map(label).collect()
    }

    fn run_values(&self, values: &[f64]) -> Vec<f64> {
        let (body, initial) = self.tables(values);
        let run = |((parameter, _), value): (&(TopParameter, bool), &f64)| {
            parameter.component_run(&body, &initial).unwrap_or(*value)
        };
        self.parameters.iter().zip(values).map(run).collect()
    }

    fn shared(&self) -> Vec<String> {
        let is_varied = |number| self.parameters.iter().any(|(parameter, _)| *parameter == number);
        fixed_values(&self.body, &self.initial, is_varied)
    }

    fn casimirs(&self) -> Vec<String> {
        Vec::new()
    }

    fn measure(&self, values: &[f64], course: &Course) -> Result<Vec<Option<f64>>, Error> {
        let (model, start) = self.top(values, course.schedule.step)?;
        let from = TopInAxes::coordinates(&start);
        let quantities = CONSERVED.map(|invariant| (model.top, invariant));
        let each = quantities.iter().map(|quantity| Some(quantity as &dyn Quantity)).collect();
        let wants_sizes = course.observables.contains(&Observable::RelativeDrift);
        let gauge = Gauge::new(&model, each, (&from, wants_sizes));
        let mut gauge = gauge.with_nutation(&model.top, &from);
        measure(&model, (&self.method, &from), &mut gauge, course)
    }
}

const CONSERVED: [Invariant; 3] =
    [Invariant::Energy, Invariant::VerticalSquared, Invariant::VerticalMomentum];

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn the_inclination_is_set_before_the_azimuth() {
        let config: Config = toml::from_str(
            "initial.vertical = [0, 0, 1]\nsweep.axes = [\
             { parameter = 'initial.vertical.azimuth', from = 1.5, to = 1.5, count = 1 }, \
             { parameter = 'initial.vertical.inclination', from = 0.5, to = 0.5, count = 1 }]",
        )
        .unwrap();
        let axes = config.sweep.as_ref().unwrap().axes.as_ref().unwrap();
        let axes: Vec<SweepAxis> = axes.iter().map(|axis| axis.axis().unwrap()).collect();
        let (family, integration) = TopFamily::new(&config, &axes).unwrap();
        let gamma = family.top(&[1.5, 0.5], integration.step).unwrap().1.0.1;
        assert!(
            (gamma.y.atan2(gamma.x) - 1.5).abs() < 1e-15 && (gamma.z.acos() - 0.5).abs() < 1e-15
        );
    }
}
