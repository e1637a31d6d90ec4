//! Measures solvers of other crates on one top: DOP853 of `ode_solvers` and of `differential-equations`, and Tsit45 of
//! `diffsol`, all with step control. States are arrays or vectors of fixed size where the crate has them, and nothing is
//! interpolated unless the crate always does so.
//!
//! ```text
//! rust-peers PROBLEM
//! ```

use contest::{Problem, State, Top, contest};
use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};
use ode_solvers::{Dop853, OutputType, System, Vector6};
use std::error::Error;

mod contest;

type Outcome = Result<(), Box<dyn Error>>;

/// More steps than any run takes.
const MOST_STEPS: u32 = 10_000_000;

impl System<f64, Vector6<f64>> for Top {
    #[inline]
    fn system(&self, _: f64, y: &Vector6<f64>, dy: &mut Vector6<f64>) {
        self.rate(y.as_slice(), dy.as_mut_slice());
    }
}

impl ODE<f64, State> for Top {
    #[inline]
    fn diff(&self, _: f64, y: &State, dy: &mut State) {
        self.rate(y, dy);
    }
}

/// The parameters are those that its constructor `new` takes, but for the number of steps and the output at the steps.
fn ode_solvers(problem: &Problem, tolerance: f64) -> Outcome {
    contest("ode_solvers DOP853", &format!("tolerance {tolerance:e}"), problem, |end| {
        let start = Vector6::from(problem.start);
        let mut solver = Dop853::from_param(
            problem.top,
            0.0,
            end,
            end,
            start,
            tolerance,
            tolerance,
            0.9,
            0.0,
            0.333,
            6.0,
            end,
            0.0,
            MOST_STEPS,
            1000,
            OutputType::Sparse,
        );
        let steps = solver.integrate()?.accepted_steps;
        let last = solver.y_out().last().ok_or("no output")?;
        Ok(((*last).into(), steps as usize))
    })
}

fn differential_equations(problem: &Problem, tolerance: f64) -> Outcome {
    contest("differential-equations DOP853", &format!("tolerance {tolerance:e}"), problem, |end| {
        let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance);
        let method = method.max_steps(MOST_STEPS as usize);
        let solution = IVP::ode(&problem.top, 0.0, end, problem.start).method(method).solve();
        let solution = solution.map_err(|failure| format!("{failure:?}"))?;
        let last = solution.y.last().ok_or("no output")?;
        Ok((*last, solution.steps.accepted))
    })
}

fn diffsol(problem: &Problem, tolerance: f64) -> Outcome {
    let (top, start) = (problem.top, problem.start);
    let equations = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(tolerance)
        .atol([tolerance])
        .rhs(move |y: &[f64], _: &[f64], _, dy: &mut [f64]| top.rate(y, dy))
        .init(move |_: &[f64], _, y: &mut [f64]| y.copy_from_slice(&start), 6)
        .build()?;
    contest("diffsol Tsit45", &format!("tolerance {tolerance:e}"), problem, |end| {
        let mut solver = equations.tsit45()?;
        solver.set_stop_time(end)?;
        while !matches!(solver.step()?, OdeSolverStopReason::TstopReached) {}
        let steps = solver.get_statistics().number_of_steps;
        Ok((solver.state().y.batch_as_slice(0).try_into()?, steps))
    })
}

fn main() -> Outcome {
    let path = std::env::args().nth(1).ok_or("one argument: PROBLEM")?;
    let problem = Problem::read(&path)?;
    for solve in [ode_solvers, differential_equations, diffsol] {
        for tolerance in [1e-9, 1e-13] {
            solve(&problem, tolerance)?;
        }
    }
    Ok(())
}
