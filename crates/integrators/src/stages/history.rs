//! What is remembered of the steps before, and the guesses from it.

use crate::stage_frame::StageFrame;
use crate::stages::block_sizes::{BlockSizes, MaskOf};
use crate::stages::convergence::{ROUND_OFF, Ratios, unknown};
use crate::stages::extrapolation::Predictor;
use crate::stages::stage_scale::Scale;
use crate::stages::stage_solver::{Unconverged, combination, fill_unless};
use crate::{StageSolver, VectorField};
use lie_poisson::{Mask, Real, Vector};

/// A guess beyond this multiple of what it extends is none.
const LARGEST_GROWTH: f64 = 2.0;

/// The stage derivatives of the last steps of equal size, each of which began where the one before
/// it ended, in the coordinates of the [frame](StageFrame). Each lane remembers by itself.
#[derive(Clone, Debug)]
pub(crate) struct StageHistory<V: Vector> {
    /// Oldest first; those that mean something come before `newest`. There is room for twice as many
    /// as are needed, so that they are moved to the front only now and then.
    past: Vec<V>,
    newest: usize,
    /// Of each step.
    stages: usize,
    /// How many steps are remembered, lane by lane; and the most in any lane.
    steps: V::Scalar,
    most: usize,
    /// Their size.
    size: f64,
    /// Where the last one ended, and how fast its iteration converged.
    end: V,
    pace: Ratios<V::Scalar>,
}

impl<V: Vector> StageHistory<V> {
    /// Empty, with room for what a predictor needs.
    pub(crate) fn new(predictor: &Predictor) -> Self {
        Self {
            past: vec![V::zero(); 2 * predictor.capacity()],
            newest: 0,
            stages: predictor.stages,
            steps: V::Scalar::from_f64(0.0),
            most: 0,
            size: 0.0,
            end: V::zero(),
            pace: unknown(),
        }
    }

    /// Forgets everything.
    pub(crate) fn forget(&mut self) {
        self.steps = V::Scalar::from_f64(0.0);
        self.most = 0;
        self.newest = 0;
        self.pace = unknown();
    }

    /// Solves for the stage derivatives k of a step of the given size from z by fixed-point
    /// iteration, from a guess where there is one; where not, or where that fails, from X(z).
    /// Remembers them. Returns the number of iterations.
    ///
    /// # Errors
    /// Where the iteration fails; nothing is remembered there.
    #[inline]
    pub(crate) fn solve<F: VectorField<V::Scalar, Point = V>>(
        &mut self,
        predictor: &Predictor,
        solver: &StageSolver,
        field: &F,
        (z, size, scale): (&V, f64, &impl Scale<V>),
        k: &mut [V],
        mut derivative: impl FnMut(usize, &[V], MaskOf<V>) -> V,
    ) -> Result<usize, Unconverged<MaskOf<V>>> {
        let frame = field.stage_frame();
        self.keep_where(z, size, predictor, &frame);
        let guessed = self.guess(predictor, &frame, k);
        if !guessed.all() {
            fill_unless(guessed, k, &field.at(z));
        }
        let none = MaskOf::<V>::from_bool(false);
        let mut outcome = solver.solve_from(none, scale, k, &mut self.pace, &mut derivative);
        if let Err(first) = &outcome {
            let misled = guessed.and(first.converged.not());
            if misled.any() {
                fill_unless(misled.not(), k, &field.at(z));
                let second = again(solver, misled.not(), scale, k, &mut derivative);
                outcome = retried(first, guessed, second);
            }
        }
        let converged = outcome.as_ref().map_or_else(|e| e.converged, |_| none.not());
        self.remember(predictor, &frame, size, k, converged);
        outcome
    }

    /// Where the step ended that was solved last.
    #[inline]
    pub(crate) fn end_at(&mut self, z: &V) {
        self.end = *z;
    }

