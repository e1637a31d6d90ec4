//! Orders and step fractions of the flows of a splitting: [`FlowSequence`].

use crate::splittings::exact_flows::ExactFlows;
use crate::step_fractions::alternating_substeps::AlternatingSubsteps;
use lie_poisson::{Real, State};

/// The order in which a [`Splitting`](crate::Splitting) runs its flows, with the fraction of the step for each of them.
///
/// Implementations are [`LieTrotter`], [`Strang`] and [`AlternatingSubsteps`].
pub trait FlowSequence {
    /// Moves z along the flows in a step of size `step`, one after the other. Temporary points come from the pool.
    fn run<T: Real, E: ExactFlows<T>>(
        &self,
        flows: &E,
        step: f64,
        z: &mut E::Point,
        pool: &mut <E::Point as State>::Pool,
    );

    /// Returns the order of convergence for generic flows.
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
    fn run<T: Real, E: ExactFlows<T>>(
        &self,
        flows: &E,
        step: f64,
        z: &mut E::Point,
        pool: &mut <E::Point as State>::Pool,
    ) {
        for index in 0..E::COUNT {
            flows.flow_in_place(index, step, z, pool);
        }
    }

    fn order(&self) -> usize {
        1
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}

/// The sequence of half steps in increasing and then in decreasing order of the parts, which is symmetric and of order
/// 2:
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
    fn run<T: Real, E: ExactFlows<T>>(
        &self,
        flows: &E,
        step: f64,
        z: &mut E::Point,
        pool: &mut <E::Point as State>::Pool,
    ) {
        let last = E::COUNT.saturating_sub(1);
        (0..last).for_each(|index| flows.flow_in_place(index, 0.5 * step, z, pool));
        flows.flow_in_place(last, step, z, pool);
        (0..last).rev().for_each(|index| flows.flow_in_place(index, 0.5 * step, z, pool));
    }

    fn order(&self) -> usize {
        2
    }

    fn is_symmetric(&self) -> bool {
        true
    }
}

/// The alternating sequence of two flows. A step with more or fewer flows does not compile.
impl FlowSequence for AlternatingSubsteps {
    #[inline]
    fn run<T: Real, E: ExactFlows<T>>(
        &self,
        flows: &E,
        step: f64,
        z: &mut E::Point,
        pool: &mut <E::Point as State>::Pool,
    ) {
        const { assert!(E::COUNT == 2, "AlternatingSubsteps run exactly two flows") };
        for (&a, &b) in self.first().iter().zip(self.second()) {
            for (index, fraction) in [a, b].into_iter().enumerate() {
                if fraction != 0.0 {
                    flows.flow_in_place(index, fraction * step, z, pool);
                }
            }
        }
    }

    fn order(&self) -> usize {
        Self::order(self)
    }

    fn is_symmetric(&self) -> bool {
        Self::is_symmetric(self)
    }
}
