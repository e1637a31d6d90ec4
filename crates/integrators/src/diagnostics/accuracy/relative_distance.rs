//! The distance between two momenta as a pure number: block by block, relative to the size of the block.

use super::system_scales::SystemScales;
use core::ops::Range;
use lie_poisson::larger;

/// The share of the size that the motion gives to a block, for blocks that start at zero.
const SHARE: f64 = 1e-6;

/// The largest |ξ_b| |μ_b|/E of a start that is zero but for rounding, such as cos(π/2).
const ROUNDING: f64 = 1e-15;

/// The blocks of coordinates of a run, and the size of each.
pub(super) struct RelativeDistance {
    blocks: Vec<(Range<usize>, f64)>,
}

impl RelativeDistance {
    /// Measures the blocks by their largest norms |μ_b| over the momenta, the first of which is the start.
    ///
    /// A block that starts at zero, but for rounding, may remain there but for rounding, which is no scale. It has at least
    /// the size 10⁻⁶ E/|ξ_b|, where E = Σ |ξ_i μ_i| is the largest over the momenta, and so is |ξ_b|. What moves a block
    /// with ξ_b = 0 gives it no size in its own unit: its own is used.
    pub(super) fn new<'a>(
        system: &dyn SystemScales,
        momenta: impl Iterator<Item = &'a [f64]>,
    ) -> Self {
        let blocks = system.blocks();
        let mut sizes = vec![Size::default(); blocks.len()];
        let mut energy = 0.0_f64;
        for mu in momenta {
            let xi = system.differential(mu);
            energy = larger(energy, xi.iter().zip(mu).map(|(xi, mu)| (xi * mu).abs()).sum());
            for (size, block) in sizes.iter_mut().zip(&blocks) {
                size.include(norm(of(mu, block)), norm(of(&xi, block)));
            }
        }
        let size = |size: &Size| {
            let is_scale =
                size.first.is_some_and(|first| first * size.velocity > ROUNDING * energy);
            match is_scale || size.velocity == 0.0 {
                true => size.most,
                false => larger(size.most, SHARE * energy / size.velocity),
            }
        };
        Self { blocks: blocks.into_iter().zip(sizes.iter().map(size)).collect() }
    }

    /// Returns a momentum at about this distance from another, in no special direction.
    pub(super) fn displaced(&self, mu: &[f64], distance: f64) -> Vec<f64> {
        let mut displaced = mu.to_vec();
        for (block, size) in &self.blocks {
            for (number, x) in displaced.get_mut(block.clone()).into_iter().flatten().enumerate() {
                *x += distance * size * (1.0 + number as f64).cos();
            }
        }
        displaced
    }

    /// Returns the largest |a_b − b_b|/size over the blocks, which is not a number if one of them is not.
    pub(super) fn between(&self, a: &[f64], b: &[f64]) -> f64 {
        let relative = |(block, size): &(Range<usize>, f64)| {
            let apart = of(a, block).iter().zip(of(b, block)).map(|(a, b)| a - b);
            let apart = apart.fold(0.0, f64::hypot);
            // A block that is always zero has no error.
            if apart == 0.0 { 0.0 } else { apart / size }
        };
        self.blocks.iter().map(relative).fold(0.0, larger)
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
        self.most = larger(self.most, size);
        self.velocity = larger(self.velocity, velocity);
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

    fn distance_in(c: f64, momenta: [[f64; 3]; 2], a: [f64; 3], b: [f64; 3]) -> f64 {
        let momenta = momenta.iter().map(<[f64; 3]>::as_slice);
        RelativeDistance::new(&Two(c), momenta).between(&a, &b)
    }

    fn distance(momenta: [[f64; 3]; 2], a: [f64; 3], b: [f64; 3]) -> f64 {
        distance_in(1.0, momenta, a, b)
    }

    #[test]
    fn each_block_has_its_own_scale() {
        for unit in [1e-30_f64, 1.0, 1e30] {
            let momenta = [[3.0, 4.0, 2.0 * unit], [0.0, 0.0, unit]];
            // The energy c y²/2 is the same in each unit of y.
            let distance = |b| distance_in(unit.powi(-2), momenta, [0.0; 3], b);
            assert_eq!(distance([3.0, 4.0, 0.0]), 1.0, "the largest |x| is 5");
            let of_y = distance([0.0, 0.0, unit]);
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
        // The cosine of π/2 is zero but for rounding.
        let cosine = core::f64::consts::FRAC_PI_2.cos();
        let turned = distance([[1.0, 0.0, cosine], [1.0, 0.0, 0.0]], [0.0; 3], [0.0, 0.0, cosine]);
        assert!(turned < 1e-20, "{turned:e}");
        // Control: a small y at the start is a scale.
        let small = distance([[1.0, 0.0, 1e-7], [1.0, 0.0, 0.0]], [0.0; 3], [0.0, 0.0, 1e-7]);
        assert_eq!(small, 1.0);
        // One that nothing depends on has its own scale, in whatever unit.
        let momenta = [[1.0, 0.0, 1e-30].as_slice(); 2];
        let passive = RelativeDistance::new(&Two(0.0), momenta.into_iter());
        assert_eq!(passive.between(&[0.0; 3], &[0.0, 0.0, 1e-30]), 1.0);
        // What is always zero has no error.
        assert_eq!(distance([[0.0; 3]; 2], [0.0; 3], [0.0; 3]), 0.0);
    }

    /// What is not a number is neither lost nor taken for a size.
    #[test]
    fn not_a_number_stays_so() {
        let momenta = [[1.0, 0.0, 1.0]; 2];
        for (a, b) in [([f64::NAN, 0.0, 0.0], [0.0; 3]), ([0.0; 3], [0.0, 0.0, f64::NAN])] {
            assert!(distance(momenta, a, b).is_nan());
        }
        assert!(distance([[f64::NAN, 0.0, 1.0]; 2], [1.0; 3], [0.0; 3]).is_nan());
        // A differential without a value is a scale of no block that starts at zero.
        let momenta = [[1.0, 0.0, 0.0].as_slice(); 2];
        let without = RelativeDistance::new(&Two(f64::NAN), momenta.into_iter());
        assert!(without.between(&[0.0; 3], &[0.0, 0.0, 1.0]).is_nan());
    }
}
