//! Bodies with reaction wheels by name: exchanges of momentum by hand, the compiled body, the power of the motors, and satellites with
//! wheels.

use crate::open_systems::support::{after, distance, method};
use collective_integrators::{AnyState, Driven, RungeKutta, Start};
use lie_poisson::{Covector, Pair, Real, Time, TimeDependent};
use lie_poisson_formula_systems::{
    FormulaSystemError, NamedInputs, OpenNames, OpenSystem, OpenTerms, SystemKind,
};
use lie_poisson_formulas::Parameters;
use lie_poisson_systems::{ReactionWheels, WheelMomenta};
use momentum_map::HOPF;
use nalgebra::{Matrix3, Vector3};

const INERTIA: [f64; 3] = [3.0, 2.0, 1.5];

/// Two wheels, of which one is along a principal axis; the other one has the unit vector (0.6, 0, 0.8).
const AXES: [f64; 6] = [0.0, 1.0, 0.0, 3.0, 0.0, 4.0];
const TILTED: [f64; 3] = [0.6, 0.0, 0.8];
const MOMENTS: [f64; 2] = [0.1, 0.05];

fn given() -> Parameters {
    let given = Parameters::new().vector("I", &INERTIA).unwrap().vector("axes", &AXES).unwrap();
    given.vector("J", &MOMENTS).unwrap()
}

fn start(kind: &str, parameters: &Parameters, given: &[(&str, &[f64])]) -> Vec<f64> {
    let values = given.iter().fold(Parameters::new(), |all, (name, values)| match *values {
        [one] => all.number(name, *one).unwrap(),
        values => all.vector(name, values).unwrap(),
    });
    let kind = SystemKind::named(kind).unwrap();
    kind.coordinates(parameters, &values).unwrap().unwrap()
}

/// Returns the body of a kind whose motors exert these torques on their wheels, for steps of a size.
fn driven(
    kind: &str,
    parameters: Parameters,
    motors: [&str; 2],
    step: f64,
) -> Result<OpenSystem, FormulaSystemError> {
    let (kind, inputs) = (SystemKind::named(kind)?, NamedInputs::default());
    let (base, names, hamiltonian) = OpenNames::of_kind(kind, parameters, &inputs, None)?;
    let torque = names.element("torque", [("l", motors.map(String::from).to_vec())])?;
    let terms = OpenTerms { hamiltonian, torque: Some(torque), inputs, ..OpenTerms::default() };
    Ok(OpenSystem::new(base, terms, step)?)
}

fn squared(pi: &[f64]) -> f64 {
    pi.iter().map(|x| x * x).sum()
}

/// A motor takes up the spin about its axis: Ω₂ = (Π₂ − l)/I₂, l = l(0) + ut, with Π₂ = (I₂ + J₁) Ω₂(0) at the start.
#[test]
fn a_motor_exchanges_momentum_with_the_body() {
    let at = start("reaction-wheels", &given(), &[("Omega", &[0.0, 0.5, 0.0])]);
    // Both wheels turn with the body: l = J a·Ω.
    assert_eq!(at, [0.0, 2.0 * 0.5 + 0.1 * 0.5, 0.0, 0.05, 0.0]);
    let body = driven("reaction-wheels", given(), ["0.2", "0"], 0.1).unwrap();
    let end = after(&body, ("direct", "gauss-4"), &at, 0.1, 50);
    let expected = [0.0, 1.05, 0.0, 0.05 + 0.2 * 5.0, 0.0];
    // The motion is linear in the time, so that each step is exact.
    assert!(distance(&end, &expected) < 1e-14, "{end:?}");
    // Motors change the l, of which the second one has none here, and keep |Π|²; a torque on the body changes that.
    let casimirs = body.base().casimirs();
    let texts: Vec<String> = casimirs.iter().map(ToString::to_string).collect();
    assert_eq!(texts, ["l1", "l2", "|Pi|^2"]);
    let kept = |body: &OpenSystem| -> Vec<bool> {
        casimirs.iter().map(|casimir| body.keeps_casimir(casimir)).collect()
    };
    assert_eq!(kept(&body), [false, true, true]);
    assert!(!body.keeps_casimirs());
    let pushed = OpenTerms {
        torque: body.terms().torque.clone().map(|all| all.into_iter().rev().collect()),
        ..body.terms().clone()
    };
    let pushed = OpenSystem::new(body.base().clone(), pushed, 0.1).unwrap();
    assert_eq!(kept(&pushed), [true, true, false]);
    // The body has come to rest: (1.05 − 1.05)/I₂.
    assert!((end[1] - end[3]).abs() < 1e-14);
    // The speed of a wheel against the body is one of a start, too.
    let spun = start("reaction-wheels", &given(), &[("speeds", &[10.0, -4.0])]);
    let expected = [0.6 * -0.2, 1.0, 0.8 * -0.2, 1.0, -0.2];
    assert!(distance(&spun, &expected) < 1e-15, "{spun:?}");
}

