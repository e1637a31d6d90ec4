//! Hamiltonians with time, inputs and drives, damping.

use super::support::{Texts, after, distance, method, open};
use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyState, Driven, Integrator, RungeKutta, Start, fitted_order};
use lie_poisson::{
    Covector, InputTable, Interpolation, LiePoisson, OrbitField, Pair, Real, So3, Time,
};
use momentum_map::HOPF;
use nalgebra::Vector3;

/// dh for h = (Π₁² + Π₂²/2)/2 + sin(3t) Π₃ Π₁.
struct Shaken;

impl<T: Real> OrbitField<LiePoisson<So3>, T> for Shaken {
    fn element(&self, Covector(pi): &Covector<Vector3<T>>, t: T) -> Vector3<T> {
        let u = (t * 3.0).sin();
        Vector3::new(pi.x + u * pi.z, pi.y * 0.5, u * pi.x)
    }
}

const SHAKEN: &str = "(Pi1^2 + Pi2^2/2)/2 + sin(3*t)*Pi3*Pi1";

#[test]
fn a_formula_with_time_is_the_typed_field() {
    let start = [0.6, -0.5, 1.2];
    let system = open("so(3)", SHAKEN, &Texts::default(), 0.1).unwrap();
    let typed = Driven::new(RungeKutta::gauss(2).unwrap(), HOPF, Shaken);
    let from = Pair(Covector(Vector3::from(start)), Time(0.0));
    let Pair(Covector(expected), _) = typed.after(&from, 0.1, 200).unwrap().momentum;
    let found = after(&system, ("collective", "gauss-4"), &start, 0.1, 200);
    // 200 steps of some roundings each.
    assert!(distance(&found, expected.as_slice()) < 1e-12, "{found:?} {expected}");
    // A frozen Hamiltonian is another motion.
    let frozen = after(
        &open("so(3)", "(Pi1^2 + Pi2^2/2)/2", &Texts::default(), 0.1).unwrap(),
        ("collective", "gauss-4"),
        &start,
        0.1,
        200,
    );
    assert!(distance(&found, &frozen) > 0.1);
}

#[test]
fn methods_have_their_orders_and_keep_the_casimirs() {
    require_orders_and_casimirs(&["so(3)"]);
}

#[test]
#[ignore = "long"]
fn methods_have_their_orders_on_every_algebra_and_keep_its_casimirs() {
    require_orders_and_casimirs(&["se(3)", "so(4)", "se(2)"]);
}

/// Checks that collective methods have their orders on some algebras, and that steps keep the Casimirs.
fn require_orders_and_casimirs(algebras: &[&str]) {
    let texts = Texts { friction: Some(0.1), ..Texts::default() };
    let weighted = |diagonal: &[f64]| {
        let size = diagonal.len();
        let mut rows = vec![0.0; size * size];
        rows.iter_mut().step_by(size + 1).zip(diagonal).for_each(|(x, entry)| *x = *entry);
        Texts { product: Some(rows), ..texts.clone() }
    };
    let so4 = "L12^2 + L13^2/2 + L24^2/3 + cos(2*t)*L34";
    let se3 = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + (1 + cos(2*t)/2)*Gamma1";
    let se2 = "Pi^2/2 + cos(2*t)*Gamma1";
    let mut tried = 0;
    for (algebra, h, texts, start) in [
        ("so(3)", SHAKEN, texts.clone(), vec![0.6, -0.5, 1.2]),
        (
            "se(3)",
            se3,
            weighted(&[1.0, 1.0, 1.0, 0.5, 0.5, 0.5]),
            vec![0.6, -0.5, 1.2, 0.6, 0.0, 0.8],
        ),
        ("so(4)", so4, texts.clone(), vec![0.4, -0.5, 0.3, 0.2, 0.6, -0.1]),
        ("se(2)", se2, weighted(&[1.0, 0.5, 0.5]), vec![0.7, 0.6, 0.8]),
    ] {
        if !algebras.contains(&algebra) {
            continue;
        }
        tried += 1;
        let end = |scheme: &str, steps: u32| {
            let step = 2.0 / f64::from(steps);
            let system = open(algebra, h, &texts, step).unwrap();
            after(&system, ("collective", scheme), &start, step, steps.into())
        };
        let exact = end("gauss-12", 160);
        for (scheme, order) in [("implicit-midpoint", 2.0), ("gauss-4", 4.0), ("gauss-6", 6.0)] {
            let error =
                |steps: u32| (2.0 / f64::from(steps), distance(&end(scheme, steps), &exact));
            let fitted = fitted_order(&[20, 40, 80].map(error), 0.0).unwrap();
            assert!((fitted - order).abs() < 0.3, "{algebra} {scheme}: {fitted}");
        }
        let system = open(algebra, h, &texts, 0.1).unwrap();
        let last = after(&system, ("collective", "gauss-4"), &start, 0.1, 10_000);
        let explicit = after(&system, ("direct", "explicit-midpoint"), &start, 0.1, 1000);
        for casimir in system.base().casimirs() {
            let [before, later, control] =
                [&start, &last, &explicit].map(|mu| casimir.value_at(mu));
            // Of 10⁴ steps.
            assert!((later - before).abs() < 3e-13, "{algebra} {casimir}: {}", later - before);
            assert!((control - before).abs() > 1e-6, "{algebra} {casimir}");
        }
    }
    assert_eq!(tried, algebras.len());
}

