//! The memory of the earlier steps, and predictions from it: [`StageHistory`].

use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use crate::iteration::convergence::{ROUND_OFF, Ratios, unknown};
use crate::iteration::prediction::{LARGEST_GROWTH, Prediction};
use crate::iteration::stage_scale::Scale;
use crate::iteration::stage_solver::{
    StageEquations, StageSolver, Unconverged, fill_unless, fit, set_combination,
};
use crate::stage_frame::StageFrame;
use crate::stages::extrapolation::Predictor;
use crate::stages::newton::FieldOn;
use crate::vector_field::VectorField;
use lie_poisson::{Mask, Real, State};

/// The stage derivatives of the last steps of equal size, each of which began where the one before it ended.
///
/// They are stored in the coordinates of the [frame](StageFrame). Each lane remembers by itself.
#[derive(Clone, Debug)]
pub(crate) struct StageHistory<V: State> {
    /// The stage derivatives, oldest first; those before `newest` are valid. There is room for twice the required
    /// number, so that they are moved to the front only rarely.
    past: Vec<V>,
    newest: usize,
    /// The number of stages of each step.
    stages: usize,
    /// The number of remembered steps in each lane, and the largest in any lane.
    steps: V::Scalar,
    most: usize,
    /// The size of the steps.
    size: f64,
    /// The end of the last step, and the ratios of changes in its iteration.
    end: Option<V>,
    pace: Ratios<V::Scalar>,
    /// The number of iterations of the last step whose stages were predicted, or 0.
    iterations: usize,
    /// The lanes in which blocks of the derivatives are round-off of larger terms.
    cancelling: MaskOf<V>,
}

impl<V: State> StageHistory<V> {
    /// Creates an empty history, with room for the needs of a predictor. Its first step makes the vectors.
    pub(crate) fn new(predictor: &Predictor) -> Self {
        Self {
            past: Vec::with_capacity(2 * predictor.capacity()),
            newest: 0,
            stages: 0,
            steps: V::Scalar::from_f64(0.0),
            most: 0,
            size: 0.0,
            end: None,
            pace: unknown(),
            iterations: 0,
            cancelling: MaskOf::<V>::from_bool(false),
        }
    }