/// The angular momenta of wheels that the motors change at steady rates.
struct Steady([f64; 2], [f64; 2]);

impl WheelMomenta<2> for Steady {
    fn momenta<T: Real>(&self, time: T) -> [T; 2] {
        core::array::from_fn(|k| time * self.1[k] + self.0[k])
    }
}

#[test]
fn the_motion_is_that_of_the_compiled_body_and_keeps_its_momentum() {
    let at = start(
        "reaction-wheels",
        &given(),
        &[("Omega", &[0.5, -0.7, 0.3]), ("speeds", &[3.0, 1.0])],
    );
    let torques = [0.03, -0.05];
    let axes = [Vector3::y(), TILTED.into()];
    let wheels = Steady([at[3], at[4]], torques);
    let compiled = ReactionWheels::new(INERTIA.into(), axes, wheels).unwrap();
    let gauss = Driven::new(RungeKutta::gauss(4).unwrap(), HOPF, TimeDependent(&compiled));
    let from = Pair(Covector(Vector3::new(at[0], at[1], at[2])), Time(0.0));
    let Covector(expected) = gauss.after(&from, 0.05, 200).unwrap().momentum.0;
    let end = |motors: [&str; 2]| {
        let body = driven("reaction-wheels", given(), motors, 0.05).unwrap();
        after(&body, ("direct", "gauss-8"), &at, 0.05, 200)
    };
    let found = end(["0.03", "-0.05"]);
    assert!(distance(&found[..3], expected.as_slice()) < 1e-11, "{found:?} {expected}");
    // |Π| is the angular momentum against the stars, which motors inside do not change.
    assert!((squared(&found[..3]) - squared(&at[..3])).abs() < 1e-13);
    // Control: motors that turn the other way.
    assert!(distance(&end(["-0.03", "0.05"])[..3], expected.as_slice()) > 0.1);
}

/// The motors do the work Σ u_k (l_k/J_k − a_k·Ω), here by a law of control that brakes the body.
#[test]
fn the_energy_is_the_work_of_the_motors() {
    let at = start(
        "reaction-wheels",
        &given(),
        &[("Omega", &[0.5, -0.7, 0.3]), ("speeds", &[3.0, 1.0])],
    );
    let (step, steps) = (0.02, 200);
    let law = ["0.4*(Pi2 - l1)/I2 + 0.05*sin(t)", "0.02*Pi1"];
    let body = driven("reaction-wheels", given(), law, step).unwrap();
    let integrator = body.tangent_integrator(&method(&body, "direct", "gauss-6"), &at).unwrap();
    let run = integrator.trajectory(&AnyState::from_slice(&at), step).unwrap();
    let samples: Vec<_> = run.take(steps + 1).map(Result::unwrap).collect();
    let power = |t: f64, mu: &[f64], reaction: f64| {
        let l = [mu[3], mu[4]];
        let q = [mu[0] - 0.6 * l[1], mu[1] - l[0], mu[2] - 0.8 * l[1]];
        let omega: Vec<f64> = q.iter().zip(INERTIA).map(|(q, i)| q / i).collect();
        let motors = [0.4 * (mu[1] - l[0]) / INERTIA[1] + 0.05 * t.sin(), 0.02 * mu[0]];
        let along = [omega[1], 0.6 * omega[0] + 0.8 * omega[2]];
        (0..2).map(|k| motors[k] * (l[k] / MOMENTS[k] - reaction * along[k])).sum::<f64>()
    };
    let work = |reaction: f64| {
        let all = samples.iter().map(|s| power(s.time, s.momentum.as_slice(), reaction));
        let all: Vec<f64> = all.collect();
        let panels = all.windows(3).step_by(2);
        panels.map(|p| step / 3.0 * (p[0] + 4.0 * p[1] + p[2])).sum::<f64>()
    };
    let h = |i: usize| body.energy(samples[i].momentum.as_slice(), samples[i].time);
    let gained = h(steps) - h(0);
    // Simpson's rule: rates of about 1/s, 0.02⁴/180 of 4 s.
    assert!((work(1.0) - gained).abs() < 1e-8 && gained.abs() > 0.01, "{} {gained}", work(1.0));
    // Control: without the reaction on the body.
    assert!((work(0.0) - gained).abs() > 1e-3, "{}", work(0.0));
}

