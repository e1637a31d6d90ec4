//! A rigid body in an ideal fluid.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, Sign, SystemKind};
use core::fmt::Write;
use lie_poisson_formulas::Parameters;
use nalgebra::{Matrix3, Matrix6};

/// Kirchhoff's body in an ideal fluid that is at rest far away.
///
/// Π is the impulsive couple and P the impulse of body and fluid, Ω and v are the velocities of the body:
///
/// ```text
/// T = ½ Ω·IΩ + Ω·Dv + ½ v·Mv,    Π = IΩ + Dv,    P = DᵀΩ + Mv,    h(Π, P) = T
/// dΠ/dt = Π × Ω + P × v,    dP/dt = P × Ω
/// ```
///
/// With three planes of symmetry I and M are diagonal, D = 0 and h = Σ_i Π_i²/(2 I_i) + Σ_i P_i²/(2 M_i). The algebra is
/// se(3). The Casimirs are Π·P and |P|².
///
/// Source: G. Kirchhoff, *Vorlesungen über mathematische Physik* (1876), 19th lecture; H. Lamb, *Hydrodynamics*, 6th ed.,
/// §124.
pub(in crate::catalogue) const BODY_IN_FLUID: SystemKind = SystemKind {
    name: "body-in-fluid",
    about: "a rigid body in an ideal fluid",
    parameters: &[
        Parameter::list("inertia", "3 moments of body and fluid, kg m², or 9 for the rows of I"),
        Parameter::list("masses", "3 masses of body and fluid, kg, or 9 for the rows of M"),
        Parameter::list("coupling", "9, the rows of D in the energy Ω·Dv, kg m").or(&[]),
    ],
    describe,
    orbit: None,
    directions: &[],
    start: None,
};

/// The largest difference of a matrix from its transpose, relative to its largest entry: that of numbers with 12 digits.
const ASYMMETRY: f64 = 1e-12;

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    let sizes = ["inertia", "masses", "coupling"].map(|name| given.values(name).len());
    let (hamiltonian, parameters) = if sizes == [3, 3, 0] {
        given.require("inertia", Sign::Positive)?;
        given.require("masses", Sign::Positive)?;
        let text = "sum(Pi[i]^2/inertia[i])/2 + sum(P[i]^2/masses[i])/2".into();
        (text, given.parameters(&["inertia", "masses"])?)
    } else {
        energy_of(&inverse_inertia(given)?)?
    };
    let algebra = SystemAlgebra::named("se(3)")?.with_symbols(&["Pi", "P"])?;
    Ok(Description { algebra, hamiltonian, parameters, has_plus_bracket: false })
}

/// Returns the inverse of [I D; Dᵀ M].
fn inverse_inertia(given: &Given<'_>) -> Result<Matrix6<f64>, KindError> {
    let [i, m] = [symmetric(given, "inertia")?, symmetric(given, "masses")?];
    let d = match given.values("coupling").as_slice() {
        [] => Matrix3::zeros(),
        rows if rows.len() == 9 => Matrix3::from_row_slice(rows),
        rows => return Err(KindError::Value("coupling", format!("9 numbers, got {}", rows.len()))),
    };
    let mut whole = Matrix6::zeros();
    whole.fixed_view_mut::<3, 3>(0, 0).copy_from(&i);
    whole.fixed_view_mut::<3, 3>(0, 3).copy_from(&d);
    whole.fixed_view_mut::<3, 3>(3, 0).copy_from(&d.transpose());
    whole.fixed_view_mut::<3, 3>(3, 3).copy_from(&m);
    let inverse = whole.cholesky().map(|factors| factors.inverse());
    inverse.filter(|inverse| inverse.iter().all(|x| x.is_finite())).ok_or_else(|| {
        let needed = "such that the energy of every motion is positive, with masses and coupling";
        KindError::Value("inertia", needed.into())
    })
}

/// Returns a matrix of 3 or 9 numbers.
fn symmetric(given: &Given<'_>, name: &'static str) -> Result<Matrix3<f64>, KindError> {
    let rows = given.values(name);
    let matrix = match rows.len() {
        3 => Matrix3::from_diagonal(&nalgebra::Vector3::from_row_slice(&rows)),
        9 => Matrix3::from_row_slice(&rows),
        count => return Err(KindError::Value(name, format!("3 or 9 numbers, got {count}"))),
    };
    let defect = (matrix - matrix.transpose()).amax();
    match defect <= ASYMMETRY * matrix.amax() {
        true => Ok(matrix),
        false => {
            let needed = format!("the rows of a symmetric matrix; it differs by {defect}");
            Err(KindError::Value(name, needed))
        }
    }
}

/// Returns the energy as a formula in the entries W_ij of the inverse inertia that are not zero.
fn energy_of(inverse: &Matrix6<f64>) -> Result<(String, Parameters), KindError> {
    let names = ["Pi1", "Pi2", "Pi3", "P1", "P2", "P3"];
    let (mut text, mut parameters) = (String::new(), Parameters::new());
    for (i, one) in names.iter().enumerate() {
        for (j, other) in names.iter().enumerate().skip(i) {
            let entry = 0.5 * (inverse[(i, j)] + inverse[(j, i)]);
            if entry != 0.0 {
                let name = format!("W{}{}", i + 1, j + 1);
                parameters = parameters.number(&name, entry)?;
                let half = if i == j { "/2" } else { "" };
                let plus = if text.is_empty() { "" } else { " + " };
                // Writing to a string does not fail.
                let _ = write!(text, "{plus}{name}*{one}*{other}{half}");
            }
        }
    }
    Ok((text, parameters))
}
