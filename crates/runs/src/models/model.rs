//! What is integrated: [`Model`].

use super::conserved::Conserved;
use crate::error::RunFailure;
use collective_integrators::diagnostics::{
    RunAccuracy, StepCheck, SystemScales, check_by_half_steps, run_accuracy,
};
use collective_integrators::{AnyIntegrator, AnyTangents, CHECKPOINT, RunError};
use core::fmt;
use heavytop::methods::Method;
use lie_poisson::Quaternion;
use lie_poisson_formula_systems::FormulaSystemError;

/// A Lie–Poisson system whose coordinates, conserved quantities and integrators are known by name: what a
/// [run](crate::Experiment) follows.
///
/// Momenta are slices of coordinates. A model may compute in other axes than those in which users give and read its
/// momenta, as a top does in its principal axes: [`start`](Self::start) takes what is given, and
/// [`present`](Self::present) makes what is read. Everything else is in the axes of the computation.
///
/// A new system needs the methods below without a body, [`SystemScales`], and what it conserves as a [`Conserved`];
/// `examples/own_model.rs` is a whole one.
pub trait Model: SystemScales + fmt::Debug + Send + Sync {
    /// Returns the name of the Lie algebra.
    fn algebra_name(&self) -> String;

    /// Returns the coordinates: the name of each vector or scalar, with the names of its columns.
    fn coordinates(&self) -> Vec<(String, Vec<String>)>;

    /// Returns the shape of the array of a group of coordinates, whose last index is the fastest; `None` if they are a
    /// number or a vector.
    fn shape(&self, _coordinate: &str) -> Option<Vec<usize>> {
        None
    }

    /// Returns what the motion from a start conserves.
    fn conserved(&self, start: &[f64]) -> Box<dyn Conserved + '_>;

    /// Returns the integrator of a method for runs from a start. It has tangent maps.
    ///
    /// # Errors
    /// If there is no such integrator.
    fn tangent_integrator(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure>;

    /// Returns the fastest integrator of a method for runs from a start.
    ///
    /// # Errors
    /// If there is no such integrator.
    fn integrator(&self, method: &Method, start: &[f64]) -> Result<AnyIntegrator, RunFailure> {
        Ok(self.tangent_integrator(method, start)?.without_tangents())
    }

    /// Returns the integrator of a method that carries the attitude along, whose unit quaternion is in the last four
    /// coordinates of its states.
    ///
    /// # Errors
    /// If there is no such integrator, the method does not determine the attitude, or the system is no body that has one.
    fn integrator_with_attitude(
        &self,
        _method: &Method,
        _start: &[f64],
    ) -> Result<AnyIntegrator, RunFailure> {
        Err(RunFailure::NoBody { algebra: self.algebra_name() })
    }

    /// Returns the order with which runs of a method converge: that of the scheme, and with noise that of its paths.
    fn order(&self, method: &Method) -> u16 {
        method.scheme().order()
    }

    /// Returns the seed and the number of the path of a motion with noise.
    fn noise(&self) -> Option<(u64, u64)> {
        None
    }

    /// Returns the angle by which the noise turns the state of a start in a step, rad, if that is known.
    fn noise_angle(&self, _start: &[f64], _step: f64) -> Option<f64> {
        None
    }

    /// Moves a state of an integrator without attitude so many paths on from the path of the [noise](Self::noise), if there is
    /// noise: for members of an ensemble.
    fn move_path(&self, _state: &mut [f64], _on: u64) {}

    /// Returns the number of steps after which a run can be interrupted and resumed with the same bits: a power of two up to
    /// [`CHECKPOINT`]. The integrators of the model forget what they know of earlier steps at its multiples.
    fn resumable_after(&self) -> u64 {
        CHECKPOINT
    }

    /// Checks that a momentum has as many numbers as there are coordinates.
    ///
    /// # Errors
    /// If it has not.
    fn require_dimension(&self, momentum: &[f64]) -> Result<(), RunFailure> {
        let expected = self.coordinates().iter().map(|(_, columns)| columns.len()).sum();
        let found = momentum.len();
        match expected == found {
            true => Ok(()),
            false => Err(FormulaSystemError::StateLength { expected, found }.into()),
        }
    }

    /// Returns the momentum in the axes of the computation of one that users give.
    ///
    /// # Errors
    /// If it has another number of coordinates, or the system cannot have it.
    fn start(&self, given: &[f64]) -> Result<Vec<f64>, RunFailure> {
        self.require_dimension(given)?;
        Ok(given.to_vec())
    }

    /// Replaces a momentum by the one in the axes of the users.
    fn present(&self, _momentum: &mut [f64]) {}

    /// Appends to the coordinates of a momentum what formulas may name behind them: the time, s, and the values of inputs at it.
    fn append_inputs(&self, time: f64, x: &mut Vec<f64>) {
        x.push(time);
    }

    /// Returns the rates at which forces change the [conserved quantities](Self::conserved) at a time and a momentum; `None` of a
    /// motion without forces, and of one with noise, which has no rates.
    fn supplied_rates(&self, _time: f64, _momentum: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// Returns the first time after a time, or before it, at which a force is not smooth.
    fn next_break(&self, _time: f64, _forward: bool) -> Option<f64> {
        None
    }

    /// Returns what turns attitudes of the motion from a start to those in the axes of the users.
    fn present_attitude(&self, _start: &[f64]) -> Box<dyn Fn(Quaternion) -> Quaternion + '_> {
        Box::new(|attitude| attitude)
    }

    /// Returns whether a conserved quantity is one of the coordinates, so that it needs no column of its own.
    fn is_coordinate(&self, _conserved: &str) -> bool {
        false
    }

    /// Returns the formula of a conserved quantity, if the system was given by formulas.
    fn formula(&self, _conserved: &str) -> Option<String> {
        None
    }

    /// Returns whether the steps of a method descend to 𝔤∗. If not, they are not Poisson maps.
    ///
    /// # Errors
    /// If there is no such method.
    fn descends(&self, _method: &Method, _start: &[f64]) -> Result<bool, RunFailure> {
        Ok(true)
    }

    /// Returns a warning for users about what the method does not conserve.
    ///
    /// # Errors
    /// If there is no such method.
    fn warning(&self, method: &Method, start: &[f64]) -> Result<Option<String>, RunFailure> {
        Ok((!self.descends(method, start)?).then(|| {
            format!(
                "warning: the steps of {}, {} on the dual of {} are not Poisson maps: the Casimirs are conserved to the \
                 order of the scheme alone",
                method.formulation(),
                method.scheme(),
                self.algebra_name()
            )
        }))
    }

    /// Returns a warning for users about conserved quantities whose digits a motion has used up: at its end they are small
    /// differences of large terms, although they were none at the start.
    fn warning_of_end(&self, _start: &[f64], _end: &[f64]) -> Option<String> {
        None
    }
}

/// The largest angle of the noise in a step, rad, without a warning.
const MOST_NOISE: f64 = 0.35;

impl dyn Model + '_ {
    /// Returns the names of the columns of the coordinates.
    #[must_use]
    pub fn columns(&self) -> Vec<String> {
        self.coordinates().into_iter().flat_map(|(_, columns)| columns).collect()
    }

