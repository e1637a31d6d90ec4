//! The engine of all batches: it advances groups of members block by block and treats those that fail.

use crate::error::IntegrationError;
use crate::stages::checkpoints::blocks;
use core::ops::Range;

/// The largest number of members that are advanced together. It is the number of SIMD lanes of the widest type.
pub const MOST_LANES: usize = 16;

/// The steps of a group of members.
pub(crate) trait Group {
    /// The type of a member.
    type Member: Copy;

    /// Returns the number of members that are advanced together.
    fn width(&self) -> usize;

    /// Advances at most `width` members by `count` steps. Returns which of them have a result; the others may be left
    /// in any state.
    fn together(&mut self, group: &mut [Self::Member], step: f64, count: u64)
    -> [bool; MOST_LANES];

    /// Advances one member by itself. If a step fails, the member keeps the state before it.
    fn alone(
        &mut self,
        member: &mut Self::Member,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError>;
}

/// Advances all members, as [`BatchIntegrator::advance`](crate::BatchIntegrator::advance) promises.
///
/// The members make a block of steps, from one checkpoint to the next, together. A member without a result repeats the
/// block by itself. If it fails there too, it is reported and takes no further step; otherwise it continues with the
/// others.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn advance_groups<G: Group>(
    group: &mut G,
    members: &mut [G::Member],
    step: f64,
    steps: Range<u64>,
    failed: &mut dyn FnMut(usize, IntegrationError),
) {
    if steps.is_empty() {
        // No step is made, but a start that is not finite is refused.
        for (i, member) in members.iter_mut().enumerate() {
            group.alone(member, step, steps.clone()).unwrap_or_else(|error| failed(i, error));
        }
        return;
    }
    let width = group.width().clamp(1, MOST_LANES);
    for (n, members) in members.chunks_mut(width).enumerate() {
        // The indices of the members that can continue come first.
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
