//! The engine of all batches: groups of members, block by block, and what becomes of those that fail.

use crate::IntegrationError;
use crate::batch::blocks::blocks;
use core::ops::Range;

/// The largest number of members that are advanced together: as many as the widest type has SIMD lanes.
pub const MOST_LANES: usize = 16;

/// The steps of a group of members.
pub(crate) trait Group {
    /// What is advanced.
    type Member: Copy;

    /// The number of members that are advanced together.
    fn width(&self) -> usize;

    /// Advances at most `width` members by `count` steps. Returns where they have a result; the others may be
    /// anything.
    fn together(&mut self, group: &mut [Self::Member], step: f64, count: u64)
    -> [bool; MOST_LANES];

    /// Advances one member by itself. If a step fails, the member is left before it.
    fn alone(
        &mut self,
        member: &mut Self::Member,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError>;
}

/// Advances all members, as [`BatchIntegrator::advance`](crate::BatchIntegrator::advance) promises.
///
/// A block of steps, from one checkpoint to the next, is made together. A member without a result makes the block
/// again by itself. If it fails there too it is reported and takes no further step; else it goes on with the others.
#[inline(always)]
pub(crate) fn advance_groups<G: Group>(
    group: &mut G,
    members: &mut [G::Member],
    step: f64,
    steps: Range<u64>,
    failed: &mut dyn FnMut(usize, IntegrationError),
) {
    if steps.is_empty() {
        // No step is made; a start that is not finite is refused all the same.
        for (i, member) in members.iter_mut().enumerate() {
            group.alone(member, step, steps.clone()).unwrap_or_else(|error| failed(i, error));
        }
        return;
    }
    let width = group.width().clamp(1, MOST_LANES);
    for (n, members) in members.chunks_mut(width).enumerate() {
        // The indices of those that can go on come first.
        let mut order: [usize; MOST_LANES] = core::array::from_fn(|i| i);
        let mut alive = members.len();
        for steps in blocks(steps.clone()) {
            if alive == 0 {
                break;
            }
            let mut together = [members[0]; MOST_LANES];
            for (copy, &i) in together.iter_mut().zip(&order[..alive]) {
                *copy = members[i];
            }
            let results = group.together(&mut together[..alive], step, steps.end - steps.start);
            let mut kept = 0;
            for place in 0..alive {
                let i = order[place];
                if results[place] {
                    members[i] = together[place];
                } else if let Err(error) = group.alone(&mut members[i], step, steps.clone()) {
                    failed(n * width + i, error);
                    continue;
                }
                order[kept] = i;
                kept += 1;
            }
            alive = kept;
        }
    }
}
