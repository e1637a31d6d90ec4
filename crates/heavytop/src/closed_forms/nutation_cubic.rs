//! The turning points of Lagrange's top.

use crate::closed_forms::elliptic::root;
use crate::closed_forms::power_of_two::power_of_two;
use lie_poisson::{Covector, Pair, Se3Dual};
use twofloat::TwoFloat;

/// The cubic of Lagrange's top in terms of the distance from its start.
///
/// With v = Γ₃/|Γ| = v₀ + w and the unit of time √(I₁/(W|Γ|)), W = m g l, it is
///
/// ```text
/// (dw/dt)² = 2w³ + Bw² + 2Aw + ρ² = 2(w − w₁)(w − w₂)(w − w₃),   w₁ ≤ 0 ≤ w₂ ≤ w₃,
/// ρ = dw/dt and A = d²w/dt² at the start.
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NutationCubic {
    /// The length |Γ| of the vertical.
    pub length: f64,
    /// The rate ρ = dw/dt at the start.
    pub rising: f64,
    /// The three roots w₁, w₂ and w₃.
    pub roots: [f64; 3],
    /// The gap w₃ − w₂, which is small near the separatrix.
    pub gap: f64,
}

/// The cubic with the upright position as origin.
///
/// With y = v − 1 ≤ 0, divided by two, it is y³ + by² + cy − d², with the roots y₁ ≤ y₂ ≤ 0 ≤ y₃.
struct UprightCubic {
    b: f64,
    c: f64,
    d: f64,
    /// The depth 1 − v₀ of the start below the upright position.
    depth: f64,
}

impl NutationCubic {
    /// Creates the cubic from the moment I₁, the weight W and the start (Π, Γ).
    pub(crate) fn new(moment: f64, weight: f64, start: &Se3Dual) -> Self {
        let Covector(Pair(pi, gamma)) = start;
        // Everything is homogeneous: in units of these powers of two |Γ| and I₁W are near 1.
        let vertical = power_of_two(gamma.amax().sqrt());
        let unit = power_of_two(moment.sqrt() * weight.sqrt());
        let [x, y, z] = (gamma / vertical / vertical).into();
        let [p, q, spin] = (pi / unit / vertical).into();
        // The numerators, whose terms may cancel, have twice the digits of an f64.
        let product = TwoFloat::new_mul;
        let strength = product(moment / unit, weight / unit);
        let level = product(x, x) + product(y, y);
        let length = root(level + product(z, z));
        let energy = product(p, p) + product(q, q);
        let along = product(p, x) + product(q, y);
        let acceleration = along * spin - strength * level - energy * z;
        let [scale, size] = [strength * length, length].map(f64::from);
        let rising = f64::from(product(x, q) - product(y, p)) / (size * scale.sqrt());
        let a = f64::from(acceleration) / (scale * size);

        // 1 − v₀ = level/(length (length + z)). The first form loses no digits near the upright position.
        let (above, below) =
            if z > 0.0 { (level, length + z) } else { (length - z, TwoFloat::from(1.0)) };
        let momentum = along * below - above * spin;
        let surplus = energy * below - strength * above * 2.0;
        let under = f64::from(below);
        let upright = UprightCubic {
            b: f64::from((strength * length * 4.0 - product(spin, spin)) * below - surplus)
                / (2.0 * scale * under),
            c: f64::from(momentum * spin - surplus * length) / (scale * size * under),
            d: f64::from(momentum).abs() / (size * under * (2.0 * scale).sqrt()),
            depth: f64::from(above) / (size * under),
        };
        let (roots, gap) = upright.roots(a, rising);
        Self { length: size * vertical * vertical, rising, roots, gap }
    }
}

