//! What forces supply to the conserved quantities of runs, and what methods add.

use crate::support::{experiment, noisy, pace};
use collective_integrators::diagnostics::Balance;
use collective_integrators::fitted_order;
use lie_poisson::{InputTable, Interpolation};
use lie_poisson_formula_systems::{
    Damping, NamedInputs, OpenNames, OpenSystem, OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::Parameters;
use lie_poisson_runs::{Experiment, Model, OpenTop, RunFailure};

/// What drives, damps and forces a body on so(3).
#[derive(Default)]
struct Forces<'a> {
    torque: Option<[&'a str; 3]>,
    friction: Option<f64>,
    input: Option<InputTable>,
}

/// Returns the run of a body.
fn run(
    hamiltonian: &str,
    forces: Forces<'_>,
    (formulation, scheme): (&str, &str),
    (step, end): (f64, f64),
) -> Experiment<OpenSystem> {
    let inputs = forces.input.into_iter().map(|table| ("u".to_owned(), table)).collect();
    let inputs = NamedInputs::new(inputs);
    let algebra = SystemAlgebra::named("so(3)").unwrap();
    let names = OpenNames::new(algebra, &inputs, Parameters::new()).unwrap();
    let (base, hamiltonian) = names.system(hamiltonian).unwrap();
    let torque = forces
        .torque
        .map(|texts| texts.iter().map(|text| names.formula("torque", text).unwrap()).collect());
    let inner_product = names.inner_product(None).unwrap();
    let damping =
        forces.friction.map(|friction| Damping::DoubleBracket { friction, inner_product });
    let terms = OpenTerms { inputs, hamiltonian, damping, torque, ..OpenTerms::default() };
    let model = OpenSystem::new(base.with_found_casimirs().unwrap(), terms, step).unwrap();
    let (formulation, scheme) = (formulation.parse().unwrap(), scheme.parse().unwrap());
    let method = model.method(formulation, scheme, 0.0).unwrap();
    let start = vec![0.6, -0.5, 1.2];
    Experiment { model, start, method, pace: pace(step, end, 1), attitude: false }
}

fn balances(run: &Experiment) -> Vec<Balance> {
    let found = run.balances(&|| true).unwrap().unwrap();
    found.into_iter().map(|(_, balance)| balance).collect()
}

const BRAKE: [&str; 3] = ["-0.1*Pi1", "-0.1*Pi2", "-0.1*Pi3"];
const BODY: &str = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2";

/// A ball in a viscous fluid: h and |Π|² decay as exp(−2kt).
#[test]
fn a_ball_loses_its_energy_in_closed_form() {
    let forces = Forces { torque: Some(BRAKE), ..Forces::default() };
    let ball = run("|Pi|^2/4", forces, ("direct", "gauss-8"), (0.1, 3.0));
    let found = balances(&ball);
    let square = 0.36 + 0.25 + 1.44;
    for (balance, first) in found.iter().zip([square / 4.0, square]) {
        let lost = first * ((-0.6_f64).exp() - 1.0);
        // Rounding errors of thirty steps.
        assert!((balance.change - lost).abs() < 1e-13 && (balance.supplied - lost).abs() < 1e-13);
        assert!(balance.defect < 1e-13, "{balance:?}");
    }
}

/// What the method adds vanishes with its order, and with the torque of the other sign it does not.
#[test]
fn what_a_method_adds_has_its_order() {
    let of = |scheme: &str, step: f64, of_rates: [&str; 3]| {
        let forces = |torque| Forces { torque: Some(torque), ..Forces::default() };
        let body = run(BODY, forces(["sin(t)", "-0.2*Pi2", "0"]), ("direct", scheme), (step, 2.0));
        let rates = run(BODY, forces(of_rates), ("direct", scheme), (step, 2.0));
        let state = collective_integrators::AnyState::from_slice(&body.start);
        let integrator = Model::integrator(&body.model, &body.method, &body.start).unwrap();
        let timed = lie_poisson_runs::TimedIntegrator::new(&integrator);
        let state = collective_integrators::Start::start(&integrator, &state).unwrap();
        let start = lie_poisson::Pair(state, lie_poisson::Time(0.0));
        let model = &rates.model;
        let values = |at: &lie_poisson_runs::TimedState| {
            vec![model.energy(at.0.as_slice(), at.1.0), at.0.as_slice().iter().map(|x| x * x).sum()]
        };
        let supplied = |at: &lie_poisson_runs::TimedState| {
            model.supplied_rates(at.0.as_slice(), at.1.0).unwrap()
        };
        let steps = (2.0 / step).round() as u64;
        let whole = |_| Some(vec![1.0]);
        Balance::all_of_run(&timed, start, (step, steps), (values, supplied), whole)
            .unwrap()
            .unwrap()
    };
    for (scheme, order) in [("rk4", 4.0), ("implicit-midpoint", 2.0), ("gauss-4", 4.0)] {
        for place in 0..2 {
            let own = ["sin(t)", "-0.2*Pi2", "0"];
            let errors = [0.2, 0.1, 0.05].map(|step| (step, of(scheme, step, own)[place].defect));
            let fitted = fitted_order(&errors, 0.0).unwrap();
            assert!((fitted - order).abs() < 0.5, "{scheme} {place}: {fitted} {errors:?}");
            let wrong = of(scheme, 0.05, ["-sin(t)", "0.2*Pi2", "0"])[place];
            assert!(wrong.defect > 0.1, "control: {wrong:?}");
        }
    }
    // The measure of a run is this one.
    let forces = Forces { torque: Some(["sin(t)", "-0.2*Pi2", "0"]), ..Forces::default() };
    let body = run(BODY, forces, ("direct", "rk4"), (0.1, 2.0));
    assert_eq!(balances(&body), of("rk4", 0.1, ["sin(t)", "-0.2*Pi2", "0"]));
}

/// At the pole of h = −cos t Π₃ the momentum rests, and h changes by ∂h/∂t alone. The breakpoints of inputs divide the quadrature.
#[test]
fn the_time_and_inputs_supply_energy() {
    let mut spin = run("-cos(t)*Pi3", Forces::default(), ("collective", "gauss-8"), (0.1, 2.0));
    spin.start = vec![0.0, 0.0, 1.5];
    let found = balances(&spin);
    let expected = 1.5 * (1.0 - 2.0_f64.cos());
    assert!((found[0].change - expected).abs() < 1e-13 && found[0].defect < 1e-13, "{found:?}");
    assert!(found[1].change.abs() < 1e-13 && found[1].supplied.abs() < 1e-13);
    let table =
        |between| InputTable::new(vec![0.0, 0.77, 1.23, 2.0], vec![1.0, 2.0, 0.5, 1.0], between);
    let linear = Forces {
        input: table(Interpolation::Linear).ok(),
        friction: Some(0.2),
        ..Forces::default()
    };
    let found = balances(&run("-u*Pi3 + Pi1^2/4", linear, ("collective", "gauss-8"), (0.1, 2.0)));
    assert!(found[0].change.abs() > 0.1 && found[0].defect < 1e-9, "{found:?}");
    // The torque jumps, and with it the rate of |Π|².
    let held = Forces {
        input: table(Interpolation::Constant).ok(),
        torque: Some(["0", "0", "u"]),
        ..Forces::default()
    };
    let found = balances(&run(BODY, held, ("direct", "gauss-8"), (0.1, 2.0)));
    assert!(found[1].change.abs() > 0.1 && found[1].defect < 1e-9, "{found:?}");
}

#[test]
fn a_top_that_is_braked_has_a_balance_of_its_casimirs() {
    let algebra = SystemAlgebra::named("se(3)").unwrap();
    let inputs = NamedInputs::default();
    let names = OpenNames::new(algebra, &inputs, Parameters::new()).unwrap();
    let (base, hamiltonian) = names.system("(Pi1^2 + Pi2^2 + Pi3^2/2)/2 + Gamma3").unwrap();
    let brake = ["-0.1*Pi1", "-0.1*Pi2", "-0.1*Pi3", "0", "0", "0"];
    let torque = brake.iter().map(|text| names.formula("torque", text).unwrap()).collect();
    let terms = OpenTerms { inputs, hamiltonian, torque: Some(torque), ..OpenTerms::default() };
    let system = OpenSystem::new(base.with_found_casimirs().unwrap(), terms, 0.1).unwrap();
    let method = system.method("direct".parse().unwrap(), "gauss-8".parse().unwrap(), 0.0).unwrap();
    let model = OpenTop { system, initial_attitude: None };
    let start = vec![0.2, 0.0, 1.5, 0.6, 0.0, 0.8];
    let top = Experiment { model, start, method, pace: pace(0.1, 3.0, 1), attitude: false };
    let found = top.balances(&|| true).unwrap().unwrap();
    let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["h", "f1", "f2"]);
    let [h, f1, f2] = [0, 1, 2].map(|i| found[i].1);
    // f2 = Π·Γ loses a tenth of itself in a unit of time, as every part of Π in space does of a viscous torque.
    let lost = (0.2 * 0.6 + 1.5 * 0.8) * ((-0.3_f64).exp() - 1.0);
    assert!((f2.change - lost).abs() < 1e-9 && (f2.supplied - lost).abs() < 1e-9, "{f2:?}");
    assert!(h.change < -0.1 && h.defect < 1e-9 && f1.change.abs() < 1e-12, "{h:?} {f1:?}");
}

#[test]
fn what_has_no_rates_has_no_balance() {
    let warm = noisy("so(3)", "-Pi3", pace(0.1, 1.0, 1));
    assert_eq!(warm.balances(&|| true).unwrap_err(), RunFailure::NoBalance);
    let top = experiment("collective", "gauss-4", pace(0.1, 1.0, 1));
    assert_eq!(top.balances(&|| true).unwrap_err(), RunFailure::NoBalance);
    let forces = || Forces { torque: Some(BRAKE), ..Forces::default() };
    let ball = run(BODY, forces(), ("direct", "gauss-4"), (0.1, 1.0));
    assert_eq!(ball.balances(&|| false), Ok(None));
    // After 1.5 there is no torque.
    let broken = Forces { torque: Some(["0", "0", "sqrt(1.5 - t)"]), ..Forces::default() };
    let broken = run(BODY, broken, ("direct", "rk4"), (0.1, 2.0));
    assert!(broken.balances(&|| true).is_err());
}
