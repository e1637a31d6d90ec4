//! Guesses of stage derivatives, from those of the steps before.

use crate::StageSolver;
use crate::settling::{Largest, ROUND_OFF};
use crate::stage_solver::{MaskOf, Unsettled, fill_unless};
use lie_poisson::{Mask, Real, Vector};

/// Nodes nearer than this to each other, in steps, carry no polynomial.
const LEAST_DISTANCE: f64 = 1e-3;

/// A guess beyond this multiple of what it extends is none.
const LARGEST_GROWTH: f64 = 2.0;

/// The extension of the stage derivatives of n steps of equal size to those of the next one,
///
/// ```text
/// k_i ≈ Σ_j w_ij k_j,    w_ij = Π_{l≠j} (c_i − x_l)/(x_j − x_l),    x = c − n, …, c − 1
/// ```
///
/// by the polynomial through them.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed. (2006), §VIII.6.1.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Predictor {
    stages: usize,
    /// The matrices w for n = 1, 2, …, row by row.
    weights: Vec<Vec<f64>>,
}

impl Predictor {
    /// For stages at the times c, in steps; none if two of them coincide, as in methods that are
    /// to be solved stage by stage.
    pub(crate) fn new(nodes: &[f64]) -> Self {
        let matrices = (1..=most_steps(nodes.len())).map_while(|steps| weights(nodes, steps));
        Self { stages: nodes.len(), weights: matrices.collect() }
    }

    /// None, as for explicit methods.
    pub(crate) fn none() -> Self {
        Self { stages: 0, weights: Vec::new() }
    }

    /// The number of stage derivatives to remember.
    fn capacity(&self) -> usize {
        self.weights.len() * self.stages
    }
}

/// How many steps are remembered: what saves the most iterations. The stages of methods with few
/// stages are of low order, and differ from the solution by errors that a polynomial of high degree
/// would enlarge; one stage alone has the same error at every step.
fn most_steps(stages: usize) -> usize {
    match stages {
        1 => 8,
        2 | 3 => 2,
        _ => 1,
    }
}

/// w for n steps; `None` if nodes coincide.
fn weights(nodes: &[f64], steps: usize) -> Option<Vec<f64>> {
    let past: Vec<f64> =
        (1..=steps).rev().flat_map(|n| nodes.iter().map(move |c| c - n as f64)).collect();
    let others = |j: usize| past.iter().enumerate().filter(move |&(l, _)| l != j).map(|(_, x)| x);
    let apart = |(j, x): (usize, &f64)| others(j).all(|y| (x - y).abs() > LEAST_DISTANCE);
    let entry = |c: f64, j: usize| others(j).map(|x| (c - x) / (past[j] - x)).product::<f64>();
    past.iter().enumerate().all(apart).then(|| {
        nodes
            .iter()
            .flat_map(|&c| (0..past.len()).map(move |j| (c, j)))
            .map(|(c, j)| entry(c, j))
            .collect()
    })
}

/// The stage derivatives of the last steps of equal size, each of which began where the one before
/// it ended. Each lane remembers by itself.
#[derive(Clone, Debug)]
pub(crate) struct Memory<V: Vector> {
    /// Oldest first; those that mean something are at the end.
    past: Vec<V>,
    /// How many steps are remembered, lane by lane; and the most in any lane.
    steps: V::Scalar,
    most: usize,
    /// Their size.
    size: f64,
    /// Where the last one ended.
    end: V,
}

impl<V: Vector> Memory<V> {
    /// Empty, with room for what a predictor needs.
    pub(crate) fn new(predictor: &Predictor) -> Self {
        let past = vec![V::zero(); predictor.capacity()];
        let steps = V::Scalar::from_f64(0.0);
        Self { past, steps, most: 0, size: 0.0, end: V::zero() }
    }

    /// Forgets everything.
    pub(crate) fn forget(&mut self) {
        self.steps = V::Scalar::from_f64(0.0);
        self.most = 0;
    }

