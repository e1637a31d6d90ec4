//! When a point is moved back along its fibre: [`RecentringThreshold`].

use crate::iteration::block_sizes::{BlockSizes, MaskOf};
use lie_poisson::{Mask, State};
use momentum_map::{Far, PoissonMap};

/// Returns the growth of a block of z beyond which z is moved to a point of the fibre nearer to the origin.
fn growth(far: Far) -> f64 {
    match far {
        Far::Digits => 4.0,
        Far::Length => 1.5,
    }
}

/// Returns which points z are moved along the fibres of a map between the steps of an equivariant scheme.
pub(crate) fn moves_along<M: PoissonMap>(map: &M) -> Far {
    if map.equivariant_maps_descend() { Far::Digits } else { Far::Length }
}

/// The sizes of z when it was near the origin of its fibre, or `None` at the beginning of a run.
#[derive(Clone, Debug)]
pub(crate) struct RecentringThreshold<V: State>(Option<BlockSizes<V>>);

impl<V: State> Default for RecentringThreshold<V> {
    fn default() -> Self {
        Self(None)
    }
}

impl<V: State> RecentringThreshold<V> {
    /// Lets `recentre` move z in the lanes in which a run begins or z has grown fourfold, or by half for
    /// [`Far::Length`], and remembers its sizes then. Does nothing if there is no such lane.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn recentre_if_grown(
        &mut self,
        z: &mut V,
        far: Far,
        recentre: impl FnOnce(&mut V, MaskOf<V>),
    ) {
        let sizes = BlockSizes::of(core::slice::from_ref(z));
        let grown = match &self.0 {
            Some(near) => sizes
                .at_most(
                    #[cfg_attr(optimised, inline(always))]
                    |block| near.at(block) * growth(far),
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
    fn a_point_is_moved_back_when_it_has_grown() {
        for (unit, far) in [1e-30, 1.0, 1e30]
            .into_iter()
            .flat_map(|unit| [(unit, Far::Digits), (unit, Far::Length)])
        {
            let mut threshold = RecentringThreshold::<Vector2<f64>>::default();
            let mut is_moved = |factor: f64| {
                let mut moved = false;
                let mut z = Vector2::new(1.0, -0.5) * (factor * unit);
                threshold.recentre_if_grown(&mut z, far, |_, _| moved = true);
                moved
            };
            // A run begins, grows to less and to more than the threshold, and continues from the new size.
            let factor = growth(far);
            let factors =
                [1.0, 0.98 * factor, 1.02 * factor, factor * factor, 1.03 * factor * factor];
            let moves = factors.map(&mut is_moved);
            assert_eq!(moves, [true, false, true, false, true], "{unit:e} {far:?}");
        }
    }
}
