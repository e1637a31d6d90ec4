//! Tops are followed by the fastest integrator of a method, which makes its steps.

use collective_integrators::{AnyIntegrator, AnyState, Integrator, Start};
use heavytop::HeavyTop;
use heavytop::methods::{Formulation, Method, SchemeName, attitude_of};
use lie_poisson::State;
use lie_poisson_runs::{Model, TopInAxes};

type Outcome = Result<(), Box<dyn std::error::Error>>;

const START: [f64; 6] = [2.0, 3.0, 4.0, 0.6, 0.0, 0.8];

/// Returns the momentum after 100 steps, and the last state.
fn end(
    integrator: &AnyIntegrator,
    start: &[f64],
    step: f64,
) -> Result<[AnyState; 2], Box<dyn std::error::Error>> {
    let end = integrator.after(&AnyState::from_slice(start), step, 100)?;
    Ok([end.momentum, end.state])
}

fn distance(a: &AnyState, b: &AnyState) -> f64 {
    a.as_slice().iter().zip(b.as_slice()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The methods whose name is not that of the fastest steps.
const METHODS: [(Formulation, SchemeName); 4] = [
    (Formulation::Reduced, SchemeName::Gauss(2)),
    (Formulation::Reduced, SchemeName::Gauss(8)),
    (Formulation::Collective, SchemeName::ImplicitMidpoint),
    (Formulation::Reduced, SchemeName::ImplicitMidpoint),
];

#[test]
fn a_top_takes_the_steps_of_its_method_and_turns_with_them() -> Outcome {
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    let model = TopInAxes::from(top);
    for (formulation, scheme) in METHODS {
        let method = Method::new(formulation, scheme, 0.0)?;
        let named = method.integrator(&top)?;
        let fast = model.integrator(&method, &START)?;
        let [expected, _] = end(&named, &START, 0.05)?;
        let apart = distance(&end(&fast, &START, 0.05)?[0], &expected);
        // 100 steps add some 100 rounding errors of momenta of size 5, which the motion magnifies little.
        assert!(apart < 1e-12, "{formulation} {scheme}: {apart:e}");
        assert!(distance(&end(&fast, &START, 0.05 + 1e-7)?[0], &expected) > 1e-6);

        let turned = method.integrator_with_attitude(&top)?.ok_or("no attitude")?;
        let fast = model.integrator_with_attitude(&method, &START)?;
        let [found, expected] = [end(&fast, &START, 0.05)?, end(&turned, &START, 0.05)?]
            .map(|[_, state]| attitude_of(state.as_slice()));
        let apart = (0..4)
            .map(|i| (found.coordinate(i) - expected.coordinate(i)).abs())
            .fold(0.0, f64::max);
        assert!(apart < 1e-12, "{formulation} {scheme}: {apart:e}");
    }
    Ok(())
}

/// Gauss's methods under `reduced` have the kernel of `collective`, unless Γ = 0 has no lift.
#[test]
fn only_a_start_with_a_lift_is_lifted() -> Outcome {
    let model = TopInAxes::from(HeavyTop::kovalevskaya(1.0, 1.0)?);
    let method = Method::new(Formulation::Reduced, SchemeName::Gauss(8), 0.0)?;
    let without = [2.0, 3.0, 4.0, 0.0, 0.0, 0.0];
    assert!(!model.integrator(&method, &START)?.states_are_momenta());
    let reduced = model.integrator(&method, &without)?;
    assert!(reduced.states_are_momenta());
    let mut state = reduced.start(&AnyState::from_slice(&without))?;
    reduced.step_in_place(&mut state, 0.1, &mut reduced.workspace())?;
    assert!(state.is_finite());
    Ok(())
}
