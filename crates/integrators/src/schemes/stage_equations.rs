//! The stage equations of a Runge–Kutta step: [`Stages`].

use crate::iteration::block_sizes::MaskOf;
use crate::iteration::convergence::Ratios;
use crate::iteration::lane_problem::{LaneProblem, Outcome};
use crate::iteration::prediction::Prediction;
use crate::iteration::stage_rows::{StageColumns, StageRows};
use crate::iteration::stage_scale::StageScale;
use crate::iteration::stage_solver::{StageEquations, StageSolver, set_combination};
use crate::tableaux::tableau::Tableau;
use crate::vector_field::VectorField;
use core::hint::black_box;
use lie_poisson::{Mask, Real, State};

/// The equations k_i = X(z + h Σ_j a_ij k_j).
pub(super) struct Stages<'a, F, V: State> {
    pub(super) tableau: &'a Tableau,
    pub(super) field: &'a F,
    pub(super) z: &'a V,
    pub(super) h: V::Scalar,
    /// The sums Σ_j low_ij k_j, or zero if the coefficients have no low parts.
    pub(super) small: &'a mut [V],
    pub(super) pool: &'a mut V::Pool,
    /// The additional data for a field that computes the stages side by side.
    pub(super) lanes: Option<(&'a StageColumns, f64, &'a StageScale<V>, &'a mut StageRows)>,
}

impl<F: VectorField<V::Scalar, Point = V>, V: State> StageEquations<V> for Stages<'_, F, V> {
    #[cfg_attr(optimised, inline(always))]
    fn has_low_parts(&self) -> bool {
        !self.tableau.row_low(0).is_empty()
    }

    #[cfg_attr(optimised, inline(always))]
    fn solve_in_lanes(
        &mut self,
        solver: &StageSolver,
        k: &mut [V],
        prediction: Option<Prediction<'_, V>>,
        (pace, usual): (&mut Ratios<V::Scalar>, usize),
    ) -> Option<Outcome<V>> {
        let (columns, step, scale, rows) = self.lanes.as_mut()?;
        let (z, step) = (self.z, *step);
        let rows = &mut **rows;
        self.field.solve_in_lanes(&mut LaneProblem {
            columns,
            solver,
            scale,
            z,
            step,
            k,
            prediction,
            pace,
            usual,
            rows,
        })
    }

    #[cfg_attr(optimised, inline(always))]
    fn evaluate(&mut self, i: usize, k: &[V], near: MaskOf<V>, value: &mut V) {
        let mut stage = V::take(self.pool, self.z);
        let (rows, small) = ([self.tableau.row_low(i), self.tableau.row(i)], &mut self.small[i]);
        // With derivatives it costs much more than a call.
        if V::Scalar::from_f64(0.0).without_derivative().is_some() {
            write_stage_apart(i, k, near, (self.z, self.h), rows, (small, &mut stage));
        } else {
            write_stage(i, k, near, (self.z, self.h), rows, (small, &mut stage));
        }
        if is_plain_and_small::<V>() {
            // In memory, so that the compiler pairs the coordinates in the sums in the order in which it loads them, and
            // not in one that suits the field.
            let mut point = stage.clone();
            black_box(&mut point);
            self.field.at_into(&point, value);
        } else {
            self.field.at_into(&stage, value);
        }
        stage.give(self.pool);
    }
}

/// Writes the stage z + h Σ_j a_ij k_j for the rows of the low parts of the coefficients and of the coefficients. The sum with
/// the low parts is `small`, which changes when k comes `near` the solution.
#[cfg_attr(optimised, inline(always))]
fn write_stage<V: State>(
    i: usize,
    k: &[V],
    near: MaskOf<V>,
    (z, h): (&V, V::Scalar),
    [row_low, row]: [&[f64]; 2],
    (small, stage): (&mut V, &mut V),
) {
    if near.any() {
        set_combination(stage, row_low, k);
        small.replace_where(near, stage);
    }
    stage.assign(small);
    let (before, after) = row.split_at(i);
    // The newest stage comes last, so that the other terms need not wait for it.
    stage.add_combination(after, &k[i..]);
    stage.add_combination(before, k);
    stage.scale_in_place(h);
    stage.add_in_place(z);
}

/// Does the same in code that is compiled once for each type of vectors, and not for each field.
#[inline(never)]
fn write_stage_apart<V: State>(
    i: usize,
    k: &[V],
    near: MaskOf<V>,
    step: (&V, V::Scalar),
    rows: [&[f64]; 2],
    written: (&mut V, &mut V),
) {
    write_stage(i, k, near, step, rows, written);
}

/// Returns whether the scalars of the state are plain numbers, and the state is not on the heap.
#[cfg_attr(optimised, inline(always))]
pub(super) fn is_plain_and_small<V: State>() -> bool {
    size_of::<V::Pool>() == 0 && V::Scalar::from_f64(0.0).as_f64().is_some()
}
