//! Guesses of stage derivatives, from those of the steps before.

use crate::stage_solver::ROUND_OFF;
use crate::{StageSolver, StepError};
use lie_poisson::{Real, Vector, larger};

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
/// it ended.
#[derive(Clone, Debug)]
pub(crate) struct Memory<V> {
    /// Oldest first; those that mean something are at the end.
    past: Vec<V>,
    /// How many steps are remembered.
    steps: usize,
    /// Their size.
    size: f64,
    /// Where the last one ended.
    end: V,
}

impl<V: Vector> Memory<V> {
    /// Empty, with room for what a predictor needs.
    pub(crate) fn new(predictor: &Predictor) -> Self {
        let past = vec![V::zero(); predictor.capacity()];
        Self { past, steps: 0, size: 0.0, end: V::zero() }
    }

    /// Forgets everything.
    pub(crate) fn forget(&mut self) {
        self.steps = 0;
    }

    /// Solves for the stage derivatives k of a step of the given size from z by fixed-point
    /// iteration, from a guess if there is one; if not, or if that fails, from `start`(), X(z).
    /// Remembers them. Returns the number of iterations.
    ///
    /// # Errors
    /// [`StepError::NotConverged`] if the iteration fails; nothing is remembered then.
    #[inline]
    pub(crate) fn solve(
        &mut self,
        predictor: &Predictor,
        solver: &StageSolver,
        (z, size): (&V, f64),
        k: &mut [V],
        start: impl Fn() -> V,
        derivative: impl Fn(usize, &[V]) -> V,
    ) -> Result<usize, StepError> {
        self.keep_if(self.size == size && near(z, &self.end), predictor);
        let mut guessed = self.guess(predictor, k);
        let mut lost = 0;
        loop {
            if !guessed {
                k.fill(start());
            }
            match solver.solve_from(size, k, &derivative) {
                Err(StepError::NotConverged { iterations, .. }) if guessed => {
                    (guessed, lost) = (false, iterations);
                }
                Ok(iterations) => {
                    self.remember(predictor, size, k);
                    return Ok(lost + iterations);
                }
                failure => {
                    self.forget();
                    return failure;
                }
            }
        }
    }

    /// Where the step ended that was solved last.
    #[inline]
    pub(crate) fn end_at(&mut self, z: &V) {
        self.end = *z;
    }

    /// Forgets everything if a step does not go on from what is remembered, or if that comes from
    /// another method.
    #[inline]
    fn keep_if(&mut self, continues: bool, predictor: &Predictor) {
        if self.past.len() != predictor.capacity() {
            self.past.resize(predictor.capacity(), V::zero());
            self.forget();
        }
        if !continues {
            self.forget();
        }
    }

    /// Writes a guess. Returns whether there is one.
    #[inline]
    fn guess(&self, predictor: &Predictor, k: &mut [V]) -> bool {
        let weights = self.steps.checked_sub(1).and_then(|n| predictor.weights.get(n));
        let remembered = self.steps * predictor.stages;
        let (Some(weights), 2..) = (weights, remembered) else {
            // The one stage of one step is a worse guess than X(z).
            return false;
        };
        let past = &self.past[self.past.len() - remembered..];
        for (k, row) in k.iter_mut().zip(weights.chunks_exact(remembered)) {
            *k = V::zero();
            for (&w, past) in row.iter().zip(past) {
                k.add_scaled(V::Scalar::from_f64(w), past);
            }
        }
        largest(k) <= LARGEST_GROWTH * largest(past)
    }

    #[inline]
    fn remember(&mut self, predictor: &Predictor, size: f64, k: &[V]) {
        if self.past.is_empty() {
            return;
        }
        self.past.copy_within(k.len().., 0);
        let newest = self.past.len() - k.len();
        self.past[newest..].copy_from_slice(k);
        self.size = size;
        self.steps = (self.steps + 1).min(predictor.weights.len());
    }

    /// Applies a linear map that takes the end of the last step to `end`; forgets everything where
    /// it has no value.
    #[inline]
    pub(crate) fn move_by(&mut self, stages: usize, end: &V, motion: impl Fn(&V) -> Option<V>) {
        let first = self.past.len().saturating_sub(self.steps * stages);
        for k in &mut self.past[first..] {
            match motion(k) {
                Some(moved) => *k = moved,
                None => self.steps = 0,
            }
        }
        self.end = *end;
    }
}

/// Whether two points are equal to round-off, in every coordinate and lane.
#[inline]
pub(crate) fn near<V: Vector>(a: &V, b: &V) -> bool {
    (*a - *b).max_abs() <= ROUND_OFF * b.max_abs()
}

/// The largest coordinate.
#[inline]
fn largest<V: Vector>(k: &[V]) -> f64 {
    k.iter().fold(0.0, |size, k| larger(size, k.max_abs()))
}
