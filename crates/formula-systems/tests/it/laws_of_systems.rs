//! The law suites of systems whose dimension is known when the program runs: the algebra, the Hamiltonian, and the
//! integrator of each formulation. Each suite refuses the same object with a wrong result.

use crate::support::system;
use collective_integrators::{AnyState, Start, laws};
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson::laws::{Faulty, NoSamples, Report, hamiltonian, lie_algebra, poisson_space};
use lie_poisson::{
    Hamiltonian, LiePoisson, Momentum, PoissonSpace, State, StructureConstants, Vector,
};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::{Coordinates, FormulaHamiltonian, Parameters, structure_constants};

/// The round-off of the few dozen operations in a law, relative to the sizes that enter it.
const ROUND_OFF: f64 = 1e-13;

/// The round-off of the 100 steps of the suite of invariants, some ten units for each.
const ROUND_OFF_OF_RUNS: f64 = 1e-12;

/// The residual that a fault must exceed: it changes a result by its own size.
const CLEAR: f64 = 1e-3;

/// The size of the steps.
const STEP: f64 = 0.05;

/// The bound (ωh)⁴ on the deviation of the energy under a method of order 4, for angular velocities ω up to 3.
const ENERGY: f64 = 81.0 * STEP * STEP * STEP * STEP;

/// Returns the algebra with these coordinates and brackets.
fn of_brackets(names: &[&str], brackets: &[(&str, &str)]) -> SystemAlgebra {
    let coordinates = Coordinates::scalars(names.iter().copied()).unwrap();
    SystemAlgebra::of_brackets(coordinates, brackets.iter().copied(), &Parameters::new()).unwrap()
}

/// Returns the product of so(3) with itself, with the coordinates x1, y1, z1, x2, and so on.
fn rotors(count: usize) -> SystemAlgebra {
    let names: Vec<String> =
        (1..=count).flat_map(|i| ["x", "y", "z"].map(|name| format!("{name}{i}"))).collect();
    let bracket = |i: usize, [a, b, c]: [usize; 3]| {
        let name = |k: usize| names[3 * i + k].as_str();
        (format!("{}, {}", name(a), name(b)), name(c).to_owned())
    };
    let cyclic = [[0, 1, 2], [1, 2, 0], [2, 0, 1]];
    let brackets: Vec<_> =
        (0..count).flat_map(|i| cyclic.map(|indices| bracket(i, indices))).collect();
    let brackets: Vec<_> = brackets.iter().map(|(of, is)| (of.as_str(), is.as_str())).collect();
    let names: Vec<_> = names.iter().map(String::as_str).collect();
    of_brackets(&names, &brackets)
}

/// Systems of the dimensions 1 to 6, 9 and 15: no brackets, the affine group of the line, sl(2), the oscillator, two pairs of
/// Heisenberg, the heavy top, a top on a movable base, and five rotors; with functions in their Hamiltonians.
fn systems() -> Vec<FormulaSystem> {
    let named = |name| SystemAlgebra::named(name).unwrap();
    let oscillator = [("a, b", "c"), ("d, a", "b"), ("d, b", "-a")];
    [
        (of_brackets(&["x"], &[]), "x^2/2 + cos(x)"),
        (of_brackets(&["x", "y"], &[("x, y", "y")]), "x^2/2 + exp(y/2)"),
        (named("sl(2)"), "(alpha^2 + beta^2/2 + gamma^2)/2 + sin(alpha)/4"),
        (of_brackets(&["a", "b", "c", "d"], &oscillator), "a^2/2 + b^2 + c*d + d^2/4"),
        (
            of_brackets(&["p", "q", "r", "s", "z"], &[("p, q", "z"), ("r, s", "z")]),
            "p^2/2 + q^2 + r^2/3 + z^2/2 + sqrt(1 + s^2)",
        ),
        (named("se(3)"), "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + Gamma1*Gamma3 + exp(Gamma2/2)"),
        (named("se(3)+R3"), "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + P1^2/4 + P2*Gamma3/3 + Gamma1"),
        (
            rotors(5),
            "x1*x2 + y2*y3/2 + z3*x4 + y4*z5 + (x1^2 + y2^2 + z3^2 + x4^2 + y5^2)/4 + cos(x3)",
        ),
    ]
    .map(|(algebra, text)| system(algebra, text))
    .into()
}

/// Returns the same generic vectors as coordinates and as a point, with coordinates in (−1, 1).
fn samples<V: Vector<Scalar = f64>>() -> Vec<V> {
    let mut seed = 7.0_f64;
    let mut next = move || {
        seed = (seed * 16_807.0) % 2_147_483_647.0;
        2.0 * seed / 2_147_483_647.0 - 1.0
    };
    (0..2).map(|_| V::from_coordinates(|_| next())).collect()
}

