//! Units of mass, length and time: no result depends on them.
//!
//! A top with the moments I and the weight moment mgl multiplied by s moves as before, with Π multiplied by s. A
//! vertical Γ of length λ with mgl divided by λ moves as before, too. Where s is a power of two and λ one of four, these
//! factors pass through products, sums and square roots without rounding. A method that compares numbers of one unit
//! only must therefore find the same bits.

use lie_poisson::{Covector, Pair, Se3Dual};
use workspace_tests::scales::{Method, Outcome, methods, scaled};

/// Binary exponents of s and λ. 2¹⁰⁰ = 1.3e30.
const SCALES: [(i32, i32); 5] = [(100, 0), (0, -100), (-27, 0), (100, -100), (-100, 100)];

/// Returns the outcome for the top in units of s and λ, back in units of 1.
fn outcome(method: &Method, symmetric: bool, [s, lambda]: [f64; 2], step: f64) -> Option<Outcome> {
    let (top, mu) = scaled(symmetric, s, lambda).unwrap();
    // A run that blows up ends where its invariants overflow.
    let finite =
        |outcome: &Outcome| outcome.deviations.iter().all(|deviation| deviation.is_finite());
    let outcome = (method.run)(&top, &mu, step, 25).filter(finite)?;
    let Covector(Pair(pi, gamma)) = outcome.last;
    // Where sweeps diverge, the number of sweeps before an overflow depends on where they began.
    let iterations = if step < 0.5 { outcome.iterations } else { 0 };
    Some(Outcome { last: Se3Dual::new(pi / s, gamma / lambda), iterations, ..outcome })
}

#[test]
#[ignore = "long"]
fn every_method_finds_the_same_bits_at_all_scales() {
    let mut found = Vec::new();
    for (symmetric, step) in
        [false, true].into_iter().flat_map(|b| [0.02, 0.25, 0.9].map(|h| (b, h)))
    {
        for method in methods(symmetric).unwrap() {
            let reference = outcome(&method, symmetric, [1.0; 2], step);
            for scales in SCALES.map(|(s, lambda)| [s, lambda].map(|n| 2.0_f64.powi(n))) {
                let there = outcome(&method, symmetric, scales, step);
                if there != reference {
                    found.push(format!("{}, h = {step}, (s, λ) = {scales:?}", method.name));
                }
            }
        }
    }
    assert!(found.is_empty(), "{} depend on units:\n{}", found.len(), found.join("\n"));
}

/// Invariants are conserved as well in decimal units, in which the parameters themselves are rounded, as in units of
/// 1.
#[test]
#[ignore = "long"]
fn structure_is_kept_at_all_scales() {
    for method in methods(false).unwrap() {
        let deviations = |s: f64, lambda: f64| {
            let (top, mu) = scaled(false, s, lambda).unwrap();
            (method.run)(&top, &mu, 0.02, 100).unwrap().deviations
        };
        let reference = deviations(1.0, 1.0);
        for (s, lambda) in [(1e-30, 1.0), (1e-15, 1.0), (1e-8, 1e30), (1e30, 1.0), (1.0, 1e-30)] {
            for (there, here) in deviations(s, lambda).into_iter().zip(reference) {
                // The bound is round-off of 100 steps, or an error of the method.
                assert!(
                    there < 1.01 * here + 1e-13,
                    "{} {s:e} {lambda:e} {there:e} {here:e}",
                    method.name
                );
            }
        }
    }
}
