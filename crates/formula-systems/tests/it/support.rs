//! Systems and tasks that several tests use.

use collective_integrators::Start;
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::Vector;
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra, SystemMethod, SystemTask};
use lie_poisson_formulas::Parameters;

/// Returns the system of a Hamiltonian without parameters, with its Casimirs.
pub fn system(algebra: SystemAlgebra, hamiltonian: &str) -> FormulaSystem {
    let system = FormulaSystem::new(algebra, hamiltonian, &Parameters::new()).unwrap();
    system.with_found_casimirs().unwrap()
}

/// The task of following a number of steps to the last state.
pub struct End<'a> {
    pub start: &'a [f64],
    pub step: f64,
    pub steps: usize,
}

impl SystemTask for End<'_> {
    type Output = Vec<f64>;

    fn perform<I>(self, integrator: &I) -> Vec<f64>
    where
        I: Start<State: Vector, Momentum: Vector<Scalar = f64>>,
    {
        let start = Vector::from_coordinates(|i| self.start.get(i).copied().unwrap_or(0.0));
        let mut run = integrator.trajectory(&start, self.step).unwrap();
        let end = run.nth(self.steps).unwrap().unwrap().momentum;
        (0..self.start.len()).map(|i| end.coordinate(i)).collect()
    }
}

/// Returns the state after a number of steps of a method.
pub fn end(
    system: &FormulaSystem,
    (formulation, scheme): (Formulation, SchemeName),
    start: &[f64],
    (step, steps): (f64, usize),
) -> Vec<f64> {
    let method = SystemMethod::new(system.algebra(), formulation, scheme, 0.0).unwrap();
    method.integrate(system, start, End { start, step, steps }).unwrap()
}

/// Returns the largest difference of two states.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