    /// Solves for the stage derivatives k of a step of the given size from z by fixed-point
    /// iteration, from a guess where there is one; where not, or where that fails, from `start`(),
    /// X(z). Remembers them. Returns the number of iterations.
    ///
    /// # Errors
    /// Where the iteration fails; nothing is remembered there.
    #[inline]
    pub(crate) fn solve(
        &mut self,
        predictor: &Predictor,
        solver: &StageSolver,
        (z, size): (&V, f64),
        k: &mut [V],
        start: impl Fn() -> V,
        mut derivative: impl FnMut(usize, &[V], MaskOf<V>) -> V,
    ) -> Result<usize, Unsettled<MaskOf<V>>> {
        self.keep_where(z, size, predictor);
        let guessed = self.guess(predictor, k);
        if !guessed.all() {
            fill_unless(guessed, k, &start());
        }
        let none = MaskOf::<V>::from_bool(false);
        let mut outcome = solver.solve_from(none, size, k, &mut derivative);
        if let Err(first) = &outcome {
            let misled = guessed.and(first.settled.not());
            if misled.any() {
                fill_unless(misled.not(), k, &start());
                let second = solver.solve_from(misled.not(), size, k, &mut derivative);
                outcome = retried(first, guessed, second);
            }
        }
        let settled = outcome.as_ref().map_or_else(|e| e.settled, |_| none.not());
        self.remember(predictor, size, k, settled);
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
    fn keep_where(&mut self, z: &V, size: f64, predictor: &Predictor) {
        if self.past.len() != predictor.capacity() {
            self.past.resize(predictor.capacity(), V::zero());
            self.forget();
        }
        if self.size != size {
            self.forget();
        }
        if self.most > 0 {
            self.steps = Real::select(near(z, &self.end), self.steps, V::Scalar::from_f64(0.0));
        }
    }

    /// Writes a guess. Returns where there is one.
    #[inline]
    fn guess(&self, predictor: &Predictor, k: &mut [V]) -> MaskOf<V> {
        let mut guessed = MaskOf::<V>::from_bool(false);
        for (n, weights) in (1..=self.most).zip(&predictor.weights) {
            let here = self.remembers(n);
            // The one stage of one step is a worse guess than X(z).
            if !here.any() || n * predictor.stages < 2 {
                continue;
            }
            let past = &self.past[self.past.len() - n * predictor.stages..];
            for (k, row) in k.iter_mut().zip(weights.chunks_exact(past.len())) {
                let mut sum = V::zero();
                for (&w, past) in row.iter().zip(past) {
                    sum.add_scaled(V::Scalar::from_f64(w), past);
                }
                *k = V::select(here, &sum, k);
            }
            let modest = largest(k).at_most(largest(past) * LARGEST_GROWTH);
            guessed = guessed.or(here.and(modest));
        }
        guessed
    }

    /// Where n steps are remembered.
    #[inline]
    fn remembers(&self, n: usize) -> MaskOf<V> {
        let n = V::Scalar::from_f64(n as f64);
        self.steps.at_most(n).and(n.at_most(self.steps))
    }

    /// One more step where it is settled, nothing elsewhere.
    #[inline]
    fn remember(&mut self, predictor: &Predictor, size: f64, k: &[V], settled: MaskOf<V>) {
        if self.past.is_empty() {
            return;
        }
        self.past.copy_within(k.len().., 0);
        let newest = self.past.len() - k.len();
        self.past[newest..].copy_from_slice(k);
        self.size = size;
        let full = self.remembers(predictor.weights.len());
        let steps = Real::select(full, self.steps, self.steps + 1.0);
        self.steps = Real::select(settled, steps, V::Scalar::from_f64(0.0));
        self.most = (self.most + 1).min(predictor.weights.len());
    }

    /// Applies a linear map that takes the end of the last step to `end`; forgets everything where
    /// it has no value.
    #[inline]
    pub(crate) fn move_by(&mut self, stages: usize, end: &V, motion: impl Fn(&V) -> Option<V>) {
        let first = self.past.len().saturating_sub(self.most * stages);
        let moved = self.past[first..].iter_mut().try_for_each(|k| {
            *k = motion(k)?;
            Some(())
        });
        if moved.is_none() {
            self.forget();
        }
        self.end = *end;
    }
}

/// What comes of a second attempt, in the lanes that a guess had misled, after the first.
fn retried<M: Mask>(
    first: &Unsettled<M>,
    guessed: M,
    second: Result<usize, Unsettled<M>>,
) -> Result<usize, Unsettled<M>> {
    let failed = guessed.or(first.settled).not();
    let lost = first.iterations;
    match second {
        Ok(iterations) if !failed.any() => Ok(lost + iterations),
        Ok(iterations) => {
            let settled = failed.not();
            Err(Unsettled { settled, iterations: lost + iterations, error: first.error })
        }
        Err(second) => {
            let settled = second.settled.and(failed.not());
            Err(Unsettled { settled, iterations: lost + second.iterations, ..second })
        }
    }
}

/// Where two points are equal to round-off, in every coordinate.
#[inline]
pub(crate) fn near<V: Vector>(a: &V, b: &V) -> MaskOf<V> {
    (*a - *b).max_norm().at_most(b.max_norm() * ROUND_OFF)
}

/// The largest coordinate.
#[inline]
fn largest<V: Vector>(k: &[V]) -> V::Scalar {
    let mut largest = Largest::zero();
    k.iter().for_each(|k| largest.include(k));
    largest.value()
}
