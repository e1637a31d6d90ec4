//! Errors of systems from formulas, of their algebras, methods and sections.

use super::refused;
use collective_integrators::{AnyState, Direction, Start, StepError};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::So3;
use lie_poisson_formula_systems::{
    FormulaSystem, FormulaSystemError, QuadraticMomenta, SystemAlgebra, SystemKind, SystemSection,
    structure_table,
};
use lie_poisson_formulas::{Coordinates, Parameters, StructureEntry, find_casimirs};

type Outcome<T> = Result<T, FormulaSystemError>;

/// Returns the algebra of brackets of the coordinates x, y and z.
fn brackets(brackets: &[(&str, &str)], parameters: &Parameters) -> Outcome<SystemAlgebra> {
    let coordinates = Coordinates::scalars(["x", "y", "z"])?;
    SystemAlgebra::of_brackets(coordinates, brackets.iter().copied(), parameters)
}

/// Returns the error of algebras, of their brackets, and of tables of structure constants.
pub fn algebras() -> Vec<String> {
    let none = Parameters::new();
    let taken = Parameters::new().number("x", 1.0).unwrap();
    let named = |name| SystemAlgebra::of_entries(Coordinates::scalars([name])?, Vec::new());
    let entries =
        |entries| SystemAlgebra::of_entries(Coordinates::scalars(["x", "y"]).unwrap(), entries);
    let beyond = vec![StructureEntry { i: 0, j: 1, k: 2, value: 1.0 }];
    vec![
        refused(SystemAlgebra::named("so4")),
        refused(SystemAlgebra::named("so(3")),
        refused(SystemAlgebra::named("so(3)^2").and_then(|spins| spins.with_symbols(&["S", "T"]))),
        refused(QuadraticMomenta::new(Vec::new())),
        refused(SystemAlgebra::named_with("so(2) ⋉ V", &[("V".into(), Vec::new())].into())),
        refused(SystemAlgebra::of_entries(Coordinates::new(), Vec::new())),
        refused(named("sin")),
        refused(brackets(&[], &taken)),
        refused(brackets(&[("x; y", "z")], &none)),
        refused(brackets(&[("x, y", "w")], &none)),
        refused(brackets(&[("x, y", "z^2")], &none)),
        refused(brackets(&[("x, y", "z"), ("x, z", "y"), ("y, z", "y")], &none)),
        refused(brackets(&[("x, y", "z"), ("y, x", "z")], &none)),
        refused(entries(beyond)),
        refused(structure_table("1, 2, 3")),
        refused(structure_table("0, 2, 3, 1")),
        refused(structure_table("1, 2, 3, one")),
        refused(structure_table("1, 1, 3, 1")),
        refused(structure_table("1, 2, 3, 1\n2, 1, 3, 1")),
        refused(structure_table("1, 2, 3, 1\n1, 3, 2, 1\n2, 3, 2, 1")),
    ]
}

