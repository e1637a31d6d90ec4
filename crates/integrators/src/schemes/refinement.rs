//! Stage derivatives of an accuracy beyond that of the rounded stages.

use crate::iteration::block_sizes::MaskOf;
use crate::iteration::stage_solver::{fit, set_combination};
use crate::sums::exact_combination::add_exactly;
use crate::tableaux::tableau::Tableau;
use crate::vector_field::VectorField;
use lie_poisson::{Mask, Real, State};

/// The factor by which the rounding error of a stage is enlarged to measure its effect on the field by a difference.
///
/// It is a power of two. The enlarged error is √ε of the stage. Rounding and curvature then disturb the difference
/// equally little, by a relative 1e-8.
const ENLARGEMENT: f64 = 67_108_864.0;

/// The number of sweeps of refinement.
///
/// The first sweep computes δk. Each further one multiplies the error of δk by the contraction factor of the
/// fixed-point iteration. After two of these the error is lost among the rounding errors of the field.
const SWEEPS: usize = 3;

/// The corrections δk_i of stage derivatives, and what they are computed from.
#[derive(Clone, Debug)]
pub(crate) struct Refinement<V> {
    corrections: Vec<V>,
    stages: Vec<V>,
    lost: Vec<V>,
    values: Vec<V>,
}

impl<V: State> Refinement<V> {
    /// Creates the storage for a number of stages.
    pub(crate) fn with_room(stages: usize) -> Self {
        let room = || Vec::with_capacity(stages);
        Self { corrections: room(), stages: room(), lost: room(), values: room() }
    }

    /// Returns the corrections δk_i.
    pub(crate) fn corrections(&self) -> &[V] {
        &self.corrections
    }

    /// Computes corrections δk_i for which k_i + δk_i is X at the unrounded stage z + e + h Σ_j a_ij (k_j + δk_j).
    ///
    /// A correction has the size of a rounding error of k_i, and would be lost if it were added. Only the chosen lanes
    /// are refined; in the others δk_i = 0.
    ///
    /// An iteration to the round-off floor ends at one of several neighbouring fixed points in floating-point
    /// arithmetic, always the one on the side from which it comes. The rounding errors of the stages are therefore
    /// biased, by some hundredths of a rounding. In a long run this is a drift of the invariants. If the field
    /// conserves |z|², an error δZ_i of the stages changes |z|² in a step by 2h Σ_i b_i k_i·δZ_i.
    #[inline]
    pub(crate) fn refine<F: VectorField<V::Scalar, Point = V>>(
        &mut self,
        field: &F,
        (start, step): ((&V, &V), f64),
        tableau: &Tableau,
        chosen: MaskOf<V>,
        k: &[V],
        pool: &mut V::Pool,
    ) {
        for vectors in [&mut self.corrections, &mut self.stages, &mut self.lost, &mut self.values] {
            fit(vectors, k.len(), start.0);
        }
        for correction in &mut self.corrections {
            correction.set_zero();
        }
        if chosen.any() {
            self.evaluate(field, (start, step), tableau, k, pool);
            self.sweep(field, step, tableau, chosen, k, pool);
        }
    }

    /// Computes the stages z + e + h Σ_j a_ij k_j, as their rounded values and the rounding errors, and X at the
    /// rounded values.
    #[cfg_attr(optimised, inline(always))]
    fn evaluate<F: VectorField<V::Scalar, Point = V>>(
        &mut self,
        field: &F,
        ((z, e), step): ((&V, &V), f64),
        tableau: &Tableau,
        k: &[V],
        pool: &mut V::Pool,
    ) {
        for i in 0..k.len() {
            let (stage, lost) = (&mut self.stages[i], &mut self.lost[i]);
            stage.assign(z);
            lost.assign(e);
            add_exactly((stage, lost), (step, tableau.row(i), tableau.row_low(i)), k, pool);
            field.at_into(stage, &mut self.values[i]);
        }
    }

    /// Improves the corrections δk_i = X(Z_i) − k_i + X′·(δZ_i + h Σ_j a_ij δk_j) by turns, where Z_i + δZ_i is a
    /// stage.
    #[cfg_attr(optimised, inline(always))]
    fn sweep<F: VectorField<V::Scalar, Point = V>>(
        &mut self,
        field: &F,
        step: f64,
        tableau: &Tableau,
        chosen: MaskOf<V>,
        k: &[V],
        pool: &mut V::Pool,
    ) {
        let Some(first) = k.first() else { return };
        let (mut error, mut stage) = (V::take(pool, first), V::take(pool, first));
        let mut change = V::take(pool, first);
        let number = V::Scalar::from_f64;
        for n in 0..SWEEPS * k.len() {
            let i = n % k.len();
            set_combination(&mut error, tableau.row(i), &self.corrections);
            error.scale_in_place(number(step));
            error.add_in_place(&self.lost[i]);
            stage.assign(&self.stages[i]);
            stage.add_multiple(number(ENLARGEMENT), &error);
            field.at_into(&stage, &mut change);
            change.subtract_in_place(&self.values[i]);
            change.scale_in_place(number(1.0 / ENLARGEMENT));
            error.assign(&self.values[i]);
            error.subtract_in_place(&k[i]);
            change.add_in_place(&error);
            self.corrections[i].replace_where(chosen, &change);
        }
        for vector in [error, stage, change] {
            vector.give(pool);
        }
    }
}
