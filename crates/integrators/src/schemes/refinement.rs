//! Stage derivatives of an accuracy beyond that of the rounded stages.

use crate::iteration::block_sizes::MaskOf;
use crate::iteration::stage_solver::{scale_evenly, set_combination};
use crate::stages::two_sum::two_sum;
use crate::{Tableau, VectorField};
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

/// Replaces k_i by X at the rounded stage Z_i, and writes the corrections δk_i = X′·δZ_i to `rest`.
///
/// Then k_i + δk_i is X at the unrounded stage Z_i + δZ_i = z + h Σ_j a_ij (k_j + δk_j). The correction is smaller than
/// a rounding of k_i, and would be lost there. Only the chosen lanes are refined; in the others δk_i = 0.
///
/// An iteration to the round-off floor ends at one of several neighbouring fixed points in floating-point arithmetic,
/// always the one on the side from which it comes. The rounding errors δZ are therefore biased, by some hundredths of a
/// rounding. In a long run this is a drift of the invariants. If the field conserves |z|², the drift of |z|² in a step
/// is 2h Σ_i b_i k_i·δZ_i.
#[inline]
pub(crate) fn refine<T: Real, F: VectorField<T>>(
    field: &F,
    (z, step): (&F::Point, f64),
    tableau: &Tableau,
    chosen: MaskOf<F::Point>,
    (k, rest): (&mut [F::Point], &mut [F::Point]),
    pool: &mut <F::Point as State>::Pool,
) {
    for rest in &mut *rest {
        rest.set_zero();
    }
    if !chosen.any() {
        return;
    }
    let (mut sum, mut change) = (F::Point::take(pool, z), F::Point::take(pool, z));
    let (mut stage, mut lost) = (F::Point::take(pool, z), F::Point::take(pool, z));
    let mut value = F::Point::take(pool, z);
    for n in 0..SWEEPS * k.len() {
        let i = n % k.len();
        set_combination(&mut sum, tableau.row_low(i), k);
        sum.add_combination(tableau.row(i), k);
        scale_evenly(&sum, step, &mut change);
        two_sum(z, &change, &mut stage, &mut lost, &mut value);
        set_combination(&mut sum, tableau.row(i), rest);
        sum.scale_in_place(T::from_f64(step));
        lost.add_in_place(&sum);
        field.at_into(&stage, &mut value);
        stage.add_multiple(T::from_f64(ENLARGEMENT), &lost);
        field.at_into(&stage, &mut change);
        change.subtract_in_place(&value);
        change.scale_in_place(T::from_f64(1.0 / ENLARGEMENT));
        k[i].replace_where(chosen, &value);
        rest[i].replace_where(chosen, &change);
    }
    for vector in [sum, change, stage, lost, value] {
        vector.give(pool);
    }
}
