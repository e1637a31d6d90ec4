//! The fastest integrator of a method makes the steps of the method: with its stages in lanes, or with a lift.

use collective_integrators::{AnyIntegrator, AnyStart, AnyState, Start};
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, FormulaSystemError, SystemAlgebra};
use lie_poisson_formulas::Parameters;

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Algebras of each family, with momenta along matrices, of dimensions that tables complete to 3 or 6, and of 9.
const ALGEBRAS: [&str; 10] = [
    "so(3)",
    "su(2)",
    "se(3)",
    "se(2)",
    "so(2,1)",
    "so(4)",
    "so(5)",
    "so(3)^2",
    "so(2,1) + R1",
    "so(3) ⋉ (R3 + R3)",
];

/// Returns Σ_i x_i²/(i + 1), with or without other terms, in the coordinates x of an algebra.
fn system(algebra: &str, other_terms: bool) -> Result<FormulaSystem, FormulaSystemError> {
    let algebra = SystemAlgebra::named(algebra)?;
    let names: Vec<String> = algebra.coordinates().names().collect();
    let squares = names.iter().enumerate().map(|(i, x)| format!("{x}^2/{}", i + 1));
    let mut text = squares.collect::<Vec<_>>().join(" + ");
    if let ([x, y, ..], true) = (names.as_slice(), other_terms) {
        text += &format!(" + {x}*{y}/9 + sin({x})/5 + exp({y}/4)");
    }
    FormulaSystem::new(algebra, &text, &Parameters::new())
}

fn start(system: &FormulaSystem) -> Vec<f64> {
    let all = [1.0, 0.4, -0.6, 0.6, 0.1, 0.8, -0.3, 0.2, 0.5, -0.7];
    all.into_iter().take(system.algebra().dimension()).collect()
}

fn after<K: ?Sized + AnyStart>(
    integrator: &AnyIntegrator<K>,
    start: &[f64],
    (step, steps): (f64, u64),
) -> Result<Vec<f64>, Box<dyn std::error::Error>> {
    Ok(integrator.after(&AnyState::from_slice(start), step, steps)?.momentum.as_slice().to_vec())
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn methods(system: &FormulaSystem) -> Vec<Method> {
    let schemes = [1, 2, 3, 5, 8].map(SchemeName::Gauss).into_iter();
    let schemes = schemes.chain([SchemeName::ImplicitMidpoint, SchemeName::Rk4]);
    let pairs = schemes.flat_map(|scheme| {
        [Formulation::Collective, Formulation::Reduced, Formulation::Direct].map(|f| (f, scheme))
    });
    pairs.filter_map(|(f, scheme)| system.algebra().method(f, scheme, 0.0).ok()).collect()
}

/// Each step adds a rounding error or two, which these motions of up to 8 rad magnify little.
fn require_steps_of_the_one_with_tangents(steps: u64) -> Outcome {
    for (name, other_terms) in ALGEBRAS.into_iter().flat_map(|name| [(name, false), (name, true)]) {
        let system = system(name, other_terms)?;
        let start = start(&system);
        for method in methods(&system) {
            let fast = system.integrator(&method, &start)?;
            let (found, expected) = (
                after(&fast, &start, (0.1, steps))?,
                after(&system.tangent_integrator(&method, &start)?, &start, (0.1, steps))?,
            );
            let apart = distance(&found, &expected);
            assert!(apart < 1e-12, "{name} {other_terms} {method:?}: {apart:e}");
            // Control: steps that are a millionth longer end elsewhere.
            assert!(distance(&after(&fast, &start, (0.1 + 1e-7, steps))?, &expected) > 1e-9);
        }
    }
    Ok(())
}

#[test]
fn the_fastest_integrator_makes_the_steps_of_the_one_with_tangents() -> Outcome {
    require_steps_of_the_one_with_tangents(10)
}

#[test]
#[ignore = "long"]
fn the_fastest_integrator_makes_long_runs_of_the_one_with_tangents() -> Outcome {
    require_steps_of_the_one_with_tangents(80)
}

/// Without a lift the reduced method is still there: Γ = 0, and no momentum at all.
#[test]
fn a_reduced_method_needs_no_lift() -> Outcome {
    let body = system("se(3)", false)?;
    let scheme = SchemeName::Gauss(4);
    let [reduced, collective] = [Formulation::Reduced, Formulation::Collective]
        .map(|formulation| body.algebra().method(formulation, scheme, 0.0));
    for start in [[1.0, 0.4, -0.6, 0.0, 0.0, 0.0], [0.0; 6]] {
        let end = after(
            &body.integrator(reduced.as_ref().map_err(Clone::clone)?, &start)?,
            &start,
            (0.1, 20),
        )?;
        let square = |mu: &[f64]| mu.iter().take(3).map(|x| x * x).sum::<f64>();
        assert!((square(&end) - square(&start)).abs() < 1e-14);
        let lifted = body.integrator(collective.as_ref().map_err(Clone::clone)?, &start)?;
        assert!(lifted.start(&AnyState::from_slice(&start)).is_err());
    }
    Ok(())
}

/// A method whose steps are found side by side is interrupted without a trace: forgetting makes the same bits.
#[test]
fn steps_after_forgetting_are_those_of_a_new_run() -> Outcome {
    use collective_integrators::Integrator;
    let body = system("se(3)", true)?;
    let start = start(&body);
    let method = body.algebra().method(Formulation::Collective, SchemeName::Gauss(8), 0.0)?;
    let integrator = body.integrator(&method, &start)?;
    let state = integrator.start(&AnyState::from_slice(&start))?;
    let (mut used, mut fresh) = (integrator.workspace(), integrator.workspace());
    let mut moved = state.clone();
    for _ in 0..20 {
        integrator.step_in_place(&mut moved, 0.1, &mut used)?;
    }
    integrator.forget(&mut used);
    let mut both = [moved.clone(), moved];
    for (state, workspace) in both.iter_mut().zip([&mut used, &mut fresh]) {
        for _ in 0..20 {
            integrator.step_in_place(state, 0.1, workspace)?;
        }
    }
    assert_eq!(both[0], both[1]);
    Ok(())
}
