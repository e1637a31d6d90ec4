//! Orders and step fractions of the flows of a splitting: [`FlowSequence`].

use crate::{AlternatingSubsteps, ExactFlows};
use lie_poisson::Real;

/// The order in which a [`Splitting`](crate::Splitting) runs its flows, with the fraction of the step for each of them.
///
/// Implementations are [`LieTrotter`], [`Strang`] and [`AlternatingSubsteps`].
pub trait FlowSequence {
    /// Returns the point to which the flows lead from z in a step of size `step`, one after the other.
    fn run<T: Real, E: ExactFlows<T>>(&self, flows: &E, step: f64, z: &E::Point) -> E::Point;

    /// Returns the order of convergence for flows in general position.
    fn order(&self) -> usize;

    /// Returns whether the splitting is symmetric in time, Φ₋ₕ ∘ Φₕ = id, for all flows.
    fn is_symmetric(&self) -> bool;
}

/// The sequence of all flows once, each for the whole step, of order 1:
///
/// ```text
/// φ_n(h) ∘ … ∘ φ_1(h)
/// ```
///
/// Source: McLachlan & Quispel, *Splitting methods*, Acta Numer. 11 (2002).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LieTrotter;

impl FlowSequence for LieTrotter {
    #[inline]
    fn run<T: Real, E: ExactFlows<T>>(&self, flows: &E, step: f64, z: &E::Point) -> E::Point {
        (0..E::COUNT).fold(z.clone(), |z, index| flows.flow(index, step, &z))
    }

    fn order(&self) -> usize {
        1
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}

/// The sequence of half steps forwards and back, which is symmetric and of order 2:
///
/// ```text
/// φ_1(h/2) ∘ … ∘ φ_(n−1)(h/2) ∘ φ_n(h) ∘ φ_(n−1)(h/2) ∘ … ∘ φ_1(h/2)
/// ```
///
/// Source: Strang (1968), Marchuk (1968); McLachlan & Quispel, *Splitting methods*, Acta Numer. 11
/// (2002).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Strang;

impl FlowSequence for Strang {
    #[inline]
    fn run<T: Real, E: ExactFlows<T>>(&self, flows: &E, step: f64, z: &E::Point) -> E::Point {
        let flow = |time: f64| move |z: E::Point, index| flows.flow(index, time, &z);
        let last = E::COUNT.saturating_sub(1);
        let there = (0..last).fold(z.clone(), flow(0.5 * step));
        let middle = flow(step)(there, last);
        (0..last).rev().fold(middle, flow(0.5 * step))
    }

    fn order(&self) -> usize {
        2
    }

    fn is_symmetric(&self) -> bool {
        true
    }
}

/// The alternating sequence of two flows. A step of more or fewer flows does not compile.
impl FlowSequence for AlternatingSubsteps {
    #[inline]
    fn run<T: Real, E: ExactFlows<T>>(&self, flows: &E, step: f64, z: &E::Point) -> E::Point {
        const { assert!(E::COUNT == 2, "AlternatingSubsteps run exactly two flows") };
        let flow = |index: usize, fraction: f64, z: E::Point| {
            if fraction == 0.0 { z } else { flows.flow(index, fraction * step, &z) }
        };
        let (a, b) = (self.first(), self.second());
        a.iter().zip(b).fold(z.clone(), |z, (&a, &b)| flow(1, b, flow(0, a, z)))
    }

    fn order(&self) -> usize {
        Self::order(self)
    }

    fn is_symmetric(&self) -> bool {
        Self::is_symmetric(self)
    }
}