impl UprightCubic {
    /// Returns w₁, w₂, w₃ and w₃ − w₂, from the third root and the coefficients A and ρ about the start.
    fn roots(&self, a: f64, rising: f64) -> ([f64; 3], f64) {
        let third = self.depth + self.largest_root();
        if a == 0.0 && rising == 0.0 {
            return ([0.0, 0.0, third], third);
        }
        // w₁w₂ = −ρ²/2w₃ ≤ 0, so that w₂ − w₁ is a sum of squares.
        let mean = rising.abs() / (2.0 * third).sqrt();
        let sum = (a + mean * mean) / third;
        let range = sum.hypot(2.0 * mean);
        let (first, second) = if sum > 0.0 {
            let second = 0.5 * (sum + range);
            (-(mean / second) * mean, second)
        } else {
            let first = 0.5 * (sum - range);
            (first, -(mean / first) * mean)
        };
        // In the same way y₂y₃ = −d²/|y₁| ≤ 0.
        let lowest = self.depth - first;
        let mean = self.d / lowest.sqrt();
        let gap = ((self.c + mean * mean) / lowest).hypot(2.0 * mean);
        ([first, second, third], gap)
    }

    /// Returns the largest root y₃, by Newton's iteration from above.
    ///
    /// The iteration decreases monotonically, by a third of the excess or more in each step, until rounding
    /// ends it.
    fn largest_root(&self) -> f64 {
        let Self { b, c, d, .. } = *self;
        if !(b + c + d).is_finite() {
            return f64::NAN;
        }
        // y³ is at most three times the largest of the terms −by², −cy and d².
        let (b_minus, c_minus, d_cbrt) = ((-b).max(0.0), (-c).max(0.0), (2.0 * d).cbrt());
        let mut y = (3.0 * b_minus).max((3.0 * c_minus).sqrt()).max(d_cbrt * d_cbrt);
        while y > 0.0 {
            let next = y * (2.0 * y + b + (d / y) * (d / y)) / (3.0 * y + 2.0 * b + c / y);
            if next >= y || next.is_nan() {
                break;
            }
            y = next;
        }
        y
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn cubic(b: f64, c: f64, d: f64) -> UprightCubic {
        UprightCubic { b, c, d, depth: 0.0 }
    }

    /// y³ = d², y³ + by² = 0 and y³ + cy = 0 have the largest roots d^(2/3), −b and √(−c).
    #[test]
    fn the_search_for_the_largest_root_begins_above_it() {
        for size in [1e-90, 1e-9, 0.1, 1.0, 7.0, 1e9, 1e90] {
            let y = [
                (cubic(0.0, 0.0, size).largest_root(), size.cbrt() * size.cbrt()),
                (cubic(-size, 0.0, 0.0).largest_root(), size),
                (cubic(0.0, -size, 0.0).largest_root(), size.sqrt()),
            ];
            for (y, root) in y {
                // The last step of Newton's iteration has a few roundings.
                assert!((y - root).abs() < 1e-15 * root, "{size:e}: {y:e} {root:e}");
            }
        }
        assert_eq!(cubic(1.0, 2.0, 0.0).largest_root(), 0.0);
        assert!(cubic(f64::NAN, 0.0, 0.0).largest_root().is_nan());
    }

    /// (y − r)((y + m)² + n²) in all ratios of its terms, of which b may have either sign.
    #[test]
    fn largest_roots_of_generic_cubics() {
        for r in [1e-3, 0.3, 2.0, 50.0] {
            for m in [1e-3, 0.2, 3.0, 40.0] {
                for n in [0.0, 0.1, 5.0] {
                    let square = m * m + n * n;
                    let cubic = cubic(2.0 * m - r, square - 2.0 * m * r, (r * square).sqrt());
                    let y = cubic.largest_root();
                    // d, b and c have roundings, and the root follows them by its distance from the others.
                    let condition = (r + m + n) / r;
                    assert!((y - r).abs() < 1e-15 * r * condition * condition, "{r} {m} {n}: {y}");
                }
            }
        }
    }

    /// In units of other powers of 2, in which squares of the moment or of the weight overflow, every bit is the same.
    #[test]
    fn units_change_no_bit() {
        let start = Se3Dual::new(Vector3::new(0.3, -0.2, 0.9), Vector3::new(0.2, 0.1, 0.95));
        let cubic = |unit: f64| NutationCubic::new(1.3 * unit, 0.7 / unit, &start);
        let expected = cubic(1.0);
        for unit in [2.0_f64.powi(-1000), 2.0_f64.powi(-600), 2.0_f64.powi(1000)] {
            let other = cubic(unit);
            assert_eq!((other.roots, other.rising), (expected.roots, expected.rising), "{unit:e}");
        }
        assert!(expected.roots.iter().all(|root| root.is_finite() && *root != 0.0));
    }
}
