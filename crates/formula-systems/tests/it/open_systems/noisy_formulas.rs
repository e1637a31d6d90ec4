//! Noise by formulas and at a temperature.

use super::support::{Texts, after, distance, method, open};
use collective_integrators::{
    AnyState, BrownianPaths, Integrator, NoiseRule, Noisy, RungeKutta, Start,
};
use lie_poisson::{
    Autonomous, Covector, DoubleBracket, InnerProduct, IsotropicNoise, LiePoisson, Pair,
    PathNumber, So3, Time, from_closure,
};
use momentum_map::HOPF;
use nalgebra::Vector3;

const BODY: &str = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2";

#[test]
fn noise_of_a_temperature_is_the_typed_one_on_every_path() {
    let start = [0.6, -0.5, 1.2];
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let texts = Texts { friction: Some(0.3), temperature: Some(0.5), rule, ..Texts::default() };
        let system = open("so(3)", BODY, &texts, 0.05).unwrap();
        let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| {
            (pi.x * pi.x + pi.y * pi.y * 0.5 + pi.z * pi.z * (1.0 / 3.0)) * 0.5
        });
        let (space, inner_product) = (LiePoisson::minus(So3), InnerProduct::euclidean());
        let field = DoubleBracket::new(space, Autonomous(h), 0.3, inner_product).unwrap();
        let noise = IsotropicNoise::thermal(InnerProduct::euclidean(), (0.3, 0.5)).unwrap();
        let paths = BrownianPaths::new(1, 0.05).unwrap();
        let typed =
            Noisy::new(RungeKutta::gauss(2).unwrap(), HOPF, field, noise, paths).with_rule(rule);
        for path in [0_u32, 7] {
            let from =
                Pair(Covector(Vector3::from(start)), Pair(PathNumber(f64::from(path)), Time(0.0)));
            let Pair(Covector(expected), _) = typed.after(&from, 0.05, 100).unwrap().momentum;
            let moved = system.clone().on_path(path.into());
            let found = after(&moved, ("collective", "gauss-4"), &start, 0.05, 100);
            assert!(
                distance(&found, expected.as_slice()) < 1e-12,
                "{rule:?} {path}: {found:?} {expected}"
            );
        }
        let [one, other] = [0, 1].map(|path| {
            after(&system.clone().on_path(path), ("collective", "gauss-4"), &start, 0.05, 100)
        });
        assert!(distance(&one, &other) > 1e-2);
    }
}

/// A spin that noise turns about e₃ alone turns by W(t).
#[test]
fn a_field_by_formulas_has_a_path_of_its_own() {
    let texts = Texts { noise: Some(vec![vec!["0", "0", "0.5"]]), ..Texts::default() };
    let spin = open("so(3)", "0*Pi3", &texts, 0.1).unwrap();
    let end = after(&spin, ("collective", "gauss-12"), &[1.0, 0.0, 0.0], 0.1, 20);
    let mut increment = [0.0];
    BrownianPaths::new(1, 0.1).unwrap().write_increments(0, 0.0, 20.0, &mut increment);
    let angle = -0.5 * increment[0];
    assert!((end[1].atan2(end[0]) - angle).abs() < 1e-9, "{end:?} {angle}");
}

/// A field that depends on the time alone turns the spin exactly, with its value in the middle of a step, on the momentum and
/// upstairs, where noise together turns it by the midpoint rule.
#[test]
fn fields_that_depend_on_the_time_alone_have_exact_flows() {
    let start = [1.0, 0.0, 0.0];
    let paths = BrownianPaths::new(1, 0.1).unwrap();
    // The second component is the coin.
    let increment = |n: u32| {
        let mut increments = [0.0; 2];
        paths.write_increments(0, f64::from(n), f64::from(n) + 1.0, &mut increments);
        0.5 * (0.1 * (f64::from(n) + 0.5)).cos() * increments[0]
    };
    let angle = -(0..20).map(increment).sum::<f64>();
    let error = |rule, formulation| {
        let noise = Some(vec![vec!["0", "0", "0.5*cos(t)"]]);
        let spin = open("so(3)", "0*Pi3", &Texts { noise, rule, ..Texts::default() }, 0.1).unwrap();
        let end = after(&spin, (formulation, "implicit-midpoint"), &start, 0.1, 20);
        (end[1].atan2(end[0]) - angle).abs()
    };
    for formulation in ["collective", "direct"] {
        // Twenty steps of some ten roundings.
        let exact = error(NoiseRule::Alternating, formulation);
        assert!(exact < 1e-14, "{formulation} {exact:e}");
        assert!(error(NoiseRule::Together, formulation) > 1e-6);
    }
}

