//! Errors of formulas, of their names, and of Casimirs.

use super::refused;
use lie_poisson::{LieAlgebra, Real, So3};
use lie_poisson_formulas::{
    CasimirError, Coordinates, EntryError, Formula, FormulaHamiltonian, Parameters,
    PolynomialCasimirs, Problem, StructureEntry, Vocabulary, find_casimirs, structure_constants,
};
use nalgebra::Vector3;

/// An algebra with an infinite constant.
#[derive(Clone)]
struct Infinite;

impl LieAlgebra for Infinite {
    type Element<T: Real> = Vector3<T>;

    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        xi.cross(eta) * T::from_f64(f64::INFINITY)
    }
}

/// Returns the Casimirs of so(3) in coordinates with these names.
fn casimirs(names: &[&str]) -> Result<PolynomialCasimirs, CasimirError> {
    find_casimirs(&So3, &Coordinates::scalars(names.iter().copied())?)
}

/// Returns the error of a table of structure constants (i, j, k, value).
fn table(entries: &[(usize, usize, usize, f64)]) -> Result<(), EntryError> {
    let entry = |&(i, j, k, value): &_| StructureEntry { i, j, k, value };
    structure_constants::<3>(&entries.iter().map(entry).collect::<Vec<_>>()).map(|_| ())
}

/// Returns a formula that has no value at Π₁ = 0, and none of its derivative at Π₂ = 0.
fn logarithm() -> Formula {
    let names = Vocabulary::of(&So3, &Parameters::new()).unwrap();
    Formula::new("ln(Pi1) + sqrt(Pi2)", &names).unwrap()
}

/// Returns the errors of names, of tables, and of the search for Casimirs.
pub fn names_and_tables() -> Vec<String> {
    let names = Coordinates::new;
    vec![
        refused(names().scalar("2x")),
        refused(names().scalar("sqrt")),
        refused(Coordinates::scalars(["x", "x"])),
        refused(Parameters::new().number("k", f64::NAN)),
        refused(names().vector("v", 0)),
        refused(names().vector("v", 1000)),
        refused(table(&[(0, 1, 3, 1.0)])),
        refused(table(&[(0, 1, 2, 1.0), (1, 0, 2, 1.0)])),
        refused(table(&[(1, 1, 2, 1.0)])),
        refused(table(&[(0, 1, 2, 1.0), (0, 2, 1, 1.0), (1, 2, 1, 1.0)])),
        refused(logarithm().checked_value(&[0.0; 3])),
        refused(logarithm().checked_differential(&[1.0, 0.0, 0.0])),
        refused(casimirs(&["x", "y"])),
        refused(casimirs(&["x", "y", "sin"])),
        refused(find_casimirs(&Infinite, &Coordinates::scalars(["x", "y", "z"]).unwrap())),
    ]
}

/// Returns what is wrong with formulas in the names of so(3)∗.
pub fn problems() -> Vec<String> {
    let names = Vocabulary::of(&So3, &Parameters::new()).unwrap();
    let problem = |text: &str| -> Result<(), Problem> {
        Formula::new(text, &names).map(|_| ()).map_err(|error| error.problem().clone())
    };
    let product: Vec<String> = (1..4700).map(|n| format!("sin({n}*Pi1)")).collect();
    let plane = Vocabulary::new(&Coordinates::scalars(["x", "y"]).unwrap(), &Parameters::new());
    let area = Formula::new("x*y", &plane.unwrap()).unwrap();
    let numbered =
        Vocabulary::new(&Coordinates::scalars(["S1", "S2"]).unwrap(), &Parameters::new());
    let no_vector = Formula::new("S·S", &numbered.unwrap()).map_err(|e| e.problem().clone());
    let other_space = FormulaHamiltonian::<So3>::of(&area).map_err(|e| e.problem().clone());
    let long = format!("Pi1{}", " + Pi1".repeat(20_000));
    let deep = format!("{}Pi1", "-(".repeat(500));
    let texts = [
        "",
        &long,
        &deep,
        "Pi1 $ 2",
        "1.2.3",
        "1e400",
        "Pi1 +",
        "2 Pi1",
        "(Pi1",
        "Pi1)",
        "zebra",
        "sqr(Pi1)",
        "Pi1(2)",
        "sin",
        "sin(Pi1, 2)",
        "sqrt(Pi)",
        "1 + Pi",
        "Pi[4]",
        "Pi[0]",
        "Pi",
        "Pi1/0",
        "ln(0)",
        "if(Pi1, 1, 2)",
        "sum(Pi1)",
        "sum(Pi[i]*Pi[i+3])",
    ];
    let mut found: Vec<String> = texts.iter().map(|text| refused(problem(text))).collect();
    found.push(refused(problem(&product.join("*"))));
    found.push(refused(other_space));
    found.push(refused(no_vector));
    found
}