    /// Removes the records of all steps.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn forget(&mut self) {
        self.steps = V::Scalar::from_f64(0.0);
        self.most = 0;
        self.newest = 0;
        self.pace = unknown();
        self.iterations = 0;
        self.cancelling = MaskOf::<V>::from_bool(false);
    }

    /// Returns the lanes in which blocks of the derivatives are round-off of larger terms, so that sweeps do not converge.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn cancelling(&self) -> MaskOf<V> {
        self.cancelling
    }

    /// Records more such lanes, until the memory is forgotten.
    pub(crate) fn include_cancelling(&mut self, lanes: MaskOf<V>) {
        self.cancelling = self.cancelling.or(lanes);
    }

    /// Solves for the stage derivatives k of a step of the given size from z by fixed-point iteration, and remembers
    /// them. Returns the number of iterations.
    ///
    /// The iteration starts from a prediction if there is one. Otherwise, or if that fails, it starts from X(z). The
    /// vector `spare` is overwritten.
    ///
    /// # Errors
    /// Returns [`Unconverged`] if the iteration fails in some lane. Nothing is remembered in such a lane.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn solve<F: VectorField<V::Scalar, Point = V>>(
        &mut self,
        predictor: &Predictor,
        solver: &StageSolver,
        field: &F,
        (z, size, scale): (&V, f64, &impl Scale<V>),
        (k, spare): (&mut [V], &mut V),
        mut equations: impl StageEquations<V>,
    ) -> Result<usize, Unconverged<MaskOf<V>>> {
        let frame = field.stage_frame();
        self.keep_where(z, size, predictor, &frame);
        let none = MaskOf::<V>::from_bool(false);
        let in_lanes = self.solve_predicted(predictor, solver, &frame, k, &mut equations);
        let (guessed, mut outcome) = match in_lanes {
            Some(outcome) => (none.not(), outcome),
            None => {
                let guessed = self.guess(predictor, &frame, k, spare);
                if !guessed.all() {
                    begin_with(field, z, guessed, (k, spare));
                }
                let usual = if guessed.all() { self.iterations } else { 0 };
                let pace = &mut self.pace;
                let outcome = match equations.solve_in_lanes(solver, k, None, (pace, usual)) {
                    Some(outcome) => outcome,
                    None => solver.solve_from(none, scale, k, spare, pace, &mut equations),
                };
                (guessed, outcome)
            }
        };
        self.iterations = match &outcome {
            Ok(iterations) if guessed.all() => *iterations,
            _ => 0,
        };
        if let Err(first) = &outcome {
            let misled = guessed.and(first.converged.not());
            if V::Scalar::HAS_SLOW_PATHS && misled.any() {
                begin_with(field, z, misled.not(), (k, spare));
                let has_low_parts = equations.has_low_parts();
                let mut evaluate = |i: usize, k: &[V], near: MaskOf<V>, value: &mut V| {
                    equations.evaluate(i, k, near, value)
                };
                let mut same = Erased { has_low_parts, evaluate: &mut evaluate };
                let second = again(solver, misled.not(), scale, (k, spare), &mut same);
                outcome = retried(first, guessed, second);
            }
        }
        let converged = match &outcome {
            Ok(_) => none.not(),
            Err(unconverged) => unconverged.converged,
        };
        self.remember(predictor, &frame, size, k, converged);
        outcome
    }

    /// Solves the equations with stages side by side, which are predicted side by side, too; `None` if they are not, or if nothing
    /// modest is predicted.
    #[cfg_attr(optimised, inline(always))]
    fn solve_predicted(
        &mut self,
        predictor: &Predictor,
        solver: &StageSolver,
        frame: &impl StageFrame<V>,
        k: &mut [V],
        equations: &mut impl StageEquations<V>,
    ) -> Option<Result<usize, Unconverged<MaskOf<V>>>> {
        // There are no stages in the lanes of states that are themselves in wide registers.
        if !V::Scalar::HAS_SLOW_PATHS || predictor.columns.is_empty() || frame.continues() {
            return None;
        }
        let matrices = (1..self.most + 1).zip(&predictor.columns).rev();
        let mut remembered = matrices.filter(|(steps, _)| self.remembers(*steps).all());
        let (steps, columns) = remembered.next()?;
        // What cannot panic costs nothing where the equations have no lanes.
        let first = self.newest.checked_sub(steps * self.stages)?;
        let past = self.past.get(first..self.newest)?;
        let prediction = Prediction { past, columns };
        equations.solve_in_lanes(solver, k, Some(prediction), (&mut self.pace, self.iterations))
    }

    /// Records that the step that was solved last ends at z + `change`.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn end_after(&mut self, z: &V, change: &V) {
        self.end_at(z);
        if let Some(end) = &mut self.end {
            end.add_in_place(change);
        }
    }

    /// Records the end of the step that was solved last.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn end_at(&mut self, z: &V) {
        match &mut self.end {
            Some(end) => end.assign(z),
            None => self.end = Some(z.clone()),
        }
    }

    /// Forgets all steps in lanes where a step does not continue from the memory, or everywhere if the memory comes
    /// from another method.
    #[cfg_attr(optimised, inline(always))]
    fn keep_where(&mut self, z: &V, size: f64, predictor: &Predictor, frame: &impl StageFrame<V>) {
        let room = 2 * predictor.capacity();
        let moved = self.past.first().is_some_and(|past| !past.same_shape(z));
        if self.past.len() != room || self.stages != predictor.stages || moved {
            fit(&mut self.past, room, z);
            (self.stages, self.end) = (predictor.stages, None);
            self.forget();
        }
        if self.size != size {
            self.forget();
        }
        // In wide registers the compiler would call the comparison, which only saves the more exact one.
        let same = V::Scalar::HAS_SLOW_PATHS && self.end.as_ref() == Some(z);
        if self.most > 0 && !frame.continues() && !same {
            let near = match &self.end {
                Some(end) => near(z, end),
                None => Mask::from_bool(false),
            };
            self.steps = Real::select(near, self.steps, V::Scalar::from_f64(0.0));
            for ratio in &mut self.pace {
                *ratio = Real::select(near, *ratio, V::Scalar::from_f64(f64::INFINITY));
            }
        }
    }

    /// Writes a prediction to k. Returns the lanes in which there is one.
    #[cfg_attr(optimised, inline(always))]
    fn guess(
        &self,
        predictor: &Predictor,
        frame: &impl StageFrame<V>,
        k: &mut [V],
        spare: &mut V,
    ) -> MaskOf<V> {
        let none = MaskOf::<V>::from_bool(false);
        let (mut tried, mut guessed) = (none, none);
        for (n, weights) in (1..self.most + 1).zip(&predictor.weights).rev() {
            let here = self.remembers(n);
            // A single stage of a single step is a worse prediction than X(z).
            if !here.any() || n * predictor.stages < 2 {
                continue;
            }
            let past = &self.past[self.newest - n * predictor.stages..self.newest];
            for (k, row) in k.iter_mut().zip(weights.chunks_exact(past.len())) {
                if here.all() {
                    set_combination(k, row, past);
                } else {
                    set_combination(spare, row, past);
                    k.replace_where(here, spare);
                }
            }
            let last = &past[past.len() - predictor.stages..];
            let last = BlockSizes::of(last);
            let modest = BlockSizes::of(k).at_most(
                #[cfg_attr(optimised, inline(always))]
                |block| last.at(block) * LARGEST_GROWTH,
            );
            guessed = guessed.or(here.and(modest));
            tried = tried.or(here);
            if tried.all() {
                break;
            }
        }
        if guessed.any() {
            for k in k {
                frame.recall(k);
            }
        }
        guessed
    }

    /// Returns the lanes in which n steps are remembered.
    #[cfg_attr(optimised, inline(always))]
    fn remembers(&self, n: usize) -> MaskOf<V> {
        let n = V::Scalar::from_f64(n as f64);
        self.steps.at_most(n).and(n.at_most(self.steps))
    }

    /// Remembers one more step in the lanes where it has converged, and forgets all steps in the others.
    #[cfg_attr(optimised, inline(always))]
    fn remember(
        &mut self,
        predictor: &Predictor,
        frame: &impl StageFrame<V>,
        size: f64,
        k: &[V],
        converged: MaskOf<V>,
    ) {
        if self.past.is_empty() {
            return;
        }
        if self.newest == self.past.len() {
            let kept = self.past.len() / 2 - k.len();
            let (oldest, latest) = self.past.split_at_mut(self.newest - kept);
            oldest[..kept].swap_with_slice(latest);
            self.newest = kept;
        }
        for (past, k) in self.past[self.newest..].iter_mut().zip(k) {
            frame.remember(k, past);
        }
        self.newest += k.len();
        self.size = size;
        let full = self.remembers(predictor.weights.len());
        let steps = Real::select(full, self.steps, self.steps + 1.0);
        self.steps = Real::select(converged, steps, V::Scalar::from_f64(0.0));
        self.most = (self.most + 1).min(predictor.weights.len());
    }
}