/// Returns the errors of Hamiltonians, states, sections and methods.
pub fn systems_and_states() -> Vec<String> {
    let none = Parameters::new();
    let flat = Parameters::new().vector("moments", &[1.0, 0.0, 2.0]).unwrap();
    let so3 = SystemAlgebra::named("so(3)").unwrap();
    let system = |text| FormulaSystem::new(so3.clone(), text, &Parameters::new());
    let body = system("Pi1^2 + Pi2^2/2").unwrap();
    let section =
        |text, level| SystemSection::new(&body, text, &Parameters::new(), (level, Direction::Both));
    let plane = SystemAlgebra::of_entries(Coordinates::scalars(["x", "y"]).unwrap(), Vec::new());
    let plane = FormulaSystem::new(plane.unwrap(), "x", &none).unwrap();
    let state = [1.0, 0.5, 0.2];
    let method = |formulation, tolerance| so3.method(formulation, SchemeName::Gauss(2), tolerance);
    // The reciprocal of the only constant is not finite, so that the Clebsch map has no units.
    let constants = vec![StructureEntry { i: 0, j: 1, k: 2, value: 1e-310 }];
    let tiny = SystemAlgebra::of_entries(Coordinates::scalars(["x", "y", "z"]).unwrap(), constants);
    let unlifted = || -> Outcome<()> {
        let tiny = FormulaSystem::new(tiny?, "x^2 + z", &Parameters::new())?;
        let collective = Formulation::Collective;
        let method = tiny.algebra().method(collective, SchemeName::Gauss(2), 0.0)?;
        tiny.tangent_integrator(&method, &state).map(drop)
    };
    // y/x² is a Casimir, but no polynomial; z is another one.
    let section_on_another_orbit = || -> Outcome<_> {
        let names = Coordinates::scalars(["a", "x", "y", "z"])?;
        let brackets = [("a, x", "x"), ("a, y", "2*y")];
        let algebra = SystemAlgebra::of_brackets(names, brackets, &Parameters::new())?;
        let lost = FormulaSystem::new(algebra, "a^2 + x^2", &Parameters::new())?;
        let lost = lost.with_found_casimirs()?;
        let at = (0.0, Direction::Both);
        SystemSection::new(&lost, "a", &Parameters::new(), at)?.starts(&[1.0; 4], &[2.0, 3.0], 1, 0)
    };
    // The stages of the step lie on a narrow hill of the energy, which its start does not see.
    let hill = || -> Outcome<_> {
        let names = Coordinates::scalars(["x", "y"])?;
        let line = SystemAlgebra::of_brackets(names, [("x, y", "y")], &Parameters::new())?;
        let text = "y^2/2 + 100*exp(-1000*(x - 1)^2)";
        let hill = FormulaSystem::new(line, text, &Parameters::new())?;
        let (collective, rk4) = (Formulation::Collective, SchemeName::Rk4);
        let method = hill.algebra().method(collective, rk4, 0.0)?;
        // control: where the energy is smooth, the same step is made
        let step = |start: [f64; 2]| -> Outcome<Result<(), StepError>> {
            let integrator = hill.tangent_integrator(&method, &start)?.without_tangents();
            let mut run = integrator.trajectory(&AnyState::from_slice(&start), 0.5).unwrap();
            let end = run.nth(1).unwrap();
            Ok(end.map(|_| ()).map_err(|error| error.source))
        };
        assert_eq!(step([3.0, 0.5])?, Ok(()));
        step([1.1, 0.5])
    };
    // A program may look for the Casimirs of a system before it makes the system.
    let casimirs =
        || -> Outcome<_> { Ok(find_casimirs(&So3, &Coordinates::scalars(["x", "y"])?)?) };
    vec![
        refused(SystemKind::named("body-with-rotor")),
        refused(SystemKind::named("body-with-rotors").unwrap().system(&none)),
        refused(SystemKind::named("rigid-body").unwrap().system(&flat)),
        refused(system("Pi4")),
        refused(casimirs()),
        refused(so3.state([("Pi1", &[1.0][..])])),
        refused(so3.state([("Gamma", &[1.0][..])])),
        refused(so3.state([("Pi", &[1.0][..])])),
        refused(so3.state([("Pi", &[1.0, 2.0, 3.0][..]), ("Pi1", &[1.0])])),
        refused(body.invariants(&[1.0, 2.0])),
        refused(system("ln(Pi1 - 5)").unwrap().invariants(&state)),
        refused(section_on_another_orbit()),
        refused(section("Gamma3", 0.0)),
        refused(section("Pi3", 0.0).unwrap().with_axes(["Pi1", "Pi4"], &none)),
        refused(SystemSection::new(&plane, "x", &none, (0.0, Direction::Up))),
        refused(section("Pi3", f64::NAN)),
        refused(section("Pi3", 0.5).unwrap().starts(&state, &[-1.0], 1, 0)),
        refused(method(Formulation::Splitting, 0.0)),
        refused(method(Formulation::Direct, -1.0)),
        refused(unlifted()),
        refused(hill().unwrap()),
    ]
}
