//! The midpoint rule without a lift along paths of a noise by formulas.

use super::support::{self, Texts, distance, open};
use collective_integrators::{AnyState, Integrator, NoiseRule, Start};
use heavytop::methods::Formulation;
use lie_poisson::{InputTable, Interpolation, Quaternion};
use lie_poisson_formula_systems::OpenSystem;

const STEP: f64 = 0.05;

/// A body and a heavy top with their starts.
const SYSTEMS: [(&str, &str, &[f64]); 2] = [
    ("so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2", &[0.6, -0.5, 1.2]),
    ("se(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + Gamma1", &[0.6, -0.5, 1.2, 0.6, 0.0, 0.8]),
];

/// Returns systems at a temperature, and with a control by an input and noise by formulas of the state and the time.
fn systems(rule: NoiseRule) -> Vec<(OpenSystem, Vec<f64>)> {
    let made = SYSTEMS.iter().flat_map(|(algebra, h, start)| {
        let line = |first: &'static str| {
            let mut texts = vec!["0"; start.len()];
            texts[0] = first;
            texts
        };
        let warm = Texts { friction: Some(0.3), temperature: Some(0.2), rule, ..Texts::default() };
        let table =
            InputTable::new(vec![0.0, 0.52, 20.0], vec![0.0, 0.4, 0.1], Interpolation::Linear);
        let driven = Texts {
            inputs: vec![("u", table.unwrap())],
            drive: Some(line("u*Pi2")),
            noise: Some(vec![line("0.2*cos(t)"), line("0.1*Pi3")]),
            rule,
            ..Texts::default()
        };
        [warm, driven].map(|texts| (open(algebra, h, &texts, STEP).unwrap(), start.to_vec()))
    });
    made.collect()
}

/// Returns the momentum after some steps of the midpoint rule of a formulation with a tolerance.
fn after(
    system: &OpenSystem,
    (formulation, tolerance): (&str, f64),
    start: &[f64],
    steps: u64,
) -> Vec<f64> {
    let scheme = "implicit-midpoint".parse().unwrap();
    let method = system.method(formulation.parse().unwrap(), scheme, tolerance).unwrap();
    let integrator = system.tangent_integrator(&method, start).unwrap();
    let end = integrator.after(&AnyState::from_slice(start), STEP, steps).unwrap();
    end.momentum.as_slice().to_vec()
}

/// Returns the largest change of a Casimir.
fn change(system: &OpenSystem, start: &[f64], end: &[f64]) -> f64 {
    let casimirs = system.base().casimirs();
    assert!(!casimirs.is_empty());
    let change = |mu: [&[f64]; 2], i: usize| {
        (casimirs[i].value_at(mu[0]) - casimirs[i].value_at(mu[1])).abs()
    };
    (0..casimirs.len()).map(|i| change([start, end], i)).fold(0.0, f64::max)
}

#[test]
fn paths_are_those_of_the_lift() {
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        for (system, start) in systems(rule) {
            for path in [0, 7] {
                let system = system.clone().on_path(path);
                let [reduced, lifted] =
                    ["reduced", "collective"].map(|name| after(&system, (name, 0.0), &start, 60));
                // 60 steps, each with some roundings of each of its sweeps.
                assert!(
                    distance(&reduced, &lifted) < 1e-12,
                    "{rule:?} {path} {reduced:?} {lifted:?}"
                );
            }
            let [one, other] = [0, 1]
                .map(|path| after(&system.clone().on_path(path), ("reduced", 0.0), &start, 60));
            assert!(distance(&one, &other) > 1e-3);
        }
    }
}

/// The strength of the noise of Gilbert's damping depends on |s|, which is smaller in the middle of a step.
#[test]
fn paths_with_gilberts_damping_are_those_of_the_lift() {
    let start = [0.6, -0.5, 1.2];
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let warm = Texts { gilbert: Some(0.5), temperature: Some(0.5), rule, ..Texts::default() };
        let spin = open("so(3)", "-2*Pi3", &warm, STEP).unwrap();
        let [reduced, lifted] =
            ["reduced", "collective"].map(|name| after(&spin, (name, 0.0), &start, 60));
        // 60 steps, each with some roundings of each of its sweeps.
        assert!(distance(&reduced, &lifted) < 1e-12, "{rule:?} {reduced:?} {lifted:?}");
        assert!(change(&spin, &start, &reduced) < 5e-14);
    }
}

/// The stages of a step in which the motion turns by more than a radian take more than the 60 sweeps of other methods.
#[test]
fn long_steps_are_those_of_the_lift() {
    let (start, step) = ([1.0; 3], 1.2);
    let warm = Texts { friction: Some(0.1), temperature: Some(0.2), ..Texts::default() };
    let body = open("so(3)", "(Pi1^2/2 + Pi2^2/2 + Pi3^2)/2", &warm, step).unwrap();
    let [reduced, lifted] = ["reduced", "collective"]
        .map(|name| support::after(&body, (name, "implicit-midpoint"), &start, step, 10));
    assert!(distance(&reduced, &lifted) < 1e-12, "{reduced:?} {lifted:?}");
    assert!(change(&body, &start, &reduced) < 5e-14);
}