/// Sets k_i = X(z) in the lanes that are not `done`. It is rare, except for methods without predictions, and so compiled
/// once for each type of vectors where a field may be called through a pointer. In wide registers a function of its own would
/// call each of its operations, in each step with noise.
#[cfg_attr(optimised, inline(always))]
fn begin_with<V: State, F: VectorField<V::Scalar, Point = V>>(
    field: &F,
    z: &V,
    done: MaskOf<V>,
    (k, spare): (&mut [V], &mut V),
) {
    if V::Scalar::HAS_SLOW_PATHS {
        evaluate::<V>(field, z, spare);
    } else {
        field.at_into(z, spare);
    }
    fill_unless(done, k, spare);
}

#[inline(never)]
fn evaluate<V: State>(field: &FieldOn<'_, V>, z: &V, value: &mut V) {
    field.at_into(z, value);
}

/// [`StageEquations::evaluate`] as a function.
type Evaluate<'a, V> = dyn FnMut(usize, &[V], MaskOf<V>, &mut V) + 'a;

/// Stage equations whose type is not known.
struct Erased<'a, 'b, V: State> {
    has_low_parts: bool,
    evaluate: &'a mut Evaluate<'b, V>,
}

impl<V: State> StageEquations<V> for Erased<'_, '_, V> {
    fn has_low_parts(&self) -> bool {
        self.has_low_parts
    }

