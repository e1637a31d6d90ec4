//! Scales of blocks from the sizes of a point and the tangent map of a step: [`natural_scales`].

use lie_poisson::{BlockScales, State, larger};

/// Returns the scales s_b in whose units vectors at a point z are measured, for points and steps in any units.
///
/// `sizes` are the sizes |z_b| of the blocks, and `coupling(a, b)` is the size c_ab of block (a, b) of DΦ − 1: the change
/// of block a in a step Φ for a vector of size 1 in block b. The scales are
///
/// ```text
/// s_a = max( |z_a|, max_b c_ab s_b/r ),    r = max over cycles (c_ab c_bc … c_ka)^(1/n) of n blocks
/// ```
///
/// The rate r is that at which the point moves, per step, and c_ab s_b/r is what block a gets from block b in the time
/// 1/r. A block that is small at z is therefore measured by the size that it may take. For a heavy top that starts at
/// rest this is √(I mgl |Γ|) for Π. Where nothing flows into a block of size 0, its scale is the one by which its own
/// influence on the other blocks has their scale. What neither acts nor is acted upon has the scale 1.
///
/// If the unit of a block is divided by a number, its scale is multiplied by that number.
pub(crate) fn natural_scales<V: State<Scalar = f64>>(
    blocks: usize,
    sizes: &BlockScales<V>,
    coupling: impl Fn(usize, usize) -> f64,
) -> BlockScales<V> {
    let pairs = || (0..blocks).flat_map(|a| (0..=a).map(move |b| (a, b)));
    // The roots are taken one by one, since units may overflow in a product.
    let mutual = |(a, b): (usize, usize)| coupling(a, b).sqrt() * coupling(b, a).sqrt();
    let fastest = larger(pairs().map(mutual).fold(0.0, larger), longer_cycles(blocks, &coupling));
    let rate = if fastest > 0.0 && fastest.is_finite() { fastest } else { 1.0 };
    let mut scales = *sizes;
    // As many rounds as there are blocks carry a scale from each to each.
    for _ in 0..blocks {
        for a in 0..blocks {
            let inflow = (0..blocks).map(|b| coupling(a, b) * scales.at(b) / rate);
            scales.set(a, inflow.fold(scales.at(a), larger));
        }
    }
    while let Some(zero) = (0..blocks).find(|&block| !is_scale(scales.at(block))) {
        let influence = |b: usize| {
            let outflow = (0..blocks).map(|a| rate * scales.at(a) / coupling(a, b));
            outflow.filter(|&scale| is_scale(scale)).reduce(f64::min)
        };
        let next = (zero..blocks).filter(|&block| !is_scale(scales.at(block)));
        let found = next.clone().find_map(|block| Some((block, influence(block)?)));
        let (block, scale) = found.unwrap_or((zero, 1.0));
        scales.set(block, scale);
    }
    scales
}

/// Returns the largest geometric mean of the couplings along a closed path of three blocks or more, or 0 without one.
///
/// Logarithms are added, since units may overflow in a product.
fn longer_cycles(blocks: usize, coupling: &impl Fn(usize, usize) -> f64) -> f64 {
    let logarithm = |a, b| coupling(a, b).ln();
    let mut paths: Vec<f64> =
        (0..blocks * blocks).map(|n| logarithm(n / blocks, n % blocks)).collect();
    let mut most = 0.0;
    for length in 2..=blocks {
        let through = |a: usize, b: usize| {
            let parts = (0..blocks).map(|c| paths[a * blocks + c] + logarithm(c, b));
            parts.fold(f64::NEG_INFINITY, larger)
        };
        paths = (0..blocks * blocks).map(|n| through(n / blocks, n % blocks)).collect();
        if length > 2 {
            let closed = (0..blocks).map(|a| paths[a * blocks + a]);
            most = larger(most, (closed.fold(f64::NEG_INFINITY, larger) / length as f64).exp());
        }
    }
    most
}

/// Returns whether a number can be divided by.
fn is_scale(x: f64) -> bool {
    x.is_normal() && x > 0.0
}

#[cfg(test)]
mod tests {
    use super::natural_scales;
    use lie_poisson::{BlockScales, Pair};
    use nalgebra::Vector1;

    type Three = Pair<Pair<Vector1<f64>, Vector1<f64>>, Vector1<f64>>;

    fn point([x, y, z]: [f64; 3]) -> BlockScales<Three> {
        BlockScales::of(&Pair(Pair(Vector1::new(x), Vector1::new(y)), Vector1::new(z)))
    }

    /// Returns the scales for sizes and couplings in units of u.
    fn scales(sizes: [f64; 3], couplings: [[f64; 3]; 3], u: [f64; 3]) -> [f64; 3] {
        let sizes = point([0, 1, 2].map(|a| sizes[a] * u[a]));
        let scales = natural_scales(3, &sizes, |a, b| couplings[a][b] * u[a] / u[b]);
        [0, 1, 2].map(|a| scales.at(a) / u[a])
    }

    /// Asserts the scales, in several units.
    fn expect(sizes: [f64; 3], couplings: [[f64; 3]; 3], expected: [f64; 3]) {
        for u in [[1.0; 3], [1e30, 1.0, 1e-30], [1e-30, 1e30, 1.0], [1e150, 1e-150, 1e-30]] {
            let found = scales(sizes, couplings, u);
            // a logarithm of 1e300 has an error of 1e-13
            let close = |a: usize| (found[a] / expected[a] - 1.0).abs() < 1e-12;
            assert!((0..3).all(close), "{sizes:?} {u:?}: {found:?}");
        }
    }

    #[test]
    fn a_small_block_has_the_size_that_it_may_take() {
        // A top: Π gets hγΓ from Γ, Γ gets hΓ/I from Π, with γ = 9, I = 4, h = 1/10; a third block stands apart.
        let top = |own: f64| [[own, 0.9, 0.0], [0.025, own, 0.0], [0.0, 0.0, 0.1]];
        // The root of I γ |Γ| is 6; the rate of the turns is 1.5.
        for small in [0.0, 1e-17, 1e-3] {
            expect([small, 1.0, 2.0], top(0.0), [6.0, 1.0, 2.0]);
        }
        expect([60.0, 1.0, 2.0], top(1.5), [60.0, 1.0, 2.0]);
    }

    /// Of three blocks that drive one another in turn, each grows at the rate of the cycle.
    #[test]
    fn a_cycle_of_blocks_has_a_rate() {
        let turn = |own: f64| [[own, 0.1, 0.0], [0.0, own, 0.4], [0.8, 0.0, own]];
        let rate = (0.1_f64 * 0.4 * 0.8).cbrt();
        let expected = [1.0, 0.4 * 0.8 / rate / rate, 0.8 / rate];
        expect([1.0, 0.0, 0.0], turn(1e-3), expected);
        // Control: a faster rate of their own leaves less.
        expect([1.0, 0.0, 0.0], turn(1.0), [1.0, 0.4 * 0.8, 0.8]);
    }

    #[test]
    fn a_block_without_an_inflow_is_measured_by_its_influence() {
        // A body that turns at the rate 2, and a block of size 0 that acts on it by 5.
        let couplings = [[2.0, 5.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]];
        expect([3.0, 0.0, 7.0], couplings, [3.0, 1.2, 7.0]);
        // What is at rest, with nothing that flows back, has the rate of one per step.
        let found = scales([0.0; 3], [[0.0, 5.0, 0.0], [0.0; 3], [0.0; 3]], [1.0; 3]);
        assert_eq!(found, [1.0, 0.2, 1.0]);
    }
}
