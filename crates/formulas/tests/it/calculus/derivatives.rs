//! Differentials and second derivatives against dual numbers, and against difference quotients.

use crate::support::{FORMULAS, POINTS, formula, point};
use lie_poisson::{
    DualNumber, Hamiltonian, LiePoisson, Se3, Se3Dual, So3, State, Vector, differential,
    hessian_by_dual_numbers,
};
use lie_poisson_formulas::{Formula, FormulaHamiltonian, Problem};

/// The relative error of a few dozen operations, some of which lose a digit.
const TOLERANCE: f64 = 1e-12;

/// Returns the largest difference of coordinates, relative to the largest coordinate or to 1 if all are smaller.
fn difference<V: Vector<Scalar = f64>>(a: &V, b: &V) -> f64 {
    let size = b.max_abs();
    (*a - *b).max_abs() / if size > 0.0 { size } else { 1.0 }
}

/// The differential by dual numbers runs the instructions of the value, which do not know the rules of the gradient.
fn by_dual_numbers(h: &Formula, z: &Se3Dual) -> <Se3Dual as Vector>::Dual {
    differential(|w: &Se3Dual<DualNumber>| h.value(w), z)
}

#[test]
fn gradients_are_those_of_dual_numbers() {
    for text in FORMULAS {
        let h = formula(text);
        for z in POINTS.iter().map(|x| point(*x)) {
            let error = difference(&h.differential(&z), &by_dual_numbers(&h, &z));
            assert!(error < TOLERANCE, "{text} at {z:?}: {error:e}");
        }
    }
    // Negative control: the gradient of another formula differs.
    let (h, other, z) = (formula("Pi1^3"), formula("Pi1^3*1.0001"), point(POINTS[1]));
    assert!(difference(&h.differential(&z), &by_dual_numbers(&other, &z)) > 1e-5);
}

#[test]
fn second_derivatives_are_those_of_dual_numbers() {
    for text in FORMULAS {
        let h = FormulaHamiltonian::<Se3>::of(&formula(text)).unwrap();
        for z in POINTS.iter().map(|x| point(*x)) {
            for v in [[1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.3, -0.7, 1.1, 0.2, -0.4, 0.9]].map(point) {
                let exact = hessian_by_dual_numbers::<LiePoisson<Se3>, f64, _>(&h, &z, &v);
                let error = difference(&h.hessian(&z, &v).unwrap(), &exact);
                assert!(error < 100.0 * TOLERANCE, "{text} at {z:?} along {v:?}: {error:e}");
            }
        }
    }
}

/// The Hamiltonian of a formula has its text, and the algebra has its dimension.
#[test]
fn hamiltonians_are_compared_and_shown_by_their_formulas() {
    let h = FormulaHamiltonian::<Se3>::of(&formula("½*Pi1^2 + Gamma3")).unwrap();
    assert_eq!(h.to_string(), "0.5*Pi1^2 + Gamma3");
    assert_eq!(format!("{h:?}"), "FormulaHamiltonian(\"0.5*Pi1^2 + Gamma3\")");
    assert_eq!(format!("{:?}", h.formula()), "Formula(\"0.5*Pi1^2 + Gamma3\")");
    assert!(h.clone() == h && *h.formula() == formula("½*Pi1^2 + Gamma3"));
    assert!(h != FormulaHamiltonian::<Se3>::of(&formula("Gamma3 + ½*Pi1^2")).unwrap());
    assert_eq!(h.formula().dimension(), 6);
    let refused = FormulaHamiltonian::<So3>::of(h.formula()).unwrap_err();
    assert_eq!(*refused.problem(), Problem::WrongDimension { formula: 6, space: 3 });
}

/// The symmetric quotient with the step s has the error s²h‴/6 + ε|h|/s, near 1e-10 for s = 1e-5 and h of order 1.
#[test]
fn gradients_are_limits_of_quotients() {
    for text in FORMULAS {
        let h = formula(text);
        for x in &POINTS[..2] {
            let gradient = h.differential(&point(*x));
            for i in 0..6 {
                let at = |step: f64| {
                    let mut moved = *x;
                    moved[i] += step;
                    h.value(&point(moved))
                };
                let quotient = (at(1e-5) - at(-1e-5)) / 2e-5;
                let error = (quotient - gradient.coordinate(i)).abs();
                assert!(
                    error < 1e-7 * (1.0 + quotient.abs() + h.value(&point(*x)).abs()),
                    "{text} {i} {error:e}"
                );
            }
        }
    }
}

