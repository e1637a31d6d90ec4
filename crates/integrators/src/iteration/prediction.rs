//! Guesses from the steps before, for stages side by side: [`Prediction`].

use crate::iteration::stage_rows::StageRow;

/// A guess Σ_j w_ij k_j of the stage derivatives, from those of the last steps.
#[derive(Debug)]
pub(crate) struct Prediction<'a, V> {
    /// The stage derivatives k_j, oldest first.
    pub(crate) past: &'a [V],
    /// The columns w_0j, w_1j, … of the weights.
    pub(crate) columns: &'a [StageRow],
}

/// The largest multiple of the last stage derivatives that a prediction may have.
pub(crate) const LARGEST_GROWTH: f64 = 2.0;
