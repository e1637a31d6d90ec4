//! Points that are the same in every run and behave like random ones.

use nalgebra::DVector;

/// Returns numbers of no special relation to each other, which are the same in every run. Those of an arithmetic progression
/// would not do: their sines fill a plane.
pub(crate) fn generic(count: usize, sample: usize) -> DVector<f64> {
    DVector::from_fn(count, |i, _| {
        let n = (1 + i + 31 * sample) as f64;
        (1.3 + 0.7 * n * n).sin()
    })
}