#[test]
fn a_drive_adds_to_the_differential() {
    let start = [0.6, -0.5, 1.2];
    let texts =
        Texts { drive: Some(vec!["sin(3*t)*Pi3", "0", "sin(3*t)*Pi1"]), ..Texts::default() };
    let driven = open("so(3)", "(Pi1^2 + Pi2^2/2)/2", &texts, 0.1).unwrap();
    let shaken = open("so(3)", SHAKEN, &Texts::default(), 0.1).unwrap();
    let [one, other] =
        [&driven, &shaken].map(|system| after(system, ("collective", "gauss-8"), &start, 0.1, 100));
    assert!(distance(&one, &other) < 1e-12);
    assert!(!driven.keeps_energy() && driven.keeps_casimirs());
    assert!(
        (shaken.energy(&start, 0.5) - driven.energy(&start, 0.5) - 1.5_f64.sin() * 0.72).abs()
            < 1e-15
    );
}

/// A spin that turns about e₃ by an input alone turns by its integral.
#[test]
fn steps_end_where_an_input_jumps() {
    let pulses = InputTable::new(
        vec![0.0, 0.25, 1.0, 2.0],
        vec![1.0, -2.0, 3.0, 0.0],
        Interpolation::Constant,
    )
    .unwrap();
    let texts = Texts { inputs: vec![("u", pulses)], ..Texts::default() };
    let spin = open("so(3)", "u*Pi3", &texts, 0.4).unwrap();
    // dΠ/dt = Π × u e₃: Π turns by −∫u.
    let angle = -(0.25 - 2.0 * 0.75 + 3.0);
    let end = after(&spin, ("collective", "gauss-8"), &[1.0, 0.0, 0.0], 0.4, 5);
    let error = (end[1].atan2(end[0]) - angle).abs();
    // Gauss's method of order 8 turns a spinor by the Padé approximant (4, 4) of a phase x, whose error is 3.9e-8 x⁹. The largest
    // part of a step turns the spin by 2x = 1.2 rad, and there are seven parts.
    assert!(error < 1e-8, "{error}");
    // At the order of the method, although no step is as short as the pulses are.
    let errors = [0.4, 0.2, 0.1].map(|step| {
        let spin = open("so(3)", "u*Pi3", &texts, step).unwrap();
        let end = after(
            &spin,
            ("collective", "gauss-4"),
            &[1.0, 0.0, 0.0],
            step,
            (2.0 / step).round() as u64,
        );
        (step, (end[1].atan2(end[0]) - angle).abs())
    });
    let fitted = fitted_order(&errors, 0.0).unwrap();
    assert!((fitted - 4.0).abs() < 0.5, "{fitted}");
    assert!(
        spin.terms().inputs.require_until(2.0).is_ok()
            && spin.terms().inputs.require_until(2.1).is_err()
    );
}

/// h = −Π₃ with friction θ: d(Π₃)/dt = θ(1 − Π₃²).
#[test]
fn damping_has_its_closed_form_in_all_units() {
    for scale in [1e-30, 1.0, 1e30] {
        // Momenta in a unit, and the friction in its inverse.
        let texts = Texts { friction: Some(0.5 / scale), ..Texts::default() };
        let spin = open("so(3)", "-Pi3", &texts, 0.1).unwrap();
        let end = after(&spin, ("collective", "gauss-8"), &[scale, 0.0, 0.0], 0.1, 100);
        assert!((end[2] / scale - 5.0_f64.tanh()).abs() < 1e-11, "{end:?}");
        // And times in a unit.
        let texts = Texts { friction: Some(0.5 * scale), ..Texts::default() };
        let h = format!("-{scale:e}*Pi3");
        let texts = Texts { friction: Some(0.5), ..texts };
        let spin = open("so(3)", &h, &texts, 0.1 / scale).unwrap();
        let end = after(&spin, ("collective", "gauss-8"), &[1.0, 0.0, 0.0], 0.1 / scale, 100);
        assert!((end[2] - 5.0_f64.tanh()).abs() < 1e-11, "{end:?}");
    }
}

