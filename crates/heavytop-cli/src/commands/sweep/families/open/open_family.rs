//! A family of motions that are driven, damped, noisy or under a torque.

use super::subject::Subject;
use super::thermal_axes::{ends, require_thermal};
use crate::commands::sweep::families::course::Course;
use crate::commands::sweep::families::family::{
    Family, drift_columns, end_columns, own_integration, require_apart,
};
use crate::commands::sweep::families::measured_motion::follow;
use crate::commands::sweep::families::varied_number::component;
use crate::configuration::{
    Column, Config, ForceParameter, Integration, Observable, OpenModel, OpenStart, Parameter,
    SweepAxis,
};
use crate::errors::{Error, SweepError};
use collective_integrators::diagnostics::RunAccuracy;
use heavytop::methods::{Formulation, Method};
use lie_poisson_runs::Model;
use lie_poisson_runs::step_angle::require_run;

/// Motions of a top or of a system with forces, whose parameters, starts or forces differ. All have the same path of a noise.
#[derive(Debug)]
pub(in crate::commands::sweep) struct OpenFamily {
    /// The configuration, with all tables of inputs.
    config: Config,
    /// The model and the start of the configuration.
    base: OpenModel,
    start: Vec<f64>,
    /// The model with the strongest noise of the axes, if there is one.
    strongest: Option<OpenModel>,
    method: Method,
    subject: Subject,
    /// For each axis the number of a force that it varies; `None` for one of the subject.
    forces: Vec<Option<ForceParameter>>,
}

impl OpenFamily {
    /// The observables of motions with forces.
    const OBSERVABLES: [Observable; 5] = [
        Observable::FinalState,
        Observable::InvariantDrift,
        Observable::Lyapunov,
        Observable::Sali,
        Observable::Megno,
    ];

    /// Reads the motions that the axes describe, and the integrator with what `[integrator]` leaves out.
    ///
    /// # Errors
    /// If there is no motion with the configured numbers, or an axis varies no number of it.
    pub fn new(config: &Config, axes: &[SweepAxis]) -> Result<(Self, Integration), Error> {
        let integration = config.integrator.or(own_integration(Formulation::default()));
        let mut config = config.clone();
        config.integrator.step = Some(integration.step);
        config.integrator.end = Some(integration.end);
        let OpenStart { model: base, start, method } = config.open_start(None)?;
        config.require_inputs(&base.system().terms().inputs, integration.end)?;
        config.read_inputs()?;
        let forces = axes.iter().map(|axis| match &axis.parameter {
            Parameter::Force(parameter) => Some(parameter.clone()),
            _ => None,
        });
        let forces: Vec<_> = forces.collect();
        let is_of_force = |axis: &SweepAxis| matches!(axis.parameter, Parameter::Force(_));
        let (of_forces, others): (Vec<_>, Vec<_>) = axes.iter().cloned().partition(is_of_force);
        let numbers: Vec<_> = forces.iter().flatten().collect();
        require_apart(&of_forces, &numbers, |one, other| one == other)?;
        numbers.iter().try_for_each(|number| require_number(number, &mut config))?;
        require_thermal(&config, axes)?;
        let strongest = strongest(&config, &of_forces, &base);
        let subject = Subject::new(&config, &base, &others)?;
        let integration = Integration { formulation: method.formulation(), ..integration };
        Ok((Self { config, base, start, strongest, method, subject, forces }, integration))
    }

    /// Returns the member at these values of the axes, which is followed with steps of a size, or with those of the configuration.
    ///
    /// # Errors
    /// If there is no such member, it has another number of Casimirs, or its motion turns too far in a step.
    fn at(&self, values: &[f64], step: f64) -> Result<OpenStart, Error> {
        let mut config = self.config.clone();
        if step != 0.0 {
            config.integrator.step = Some(step);
        }
        for (force, value) in self.forces.iter().zip(values) {
            let number = force.as_ref().and_then(|force| number_of(force, &mut config));
            number.into_iter().for_each(|number| *number = *value);
        }
        let of_subject = self.of_subject(values);
        self.subject.set(&of_subject, &mut config);
        let mut member = config.open_start(Some(&self.base))?;
        self.subject.set_start(&of_subject, &mut member.start);
        let casimirs = |model: &OpenModel| model.system().base().casimirs().len();
        let (found, expected) = (casimirs(&member.model), casimirs(&self.base));
        if found != expected {
            return Err(SweepError::Casimirs { found, expected }.into());
        }
        require_run(member.model.as_model(), &self.method, (&member.start, step))?;
        Ok(member)
    }

