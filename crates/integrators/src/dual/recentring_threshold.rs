//! When a point is moved back along its fibre: [`RecentringThreshold`].

use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use lie_poisson::{Mask, State};

/// The growth of a block of z beyond which z is moved to a point of the fibre nearer to the origin.
const GROWTH: f64 = 4.0;

/// The sizes of z when it was near the origin of its fibre, or `None` at the beginning of a run.
#[derive(Clone, Debug)]
pub(crate) struct RecentringThreshold<V: State>(Option<BlockSizes<V>>);

impl<V: State> Default for RecentringThreshold<V> {
    fn default() -> Self {
        Self(None)
    }
}

impl<V: State> RecentringThreshold<V> {
    /// Lets `recentre` move z in the lanes in which a run begins or z has grown fourfold, and remembers its sizes then.
    /// Does nothing if there is no such lane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn recentre_if_grown(
        &mut self,
        z: &mut V,
        recentre: impl FnOnce(&mut V, MaskOf<V>),
    ) {
        let sizes = BlockSizes::of(core::slice::from_ref(z));
        let grown = match &self.0 {
            Some(near) => sizes
                .at_most(
                    #[inline(always)]
                    |block| near.at(block) * GROWTH,
                )
                .not(),
            None => Mask::from_bool(true),
        };
        if !grown.any() {
            return;
        }
        recentre(z, grown);
        let sizes = BlockSizes::of(core::slice::from_ref(z));
        self.0 = Some(BlockSizes::select(grown, &sizes, self.0.as_ref().unwrap_or(&sizes)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    /// The threshold is a ratio of sizes, whatever their unit.
    #[test]
    fn a_point_is_moved_back_when_it_has_grown_fourfold() {
        for unit in [1e-30, 1.0, 1e30] {
            let mut threshold = RecentringThreshold::<Vector2<f64>>::default();
            let mut is_moved = |factor: f64| {
                let mut moved = false;
                let mut z = Vector2::new(1.0, -0.5) * (factor * unit);
                threshold.recentre_if_grown(&mut z, |_, _| moved = true);
                moved
            };
            // A run begins, grows to less and to more than the threshold, and continues from the new size.
            let moves = [1.0, 3.9, 4.1, 16.0, 16.5].map(&mut is_moved);
            assert_eq!(moves, [true, false, true, false, true], "{unit:e}");
        }
    }
}
