//! Compensated summation in exact arithmetic: which rounding errors it keeps.

use collective_integrators::*;
use lie_poisson::Pair;
use nalgebra::{Vector1, Vector2};

/// The sum z + e of a number and its carry.
type Sum = Pair<Vector1<f64>, Vector1<f64>>;

/// Returns a number of size below 2¹⁷ in units of 2⁻¹¹⁰, without rounding if it is a multiple of 2⁻¹¹⁰.
fn fixed(x: f64) -> i128 {
    (x * 110.0_f64.exp2()) as i128
}

/// Returns (z, e) as a fixed-point number.
fn whole(pair: &Sum) -> i128 {
    fixed(pair.0.x) + fixed(pair.1.x)
}

/// Returns numbers in (½, 1) with 53 significant bits.
fn mantissas() -> impl Iterator<Item = f64> {
    let mut seed = 7_u64;
    core::iter::repeat_with(move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        0.5 + (seed >> 12) as f64 * (-53.0_f64).exp2()
    })
}

/// Each addition is exact but for rounding errors of e, which is smaller than z by 2⁵³.
#[test]
fn a_compensated_sum_loses_only_roundings_of_the_carry() {
    const TERMS: usize = 1000;
    let error = |sum: fn(&Sum, &Sum) -> Sum| {
        let start = Pair(Vector1::new(1.0), Vector1::new(0.0));
        let (mut compensated, mut exact) = (start, whole(&start));
        for m in mantissas().take(TERMS) {
            // δz has some 2⁻¹⁰ of the size of z, and δe the size of the rounding errors of δz.
            let increment =
                Pair(Vector1::new(m / 512.0), Vector1::new((m - 0.7) / 512.0 * f64::EPSILON));
            compensated = sum(&compensated, &increment);
            exact += whole(&increment);
        }
        (whole(&compensated) - exact).unsigned_abs() as f64 / 110.0_f64.exp2()
    };
    // |e| ≤ ε, so that each of two additions to it has an error of ε²/4 at most; and δe is cut off at 2⁻¹¹⁰.
    let bound = TERMS as f64 * (0.5 * f64::EPSILON.powi(2) + (-110.0_f64).exp2());
    let compensated = error(compensated_sum);
    assert!(compensated < bound, "{compensated:e}, {bound:e}");
    // Control: the rounding error of the addition of e to δz must not be lost.
    let without = error(|sum, increment| {
        let change = increment.0 + sum.1;
        let next = sum.0 + change;
        Pair(next, (change - (next - sum.0)) + increment.1)
    });
    assert!(without > 1e3 * bound, "{without:e}, {bound:e}");
}

/// Returns ẋ = y, ẏ = −x, evaluated without rounding.
fn oscillator(z: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(z.y, -z.x)
}

/// Tests that refined increments satisfy the stage equation far beyond the rounding error of the stage.
///
/// With a step of a power of two the midpoint rule gives k + δk from δz + δe without rounding. Then k + δk = X(z +
/// ½h(k + δk)) should hold.
#[test]
fn refined_increments_belong_to_stages_without_rounding() {
    const SHIFT: i32 = 6;
    let step = f64::from(-SHIFT).exp2();
    let midpoint = RungeKutta::implicit_midpoint();
    let mut largest = [0.0_f64; 2];
    let numbers: Vec<f64> = mantissas().take(64).collect();
    for pair in numbers.chunks(2) {
        let z = Vector2::new(pair[0], -pair[1]);
        let mut workspace = midpoint.workspace();
        let increment =
            midpoint.refined_increment(&from_fn(oscillator), &z, step, &mut workspace).unwrap();
        let Pair(change, rest) = increment.point;
        let k = [change.x, change.y, rest.x, rest.y].map(|x| fixed(x) << SHIFT);
        for (defect, rest) in largest.iter_mut().zip([1, 0]) {
            let k = [k[0] + rest * k[2], k[1] + rest * k[3]];
            let middle = |z: f64, k: i128| fixed(z) + (k >> (SHIFT + 1));
            let residual = [k[0] - middle(z.y, k[1]), k[1] + middle(z.x, k[0])];
            for r in residual {
                *defect = defect.max(r.unsigned_abs() as f64 / 110.0_f64.exp2());
            }
        }
    }
    // Three sweeps leave (½h)³ = 5e-7 of a rounding error; the computed difference adds 1e-8.
    let [refined, rounded] = largest;
    assert!(refined < 1e-6 * f64::EPSILON, "{refined:e}");
    // Control: without refinement half a rounding error of the stage remains.
    assert!(rounded > 0.2 * f64::EPSILON, "{rounded:e}");
}