    fn evaluate(&mut self, i: usize, k: &[V], near: MaskOf<V>, value: &mut V) {
        (self.evaluate)(i, k, near, value);
    }
}

/// Makes a second attempt in the lanes that are not `done`. It is rare, and so compiled once for each type of vectors and
/// scales, and not for each field.
#[cold]
#[inline(never)]
fn again<V: State>(
    solver: &StageSolver,
    done: MaskOf<V>,
    scale: &impl Scale<V>,
    (k, spare): (&mut [V], &mut V),
    equations: &mut Erased<'_, '_, V>,
) -> Result<usize, Unconverged<MaskOf<V>>> {
    solver.solve_from(done, scale, k, spare, &mut unknown(), equations)
}

/// Returns the combined result of a first attempt, and of a second one in the lanes that a prediction had misled.
fn retried<M: Mask>(
    first: &Unconverged<M>,
    guessed: M,
    second: Result<usize, Unconverged<M>>,
) -> Result<usize, Unconverged<M>> {
    let failed = guessed.or(first.converged).not();
    let lost = first.iterations;
    match second {
        Ok(iterations) if !failed.any() => Ok(lost + iterations),
        Ok(iterations) => {
            let (converged, astray) = (failed.not(), first.astray.and(failed));
            let iterations = lost + iterations;
            Err(Unconverged { converged, astray, iterations, error: first.error })
        }
        Err(second) => {
            let converged = second.converged.and(failed.not());
            let astray = second.astray.or(first.astray.and(failed));
            Err(Unconverged { converged, astray, iterations: lost + second.iterations, ..second })
        }
    }
}

/// Returns the lanes in which two points are equal to round-off, in every coordinate.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn near<V: State>(a: &V, b: &V) -> MaskOf<V> {
    let (mut apart, size) = (BlockSizes::zero(), BlockSizes::of(core::slice::from_ref(b)));
    apart.include_difference(a, b);
    apart.at_most(
        #[cfg_attr(optimised, inline(always))]
        |block| size.at(block) * ROUND_OFF,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::StepError;

    /// The iterations of both attempts count, whatever becomes of the second.
    #[test]
    fn a_second_attempt_adds_its_iterations() {
        let failed = |converged, iterations| Unconverged {
            converged,
            astray: false,
            iterations,
            error: StepError::NotConverged { residual: 1.0, required: 0.0, iterations },
        };
        let first = failed(false, 30);
        assert_eq!(retried(&first, true, Ok(5)).ok(), Some(35));
        let count = |guessed, second| retried(&first, guessed, second).err().map(|e| e.iterations);
        assert_eq!(count(true, Err(failed(false, 7))), Some(37));
        // The first attempt was not misled by a prediction, and its failure stays.
        assert_eq!(count(false, Ok(5)), Some(35));
    }
}