    /// Returns the values of the axes that vary no force.
    fn of_subject(&self, values: &[f64]) -> Vec<f64> {
        let axes = self.forces.iter().zip(values);
        axes.filter(|(force, _)| force.is_none()).map(|(_, value)| *value).collect()
    }

    /// Returns whether the steps of the method descend to 𝔤∗.
    fn descends(&self) -> bool {
        // A method whose steps fail to be made has no tangent vectors either, and the rows say why.
        self.base.as_model().descends(&self.method, &self.start).unwrap_or(true)
    }

    /// Returns the columns of the deviations, whose labels call changes what the motion does not keep.
    fn drift_columns(&self) -> Vec<Column> {
        let conserved = self.base.as_model().conserved(&self.start);
        let columns = match self.subject.tops() {
            Some(_) => Observable::InvariantDrift.columns(),
            None => drift_columns(conserved.names()),
        };
        let named = conserved.names().into_iter().zip(columns);
        let columns = named.map(|(name, column)| match conserved.is_kept(&name) {
            true => column,
            false => Column { label: column.label.replacen("deviation", "change", 1), ..column },
        });
        columns.collect()
    }
}

/// Returns the number of a force in a configuration, if it has the number.
fn number_of<'a>(number: &ForceParameter, config: &'a mut Config) -> Option<&'a mut f64> {
    match number {
        ForceParameter::Friction => config.damping.as_mut()?.friction.as_mut(),
        ForceParameter::Temperature => config.noise.as_mut()?.temperature.as_mut(),
        ForceParameter::Strength => config.noise.as_mut()?.strength.as_mut(),
        ForceParameter::InputValue { input, index } => {
            config.inputs.as_mut()?.get_mut(input)?.values.get_mut(*index)
        }
    }
}

/// Returns the model with the largest strength or temperature of the axes, whose noise turns states the most. There is none if the
/// noise is on no axis, or is not possible with the numbers of the configuration.
fn strongest(config: &Config, axes: &[SweepAxis], base: &OpenModel) -> Option<OpenModel> {
    let (mut config, mut is_varied) = (config.clone(), false);
    for axis in axes {
        let Parameter::Force(force) = &axis.parameter else { continue };
        if !matches!(force, ForceParameter::Strength | ForceParameter::Temperature) {
            continue;
        }
        if let (Some(number), Some(most)) = (number_of(force, &mut config), ends(axis)[1]) {
            *number = most;
            is_varied = true;
        }
    }
    is_varied.then(|| config.open_start(Some(base)).ok()).flatten().map(|start| start.model)
}

/// Checks that a configuration has a number of a force.
fn require_number(number: &ForceParameter, config: &mut Config) -> Result<(), SweepError> {
    if number_of(number, config).is_some() {
        return Ok(());
    }
    let parameter = number.to_string();
    let input = |name: &String| config.inputs.as_ref().and_then(|inputs| inputs.get(name));
    Err(match number {
        ForceParameter::InputValue { input: name, index } if input(name).is_some() => {
            let most = input(name).map_or(0, |input| input.values.len().saturating_sub(1));
            SweepError::Index { parameter, index: Some(*index), most }
        }
        _ => {
            SweepError::NoParameter { parameter, has: "the configuration does not write it".into() }
        }
    })
}

impl Family for OpenFamily {
    fn nouns(&self) -> [&'static str; 2] {
        self.subject.nouns()
    }

    fn method(&self) -> &Method {
        &self.method
    }

    fn member(&self, values: &[f64], step: f64) -> Result<(Box<dyn Model>, Vec<f64>), Error> {
        let OpenStart { model, start, .. } = self.at(values, step)?;
        Ok((model.boxed(), start))
    }