    /// Measures how accurate a run of `steps` steps of size `step` from a start is, without making the whole run if it is
    /// long: [`run_accuracy`]. There is no estimate if `going` tells it to end.
    ///
    /// # Errors
    /// Those of [`integrator`](Model::integrator).
    ///
    /// # Example
    /// A free rigid body that turns by 15 rad in a step. The energy and |Π|² are conserved to round-off.
    /// ```
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_runs::Model;
    /// let so3 = SystemAlgebra::named("so(3)")?;
    /// let gauss = so3.method(Formulation::Collective, SchemeName::Gauss(4), 0.0)?;
    /// let body = FormulaSystem::new(so3, "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2", &Default::default())?;
    /// let (body, start): (&dyn Model, _) = (&body, [10.0, 0.1, 10.0]);
    /// let accuracy = body.accuracy(&gauss, &start, (0.02, 100), &|| true)?;
    /// assert!(accuracy.error < Some(1e-9) && accuracy.warning().is_none());
    /// let accuracy = body.accuracy(&gauss, &start, (0.3, 100), &|| true)?;
    /// assert!(accuracy.angle > 3.0 && accuracy.warning().is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn accuracy(
        &self,
        method: &Method,
        start: &[f64],
        steps: (f64, u64),
        going: &dyn Fn() -> bool,
    ) -> Result<RunAccuracy, RunFailure> {
        let (integrator, order) = (self.integrator(method, start)?, self.order(method));
        Ok(run_accuracy(&integrator, self, start, steps, order, going))
    }

    /// Returns the [warning](RunAccuracy::warning) about the accuracy of a run from a start. With noise it is about long steps alone: single
    /// paths converge slowly, and means over many, for which they are made, do not need them.
    #[must_use]
    pub fn accuracy_warning(&self, start: &[f64], accuracy: &RunAccuracy) -> Option<String> {
        match self.noise() {
            None => accuracy.warning(),
            Some(_) => {
                let angle = self.noise_angle(start, accuracy.step);
                let of_noise = angle.filter(|angle| *angle > MOST_NOISE);
                let of_noise = of_noise.map(|angle| {
                    format!(
                        "the noise turns the state by about {angle:.1e} rad in a step, where at most 1/3 rad is safe: means may be wrong, \
                         and steps may fail; compare with a step of {:.1e} or less",
                        accuracy.step.abs() * (1.0 / (3.0 * angle)).powi(2)
                    )
                });
                let of_motion = RunAccuracy { error: None, chaos: None, ..*accuracy }.warning();
                of_noise.or(of_motion)
            }
        }
    }

    /// Checks a whole run of `steps` steps of size `step` from a start by runs with half the step and with twice the step:
    /// [`check_by_half_steps`]. Returns `None` if `going` tells it to end.
    ///
    /// # Errors
    /// Those of [`integrator`](Model::integrator). The inner error is that of a step that fails.
    pub fn check(
        &self,
        method: &Method,
        start: &[f64],
        steps: (f64, u64),
        going: &dyn Fn() -> bool,
    ) -> Result<Result<Option<StepCheck>, RunError>, RunFailure> {
        let (integrator, order) = (self.integrator(method, start)?, self.order(method));
        Ok(check_by_half_steps(&integrator, self, start, steps, order, going))
    }
}
