//! Checkpoints, where the steps before are forgotten, and ranges of steps that are divided there.

use core::ops::Range;

/// The number of steps between two checkpoints.
///
/// A step whose number is a multiple of it begins without any memory of earlier steps, from which implicit methods
/// [predict](crate::StageSolver) their stages.
pub const CHECKPOINT: u64 = 1024;

/// Divides a range of steps at the multiples of [`CHECKPOINT`].
pub(crate) fn blocks(steps: Range<u64>) -> impl Iterator<Item = Range<u64>> {
    let mut next = steps.start;
    core::iter::from_fn(move || {
        let start = next;
        next = (start / CHECKPOINT + 1).saturating_mul(CHECKPOINT).min(steps.end);
        (start < steps.end).then_some(start..next)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_end_at_checkpoints() {
        let (c, all) = (CHECKPOINT, |steps| blocks(steps).collect::<Vec<_>>());
        assert_eq!(all(0..2 * c), [0..c, c..2 * c]);
        assert_eq!(all(5..c + 1), [5..c, c..c + 1]);
        assert!(all(u64::MAX - 1..u64::MAX).len() == 1 && all(3..9).len() == 1);
        assert!(all(7..7).is_empty());
    }
}
