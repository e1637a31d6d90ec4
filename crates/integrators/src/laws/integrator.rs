//! The law suite of [`Integrator`].

use super::differences::{
    NOT_FINITE, at_least_one, broken_unless, different_bits, largest, largest_difference,
    not_finite, point_or_nan,
};
use super::{Faulty, NoSamples, Report};
use crate::error::StepError;
use crate::integrators::trajectories::integrator::{Integrator, SampleOf};
use crate::schemes::scheme::Step;
use crate::stages::checkpoints::CHECKPOINT;
use lie_poisson::{BlockScales, Real, State};

/// Evaluates the laws of an integrator on samples of states, for one step size:
///
/// * `step of size 0`: a step of size 0 keeps μ;
/// * `step in place`: [`step_in_place`](Integrator::step_in_place) is bit-identical to the step, and a step that fails
///   changes nothing;
/// * `advance`: [`advance`](Integrator::advance) is bit-identical to the same number of steps, also in two parts, and
///   refuses what a step refuses;
/// * `samples`: sample n of a trajectory has the number n, the time nh and the momentum of its state;
/// * `forgetting`: after [`forget`](Integrator::forget) a used workspace gives results bit-identical to those of a new
///   one, by as many iterations, for steps of several sizes;
/// * `pinning`: with a [pinned](Integrator::pin) workspace a step of size 0 keeps the state itself, and not only μ, in a new
///   workspace, after other steps, and after [`forget`](Integrator::forget);
/// * `resumption`: a trajectory resumed at a [`CHECKPOINT`] is bit-identical to the uninterrupted one;
/// * `refusal`: a state or a step size that is infinite or not a number is an error, of a step and of a trajectory.
///
/// An integrator that moves states along their fibres does so far from the origin. Only states there show whether it obeys
/// the law `pinning`, such as (q + 1000 p, p) for the map q × p.
///
/// For an integrator that can start from a momentum, [`start`](super::start) includes these laws.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
///
/// # Example
/// ```
/// use collective_integrators::{Direct, RungeKutta, from_fn, laws};
/// use nalgebra::Vector2;
/// let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
/// let gauss = Direct::new(RungeKutta::gauss(3)?, pendulum);
/// laws::integrator(&gauss, &[Vector2::new(1.0, 0.0), Vector2::new(-0.5, 0.8)], 0.1)?.check(1e-13)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn integrator<I: Integrator>(
    integrator: &I,
    states: &[I::State],
    step: f64,
) -> Result<Report, NoSamples> {
    at_least_one("states", states)?;
    let mut report = Report::default();
    for (state, other) in states.iter().zip(states.iter().cycle().skip(1)) {
        still(integrator, state, &mut report);
        in_place(integrator, state, step, &mut report);
        advance(integrator, state, step, &mut report);
        samples(integrator, state, step, &mut report);
        forgetting(integrator, (state, other), step, &mut report);
        pinning(integrator, state, step, &mut report);
        resumption(integrator, state, step, &mut report);
        refusal(integrator, state, step, &mut report);
    }
    Ok(report)
}

/// The number of successive steps for the laws about bits: enough to fill the memory of a workspace.
const STEPS: usize = 12;

/// The sizes of the steps of the law `forgetting`, in those of the samples: what an integrator remembers may show at one
/// of them alone.
const SIZES: [f64; 3] = [1.0, 0.125, 4.0];

fn still<I: Integrator>(integrator: &I, state: &I::State, report: &mut Report) {
    let after = point_or_nan(integrator.step(state, 0.0, &mut integrator.workspace()), state);
    let (mu, end) = (integrator.momentum(state), integrator.momentum(&after));
    report.note("step of size 0", largest_difference(&end, &mu), largest(&mu));
}

/// Returns the state after [`STEPS`] steps, or NaN if one failed.
fn steps<I: Integrator>(
    integrator: &I,
    state: &I::State,
    step: f64,
    workspace: &mut I::Workspace,
) -> I::State {
    counted_steps(integrator, state, step, workspace).0
}

/// Returns the state after [`STEPS`] steps, or NaN if one failed, and the number of iterations of each step.
fn counted_steps<I: Integrator>(
    integrator: &I,
    state: &I::State,
    step: f64,
    workspace: &mut I::Workspace,
) -> (I::State, [usize; STEPS]) {
    let mut z = state.clone();
    let counts = core::array::from_fn(|_| {
        let made = integrator.step(&z, step, workspace);
        let iterations = made.as_ref().map_or(0, |made| made.iterations);
        z = point_or_nan(made, &z);
        iterations
    });
    (z, counts)
}

fn in_place<I: Integrator>(integrator: &I, state: &I::State, step: f64, report: &mut Report) {
    let by_value = &mut integrator.workspace();
    let end = steps(integrator, state, step, by_value);
    let (mut z, workspace) = (state.clone(), &mut integrator.workspace());
    let made = (0..STEPS).all(|_| integrator.step_in_place(&mut z, step, workspace).is_ok());
    report.note("step in place", different_bits(&z, &end) + broken_unless(made), 1.0);
    let mut kept = state.clone();
    let refused = integrator.step_in_place(&mut kept, f64::NAN, workspace).is_err();
    let changed = if refused { different_bits(&kept, state) } else { 0.0 };
    report.note("step in place", changed, 1.0);
}

