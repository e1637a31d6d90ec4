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

/// Returns α d − β h J (2u + d) − γ h² d for h = 2⁻⁶ and J (x, y) = (y, −x).
///
/// A step from u to u + d for ż = J z makes it zero: with (2, 1, 0) that of the midpoint rule, and with (12, 6, 1) that of
/// Gauss's method with two stages.
fn residual([alpha, beta, gamma]: [i128; 3], u: [i128; 2], d: [i128; 2]) -> [i128; 2] {
    let middle = [0, 1].map(|i| 2 * u[i] + d[i]);
    let turned = [middle[1], -middle[0]];
    [0, 1].map(|i| alpha * d[i] - ((beta * turned[i]) >> 6) - ((gamma * d[i]) >> 12))
}

/// Tests that refined increments satisfy the equation of a step far beyond the rounding errors of the stages, of the sums
/// over them, and of the point from which the step starts.
#[test]
fn refined_increments_have_more_digits_than_their_stages() {
    let schemes =
        [(RungeKutta::implicit_midpoint(), [2, 1, 0]), (RungeKutta::gauss(2).unwrap(), [12, 6, 1])];
    let numbers: Vec<f64> = mantissas().take(256).collect();
    for (scheme, equation) in schemes {
        let mut largest = [0.0_f64; 3];
        for numbers in numbers.chunks(4) {
            let z = Vector2::new(numbers[0], -numbers[1]);
            let e = Vector2::new(numbers[2] - 0.75, numbers[3] - 0.75) * f64::EPSILON;
            let (field, mut workspace) = (from_fn(oscillator), scheme.workspace());
            let made = scheme.refined_increment(&field, (&z, &e), 1.0 / 64.0, &mut workspace);
            let Pair(change, rest) = made.unwrap().point;
            for (defect, (e, rest)) in
                largest.iter_mut().zip([(e, rest), (e, 0.0 * rest), (0.0 * e, rest)])
            {
                let u = [0, 1].map(|i| fixed(z[i]) + fixed(e[i]));
                let d = [0, 1].map(|i| fixed(change[i]) + fixed(rest[i]));
                for r in residual(equation, u, d) {
                    let size = r.unsigned_abs() as f64 / equation[0] as f64;
                    *defect = defect.max(size / 110.0_f64.exp2());
                }
            }
        }
        // In units of the rounding error hε/2 of h k, where |k| < 1: three sweeps leave (½h)³ = 5e-7 of it, and the
        // computed difference adds 1e-8.
        let [refined, rounded, from_z] = largest.map(|defect| defect / (f64::EPSILON / 128.0));
        assert!(refined < 1e-6, "{refined:e}");
        // Controls: without δe a rounding error remains, and without e that of a start.
        assert!(rounded > 0.2, "{rounded:e}");
        assert!(from_z > 0.2, "{from_z:e}");
    }
}

/// A step forwards, one backwards and one forwards are one step. They are so far beyond the rounding error of the points
/// between them, which a composition carries along.
#[test]
fn compositions_carry_rounding_errors_from_substep_to_substep() {
    let (base, step) = (RungeKutta::implicit_midpoint(), 1.0 / 64.0);
    let there_and_back = Composition::new(base.clone(), Substeps::new(&[1.0, -1.0, 1.0]).unwrap());
    let numbers: Vec<f64> = mantissas().take(256).collect();
    let mut largest = [0.0_f64; 2];
    for numbers in numbers.chunks(4) {
        let z = Vector2::new(numbers[0], -numbers[1]);
        let e = Vector2::new(numbers[2] - 0.75, numbers[3] - 0.75) * f64::EPSILON;
        let (field, mut workspace) = (from_fn(oscillator), base.workspace());
        let mut increment = |from: (&Vector2<f64>, &Vector2<f64>), step| {
            base.refined_increment(&field, from, step, &mut workspace).unwrap().point
        };
        let once = increment((&z, &e), step);
        // Control: from the points without their rounding errors.
        let zero = Vector2::zeros();
        let back = increment((&(z + once.0), &zero), -step);
        let again = increment((&(z + once.0 + back.0), &zero), step);
        let without = once + back + again;
        let made = there_and_back.refined_increment(
            &field,
            (&z, &e),
            step,
            &mut there_and_back.workspace(),
        );
        for (largest, found) in largest.iter_mut().zip([made.unwrap().point, without]) {
            for i in 0..2 {
                let apart =
                    fixed(found.0[i]) + fixed(found.1[i]) - fixed(once.0[i]) - fixed(once.1[i]);
                *largest = largest.max(apart.unsigned_abs() as f64 / 110.0_f64.exp2());
            }
        }
    }
    // In units of the rounding error hε/2 of an increment, as above.
    let [found, without] = largest.map(|apart| apart / (f64::EPSILON / 128.0));
    assert!(found < 1e-5, "{found:e}");
    assert!(without > 0.2, "{without:e}");
}
