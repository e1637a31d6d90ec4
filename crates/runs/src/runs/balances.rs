//! The laws of balance along a run: what forces supply to the conserved quantities, and what the method adds.

use super::events::timed_integrator::{TimedIntegrator, TimedState};
use super::experiment::Experiment;
use super::schedule::Schedule;
use crate::error::RunFailure;
use crate::models::model::Model;
use collective_integrators::diagnostics::Balance;
use collective_integrators::{AnyState, RunError, Start};
use heavytop::methods::Method;
use lie_poisson::{Pair, Time};

impl Experiment {
    /// Measures the balances of the run.
    ///
    /// # Errors
    /// Returns [`RunFailure::NoBalance`] for a motion whose forces have no rates, and the error of a step that fails.
    pub fn balances(
        &self,
        going: &dyn Fn() -> bool,
    ) -> Result<Option<Vec<(String, Balance)>>, RunFailure> {
        let Schedule { step, steps } = self.pace.schedule;
        self.model.balances((&self.method, &self.start), (step, steps), going)
    }
}

impl dyn Model + '_ {
    /// Measures for each conserved quantity C of a motion with forces how it changes along a run of `steps` steps of a size from a
    /// start, how much of that the forces supply, by quadrature of dC/dt along the run, and what is left, the error of the method:
    /// [`Balance`]. It takes nine times as long as the run. There is no result if `going` tells it to end.
    ///
    /// # Errors
    /// Returns [`RunFailure::NoBalance`] for a motion whose forces have no rates: without any, with noise, or of arrays; and the error
    /// of a step that fails.
    pub fn balances(
        &self,
        (method, start): (&Method, &[f64]),
        (step, steps): (f64, u64),
        going: &dyn Fn() -> bool,
    ) -> Result<Option<Vec<(String, Balance)>>, RunFailure> {
        self.require_balance(start)?;
        let (conserved, from) = (self.conserved(start), AnyState::from_slice(start));
        let integrator = self.integrator(method, start)?;
        let state = integrator.start(&from).map_err(RunError::from)?;
        let quantities = |Pair(mu, time): &TimedState| {
            let mut values = Vec::new();
            conserved.append(time.0, mu.as_slice(), &mut values);
            values
        };
        let rates = |Pair(mu, time): &TimedState| {
            self.supplied_rates(time.0, mu.as_slice()).unwrap_or_default()
        };
        let smooth = |made: u64| going().then(|| self.smooth_parts(made as f64 * step, step));
        let (timed, start) = (TimedIntegrator::new(&integrator), Pair(state, Time(0.0)));
        let found = Balance::all_of_run(&timed, start, (step, steps), (quantities, rates), smooth);
        let found = found.map_err(|reason| RunFailure::of_step(method, reason))?;
        let named = |balances| conserved.names().into_iter().zip(balances);
        let found: Option<Vec<(String, Balance)>> = found.map(|found| named(found).collect());
        let is_broken = |of: &Balance| {
            !(of.defect.is_finite() && of.supplied.is_finite() && of.change.is_finite())
        };
        let broken = found.iter().flatten().find(|(_, balance)| is_broken(balance));
        match broken {
            Some((name, _)) => {
                let reason =
                    format!("the rate at which the forces change {name} has no value on the way");
                Err(RunFailure::NoValue { time: step * steps as f64, reason })
            }
            None => Ok(found),
        }
    }

    /// Checks that the forces of a motion from a start have rates.
    ///
    /// # Errors
    /// Returns [`RunFailure::NoBalance`] if they have none.
    pub fn require_balance(&self, start: &[f64]) -> Result<(), RunFailure> {
        match self.supplied_rates(0.0, start) {
            Some(_) => Ok(()),
            None => Err(RunFailure::NoBalance),
        }
    }

    /// Returns the ends of the parts of the step from a time in which the forces are smooth, as fractions of the step.
    fn smooth_parts(&self, time: f64, step: f64) -> Vec<f64> {
        let (mut ends, mut at) = (Vec::new(), time);
        // A time that misses a breakpoint by rounding counts as the breakpoint.
        let slack = SLACK * step;
        while let Some(next) = self.next_break(at + slack, step > 0.0) {
            let fraction = (next - time) / step;
            if fraction >= 1.0 - SLACK {
                break;
            }
            ends.push(fraction);
            at = next;
        }
        ends.push(1.0);
        ends
    }
}

/// The part of a step by which a time may miss a breakpoint and still count as the breakpoint.
const SLACK: f64 = 1e-9;
