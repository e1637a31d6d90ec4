//! The sizes of the terms whose sums are the derivatives of a state: [`terms`], and where they cancel: [`cancels`].

use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use crate::iteration::convergence::is_finite;
use crate::stages::newton::FieldOn;
use lie_poisson::{Mask, Real, State};

/// The part of its size by which each coordinate is changed: half of the digits.
const PART: f64 = 1.0 / (1 << 26) as f64;

/// The number whose multiples have fractional parts that are all different, and evenly spread.
const GOLDEN_RATIO: f64 = 1.618_033_988_749_895;

/// The longest chain of blocks, of which each drives the next alone, whose terms are measured.
const CHAIN: usize = 4;

/// The size of a derivative, relative to its terms, below which they cancel.
const CANCELLED: f64 = 1.0 / 1024.0;

/// The sizes of the terms whose sums are the derivatives.
pub(crate) struct Terms<V: State> {
    /// Those at the point itself.
    of_point: BlockSizes<V>,
    /// Those in the step, in which round-off of a block has the size of its terms.
    pub(crate) of_step: BlockSizes<V>,
}

/// Returns the sizes of the terms whose sums are the derivatives in a step of the given size from z, where `rate` is X(z).
///
/// The derivative of a block whose terms cancel is round-off, which differs by its own size from one solution to the
/// next. That of a block which such a block alone drives is round-off, too. A change of each coordinate by a small part
/// of its size, and of the size that the terms of its block give it in the step, changes X by that part of its terms.
#[cold]
#[inline(never)]
pub(crate) fn terms<V: State>(field: &FieldOn<'_, V>, (z, step): (&V, f64), rate: &V) -> Terms<V> {
    let start = BlockSizes::of(core::slice::from_ref(z));
    let (mut moves, mut terms) = (start.clone(), BlockSizes::zero());
    let mut of_point = None;
    let (mut moved, mut value) = (z.clone(), rate.clone());
    for _ in 0..CHAIN {
        // No two coordinates change alike, so that no symmetry keeps sums that cancel.
        let change = |i| PART * (0.5 + 0.5 * f64::fract(GOLDEN_RATIO * i as f64));
        moved.set_coordinates(|i| z.coordinate(i) + moves.at(z.block(i)) * change(i));
        field.at_into(&moved, &mut value);
        let mut response = BlockSizes::zero();
        response.include_difference(&value, rate);
        terms = BlockSizes::zero();
        // The state may be at the edge of the domain of X.
        let finite = is_finite(response.largest());
        let response = BlockSizes::select(finite, &response, &terms);
        terms.add_multiple(V::Scalar::from_f64(1.0 / PART), &response);
        moves = start.clone();
        moves.add_multiple(V::Scalar::from_f64(step.abs()), &terms);
        of_point.get_or_insert_with(|| terms.clone());
    }
    Terms { of_point: of_point.unwrap_or_else(|| terms.clone()), of_step: terms }
}

/// Returns the lanes in which a block of the derivatives is small because its terms cancel, in a short step: none of the other
/// blocks moves by more than its size. The terms in a long step say nothing, since they grow with powers of its length.
pub(crate) fn cancels<V: State>(terms: &Terms<V>, (z, step): (&V, f64), rate: &V) -> MaskOf<V> {
    let [start, sizes] = [z, rate].map(|v| BlockSizes::of(core::slice::from_ref(v)));
    let is_sum = |b| (terms.of_point.at(b) * CANCELLED).at_most(sizes.at(b));
    let moving = BlockSizes::<V>::from_parts(
        |b| Real::select(is_sum(b), sizes.at(b), V::Scalar::from_f64(0.0)),
        sizes.sum(),
    );
    let is_short = moving.at_most(|b| start.at(b) * step.abs().recip());
    let cancelled = terms.of_step.at_most(|b| sizes.at(b) * (1.0 / CANCELLED)).not();
    cancelled.and(is_short)
}
