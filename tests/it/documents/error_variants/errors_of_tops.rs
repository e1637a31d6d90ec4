//! Errors of tops, their methods and their sections.

use super::refused;
use collective_integrators::Direction;
use heavytop::methods::{Formulation, Method, MethodError, SchemeName};
use heavytop::{
    Body, Coordinate, EnergyLevel, HeavyTop, JacobiElliptic, LagrangeNutation, PrincipalAxes,
    Section, Surface, SymmetricTopSplitting, require_unit,
};
use lie_poisson::{InstructionSet, MissingInstructions};
use nalgebra::{Matrix3, Vector3};
use workspace_tests::tops;

/// Returns a method by the names of its formulation and its scheme, on an instruction set.
fn method(formulation: &str, scheme: &str, set: InstructionSet) -> Result<Method, MethodError> {
    let method = Method::new(formulation.parse()?, scheme.parse()?, 0.0)?;
    Ok(method.with_instructions(set)?)
}

/// Returns the error of a method with instructions that the processor lacks. One that has all of them refuses none.
fn missing_instructions() -> String {
    let missing = InstructionSet::ALL.into_iter().find(|set| !set.is_available());
    match missing {
        Some(set) => refused(method("direct", "rk4", set)),
        None => {
            refused::<(), MethodError>(Err(
                MissingInstructions { set: InstructionSet::Avx512 }.into()
            ))
        }
    }
}

/// Returns the errors of parameters of tops, of methods, and of sections.
pub fn errors() -> Vec<String> {
    let body = Body {
        inertia: Vector3::new(2.0, 2.0, 1.0),
        mass: 1.0,
        gravity: 9.81,
        length: 0.1,
        center_of_mass: Vector3::z(),
    };
    let rod = HeavyTop::new(&Body { inertia: Vector3::new(2.0, 2.0, 0.0), ..body }).unwrap();
    let top = tops::paper().unwrap();
    let generic = tops::generic().unwrap();
    let portable = InstructionSet::Portable;
    let no_stages = Method::new(Formulation::Direct, SchemeName::Gauss(0), 0.0).unwrap();
    let section = |energy, level| {
        let surface =
            Surface { variable: Coordinate::Gamma3.into(), level, direction: Direction::Up };
        Section::new(EnergyLevel { top, energy, vertical_momentum: 0.0 }, surface)
    };
    let surface =
        Surface { variable: Coordinate::Pi1.into(), level: 0.0, direction: Direction::Up };
    let of_rod =
        Section::new(EnergyLevel { top: rod, energy: 1.0, vertical_momentum: 0.0 }, surface);
    vec![
        refused(HeavyTop::new(&Body { length: f64::INFINITY, ..body })),
        refused(HeavyTop::new(&Body { mass: 0.0, ..body })),
        refused(HeavyTop::new(&Body { gravity: -9.81, ..body })),
        refused(HeavyTop::new(&Body { inertia: Vector3::new(1.0, 1.0, 3.0), ..body })),
        refused(Body { mass: 500.0, ..body }.require_possible()),
        refused(PrincipalAxes::of(&Matrix3::new(2.0, 0.1, 0.0, 0.2, 2.0, 0.0, 0.0, 0.0, 1.0))),
        refused(HeavyTop::new(&Body { inertia: Vector3::new(0.0, 1.0, 1.0), ..body })),
        refused(rod.require_state(&tops::generic_start())),
        refused(JacobiElliptic::new(1.5)),
        refused(LagrangeNutation::new(&generic, &tops::generic_start())),
        refused(SymmetricTopSplitting::new(generic)),
        refused(require_unit("axis", &Vector3::new(1.0, 1.0, 0.0))),
        refused(method("direct", "rk5", portable)),
        refused(method("direct", "stormer-verlet", portable)),
        refused(Method::new(Formulation::Direct, SchemeName::Rk4, -1.0)),
        missing_instructions(),
        refused(no_stages.integrator(&top).map(drop)),
        refused(section(f64::NAN, 0.0)),
        refused(of_rod),
        refused(section(1.0, -1.0)),
        refused(section(-2.0, 0.0)),
        refused(section(-1.0 + 1e-13, 0.0).unwrap().starts(1000, 0)),
    ]
}