fn advance<I: Integrator>(integrator: &I, state: &I::State, step: f64, report: &mut Report) {
    let (end, middle) = (STEPS as u64, STEPS as u64 / 3);
    let (one_by_one, counts) = counted_steps(integrator, state, step, &mut integrator.workspace());
    for part in [0, 1, middle, end] {
        let (mut z, workspace) = (state.clone(), &mut integrator.workspace());
        let parts =
            [0..part, part..end].map(|steps| integrator.advance(&mut z, step, steps, workspace));
        let made = parts.into_iter().sum::<Result<usize, _>>();
        let counted = made.is_ok_and(|iterations| iterations == counts.iter().sum());
        report.note("advance", different_bits(&z, &one_by_one) + broken_unless(counted), 1.0);
    }
    let (mut kept, workspace) = (state.clone(), &mut integrator.workspace());
    let refused = integrator.advance(&mut kept, f64::NAN, middle..end, workspace);
    let named = refused.is_err_and(|error| error.step == middle + 1);
    report.note("advance", different_bits(&kept, state) + broken_unless(named), 1.0);
}

fn samples<I: Integrator>(integrator: &I, state: &I::State, step: f64, report: &mut Report) {
    let run = integrator.trajectory_from(state.clone(), step).take(STEPS);
    for (n, sample) in (0..).zip(run) {
        let fits = |sample: SampleOf<I>| {
            let mu = integrator.momentum(&sample.state);
            sample.step == n
                && sample.time == n as f64 * step
                && different_bits(&sample.momentum, &mu) == 0.0
                && (n > 0 || different_bits(&sample.state, state) == 0.0)
        };
        report.note("samples", broken_unless(sample.is_ok_and(fits)), 1.0);
    }
}

fn forgetting<I: Integrator>(
    integrator: &I,
    (state, other): (&I::State, &I::State),
    step: f64,
    report: &mut Report,
) {
    let anew = |start: &I::State, size| {
        counted_steps(integrator, start, size, &mut integrator.workspace())
    };
    for factor in SIZES {
        let size = factor * step;
        let first = anew(state, size);
        let second = anew(&first.0, size);
        // Steps of another size than the one asked for may fail.
        if factor != 1.0 && !largest(&second.0).is_finite() {
            continue;
        }
        let mut used = integrator.workspace();
        steps(integrator, other, 0.7 * size, &mut used);
        // Otherwise the second run would continue from what the first one left in the workspace.
        for (start, expected) in [(state, &first), (&first.0, &second)] {
            integrator.forget(&mut used);
            let again = counted_steps(integrator, start, size, &mut used);
            report.note("forgetting", different_bits(&again.0, &expected.0), 1.0);
            // What is remembered saves iterations, even where it leaves no trace in the bits.
            report.note("forgetting", broken_unless(again.1 == expected.1), 1.0);
        }
    }
}

fn pinning<I: Integrator>(integrator: &I, state: &I::State, step: f64, report: &mut Report) {
    let (sizes, mut pinned) = (BlockScales::of(state), integrator.workspace());
    integrator.pin(&mut pinned);
    let mut stays = |workspace: &mut I::Workspace| {
        let mut moved = point_or_nan(integrator.step(state, 0.0, workspace), state);
        moved.subtract_in_place(state);
        report.note("pinning", sizes.largest(&moved), 1.0);
    };
    stays(&mut pinned);
    steps(integrator, state, step, &mut pinned);
    stays(&mut pinned);
    integrator.forget(&mut pinned);
    stays(&mut pinned);
}

fn resumption<I: Integrator>(integrator: &I, state: &I::State, step: f64, report: &mut Report) {
    let mut run = integrator.trajectory_from(state.clone(), step).skip(CHECKPOINT as usize);
    let Some(Ok(saved)) = run.next() else {
        report.note("resumption", f64::NAN, 1.0);
        return;
    };
    let resumed = integrator.trajectory_resumed(saved.state, saved.step, step).skip(1);
    for pair in run.zip(resumed).take(STEPS) {
        let residual = match pair {
            (Ok(a), Ok(b)) => different_bits(&a.state, &b.state) + broken_unless(a.step == b.step),
            _ => f64::NAN,
        };
        report.note("resumption", residual, 1.0);
    }
}

fn refusal<I: Integrator>(integrator: &I, state: &I::State, step: f64, report: &mut Report) {
    let bad_states = not_finite(state).map(|bad| (bad, step));
    for (state, step) in bad_states.chain(NOT_FINITE.map(|bad| (state.clone(), bad))) {
        let stepped = integrator.step(&state, step, &mut integrator.workspace());
        report.note("refusal", broken_unless(stepped.is_err()), 1.0);
        let first = integrator.trajectory_from(state, step).next();
        report.note("refusal", broken_unless(first.is_some_and(|item| item.is_err())), 1.0);
    }
}

/// The method [`step`](Integrator::step) may have the fault, and [`step_in_place`](Integrator::step_in_place) with it.
impl<T: Real, I: Integrator<T>> Integrator<T> for Faulty<'_, I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> I::Workspace {
        self.object().workspace()
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        let made = self.object().step(state, step, workspace)?;
        Ok(Step { point: self.halved("step", made.point), ..made })
    }

    fn step_in_place(
        &self,
        state: &mut I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<usize, StepError> {
        let iterations = self.object().step_in_place(state, step, workspace)?;
        self.halve("step", state);
        Ok(iterations)
    }

    fn forget(&self, workspace: &mut I::Workspace) {
        self.object().forget(workspace);
    }

    fn pin(&self, workspace: &mut I::Workspace) {
        self.object().pin(workspace);
    }

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.object().momentum(state)
    }
}