fn require_casimirs(steps: u64) {
    let noise = |size: usize, texts: &[&'static str]| {
        let field = |i: usize| {
            (0..size).map(|j| if i == j { texts[i % texts.len()] } else { "0" }).collect()
        };
        (0..size).map(field).collect::<Vec<Vec<&'static str>>>()
    };
    for (algebra, h, start) in [
        ("so(3)", BODY, vec![0.6, -0.5, 1.2]),
        ("se(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2 + Gamma1", vec![0.6, -0.5, 1.2, 0.6, 0.0, 0.8]),
        ("so(4)", "L12^2 + L13^2/2 + L24^2/3", vec![0.4, -0.5, 0.3, 0.2, 0.6, -0.1]),
        (
            "so(5)",
            "L12^2 + L13^2/2 + L45^2/3",
            vec![0.4, -0.5, 0.3, 0.2, 0.6, -0.1, 0.1, 0.2, 0.3, 0.1],
        ),
    ] {
        for rule in [NoiseRule::Together, NoiseRule::Alternating] {
            let texts = Texts {
                noise: Some(noise(start.len(), &["0.3", "0.2"])),
                rule,
                ..Texts::default()
            };
            let system = open(algebra, h, &texts, 0.05).unwrap();
            let last = after(&system, ("collective", "implicit-midpoint"), &start, 0.05, steps);
            assert!(distance(&last, &start) > 0.1);
            for casimir in system.base().casimirs() {
                let [before, later] = [&start, &last].map(|mu| casimir.value_at(mu));
                assert!((later - before).abs() < 2e-13, "{algebra} {casimir}: {}", later - before);
            }
        }
        let texts = Texts { noise: Some(noise(start.len(), &["0.3"])), ..Texts::default() };
        let system = open(algebra, h, &texts, 0.05).unwrap();
        let control = after(&system, ("direct", "explicit-midpoint"), &start, 0.05, steps);
        let casimir = &system.base().casimirs()[0];
        assert!((casimir.value_at(&control) - casimir.value_at(&start)).abs() > 1e-6, "{algebra}");
    }
}

#[test]
fn noise_keeps_the_casimirs_of_every_algebra() {
    require_casimirs(300);
}

#[test]
#[ignore = "long"]
fn noise_keeps_the_casimirs_of_every_algebra_in_long_runs() {
    require_casimirs(2000);
}

/// One spin in a field: ⟨s₃⟩ = coth x − 1/x with x = B/kT. The means of 60 paths of 50 relaxation times each.
#[test]
#[ignore = "long"]
fn a_spin_at_a_temperature_has_langevins_mean() {
    let (field, temperature) = (1.0_f64, 0.5);
    let texts = Texts { friction: Some(1.0), temperature: Some(temperature), ..Texts::default() };
    let spin = open("so(3)", "-Pi3", &texts, 0.05).unwrap();
    let start = [1.0, 0.0, 0.0];
    let integrator =
        spin.tangent_integrator(&method(&spin, "collective", "gauss-4"), &start).unwrap();
    let means: Vec<f64> = (0..60)
        .map(|path| {
            let from = AnyState::from_slice(&start);
            let mut state = integrator.start(&from).unwrap();
            spin.move_path(state.as_mut_slice(), path);
            let run = integrator.trajectory_from(state, 0.05);
            let late = run.map(Result::unwrap).skip(200).step_by(20).take(40);
            late.map(|sample| sample.momentum.as_slice()[2]).sum::<f64>() / 40.0
        })
        .collect();
    let n = means.len() as f64;
    let mean = means.iter().sum::<f64>() / n;
    let error = (means.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n * (n - 1.0))).sqrt();
    let x = field / temperature;
    let exact = 1.0 / x.tanh() - 1.0 / x;
    assert!((mean - exact).abs() < 4.0 * error && error < 0.03, "{mean} ± {error} for {exact}");
    // Control: the mean of another temperature is far off.
    assert!((mean - (1.0 / (2.0 * x).tanh() - 0.5 / x)).abs() > 4.0 * error);
}