/// Motions with the plus bracket are those along −ξ, with noise, too.
#[test]
fn paths_with_the_plus_bracket_are_those_of_the_lift() {
    let (warm, start) = systems(NoiseRule::Together).swap_remove(0);
    let base = warm.base().clone().with_plus_bracket().unwrap();
    let plus = OpenSystem::new(base, warm.terms().clone(), STEP).unwrap();
    let [reduced, lifted] =
        ["reduced", "collective"].map(|name| after(&plus, (name, 0.0), &start, 60));
    assert!(distance(&reduced, &lifted) < 1e-12, "{reduced:?} {lifted:?}");
    let minus = after(&warm, ("reduced", 0.0), &start, 60);
    assert!(distance(&reduced, &minus) > 1e-2);
}

/// A tolerance of the stages is an error of the path, and none of the Casimirs. By the lift it is one of these, too.
#[test]
fn casimirs_are_kept_for_every_tolerance_of_the_stages() {
    for (system, start) in systems(NoiseRule::Together) {
        let exact = after(&system, ("reduced", 0.0), &start, 200);
        let mut errors = Vec::new();
        for tolerance in [1e-9, 1e-6, 1e-3] {
            let end = after(&system, ("reduced", tolerance), &start, 200);
            // Each of 200 steps has some roundings.
            assert!(change(&system, &start, &end) < 5e-14, "{tolerance}");
            errors.push(distance(&end, &exact));
        }
        // The errors of single steps add up, and motions that are not damped take them apart.
        assert!(errors[0] < 2e-7 && errors[1] < 2e-4 && errors[2] > 1e-6, "{errors:?}");
        let lifted = after(&system, ("collective", 1e-3), &start, 200);
        assert!(change(&system, &start, &lifted) > 1e-8);
    }
}

#[test]
fn runs_go_on_from_their_states_to_the_bit() {
    for (system, start) in systems(NoiseRule::Together) {
        let scheme = "implicit-midpoint".parse().unwrap();
        let method = system.method("reduced".parse().unwrap(), scheme, 1e-6).unwrap();
        let integrator = system.tangent_integrator(&method, &start).unwrap().without_tangents();
        let from = integrator.start(&AnyState::from_slice(&start)).unwrap();
        let run = |mut state: AnyState, steps: u64| {
            integrator.advance(&mut state, STEP, 0..steps, &mut integrator.workspace()).unwrap();
            state
        };
        let whole = run(from.clone(), 40);
        assert_eq!(run(run(from.clone(), 17), 23), whole);
        assert_eq!(
            (integrator.tangent_dimension(), integrator.states_are_momenta()),
            (start.len(), true)
        );
        // A member of an ensemble is the run on its path.
        let mut member = from;
        system.move_path(member.as_mut_slice(), 5);
        let member = integrator.momentum(&run(member, 40));
        let alone = after(&system.clone().on_path(5), ("reduced", 1e-6), &start, 40);
        assert_eq!(member.as_slice(), alone);
        assert_ne!(integrator.momentum(&whole).as_slice(), alone);
    }
}

#[test]
fn what_the_rule_cannot_follow_is_refused() {
    let (warm, start) = systems(NoiseRule::Together).swap_remove(0);
    let refused = |system: &OpenSystem, scheme: &str| {
        let method = system.method("reduced".parse().unwrap(), scheme.parse().unwrap(), 0.0);
        method.unwrap_err().to_string()
    };
    assert!(refused(&warm, "gauss-4").contains("reduced with implicit-midpoint alone"));
    let spins = Texts { temperature: Some(0.2), friction: Some(0.3), ..Texts::default() };
    let spins = open("so(3) + so(3)", "0", &spins, STEP).unwrap();
    assert!(refused(&spins, "implicit-midpoint").contains("collective and direct"));
    let names = |system: &OpenSystem| {
        let own = system.terms().formulations(system.base().algebra());
        own.into_iter().map(Formulation::name).collect::<Vec<_>>()
    };
    assert_eq!(names(&warm), ["collective", "reduced", "direct"]);
    assert_eq!(names(&spins), ["collective", "direct"]);
    let midpoint = "implicit-midpoint".parse().unwrap();
    let method = warm.method("reduced".parse().unwrap(), midpoint, 0.0).unwrap();
    let turned = warm.integrator_with_attitude(&method, &start, Quaternion::one());
    assert!(turned.unwrap_err().to_string().contains("attitude"));
    assert!(warm.tangent_integrator(&method, &start[..2]).is_err());
}
