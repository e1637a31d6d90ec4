//! What formulas mean, and how they are printed.

use crate::support::{formula, heavy_top, point};
use lie_poisson::Covector;
use lie_poisson_formulas::{Coordinates, Formula, NameError, Parameters, Vocabulary};
use nalgebra::Vector2;

/// Returns the value of a formula of (x, y) at (3, 4).
fn value(text: &str) -> f64 {
    let coordinates = Coordinates::scalars(["x", "y"]).unwrap();
    let names = Vocabulary::new(&coordinates, &Parameters::new()).unwrap();
    let formula =
        Formula::new(text, &names).unwrap_or_else(|error| panic!("{}", error.quoted(text)));
    formula.value(&Covector(Vector2::new(3.0, 4.0)))
}

/// Returns whether two numbers differ by the rounding of a few operations.
fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 8.0 * f64::EPSILON * b.abs()
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, exact) in [
        ("1 + 2*3", 7.0),
        ("2 - 3 - 4", -5.0),
        ("24/4/2", 3.0),
        ("24/(4/2)", 12.0),
        ("-x^2", -9.0),
        ("(x - y)^3", -1.0),
        ("(x - y)^4", 1.0),
        ("(3 - 5)^3", -8.0),
        ("(-2)^-2", 0.25),
        ("(-x)^2", 9.0),
        ("2^3^2", 512.0),
        ("(2^3)^2", 64.0),
        ("2^-1", 0.5),
        ("2**3", 8.0),
        ("2^-x^2", 2.0_f64.powi(-9)),
        ("-2^2*3", -12.0),
        ("--x", 3.0),
        ("+x - +y", -1.0),
        ("x - -y", 7.0),
        ("6/2*x", 9.0),
        ("x² + y³", 73.0),
        ("x⁻²", 1.0 / 9.0),
        ("2^x²", 512.0),
        ("√y²", 4.0),
        ("√(x² + y²)", 5.0),
        ("√√16", 2.0),
        ("½*x", 1.5),
        (".5*x + 1.*y + 2e1", 25.5),
        ("|x - y|", 1.0),
        ("||x| - |y||*2", 2.0),
        ("x÷y − 1", -0.25),
        ("1e-3*x", 3e-3),
        ("⅓*x + ⅔*x", 3.0),
        ("¼*y + ¾*y", 4.0),
        ("⅙*x + ⅛*y", 1.0),
        ("x⁰ + x⁵ − 10", 234.0),
        ("x⁶ + x⁷", 2916.0),
        ("x⁸ + x⁹", 26_244.0),
        ("y^1 + x¹", 7.0),
    ] {
        assert!(near(value(text), exact), "{text}: {} {exact}", value(text));
    }
}

#[test]
fn functions_have_their_values() {
    let (x, y) = (3.0_f64, 4.0_f64);
    for (text, exact) in [
        ("sqrt(x)", x.sqrt()),
        ("exp(x)", x.exp()),
        ("ln(x)", x.ln()),
        ("log(x)", x.ln()),
        ("sin(x)", x.sin()),
        ("cos(x)", x.cos()),
        ("tan(x)", x.tan()),
        ("tanh(x)", x.tanh()),
        ("sinh(x)", x.sinh()),
        ("cosh(x)", x.cosh()),
        ("sinh(x/1e9)", 3e-9),
        ("atan2(y, x)", y.atan2(x)),
        ("arcsin(x/5)", 0.6_f64.asin()),
        ("asin(-x/x)", -core::f64::consts::FRAC_PI_2),
        ("arccos(x/5)", 0.6_f64.acos()),
        ("acos(x/x - 2)", core::f64::consts::PI),
        ("arctan(-y)", (-y).atan()),
        ("atan(x)", x.atan()),
        ("log10(x*1e20)", 3e20_f64.log10()),
        ("cbrt(x)", x.cbrt()),
        ("cbrt(-1e300*y)", (-4e300_f64).cbrt()),
        ("cbrt(x - 3)", 0.0),
        ("hypot(x, y)", 5.0),
        ("if(x >= 3, y, ln(x - 4))", y),
        ("if(x > 3, 1/(x - 3), y)", y),
        ("if(x <= 3, y, 0)", y),
        ("if(x < 3, 0, y)", y),
        ("if(y ≥ x, if(0 < x, 7, 8), 9)", 7.0),
        ("if(-x ≤ 0, 1, 2) + if(0 > x, 10, 20)", 21.0),
        ("(2 - x)^3000000000", 1.0),
        ("(2 - x)^3000000001", -1.0),
        ("(-1)^3000000000", 1.0),
        ("abs(x - y)", 1.0),
        ("sin(pi/2)", 1.0),
        ("x^2.5", x.powf(2.5)),
        ("x^-0.5", x.powf(-0.5)),
        ("x^-1.5", x.powf(-1.5)),
        ("x^0.3", x.powf(0.3)),
        ("x^y", x.powf(y)),
        ("x^100", x.powi(100)),
        ("x^0", 1.0),
        // A power of a constant is a number.
        ("x*2^0.3", x * 2.0_f64.powf(0.3)),
        ("x*0.3^-1.7", x * 0.3_f64.powf(-1.7)),
    ] {
        // exp(c ln x) and the power by repeated squares differ from `powf` by up to c units of rounding.
        let error = (value(text) - exact).abs();
        assert!(error <= 100.0 * f64::EPSILON * exact.abs(), "{text}: {} {exact}", value(text));
    }
}