/// A torque −kΠ beside noise about e₃ alone: Π(t) = exp(−kt) R₃(W(t)) Π(0) on every path, in both rules.
#[test]
fn a_viscous_torque_shrinks_every_path_of_a_noise() {
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let torque = Some(vec!["-0.3*Pi1", "-0.3*Pi2", "-0.3*Pi3"]);
        let noise = Some(vec![vec!["0", "0", "0.5"]]);
        let braked = Texts { noise, torque, rule, ..Texts::default() };
        let spin = open("so(3)", "0*Pi3", &braked, 0.1).unwrap();
        assert!(!spin.keeps_casimirs());
        for path in [0, 5] {
            let end = after(
                &spin.clone().on_path(path),
                ("direct", "gauss-12"),
                &[1.0, 0.0, 0.5],
                0.1,
                20,
            );
            let mut increments = [0.0; 2];
            let count = if rule == NoiseRule::Together { 1 } else { 2 };
            let paths = BrownianPaths::new(1, 0.1).unwrap();
            paths.write_increments(path, 0.0, 20.0, &mut increments[..count]);
            let (angle, size) = (-0.5 * increments[0], (-0.6_f64).exp());
            let expected = [size * angle.cos(), size * angle.sin(), 0.5 * size];
            assert!(distance(&end, &expected) < 1e-11, "{rule:?} {path}: {end:?} {expected:?}");
        }
        // Control: without the torque the path has another length.
        let free = open("so(3)", "0*Pi3", &Texts { torque: None, ..braked }, 0.1).unwrap();
        let end = after(&free, ("direct", "gauss-12"), &[1.0, 0.0, 0.5], 0.1, 20);
        assert!(end.iter().map(|x| x * x).sum::<f64>() > 1.2);
    }
}

/// The noise σ Σ_k Π × e_k ∘ dW_k has the drift ½σ² Σ_k (Π × e_k) × e_k = −σ²Π in the sense of Itô, so that with the torque −kΠ and
/// a field along e₃ the mean is ⟨Π(t)⟩ = exp(−(k + σ²)t) R₃(Bt) Π(0). Of 4000 paths, to four standard errors. In a step s² = σ²h
/// the mean shrinks by (1 + 2(1 − s²) exp(−s²/2))/3 instead of exp(−s²), which is 1e-3 at the end.
#[test]
#[ignore = "long"]
fn a_viscous_torque_and_isotropic_noise_have_the_mean_of_itos_drift() {
    let isotropic = vec![vec!["0.7", "0", "0"], vec!["0", "0.7", "0"], vec!["0", "0", "0.7"]];
    let (torque, start) = (Some(vec!["-0.3*Pi1", "-0.3*Pi2", "-0.3*Pi3"]), [1.0, 0.0, 0.5]);
    let texts = Texts { noise: Some(isotropic), torque, ..Texts::default() };
    let spin = open("so(3)", "-2*Pi3", &texts, 0.05).unwrap();
    let integrator = spin.tangent_integrator(&method(&spin, "direct", "gauss-4"), &start).unwrap();
    let (count, mut sums, mut squares) = (1600, [0.0; 3], [0.0; 3]);
    for path in 0..count {
        let mut state = integrator.start(&AnyState::from_slice(&start)).unwrap();
        spin.move_path(state.as_mut_slice(), path);
        let end = integrator.after_from(state, 0.05, 20).unwrap().momentum;
        let length: f64 = end.as_slice().iter().map(|x| x * x).sum();
        // The torque alone changes the length, with the error (kh)⁵/720 of a half step of order 4, and rounding.
        assert!((length.sqrt() - 1.25_f64.sqrt() * (-0.3_f64).exp()).abs() < 1e-11, "{length}");
        for ((sum, square), x) in sums.iter_mut().zip(&mut squares).zip(end.as_slice()) {
            (*sum, *square) = (*sum + x, *square + x * x);
        }
    }
    let n = count as f64;
    let (sine, cosine) = 2.0_f64.sin_cos();
    for (i, turned) in [cosine, sine, 0.5].into_iter().enumerate() {
        let (mean, expected) = (sums[i] / n, (-0.3_f64 - 0.49).exp() * turned);
        let error = ((squares[i] / n - mean * mean) / n).sqrt();
        assert!((mean - expected).abs() < 4.0 * error, "{i}: {mean} ± {error}, not {expected}");
        // Control: neither the torque nor the noise alone has this mean.
        for rate in [0.3_f64, 0.49] {
            assert!(i != 1 || (mean - (-rate).exp() * turned).abs() > 8.0 * error, "{i} {rate}");
        }
    }
}

