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

/// Returns the system of an algebra by name, with its Casimirs.
pub fn named(text: &str) -> FormulaSystem {
    system(SystemAlgebra::named(text).unwrap(), "1")
}

/// Returns numbers between −1 and 1 that behave like random ones.
pub fn random(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let next = |_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(0x1405_7b7e_f767_814f);
        (state >> 11) as f64 / 2.0_f64.powi(52) - 1.0
    };
    (0..count).map(next).collect()
}

/// Returns the largest bracket of a function, by its differential, with a coordinate, relative to the largest of the terms of which it is the sum.
pub fn bracket(system: &FormulaSystem, xi: &[f64], mu: &[f64]) -> f64 {
    let (mut rate, mut size) = (vec![0.0; mu.len()], f64::MIN_POSITIVE);
    for entry in system.algebra().table().entries() {
        let term = entry.value * xi[entry.i] * mu[entry.k];
        rate[entry.j] += term;
        size = size.max(term.abs());
    }
    rate.iter().fold(0.0_f64, |largest, x| largest.max(x.abs())) / size
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
