//! Names and points that the tests share.

use lie_poisson::{Covector, Pair, Real, Se3Dual};
use lie_poisson_formulas::{Coordinates, Formula, Parameters, Vocabulary};
use nalgebra::Vector3;

/// Returns the vocabulary of a heavy top, with a superfluous number `k`.
pub fn heavy_top() -> Vocabulary {
    let coordinates = Coordinates::new().vector("Pi", 3).unwrap().vector("Gamma", 3).unwrap();
    let parameters = Parameters::new()
        .vector("I", &[2.0, 3.0, 4.0])
        .and_then(|p| p.vector("c", &[0.6, 0.0, 0.8]))
        .and_then(|p| p.number("mgl", 1.5))
        .and_then(|p| p.number("k", -0.25));
    Vocabulary::new(&coordinates, &parameters.unwrap()).unwrap()
}

/// Returns a formula in these names.
pub fn formula(text: &str) -> Formula {
    Formula::new(text, &heavy_top()).unwrap_or_else(|error| panic!("{}", error.quoted(text)))
}

/// Returns a point by its six coordinates.
pub fn point<T: Real>(x: [T; 6]) -> Se3Dual<T> {
    let [a, b, c, d, e, f] = x;
    Covector(Pair(Vector3::new(a, b, c), Vector3::new(d, e, f)))
}

/// Formulas of all kinds, which are smooth where all coordinates are positive.
pub const FORMULAS: &[&str] = &[
    "0.5*(Pi1^2/I1 + Pi2^2/I2 + Pi3^2/I3) + mgl*c·Gamma",
    "|Pi|^2/2 + Pi·(Gamma×c) + (Pi×Gamma)[2]*Gamma1",
    "Pi1*Pi2*Pi3*Gamma1*Gamma2*Gamma3",
    "(Pi1 + Gamma1)^5 - Pi2^3*Gamma2^4 + Pi3^17",
    "1/|Pi| + Pi1/|Gamma|^3 + Gamma2^-4 + Pi3^-1.5 + Pi2^2.5",
    "sqrt(Pi1*Gamma1 + Pi2^2) + √(Gamma3)",
    "Pi1^Gamma1 + Pi2^0.3 + 2^Pi3",
    "exp(-Pi1^2/2)*cos(3*Gamma1) + sin(Gamma2*Gamma3)*tan(Pi2/4)",
    "ln(Pi1 + Gamma1) + atan2(Pi2, Gamma2) + tanh(Pi3 - Gamma3)",
    "atan2(Pi1, Gamma1)^2*Pi2 + Gamma3*atan2(1, Pi3)",
    "sinh(Pi1/2)*cosh(Gamma1/2) + abs(Pi2 - 10)*|Gamma3 + 1|",
    "norm(Pi + k*Gamma - 2*c) + dot(Pi, c)/(1 + |cross(Pi, Gamma)|^2)",
    "Pi1/(Pi2/(Pi3/(Gamma1/(Gamma2/Gamma3))))",
    "arcsin(Pi1/3) + arccos(Gamma1/3)*arctan(Pi2 - Gamma2)",
    "cbrt(Pi1 - 10) + log10(Pi2)*hypot(Gamma1, Gamma3) + cbrt(Gamma2)",
    "if(Pi1 + Gamma1 > 2.5, Pi2^2, Pi3*Gamma3) + if(Pi2 <= 1e-3, 1, exp(-Pi2)) + |if(Gamma1 < 1.5, Pi, 2*Gamma)|^1.5",
];

/// Points at which the formulas are smooth: generic ones, near 0, near a coordinate axis, and with equal coordinates.
pub const POINTS: &[[f64; 6]] = &[
    [1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
    [0.7, 1.3, 0.4, 1.9, 0.8, 1.1],
    [2.0, 0.1, 0.6, 0.05, 1.2, 0.9],
    [1e-6, 1.0, 1e-7, 1.0, 1e-5, 1.0],
    [1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3],
];