    /// Forgets everything where a step does not go on from what is remembered, or if that comes
    /// from another method.
    #[inline]
    fn keep_where(&mut self, z: &V, size: f64, predictor: &Predictor, frame: &impl StageFrame<V>) {
        let room = 2 * predictor.capacity();
        if self.past.len() != room || self.stages != predictor.stages {
            self.past.resize(room, V::zero());
            self.stages = predictor.stages;
            self.forget();
        }
        if self.size != size {
            self.forget();
        }
        if self.most > 0 && !frame.continues() && *z != self.end {
            let near = near(z, &self.end);
            self.steps = Real::select(near, self.steps, V::Scalar::from_f64(0.0));
            self.pace = self
                .pace
                .map(|ratio| Real::select(near, ratio, V::Scalar::from_f64(f64::INFINITY)));
        }
    }

    /// Writes a guess. Returns where there is one.
    #[inline]
    fn guess(&self, predictor: &Predictor, frame: &impl StageFrame<V>, k: &mut [V]) -> MaskOf<V> {
        let none = MaskOf::<V>::from_bool(false);
        let (mut tried, mut guessed) = (none, none);
        for (n, weights) in (1..self.most + 1).zip(&predictor.weights).rev() {
            let here = self.remembers(n);
            // The one stage of one step is a worse guess than X(z).
            if !here.any() || n * predictor.stages < 2 {
                continue;
            }
            let past = &self.past[self.newest - n * predictor.stages..self.newest];
            for (k, row) in k.iter_mut().zip(weights.chunks_exact(past.len())) {
                let sum = combination(row, past);
                *k = if here.all() { sum } else { V::select(here, &sum, k) };
            }
            let last = &past[past.len() - predictor.stages..];
            let last = BlockSizes::of(last);
            let modest = BlockSizes::of(k).at_most(|block| last.at(block) * LARGEST_GROWTH);
            guessed = guessed.or(here.and(modest));
            tried = tried.or(here);
            if tried.all() {
                break;
            }
        }
        if guessed.any() {
            k.iter_mut().for_each(|k| *k = frame.recalled(k));
        }
        guessed
    }

    /// Where n steps are remembered.
    #[inline]
    fn remembers(&self, n: usize) -> MaskOf<V> {
        let n = V::Scalar::from_f64(n as f64);
        self.steps.at_most(n).and(n.at_most(self.steps))
    }

    /// One more step where it is converged, nothing elsewhere.
    #[inline]
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
            self.past.copy_within(self.newest - kept.., 0);
            self.newest = kept;
        }
        for (past, k) in self.past[self.newest..].iter_mut().zip(k) {
            *past = frame.remembered(k);
        }
        self.newest += k.len();
        self.size = size;
        let full = self.remembers(predictor.weights.len());
        let steps = Real::select(full, self.steps, self.steps + 1.0);
        self.steps = Real::select(converged, steps, V::Scalar::from_f64(0.0));
        self.most = (self.most + 1).min(predictor.weights.len());
    }
}

/// A second attempt, in the lanes that are not `done`. It is rare, and stays out of the way of the first.
#[cold]
#[inline(never)]
fn again<V: Vector>(
    solver: &StageSolver,
    done: MaskOf<V>,
    scale: &impl Scale<V>,
    k: &mut [V],
    derivative: &mut impl FnMut(usize, &[V], MaskOf<V>) -> V,
) -> Result<usize, Unconverged<MaskOf<V>>> {
    solver.solve_from(done, scale, k, &mut unknown(), derivative)
}

/// What comes of a second attempt, in the lanes that a guess had misled, after the first.
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
            let converged = failed.not();
            Err(Unconverged { converged, iterations: lost + iterations, error: first.error })
        }
        Err(second) => {
            let converged = second.converged.and(failed.not());
            Err(Unconverged { converged, iterations: lost + second.iterations, ..second })
        }
    }
}

/// Where two points are equal to round-off, in every coordinate.
#[inline]
pub(crate) fn near<V: Vector>(a: &V, b: &V) -> MaskOf<V> {
    let (apart, size) = (BlockSizes::of(&[*a - *b]), BlockSizes::of(core::slice::from_ref(b)));
    apart.at_most(|block| size.at(block) * ROUND_OFF)
}
