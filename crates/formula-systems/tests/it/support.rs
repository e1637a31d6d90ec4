//! Systems and runs that several tests use.

use collective_integrators::{AnyState, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::Parameters;

/// Returns the system of a Hamiltonian without parameters, with its Casimirs.
pub fn system(algebra: SystemAlgebra, hamiltonian: &str) -> FormulaSystem {
    let system = FormulaSystem::new(algebra, hamiltonian, &Parameters::new()).unwrap();
    system.with_found_casimirs().unwrap()
}

/// Returns the state after a number of steps of a method.
pub fn end(
    system: &FormulaSystem,
    (formulation, scheme): (Formulation, SchemeName),
    start: &[f64],
    (step, steps): (f64, u64),
) -> Vec<f64> {
    let method = system.algebra().method(formulation, scheme, 0.0).unwrap();
    let integrator = system.tangent_integrator(&method, start).unwrap();
    integrator
        .after(&AnyState::from_slice(start), step, steps)
        .unwrap()
        .momentum
        .as_slice()
        .to_vec()
}

/// Returns the largest difference of two states.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