/// dΠ/dt = Π × Ω + 3n² Γ₁ × I′Γ₁ with the moments of the wheels in I′ = I + Σ J_k a_k a_kᵀ.
#[test]
fn the_tide_acts_on_the_wheels_too() {
    let rate = 0.7;
    let parameters = given().number("n", rate).unwrap();
    let turned: [(&str, &[f64]); 4] =
        [("roll", &[0.3]), ("pitch", &[-0.4]), ("yaw", &[0.2]), ("relative", &[0.1, 0.2, -0.3])];
    let mu = start("satellite", &parameters, &turned);
    let part = |i: usize| Vector3::new(mu[i], mu[i + 1], mu[i + 2]);
    let (pi, radial, normal) = (part(0), part(3), part(6));
    let axes = [Vector3::y(), Vector3::from(TILTED)];
    let inertia = Matrix3::from_diagonal(&INERTIA.into());
    let whole = (0..2).fold(inertia, |sum, k| sum + axes[k] * axes[k].transpose() * MOMENTS[k]);
    // The wheels are at rest in the body: Π = I′Ω.
    let omega = Vector3::new(0.1, 0.2, -0.3) + normal * rate;
    assert!((pi - whole * omega).amax() < 1e-15);
    let rates = |inertia: Matrix3<f64>| {
        let torque = pi.cross(&omega) + radial.cross(&(inertia * radial)) * (3.0 * rate * rate);
        let relative = omega - normal * rate;
        let parts = [torque, radial.cross(&relative), normal.cross(&relative)];
        let all: Vec<f64> = parts.iter().flatten().copied().chain([0.01, -0.02]).collect();
        all
    };
    let satellite = driven("satellite", parameters, ["0.01", "-0.02"], 0.1).unwrap();
    let found = satellite.rate(&mu, 0.0).unwrap();
    assert!(distance(&found, &rates(whole)) < 1e-14, "{found:?}");
    // Control: without the moments about the axes.
    assert!(distance(&found, &rates(inertia)) > 1e-3);
    // On an ellipse at its pericentre, the rate and the tide are larger.
    let ellipse = given().number("n", rate).unwrap().number("eccentricity", 0.2).unwrap();
    let orbit = SystemKind::named("satellite").unwrap().orbit(&ellipse).unwrap().unwrap();
    let faster = start("satellite", &ellipse, &turned);
    let spin = whole * normal * (orbit.rate(0.0) - rate);
    assert!((Vector3::new(faster[0], faster[1], faster[2]) - pi - spin).amax() < 1e-15);
}

#[test]
fn wrong_wheels_are_refused_by_name() {
    let body = || Parameters::new().vector("I", &INERTIA).unwrap();
    for (kind, axes, moments, message) in [
        (
            "reaction-wheels",
            &AXES[..5],
            &MOMENTS[..],
            "axes must be three numbers for each wheel, got 5",
        ),
        (
            "reaction-wheels",
            &AXES,
            &[0.1, 0.1, 0.1],
            "J must be a number for each of 2 axes, got 3",
        ),
        ("reaction-wheels", &AXES, &[0.1, -0.1], "J must be positive, got -0.1"),
        ("reaction-wheels", &[0.0; 6], &[0.1, 0.1], "axes must be of a length that is not 0"),
        ("satellite", &AXES[..4], &MOMENTS, "axes must be three numbers for each wheel, got 4"),
    ] {
        let given = body().vector("axes", axes).unwrap().vector("J", moments).unwrap();
        let given = if kind == "satellite" { given.number("n", 1.0).unwrap() } else { given };
        let error = driven(kind, given, ["0", "0"], 0.1).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
    let lonely = body().number("n", 1.0).unwrap().vector("J", &MOMENTS).unwrap();
    let error = driven("satellite", lonely, ["0", "0"], 0.1).unwrap_err().to_string();
    assert!(error.contains("J must be a number for each of 0 axes"), "{error}");
    let alone = body().number("n", 1.0).unwrap().number("J", 0.1).unwrap();
    let error = driven("satellite", alone, ["0", "0"], 0.1).unwrap_err().to_string();
    assert!(error.contains("axes must be given where there is J"), "{error}");
    // Each wheel has a motor, and a speed.
    let names = driven("reaction-wheels", given(), ["0", "Omega"], 0.1).unwrap_err().to_string();
    assert!(names.contains("torque l2"), "{names}");
    let kind = SystemKind::named("reaction-wheels").unwrap();
    let speeds = Parameters::new().vector("speeds", &[1.0, 2.0, 3.0]).unwrap();
    let error = kind.coordinates(&given(), &speeds).unwrap().unwrap_err().to_string();
    assert!(error.contains("speeds must be a number for each of 2 wheels, got 3"), "{error}");
}
