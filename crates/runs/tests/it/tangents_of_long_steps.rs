//! Tangent vectors of steps whose stage equations sweeps do not solve.

use collective_integrators::{AnyIntegrator, AnyState, AnyTangents, Start, VariationalFlow};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::Parameters;

const STRENGTHS: [f64; 6] = [1.0, -0.6, 0.8, 1.3, -0.9, 0.7];
const HAMILTONIAN: &str =
    "sum(strengths[i]*strengths[j]*ln(2 - 2*m[i]·m[j]/(strengths[i]*strengths[j])), i < j)/(4*pi)";

/// Six vortices on a sphere, two of which come close to each other at once, and others later.
fn vortices(scheme: &str) -> (AnyIntegrator<dyn AnyTangents>, AnyState) {
    let algebra = SystemAlgebra::named("so(3)^6").unwrap().with_symbols(&["m"]).unwrap();
    let parameters = Parameters::new().vector("strengths", &STRENGTHS).unwrap();
    let method = algebra.method("reduced".parse().unwrap(), scheme.parse().unwrap(), 0.0).unwrap();
    let system = FormulaSystem::new(algebra, HAMILTONIAN, &parameters).unwrap();
    let of_vortex = |(n, strength): (u8, f64)| {
        let t = f64::from(n);
        let place = [(1.7 * t).sin(), (2.9 * t).cos(), (0.8 * t * t).sin()];
        let length = place.iter().map(|x| x * x).sum::<f64>().sqrt();
        place.map(|x| strength * x / length)
    };
    let start: Vec<f64> = (1..).zip(STRENGTHS).flat_map(of_vortex).collect();
    let integrator = system.tangent_integrator(&method, &start).unwrap();
    (integrator, AnyState::from_slice(&start))
}

/// Makes up to so many steps with K tangent vectors, orthonormal at the start of each step. Returns the number of those that
/// could be made.
fn steps_with<const K: usize>(
    integrator: &AnyIntegrator<dyn AnyTangents>,
    start: &AnyState,
    (step, most): (f64, u64),
) -> u64 {
    let state = integrator.start(start).unwrap();
    let mut flow = VariationalFlow::<_, K>::generic(integrator, state, 18, step);
    while flow.steps() < most {
        flow.orthonormalise().unwrap();
        if flow.advance().is_err() {
            break;
        }
    }
    flow.steps()
}

/// Steps that can be made can be made with tangent vectors, whose equations are linear. Longer ones cannot be made without
/// them, either.
#[test]
fn steps_with_tangent_vectors_are_those_without() {
    for (scheme, step, most, all) in
        [("gauss-4", 0.4, 8, true), ("gauss-8", 0.5, 12, true), ("gauss-4", 1.0, 12, false)]
    {
        let (integrator, start) = vortices(scheme);
        let steps = [
            steps_with::<0>(&integrator, &start, (step, most)),
            steps_with::<1>(&integrator, &start, (step, most)),
            steps_with::<2>(&integrator, &start, (step, most)),
        ];
        assert_eq!(steps, [steps[0]; 3], "{scheme} {step}");
        assert_eq!(steps[0] == most, all, "{scheme} {step}");
    }
}

/// The tangent vectors of such steps are derivatives of the states.
#[test]
fn tangent_vectors_of_long_steps_are_derivatives() {
    let ((integrator, start), step, steps) = (vortices("gauss-4"), 0.4, 8);
    let state = integrator.start(&start).unwrap();
    let mut flow = VariationalFlow::<_, 1>::generic(&integrator, state, 18, step);
    let tangent = flow.tangents()[0].as_slice().to_vec();
    (0..steps).for_each(|_| flow.advance().unwrap());
    let end = |width: f64| {
        let moved = start.as_slice().iter().zip(&tangent).map(|(x, v)| x + width * v);
        let moved = AnyState::from_slice(&moved.collect::<Vec<_>>());
        integrator.after(&moved, step, steps).unwrap().momentum.as_slice().to_vec()
    };
    // The quotient has the round-off ε/width of states of size 1 times their growth, about 1e2 after the close encounters.
    let width = 1e-6;
    let (after, before) = (end(width), end(-width));
    let quotient = after.iter().zip(&before).map(|(a, b)| (a - b) / (2.0 * width));
    let carried = flow.tangents()[0].as_slice();
    let (mut error, mut size) = (0.0_f64, 0.0_f64);
    for (quotient, carried) in quotient.zip(carried) {
        (error, size) = (error.max((quotient - carried).abs()), size.max(carried.abs()));
    }
    assert!(error < 1e-6 * size, "{error:e} {size}");
}