/// Homogeneous formulas at points of sizes 1e±30: dh(s z) = s^(n−1) dh(z), with the same relative accuracy.
#[test]
fn units_do_not_matter() {
    for (text, degree) in [
        ("0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + Pi·Gamma×c", 2),
        ("Pi1*Gamma2*Pi3 + Pi2^3 - |Pi|^2*Gamma3", 3),
        ("|Pi| + sqrt(Pi1*Gamma1) + Pi1^2/Gamma2", 1),
        ("Pi1^2.5/Pi2^1.5 + Pi3*tanh(Pi1/Pi2)", 1),
        ("atan2(Pi1, Gamma1) + ln(Pi1/Gamma2)", 0),
        ("1/|Gamma|^3 + Pi1/Gamma1^4", -3),
    ] {
        let h = formula(text);
        for x in [POINTS[1], POINTS[2]] {
            let exact = by_dual_numbers(&h, &point(x));
            for scale in [1e-30, 1e-10, 1e10, 1e30_f64] {
                let scaled = h.differential(&point(x.map(|x| x * scale)));
                let back = scaled.scaled(scale.powi(1 - degree));
                let error = difference(&back, &exact);
                // exp(c ln x) loses as many units as ln x has: 70 for 1e30.
                assert!(error < 100.0 * TOLERANCE, "{text} at {scale:e}: {error:e}");
            }
        }
    }
}

/// |x| has slopes ±1, and 1 at 0; √x and |v| have none at 0, as in the same Rust code.
#[test]
fn slopes_at_corners() {
    let slope =
        |text: &str, x: f64| formula(text).differential(&point([x, 0.0, 0.0, 0.0, 0.0, 0.0])).0.x;
    assert_eq!([-2.0, 0.0, 2.0].map(|x| slope("|Pi1|", x)), [-1.0, 1.0, 1.0]);
    assert!(slope("sqrt(Pi1)", 0.0).is_infinite() && slope("|Pi|", 0.0).is_nan());
    assert_eq!(slope("|Pi|^2", 0.0), 0.0);
    assert_eq!(slope("|Pi|^3", 0.0), 0.0);
    assert_eq!(slope("Pi1^1.5", 0.0), 0.0);
    // |v|^p has the value and the slope 0 for p > 1, also in other words; its second derivative along v is no NaN.
    for text in [
        "|Pi|^1.5",
        "|Pi|^1.01 + 2*|Pi|^1.9",
        "(Pi1^2 + Pi2^2)^0.75",
        "sqrt(|Pi|^4)",
        "sqrt((Pi·Pi)^1.5)",
        "(|Pi|^2*|Gamma|^2 + Pi1^4)^0.6",
    ] {
        let (h, zero) = (formula(text), point([0.0; 6]));
        assert_eq!(h.value(&zero), 0.0, "{text}");
        assert_eq!(h.differential(&zero).max_abs(), 0.0, "{text}");
        assert!(!h.second_derivative(&zero, &zero).max_abs().is_nan(), "{text}");
        // Beside 0 the slope is that of dual numbers.
        let z = point([1e-9, 2e-9, 0.0, 1.0, 2.0, 3.0]);
        let error = difference(&h.differential(&z), &by_dual_numbers(&h, &z));
        assert!(error < TOLERANCE, "{text}: {error:e}");
    }
    assert_eq!(slope("abs(Pi1)^1.2", 0.0), 0.0);
    // On a seam the slope is that of the chosen formula.
    let seam = |text: &str| slope(text, 1.0);
    assert_eq!(seam("if(Pi1 >= 1, 2*Pi1, 3*Pi1 - 1)"), 2.0);
    assert_eq!(seam("if(Pi1 > 1, 2*Pi1, 3*Pi1 - 1)"), 3.0);
    // The other formula may have no value.
    assert_eq!(slope("if(Pi1 >= 1, ln(Pi1 - 1), Pi1^2)", 0.5), 1.0);
    // |−0| is 0 with the sign of 0.
    assert_eq!(formula("|Pi1|").value(&point([-0.0; 6])).to_bits(), 0);
    // the slope 4 exp(−2x) of tanh x where tanh x rounds to 1
    let exact = 4.0 * (-60.0_f64).exp();
    assert!((slope("tanh(Pi1)", 30.0) - exact).abs() < 1e-14 * exact);
}