/// Checks that a suite accepts an object, and that it refuses the object with a fault in the given method and coordinate.
fn obeys<'a, S>(
    what: &str,
    object: &'a S,
    (method, coordinate): (&'static str, usize),
    tolerance: f64,
    suite: impl Fn(&Faulty<'a, S>) -> Result<Report, NoSamples>,
) {
    let report = suite(&Faulty::without_fault(object)).unwrap();
    report.check(tolerance).unwrap_or_else(|broken| panic!("{what}: {broken}"));
    let refused = suite(&Faulty::new(object, method, coordinate)).unwrap().check(CLEAR);
    assert!(
        refused.is_err(),
        "{what}: a fault of {method} in coordinate {coordinate} was not found"
    );
}

/// Runs the suites of the algebra and of the Hamiltonian.
fn statics<const N: usize>(system: &FormulaSystem) {
    let algebra = structure_constants::<N>(system.algebra().entries()).unwrap();
    let what = format!("dimension {N}");
    let h = FormulaHamiltonian::<StructureConstants<N>>::of(system.hamiltonian()).unwrap();
    obeys(&what, &h, ("differential", 0), ROUND_OFF, |h| {
        hamiltonian::<LiePoisson<StructureConstants<N>>, _>(h, &samples())
    });
    // Without brackets there is nothing to halve.
    if let Some(entry) = system.algebra().entries().first() {
        obeys(&what, &algebra, ("bracket", entry.k), ROUND_OFF, |algebra| {
            lie_algebra(algebra, &samples()[..1])
        });
    }
    let space = LiePoisson::minus(algebra);
    poisson_space(&space, &samples()).unwrap().check(ROUND_OFF).unwrap();
    // The rate of the system is the Hamiltonian vector of this space.
    for mu in samples::<Momentum<StructureConstants<N>>>() {
        let vector = space.hamiltonian_vector::<f64>(&mu, &h.differential(&mu));
        let coordinates: Vec<f64> = (0..N).map(|i| mu.coordinate(i)).collect();
        let rate = system.rate(&coordinates).unwrap();
        let rate: Momentum<StructureConstants<N>> = Vector::from_coordinates(|i| rate[i]);
        assert!((rate - vector).max_abs() < ROUND_OFF, "{what}");
    }
}

#[test]
#[ignore = "long"]
fn algebras_and_hamiltonians_of_any_dimension() {
    let mut dimensions = Vec::new();
    for system in systems() {
        let dimension = system.algebra().dimension();
        match dimension {
            1 => statics::<1>(&system),
            2 => statics::<2>(&system),
            3 => statics::<3>(&system),
            4 => statics::<4>(&system),
            5 => statics::<5>(&system),
            6 => statics::<6>(&system),
            9 => statics::<9>(&system),
            15 => statics::<15>(&system),
            other => panic!("{other}"),
        }
        dimensions.push(dimension);
    }
    assert_eq!(dimensions, [1, 2, 3, 4, 5, 6, 9, 15]);
}

/// Runs the suites of an integrator.
fn dynamics(what: &str, method: &Method, system: &FormulaSystem, start: &[f64]) {
    let integrator = &system.tangent_integrator(method, start).unwrap().without_tangents();
    let mu = [AnyState::from_slice(start)];
    obeys(what, integrator, ("step", 0), ROUND_OFF, |i| laws::start(i, &mu, STEP));
    let state = [integrator.start(&mu[0]).unwrap()];
    let invariant =
        |index: usize| move |mu: &AnyState| system.invariants(mu.as_slice()).unwrap()[index];
    let run = |index| laws::invariants(integrator, &state, STEP, &[&invariant(index)]).unwrap();
    let energy = run(0);
    energy.check(ENERGY).unwrap_or_else(|broken| panic!("{what}, energy: {broken}"));
    for index in 1..=system.casimirs().len() {
        let checked = run(index).check(ROUND_OFF_OF_RUNS);
        checked.unwrap_or_else(|broken| panic!("{what}, Casimir {index}: {broken}"));
    }
}

/// All Casimirs of these systems are at most quadratic, so that a Gauss method conserves them in every formulation.
#[test]
#[ignore = "long"]
fn integrators_of_systems_of_any_dimension() {
    let mut kinds = Vec::new();
    for system in systems() {
        let algebra = system.algebra();
        let start =
            &[0.6, -0.4, 0.7, 0.3, -0.5, 0.8, 0.2, -0.9, 0.5, 0.4, 0.1, -0.3, 0.6, -0.2, 0.9]
                [..algebra.dimension()];
        for formulation in algebra.formulations() {
            let method = algebra.method(formulation, SchemeName::Gauss(2), 0.0).unwrap();
            let what = format!("dimension {}, {formulation}", start.len());
            dynamics(&what, &method, &system, start);
            kinds.push((start.len(), formulation));
        }
    }
    // Each formulation has run, and the direct one in each width.
    for expected in [
        (2, Formulation::Collective),
        (6, Formulation::Collective),
        (6, Formulation::Reduced),
        (3, Formulation::Direct),
        (9, Formulation::Direct),
        (15, Formulation::Direct),
    ] {
        assert!(kinds.contains(&expected), "{expected:?}");
    }
}

/// Negative control: a method that does not conserve Casimirs is refused by the suite of invariants.
#[test]
#[should_panic = "Casimir 1: invariants fails"]
fn methods_that_lose_casimirs_are_refused() {
    let so3 = SystemAlgebra::named("so(3)").unwrap();
    let body = system(so3, "Pi1^2 + Pi2^2/2 + Pi3^2/3");
    let start = [0.6, -0.4, 0.7];
    let method = body.algebra().method(Formulation::Direct, SchemeName::Rk4, 0.0).unwrap();
    dynamics("rk4", &method, &body, &start);
}
