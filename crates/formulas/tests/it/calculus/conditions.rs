//! Formulas that differ from place to place, where one of them has no value or no slope, and where the condition has none.

use crate::support::{formula, point};
use lie_poisson::DualNumber;

/// Returns the value, the first slope, and the second derivative along the first axis, of a formula at (x, 1, 1, 1, 1, 1).
fn jet(text: &str, x: f64) -> [f64; 3] {
    let (h, z) = (formula(text), point([x, 1.0, 1.0, 1.0, 1.0, 1.0]));
    let v = point([1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    [h.value(&z), h.differential(&z).0.x, h.second_derivative(&z, &v).0.x]
}

/// Returns these three numbers and their largest difference from the exact ones, or ∞ if one is not finite.
fn compared(text: &str, x: f64, exact: [f64; 3]) -> ([f64; 3], f64) {
    let found = jet(text, x);
    let error = found.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    (found, if found.iter().all(|x| x.is_finite()) { error } else { f64::INFINITY })
}

/// The slopes are those of the chosen formula, also where the other has none, and on the seam.
#[test]
fn the_formula_that_is_not_chosen_does_not_count() {
    for (text, x, exact) in [
        ("if(Pi1 > 0, sqrt(Pi1), 0)", -1.0, [0.0; 3]),
        ("if(Pi1 > 0, sqrt(Pi1), 0)", 0.0, [0.0; 3]),
        ("if(Pi1 > 0, sqrt(Pi1), 0)", 4.0, [2.0, 0.25, -0.03125]),
        ("if(Pi1 > 0, Pi1*ln(Pi1), 0)", -1.0, [0.0; 3]),
        ("if(Pi1 > 0, Pi1*ln(Pi1), 0)", 0.0, [0.0; 3]),
        ("if(Pi1 > 0, Pi1*ln(Pi1), 0)", 1.0, [0.0, 1.0, 1.0]),
        ("if(Pi1 > 0, 1/Pi1, 0)", 0.0, [0.0; 3]),
        ("if(Pi1 > 0, 1/Pi1, Pi1^2)", -2.0, [4.0, -4.0, 2.0]),
        ("if(Pi1 > 0, 1/Pi1, Pi1^2)", 2.0, [0.5, -0.25, 0.25]),
        // The other way round, and through further operations.
        ("if(Pi1 <= 0, Pi1^2, 3*ln(2*Pi1)^2)", 0.0, [0.0, 0.0, 2.0]),
        ("Pi2*exp(if(Pi1 > 0, Pi1^1.5/sqrt(Pi1), Pi1))", 0.0, [1.0, 1.0, 1.0]),
        ("2*if(Pi1 > 1, hypot(Pi1, 0)*arccos(Pi1), Pi1^3)", 1.0, [2.0, 6.0, 12.0]),
        // What two formulas share counts where one of them is chosen.
        ("if(Pi1 > 0, sqrt(Pi1), 0) + if(Pi1 > 1, 2*sqrt(Pi1), 3)", 0.0, [3.0, 0.0, 0.0]),
        ("if(Pi1 > 0, sqrt(Pi1), 0) + if(Pi1 > 1, 2*sqrt(Pi1), 3)", 0.25, [3.5, 1.0, -2.0]),
        ("if(Pi1 > 0, sqrt(Pi1), 0) + if(Pi1 > 1, 2*sqrt(Pi1), 3)", 4.0, [6.0, 0.75, -0.09375]),
        ("if(Pi1 > 0, sqrt(Pi1), 2*sqrt(Pi1 + 4))", -3.0, [2.0, 1.0, -0.5]),
        ("if(Pi1 >= 4, sqrt(Pi1), 2*sqrt(Pi1))", 4.0, [2.0, 0.25, -0.03125]),
        ("if(Pi1 > 4, sqrt(Pi1), 2*sqrt(Pi1))", 4.0, [4.0, 0.5, -0.0625]),
        // One within another.
        ("if(Pi1 > 0, if(Pi1 > 1, ln(Pi1 - 1), sqrt(Pi1)), Pi1^2)", -1.0, [1.0, -2.0, 2.0]),
        ("if(Pi1 > 0, if(Pi1 > 1, ln(Pi1 - 1), sqrt(Pi1)), Pi1^2)", 0.0, [0.0, 0.0, 2.0]),
        ("if(Pi1 > 0, if(Pi1 > 1, ln(Pi1 - 1), sqrt(Pi1)), Pi1^2)", 1.0, [1.0, 0.5, -0.25]),
        ("if(Pi1 > 0, if(Pi1 > 1, ln(Pi1 - 1), sqrt(Pi1)), Pi1^2)", 2.0, [0.0, 1.0, -1.0]),
        // The slope of a condition does not count.
        ("if(sqrt(Pi1) + ln(1 + Pi1) >= 0, Pi1, 2)", 0.0, [0.0, 1.0, 0.0]),
        ("|if(Pi1 > 0, sqrt(Pi1)*Pi, 2*Gamma)|^2", 0.0, [12.0, 0.0, 0.0]),
    ] {
        let (found, error) = compared(text, x, exact);
        assert!(error < 1e-14, "{text} at {x}: {found:?}, not {exact:?}");
    }
    // Control: where a formula without a slope is chosen, there is none.
    assert!(jet("if(Pi1 >= 0, sqrt(Pi1), 0)", 0.0)[1].is_infinite());
    assert!(jet("if(Pi1 >= 0, sqrt(Pi1), 0) + if(Pi1 > 1, sqrt(Pi1), 0)", 0.0)[1].is_infinite());
    assert!(jet("cbrt(Pi1)", 0.0)[1].is_infinite());
    assert_eq!(jet("if(Pi1 > 0, cbrt(Pi1), 0)", 0.0), [0.0; 3]);
}

/// Many conditions on one coordinate, side by side and within each other.
#[test]
fn many_conditions() {
    let close = |text: &str, x: f64, exact: [f64; 3]| {
        let (found, error) = compared(text, x, exact);
        assert!(error < 1e-13, "at {x}: {found:?}, not {exact:?}");
    };
    // Σ_k max(x − k, 0)²
    let ramp = |k| format!("if(Pi1 > {k}, (Pi1 - {k})^1.5*sqrt(Pi1 - {k}), 0)");
    let ramps: Vec<String> = (0..100).map(ramp).collect();
    close(&ramps.join(" + "), 3.0, [14.0, 12.0, 6.0]);
    // √(x − k) with the largest k < x
    let mut nested = "Pi1^2".to_owned();
    for k in 1..60 {
        nested = format!("if(Pi1 > {k}, sqrt(Pi1 - {k}), {nested})");
    }
    for k in 1..60 {
        close(&nested, f64::from(k) + 0.25, [0.5, 1.0, -2.0]);
    }
    close(&nested, 1.0, [1.0, 2.0, 2.0]);
    close(&nested, -3.0, [9.0, -6.0, 2.0]);
}

/// A condition that is not a number decides nothing, whichever way it is written.
#[test]
fn a_condition_without_a_value_has_no_formula() {
    for sign in [">", ">=", "<", "<="] {
        for text in [
            format!("if(ln(Pi1) {sign} 0, 1, 2)"),
            format!("if(0 {sign} ln(Pi1), Pi1, 2)"),
            format!("if(ln(Pi1) {sign} 0, 1, 1)"),
            format!("if(1/(Pi1 + 1) {sign} 2/(Pi1 + 1), 1, 2)"),
        ] {
            let h = formula(&text);
            let z = [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
            assert!(h.value(&point(z)).is_nan(), "{text}");
            let dual = h.value(&point(z.map(DualNumber::variable)));
            assert!(dual.value_without_derivative().is_nan() && dual.derivative().is_nan());
            assert!(h.checked_value(&z).is_err(), "{text}");
            // Control: elsewhere it has a value.
            assert!(h.checked_value(&[2.0, 0.0, 0.0, 0.0, 0.0, 0.0]).is_ok(), "{text}");
        }
    }
    assert!(jet("if(ln(Pi1) > 0, Pi1, 2)", -1.0).iter().take(2).all(|x| x.is_nan()));
    // An infinite condition holds or does not.
    assert_eq!(jet("if(1/Pi1 > 2, 3*Pi1, Pi1)", 0.0), [0.0, 3.0, 0.0]);
}

/// √(x² + y²) where the squares are out of range, with its slopes.
#[test]
fn hypotenuses_of_all_sizes() {
    let at = |text: &str, x: f64, y: f64| {
        let (h, z) = (formula(text), point([x, y, 0.0, 0.0, 0.0, 0.0]));
        let slope = h.differential(&z).0;
        let v = point([0.8 * x, 0.6 * y, 0.0, 0.0, 0.0, 0.0]);
        [h.value(&z), slope.x, slope.y, h.second_derivative(&z, &v).0.x]
    };
    for size in [1e-300, 1e-170, 1e-150, 1e-20, 1.0, 1e20, 1e150, 1e200, 1e307] {
        let found = at("hypot(Pi1, Pi2)", 3.0 * size, -4.0 * size);
        // D²h·v = (y², −xy; −xy, x²)v/h³
        let exact = [5.0 * size, 0.6, -0.8, 48.0 * (0.8 - 0.6) / 125.0];
        for (found, exact) in found.iter().zip(exact) {
            assert!((found / exact - 1.0).abs() < 1e-14, "{size:e}: {found:e} {exact:e}");
        }
    }
    assert_eq!(at("hypot(Pi1, Pi2)", 1e-170, 0.0)[..3], [1e-170, 1.0, 0.0]);
    assert_eq!(at("hypot(Pi1, 0)", -1e200, 0.0)[..2], [1e200, -1.0]);
    assert_eq!(at("hypot(1e200, 0) + Pi1", 0.0, 0.0)[0], 1e200);
    // Control: the root of the squares has no such range.
    assert_eq!(at("sqrt(Pi1^2 + Pi2^2)", 1e-170, 0.0)[0], 0.0);
    // The square is smooth, and the length itself has no slope at 0.
    assert_eq!(at("hypot(Pi1, Pi2)^2", 0.0, 0.0)[..3], [0.0; 3]);
    assert_eq!(at("hypot(Pi1, Pi2)^1.5", 0.0, 0.0)[..3], [0.0; 3]);
    assert!(at("hypot(Pi1, Pi2)", 0.0, 0.0)[1].is_nan());
}