    fn warnings(&self) -> Vec<String> {
        // A method whose steps fail to be made has no warning, and the rows say why.
        let of_method = self.base.as_model().warning(&self.method, &self.start).ok().flatten();
        let of_body = self.subject.tops().map(Family::warnings).unwrap_or_default();
        of_method.into_iter().chain(of_body).collect()
    }

    fn accuracy_warning(&self, accuracy: &RunAccuracy) -> Option<String> {
        let model = self.strongest.as_ref().unwrap_or(&self.base);
        model.as_model().accuracy_warning(&self.start, accuracy)
    }

    fn judges_members(&self) -> bool {
        self.subject.tops().is_some_and(Family::judges_members)
    }

    fn impossibility(&self, values: &[f64]) -> Option<String> {
        self.subject.tops()?.impossibility(&self.of_subject(values))
    }

    fn columns(&self, observable: Observable) -> Result<Vec<Column>, SweepError> {
        match (observable, self.subject.tops()) {
            (Observable::FinalState, Some(_)) => Ok(observable.columns()),
            (Observable::FinalState, None) => Ok(end_columns(self.base.as_model().columns())),
            (Observable::InvariantDrift, _) => Ok(self.drift_columns()),
            (lifted, _) if lifted.tangents() > 0 && !self.descends() => Err(SweepError::Lifted {
                observable: lifted.name(),
                formulation: self.method.formulation().name(),
            }),
            (Observable::Lyapunov | Observable::Sali | Observable::Megno, _) => {
                Ok(observable.columns())
            }
            (other, _) => Err(SweepError::OfClosed {
                observable: other.name(),
                has: Self::OBSERVABLES.map(Observable::name).to_vec(),
            }),
        }
    }

    fn labels(&self) -> Vec<String> {
        let mut of_subject = self.subject.labels(&self.base).into_iter();
        let label = |force: &Option<ForceParameter>| match force {
            Some(ForceParameter::Friction) => "θ".into(),
            Some(ForceParameter::Temperature) => "kT".into(),
            Some(ForceParameter::Strength) => "σ".into(),
            Some(ForceParameter::InputValue { input, index }) => component(input, *index),
            None => of_subject.next().unwrap_or_default(),
        };
        self.forces.iter().map(label).collect()
    }

    fn run_values(&self, values: &[f64]) -> Vec<f64> {
        let Some(tops) = self.subject.tops() else { return values.to_vec() };
        let mut of_subject = tops.run_values(&self.of_subject(values)).into_iter();
        let run = |(force, value): (&Option<ForceParameter>, &f64)| match force {
            Some(_) => *value,
            None => of_subject.next().unwrap_or(*value),
        };
        self.forces.iter().zip(values).map(run).collect()
    }

    fn shared(&self) -> Vec<String> {
        let mut config = self.config.clone();
        if self.forces.contains(&Some(ForceParameter::Friction))
            && let Some(damping) = &mut config.damping
        {
            damping.friction = None;
        }
        self.subject.shared(&config, &self.base).into_iter().chain(config.forces()).collect()
    }

    fn casimirs(&self) -> Vec<String> {
        self.subject.casimirs(&self.base)
    }

    fn measure(&self, values: &[f64], course: &Course) -> Result<Vec<Option<f64>>, Error> {
        let OpenStart { model, start, .. } = self.at(values, course.schedule.step)?;
        self.config.require_inputs(&model.system().terms().inputs, course.schedule.end())?;
        let model = model.as_model();
        let (grown, drifts) = follow(model, (&self.method, &start), course)?;
        let values = |observable: &Observable| match observable {
            Observable::InvariantDrift => drifts.iter().copied().map(Some).collect(),
            Observable::Lyapunov => vec![Some(grown.lyapunov)],
            Observable::Megno => vec![Some(grown.megno)],
            Observable::Sali => vec![grown.alignment],
            _ => {
                let mut end = grown.end.as_slice().to_vec();
                model.present(&mut end);
                end.into_iter().map(Some).collect()
            }
        };
        Ok(course.observables.iter().flat_map(values).collect())
    }
}