/// Times are whole numbers of intervals, to the bit, so that they do not drift and lifts are renewed when they should.
#[test]
fn the_clock_counts_whole_intervals() {
    require_whole_intervals(&["implicit-midpoint", "suzuki-4"]);
}

#[test]
#[ignore = "long"]
fn the_clock_of_every_scheme_counts_whole_intervals() {
    require_whole_intervals(&["gauss-6", "gauss-8", "gauss-16", "rk4"]);
}

/// Checks the clock after many steps of some schemes.
fn require_whole_intervals(schemes: &[&str]) {
    let noise = Texts { noise: Some(vec![vec!["0.1", "0", "0.2"]]), ..Texts::default() };
    for (texts, step) in [(Texts::default(), 0.1), (noise, 0.3)] {
        for scheme in schemes {
            let spin = open("so(3)", SHAKEN, &texts, step).unwrap();
            let start = AnyState::from_slice(&[0.6, -0.5, 1.2]);
            let method = method(&spin, "collective", scheme);
            let integrator = spin.tangent_integrator(&method, start.as_slice()).unwrap();
            let end = integrator.trajectory(&start, step).unwrap().nth(1500).unwrap().unwrap();
            let clock = end.state.as_slice().last().copied().unwrap();
            assert_eq!(clock, 1500.0, "{scheme}");
        }
    }
}

#[test]
fn a_run_that_is_resumed_is_the_same_one() {
    let field = vec!["0.1", "0", "0.2", "0", "0", "0.1"];
    let noise = Texts { noise: Some(vec![field]), ..Texts::default() };
    resumed_is_the_same(&Texts::default());
    resumed_is_the_same(&noise);
}

fn resumed_is_the_same(texts: &Texts) {
    let h = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + cos(t)*Gamma1";
    let system = open("se(3)", h, texts, 0.1).unwrap();
    let start = AnyState::from_slice(&[0.6, -0.5, 1.2, 0.6, 0.0, 0.8]);
    let integrator = system
        .tangent_integrator(&method(&system, "collective", "gauss-6"), start.as_slice())
        .unwrap();
    let run = |from: Option<(AnyState, u64)>, last: u64| {
        let trajectory = match from {
            None => integrator.trajectory(&start, 0.1).unwrap(),
            Some((state, made)) => integrator.trajectory_resumed(state, made, 0.1),
        };
        let mut end = None;
        for sample in trajectory {
            let sample = sample.unwrap();
            let is_last = sample.step == last;
            end = Some(sample.state.clone());
            if is_last {
                break;
            }
        }
        end.unwrap()
    };
    let middle = run(None, 1024);
    assert_eq!(run(Some((middle, 1024)), 2100), run(None, 2100));
}

/// A spin at rest until a pulse turns it by 30 rad/s, and one that a drive turns.
#[test]
fn the_fastest_rate_knows_pulses_and_drives() {
    let pulse = InputTable::new(
        vec![0.0, 4.0, 5.0, 9.0],
        vec![0.0, 30.0, 0.0, 0.0],
        Interpolation::Constant,
    );
    let texts = Texts { inputs: vec![("u", pulse.unwrap())], ..Texts::default() };
    let rate = |hamiltonian: &str, texts: &Texts| {
        open("so(3)", hamiltonian, texts, 0.01).unwrap().fastest_rate(&[0.6, 0.0, 0.8])
    };
    assert!((rate("-u*Pi3", &texts) / 30.0 - 1.0).abs() < 1e-3);
    // A run backward in time meets a pulse before 0.
    let before =
        InputTable::new(vec![-5.0, -4.0, 1.0], vec![20.0, 0.0, 0.0], Interpolation::Constant);
    let texts = Texts { inputs: vec![("u", before.unwrap())], ..Texts::default() };
    assert!((rate("-u*Pi3", &texts) / 20.0 - 1.0).abs() < 1e-3);
    let driven = Texts { drive: Some(vec!["0", "7", "0"]), ..Texts::default() };
    assert!((rate("0*Pi3", &driven) / 7.0 - 1.0).abs() < 1e-3);
    // Control: without them nothing turns.
    assert_eq!(rate("0*Pi3", &Texts::default()), 0.0);
    assert!(open("so(3)", "0*Pi3", &driven, 0.01).unwrap().fastest_rate(&[1.0]).is_nan());
}