/// Beside a noise of the strength 0 a torque in time is that of the motion without noise, to the order 2 of the splitting.
#[test]
fn a_torque_in_time_beside_a_noise_has_the_order_of_the_splitting() {
    let torque = Some(vec!["sin(3*t) - 0.2*Pi1", "-0.1*Pi2", "cos(t)*Pi1"]);
    let start = [0.6, -0.5, 1.2];
    let end = |noise: Option<Vec<Vec<&'static str>>>, step: f64, steps: u64| {
        let texts = Texts { noise, torque: torque.clone(), ..Texts::default() };
        after(
            &open("so(3)", BODY, &texts, step).unwrap(),
            ("direct", "gauss-8"),
            &start,
            step,
            steps,
        )
    };
    let exact = end(None, 0.01, 200);
    let error = |step, steps| distance(&end(Some(vec![vec!["0"; 3]]), step, steps), &exact);
    let (long, short) = (error(0.1, 20), error(0.05, 40));
    assert!(short > 1e-6 && (3.8..4.2).contains(&(long / short)), "{long:e} {short:e}");
}

/// √(h Σ_k σ_k²) of the rotation that is the largest. Fields on each axis are isotropic noise.
#[test]
fn constant_fields_have_the_angle_of_their_noise() {
    let angle = |algebra: &str, h: &str, fields: Vec<Vec<&'static str>>| {
        let texts = Texts { noise: Some(fields), ..Texts::default() };
        let system = open(algebra, h, &texts, 0.04).unwrap();
        system.noise_angle(&vec![0.7; system.base().algebra().dimension()], -0.04)
    };
    let axes = || vec![vec!["0.5", "0", "0"], vec!["0", "0.5", "0"], vec!["0", "0", "0.5"]];
    for (fields, strength) in [
        (axes(), 0.5),
        (vec![vec!["0.3", "0", "0.1"], vec!["-0.4", "0", "0.2"]], 0.5),
        (vec![vec!["0", "0.5*cos(t)", "t"]], 0.5),
        (vec![vec!["0", "1e200", "0"], vec!["0", "1e200", "0"]], 2.0_f64.sqrt() * 1e200),
        (vec![vec!["0", "0", "0"]], 0.0),
    ] {
        let found = angle("so(3)", BODY, fields).unwrap();
        // Some roundings, relative to the angle.
        assert!((found - 0.2 * strength).abs() <= 1e-15 * strength, "{found:e} {strength:e}");
    }
    // Of se(3) the first three are rotations, and the others displacements.
    let moved = angle("se(3)", "Pi1^2", vec![vec!["0", "0.2", "0", "9", "9", "9"]]).unwrap();
    assert!((moved - 0.04).abs() < 1e-15);
    // Control: fields of coordinates, without a value, or of other algebras have none.
    assert_eq!(angle("so(3)", BODY, vec![vec!["Pi1", "0", "0"]]), None);
    assert_eq!(angle("so(3)", BODY, vec![vec!["1/t", "0", "0"]]), None);
    assert_eq!(angle("so(2,1)", "0", vec![vec!["0.5", "0", "0"]]), None);
}
