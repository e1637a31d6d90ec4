//! The distance between two momenta as a pure number: block by block, relative to the size of the block.

use super::system_scales::SystemScales;
use core::ops::Range;

/// The share of the size that the motion gives to a block, for blocks that start at zero.
const SHARE: f64 = 1e-6;

/// The blocks of coordinates of a run, and the size of each.
pub(super) struct RelativeDistance {
    blocks: Vec<(Range<usize>, f64)>,
}

impl RelativeDistance {
    /// Measures the blocks by their largest norms |μ_b| over the momenta, the first of which is the start.
    ///
    /// A block that starts at zero may remain there but for rounding, which is no scale. It has at least the size
    /// 10⁻⁶ E/|ξ_b|, where E = Σ |ξ_i μ_i| is the largest over the momenta, and so is |ξ_b|.
    pub(super) fn new<'a>(
        system: &impl SystemScales,
        momenta: impl Iterator<Item = &'a [f64]>,
    ) -> Self {
        let blocks = system.blocks();
        let mut sizes = vec![Size::default(); blocks.len()];
        let mut energy = 0.0_f64;
        for mu in momenta {
            let xi = system.differential(mu);
            energy = energy.max(xi.iter().zip(mu).map(|(xi, mu)| (xi * mu).abs()).sum());
            for (size, block) in sizes.iter_mut().zip(&blocks) {
                size.include(norm(of(mu, block)), norm(of(&xi, block)));
            }
        }
        let size = |size: &Size| match size.first {
            Some(0.0) if size.velocity > 0.0 => size.most.max(SHARE * energy / size.velocity),
            _ => size.most,
        };
        Self { blocks: blocks.into_iter().zip(sizes.iter().map(size)).collect() }
    }

    /// Returns the largest |a_b − b_b|/size over the blocks.
    pub(super) fn between(&self, a: &[f64], b: &[f64]) -> f64 {
        let relative = |(block, size): &(Range<usize>, f64)| {
            let apart = of(a, block).iter().zip(of(b, block)).map(|(a, b)| a - b);
            let apart = apart.fold(0.0, f64::hypot);
            // A block that is always zero has no error.
            if apart == 0.0 { 0.0 } else { apart / size }
        };
        self.blocks.iter().map(relative).fold(0.0, f64::max)
    }
}

/// The sizes of a block of μ, and of the same block of ξ.
#[derive(Clone, Default)]
struct Size {
    first: Option<f64>,
    most: f64,
    velocity: f64,
}

impl Size {
    fn include(&mut self, size: f64, velocity: f64) {
        self.first.get_or_insert(size);
        self.most = self.most.max(size);
        self.velocity = self.velocity.max(velocity);
    }
}

fn of<'a>(coordinates: &'a [f64], block: &Range<usize>) -> &'a [f64] {
    coordinates.get(block.clone()).unwrap_or_default()
}

fn norm(coordinates: &[f64]) -> f64 {
    coordinates.iter().copied().fold(0.0, f64::hypot)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two blocks, x of two coordinates and y of one, with ξ = (x, c y).
    struct Two(f64);

    impl SystemScales for Two {
        fn blocks(&self) -> Vec<Range<usize>> {
            vec![0..2, 2..3]
        }

        fn differential(&self, mu: &[f64]) -> Vec<f64> {
            vec![mu[0], mu[1], self.0 * mu[2]]
        }

        fn fastest_rate(&self, _: &[f64]) -> f64 {
            1.0
        }
    }

    fn distance(momenta: [[f64; 3]; 2], a: [f64; 3], b: [f64; 3]) -> f64 {
        let momenta = momenta.iter().map(<[f64; 3]>::as_slice);
        RelativeDistance::new(&Two(1.0), momenta).between(&a, &b)
    }

    #[test]
    fn each_block_has_its_own_scale() {
        for unit in [1e-30, 1.0, 1e30] {
            let momenta = [[3.0, 4.0, 2.0 * unit], [0.0, 0.0, unit]];
            assert_eq!(distance(momenta, [0.0; 3], [3.0, 4.0, 0.0]), 1.0, "the largest |x| is 5");
            let of_y = distance(momenta, [0.0; 3], [0.0, 0.0, unit]);
            assert!((of_y - 0.5).abs() < 1e-15, "{of_y}");
        }
    }

    /// A y that starts at zero and remains there but for rounding has no error; one that grows is measured by itself.
    #[test]
    fn rounding_is_no_scale() {
        let noise = distance([[1.0, 0.0, 0.0], [1.0, 0.0, 1e-17]], [0.0; 3], [0.0, 0.0, 1e-17]);
        assert!(noise < 1e-20, "{noise:e}");
        let grown = distance([[1.0, 0.0, 0.0], [1.0, 0.0, 0.5]], [0.0; 3], [0.0, 0.0, 0.5]);
        assert_eq!(grown, 1.0);
        // Control: a small y at the start is a scale.
        let small = distance([[1.0, 0.0, 1e-17], [1.0, 0.0, 0.0]], [0.0; 3], [0.0, 0.0, 1e-17]);
        assert_eq!(small, 1.0);
        // What is always zero has no error.
        assert_eq!(distance([[0.0; 3]; 2], [0.0; 3], [0.0; 3]), 0.0);
    }
}
