//! Stage derivatives of an accuracy beyond that of the rounded stages.

use crate::stages::block_sizes::MaskOf;
use crate::stages::stage_solver::{combination, evenly_scaled, plus_combination};
use crate::stages::two_sum::two_sum;
use crate::{Tableau, VectorField};
use lie_poisson::{Mask, Pair, Real, Vector};

/// What a stage's rounding is enlarged by, a power of two, where its effect on the field is taken by a
/// difference: to √ε of the stage, where rounding and curvature disturb the difference equally
/// little, by a relative 1e-8.
const ENLARGEMENT: f64 = 67_108_864.0;

/// Sweeps of refinement. The first makes δk; each further one multiplies what is missing by the
/// contraction of the fixed-point iteration, and after two of these it is lost among the roundings of the
/// field.
const SWEEPS: usize = 3;

/// Replaces k_i by X at the rounded stage Z_i, and writes to `rest` the δk_i = X′·δZ_i for which k_i + δk_i is
/// X at the unrounded stage Z_i + δZ_i = z + h Σ_j a_ij (k_j + δk_j); less than a rounding of k_i, it would be
/// lost there. Only in the chosen lanes; in the others δk_i = 0.
///
/// An iteration to the floor ends at one of several neighbouring fixed points in floating-point
/// arithmetic, always the one on the side from which it comes. The roundings δZ therefore have a mean: of
/// some hundredths of a rounding, which in a long run is a drift of the invariants: of |z|² by
/// 2h Σ_i b_i k_i·δZ_i in a step, if it conserves |z|².
#[inline]
pub(crate) fn refine<T: Real, F: VectorField<T>>(
    field: &F,
    (z, step): (&F::Point, f64),
    tableau: &Tableau,
    chosen: MaskOf<F::Point>,
    k: &mut [F::Point],
    rest: &mut [F::Point],
) {
    rest.fill(F::Point::zero());
    if !chosen.any() {
        return;
    }
    for n in 0..SWEEPS * k.len() {
        let i = n % k.len();
        let small = combination(tableau.row_low(i), k);
        let sum = plus_combination(small, tableau.row(i), k);
        let Pair(stage, rounding) = two_sum(z, &evenly_scaled(&sum, step));
        let lost = rounding + combination(tableau.row(i), rest).scaled(T::from_f64(step));
        let value = field.at(&stage);
        let moved = field.at(&(stage + lost.scaled(T::from_f64(ENLARGEMENT))));
        let correction = (moved - value).scaled(T::from_f64(1.0 / ENLARGEMENT));
        k[i] = F::Point::select(chosen, &value, &k[i]);
        rest[i] = F::Point::select(chosen, &correction, &rest[i]);
    }
}
