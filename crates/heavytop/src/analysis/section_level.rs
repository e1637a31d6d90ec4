//! The least energy of a section, and evenly spread points of its plane.

use core::f64::consts::PI;

/// The number of angles at which the search begins.
const ANGLES: u32 = 24;

/// The number of heights at which the search begins.
const HEIGHTS: u32 = 12;

/// The number of times that the step lengths are halved, until rounding ends the search.
const HALVINGS: u32 = 28;

/// The largest number of moves of a search, far more than a valley takes. It ends a search along a slope without end.
const MOVES: u32 = 10_000;

/// Returns the least value of f(angle, height) over all angles and −1 < height < 1.
///
/// It is found by compass search from a grid, down to the rounding of f.
///
/// Source: T. G. Kolda, R. M. Lewis & V. Torczon, *Optimization by direct search*, SIAM Review 45
/// (2003).
pub(crate) fn least_energy(f: impl Fn(f64, f64) -> f64) -> f64 {
    let steps = [PI / f64::from(ANGLES), 1.0 / f64::from(HEIGHTS)];
    let mut least = f64::INFINITY;
    for i in 0..ANGLES {
        for j in 0..HEIGHTS {
            let angle = steps[0] * f64::from(2 * i + 1) - PI;
            let height = steps[1] * f64::from(2 * j + 1) - 1.0;
            least = least.min(compass(&f, [angle, height], steps));
        }
    }
    least
}

fn compass(f: &impl Fn(f64, f64) -> f64, mut at: [f64; 2], mut steps: [f64; 2]) -> f64 {
    let (mut least, mut moves) = (f(at[0], at[1]), 0);
    for _ in 0..HALVINGS {
        while moves < MOVES {
            let [[x, y], [dx, dy]] = [at, steps];
            let around = [[x + dx, y], [x - dx, y], [x, y + dy], [x, y - dy]];
            let lower =
                around.iter().filter(|[_, y]| y.abs() < 1.0).find(|[x, y]| f(*x, *y) < least);
            let Some(&[x, y]) = lower else { break };
            (at, least) = ([x, y], f(x, y));
            moves += 1;
        }
        steps = steps.map(|step| 0.5 * step);
    }
    least
}

/// Returns Weyl's sequence (n/g, n/g²) mod 1 for g³ = g + 1, shifted at random.
pub(crate) fn quasi_random(seed: u64) -> impl Iterator<Item = [f64; 2]> {
    const ROOT: f64 = 1.324_717_957_244_746;
    let shift = [seed, seed.wrapping_add(GOLDEN)].map(split_mix);
    (1_u32..).map(move |n| {
        let n = f64::from(n);
        [(shift[0] + n / ROOT).fract(), (shift[1] + n / (ROOT * ROOT)).fract()]
    })
}

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Returns a number in [0, 1) that depends on every bit of the seed.
///
/// Source: G. L. Steele, D. Lea & C. H. Flood, *Fast splittable pseudorandom number generators*,
/// OOPSLA 2014: the generator SplitMix64.
fn split_mix(seed: u64) -> f64 {
    let mut bits = seed.wrapping_add(GOLDEN);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((bits ^ (bits >> 31)) >> 11) as f64 * 0.5_f64.powi(53)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_of_two_valleys_is_found() {
        // −1 at (1, 0.3) and −1 − 1e-6 at (−2, −0.5)
        let valley = |x: f64, y: f64, a: f64, b: f64| {
            let square = (x - a).powi(2) + 3.0 * (y - b).powi(2);
            -(-20.0 * square).exp()
        };
        let f =
            |x: f64, y: f64| valley(x, y, 1.0, 0.3).min((1.0 + 1e-6) * valley(x, y, -2.0, -0.5));
        assert!((least_energy(f) + 1.0 + 1e-6).abs() < 1e-14);
        // NaN is no minimum
        assert_eq!(least_energy(|_, y: f64| if y > 0.5 { f64::NAN } else { 2.0 }), 2.0);
        // a slope without end
        assert!(least_energy(|x, _| -x) < -100.0);
    }

    #[test]
    fn a_search_goes_in_all_directions() {
        let bowl = |x: f64, y: f64| (x - 0.1).powi(2) + (y + 0.2).powi(2);
        for [x, y] in [[0.33, 0.31], [0.33, -0.31], [-0.33, 0.31], [-0.33, -0.31]] {
            let start = [0.1 + x, -0.2 + y];
            // The last steps have the length 0.1 / 2²⁷.
            assert!(compass(&bowl, start, [0.1; 2]) < 1e-17, "from {start:?}");
            // Control: the start is no minimum.
            assert!(bowl(start[0], start[1]) > 0.1);
        }
    }

    /// The first output of SplitMix64 for three seeds, computed with whole numbers of arbitrary length.
    #[test]
    fn random_shifts_are_those_of_split_mix() {
        for (seed, output) in SPLIT_MIX {
            assert_eq!(split_mix(seed), (output >> 11) as f64 / 2.0_f64.powi(53), "{seed}");
        }
    }

    const SPLIT_MIX: [(u64, u64); 3] = [
        (0, 16_294_208_416_658_607_535),
        (1234567, 6_457_827_717_110_365_317),
        (u64::MAX, 16_490_336_266_968_443_936),
    ];

    /// Each box of a 16 × 16 grid gets its share of 2560 points to within a few; the pseudorandom
    /// numbers of the shift alone would be 10 ± 10.
    #[test]
    fn the_sequence_is_spread_evenly() {
        for seed in [0, 1, u64::MAX] {
            let mut counts = [[0_u32; 16]; 16];
            for [s, t] in quasi_random(seed).take(2560) {
                counts[(s * 16.0) as usize][(t * 16.0) as usize] += 1;
            }
            let counts = counts.as_flattened();
            assert!(counts.iter().all(|n| (6..=14).contains(n)), "{seed}: {counts:?}");
        }
        let first = |seed| quasi_random(seed).next();
        assert!(first(0) != first(1));
    }

    /// Only the search that begins in the middle of a box of the grid finds a valley within that box.
    #[test]
    fn a_search_begins_in_every_box() {
        for (i, j) in (0..ANGLES).flat_map(|i| (0..HEIGHTS).map(move |j| (i, j))) {
            let angle = (f64::from(i) + 0.5) / f64::from(ANGLES) * 2.0 * PI - PI;
            let height = (f64::from(j) + 0.5) / f64::from(HEIGHTS) * 2.0 - 1.0;
            let sides = [PI / f64::from(ANGLES), 1.0 / f64::from(HEIGHTS)];
            let valley = |x: f64, y: f64| {
                let distance = ((x - angle) / sides[0]).hypot((y - height) / sides[1]);
                if distance < 0.4 { distance - 1.0 } else { 0.0 }
            };
            assert!((least_energy(valley) + 1.0).abs() < 1e-12, "{i} {j}");
        }
    }
}