#[test]
fn vectors_have_products_lengths_and_components() {
    let z = point([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    for (text, exact) in [
        ("Pi·Gamma", 32.0),
        ("dot(Pi, Gamma)", 32.0),
        ("(Pi×Gamma)[1]", -3.0),
        ("cross(Pi, Gamma)[2]", 6.0),
        ("Pi·Pi×Gamma", 0.0),
        ("c·Pi×Gamma", 0.6 * -3.0 + 0.8 * -3.0),
        ("|Pi|^2", 14.0),
        ("norm(Pi - Gamma)", 27.0_f64.sqrt()),
        ("Π₁ + Π₂*Γ₃", 13.0),
        ("Gamma[3] - Gamma3", 0.0),
        ("(2*Pi - Pi/2 + Gamma)[1]", 5.5),
        ("-Pi·c", -3.0),
        ("I[2]*k", -0.75),
        ("mgl*c·Gamma", 1.5 * (2.4 + 4.8)),
    ] {
        let found = formula(text).value(&z);
        assert!((found - exact).abs() <= 1e-14, "{text}: {found} {exact}");
    }
}

#[test]
fn what_is_printed_is_what_was_read() {
    for (text, printed) in [
        ("½*(Π₁²/I₁)", "0.5*(Pi1^2/I1)"),
        ("if(Pi1 > 0, 1, Pi2)", "if(Pi1 > 0, 1, Pi2)"),
        ("if(Π₁ ≤ Π₂, asin(k), 2)", "if(Pi1 <= Pi2, arcsin(k), 2)"),
        ("if(Pi1 + 1 < Pi2 - 2, |Pi|, 2)", "if(Pi1 + 1 < Pi2 - 2, |Pi|, 2)"),
        ("((Pi1)) + (Pi2*Pi3)", "Pi1 + Pi2*Pi3"),
        ("Pi1 - (Pi2 - Pi3)", "Pi1 - (Pi2 - Pi3)"),
        ("(Pi1 - Pi2) - Pi3", "Pi1 - Pi2 - Pi3"),
        ("(2^3)^2", "(2^3)^2"),
        ("-(Pi1^2)", "-Pi1^2"),
        ("(-Pi1)**2", "(-Pi1)^2"),
        ("Pi1/(Pi2*Pi3)", "Pi1/(Pi2*Pi3)"),
        ("dot(Pi, cross(c, Gamma))", "Pi·c×Gamma"),
        ("√(log(Pi1))", "sqrt(ln(Pi1))"),
        ("norm(Pi)*abs(Pi1)", "|Pi|*|Pi1|"),
        ("1e300*Pi1 + 1e-300 + 12345678", "1e300*Pi1 + 1e-300 + 12345678"),
        ("(Pi×Gamma)[2]", "(Pi×Gamma)[2]"),
        ("Pi1^(-2)", "Pi1^-2"),
    ] {
        let once = formula(text);
        assert_eq!(once.to_string(), printed, "{text}");
        assert_eq!(formula(printed), once, "{text}");
    }
    // Negative control: other formulas, names and parameters are not equal.
    assert_ne!(formula("Pi1 - Pi2 - Pi3"), formula("Pi1 - (Pi2 - Pi3)"));
    let others = Vocabulary::new(heavy_top().coordinates(), &Parameters::new()).unwrap();
    assert_ne!(Formula::new("Pi1", &others).unwrap(), formula("Pi1"));
}

#[test]
fn zero_times_what_may_be_infinite_is_kept() {
    // 0·x is 0 for polynomials, but not for 1/x and √x.
    let (zero, one) = (point([0.0; 6]), point([1.0; 6]));
    for (text, singular) in [
        ("0*Pi1", false),
        ("0/Pi1", true),
        ("0*ln(Pi1)", true),
        ("Pi1/Pi1", true),
        ("0*Pi1^3", false),
        ("0*Pi1^-1", true),
        ("0*(Pi1/2)", false),
        ("0*(1/Pi1 + Pi2)", true),
    ] {
        let value = formula(text).value(&zero);
        assert_eq!(value.is_nan(), singular, "{text}");
        assert!(formula(text).value(&one).is_finite(), "{text}");
    }
    assert!(formula("ln(Pi1) - ln(Pi1)").value(&zero).is_nan());
}

/// The square of √x is x where x cannot be negative, and not a number elsewhere.
#[test]
fn squares_of_roots_are_kept_where_the_root_may_be_none() {
    let negative = point([-1.0; 6]);
    for (square, possible) in [
        ("Pi1*exp(Pi2)", false),
        ("exp(Pi2)*Pi1", false),
        ("Pi1 + exp(Pi2)", false),
        ("Pi1/exp(Pi2)", false),
        ("exp(Pi2)/Pi1", false),
        ("Pi1^3", false),
        ("Pi1*Pi1", true),
        ("exp(Pi1)*exp(Pi2)", true),
        ("cosh(Pi1)/exp(Pi2)", true),
        ("Pi1^2*exp(Pi2)", true),
        ("abs(Pi1) + Pi2^4", true),
    ] {
        for text in [format!("sqrt({square})*sqrt({square})"), format!("sqrt({square})^2")] {
            let value = formula(&text).value(&negative);
            assert_eq!(value.is_nan(), !possible, "{text}: {value}");
            let exact = formula(square).value(&negative);
            assert!(!possible || near(value, exact), "{text}: {value} {exact}");
        }
    }
}

#[test]
fn constants_are_not_multiplied_out_of_range() {
    let large = point([1e200; 6]);
    // (1e-200 Π₁)(1e-200 Π₂) is 1; a product of the constants would be 0.
    for text in ["1e-200*Pi1*1e-200*Pi2", "(1e-200*Pi1)*(1e-200*Pi2)", "Pi1/1e200*(Pi2/1e200)"] {
        assert!(near(formula(text).value(&large), 1.0), "{text}");
    }
    // Quotients and powers below the normal numbers, whose reciprocals are none.
    assert_eq!(value("(x - x + 1e-200)/1e120"), 1e-320);
    assert_eq!(value("1e-200/1e120*x"), 1e-320 * 3.0);
    assert_eq!(value("x/1.6e308"), 3.0 / 1.6e308);
    assert_eq!(value("1e-110^3 + x"), 3.0);
    assert_eq!(formula("Pi1*1e-300*1e-300*1e300").value(&point([1.0; 6])), 1e-300);
}

#[test]
fn names_are_checked() {
    let repeated = |name: &str| Some(NameError::Repeated { name: name.to_owned() });
    let pi = || Coordinates::new().vector("Pi", 3).unwrap();
    assert_eq!(pi().scalar("Π₂").err(), repeated("Pi2"));
    assert_eq!(Coordinates::new().scalar("Pi2").unwrap().vector("Pi", 3).err(), repeated("Pi2"));
    assert!(matches!(pi().scalar("sqrt"), Err(NameError::Reserved { .. })));
    assert!(matches!(pi().scalar("2x"), Err(NameError::NotAName { .. })));
    assert!(matches!(pi().vector("v", 0), Err(NameError::Dimension { .. })));
    assert!(matches!(pi().vector("v", usize::MAX), Err(NameError::TooMany { .. })));
    assert!(matches!(Parameters::new().vector("v", &[]), Err(NameError::Dimension { .. })));
    assert!(matches!(
        Parameters::new().number("v", f64::INFINITY),
        Err(NameError::NotFinite { .. })
    ));
    let one = || Parameters::new().number("Π", 1.0).unwrap();
    assert_eq!(one().vector("Pi", &[1.0]).err(), repeated("Pi"));
    let clash = Parameters::new().number("Pi", 1.0).unwrap();
    assert_eq!(Vocabulary::new(&pi(), &clash).err(), repeated("Pi"));
    // eleven copies of a vector have different names, since a component of `x_1` is `x_1_1`
    assert_eq!(pi().repeated(11).unwrap().dimension(), 33);
}
