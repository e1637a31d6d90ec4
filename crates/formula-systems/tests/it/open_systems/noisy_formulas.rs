//! Noise by formulas and at a temperature.

use super::support::{Texts, after, distance, method, open};
use collective_integrators::{
    AnyState, BrownianPaths, Integrator, NoiseRule, Noisy, RungeKutta, Start,
};
use lie_poisson::{
    Autonomous, Covector, DoubleBracket, InnerProduct, IsotropicNoise, LiePoisson, Pair, So3,
    from_closure,
};
use momentum_map::HOPF;
use nalgebra::{Vector1, Vector3};

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
            let from = Pair(
                Covector(Vector3::from(start)),
                Pair(Vector1::new(f64::from(path)), Vector1::new(0.0)),
            );
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

#[test]
fn noise_keeps_the_casimirs_of_every_algebra() {
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
            let last = after(&system, ("collective", "implicit-midpoint"), &start, 0.05, 2000);
            assert!(distance(&last, &start) > 0.1);
            for casimir in system.base().casimirs() {
                let [before, later] = [&start, &last].map(|mu| casimir.value_at(mu));
                assert!((later - before).abs() < 2e-13, "{algebra} {casimir}: {}", later - before);
            }
        }
        let texts = Texts { noise: Some(noise(start.len(), &["0.3"])), ..Texts::default() };
        let system = open(algebra, h, &texts, 0.05).unwrap();
        let control = after(&system, ("direct", "explicit-midpoint"), &start, 0.05, 2000);
        let casimir = &system.base().casimirs()[0];
        assert!((casimir.value_at(&control) - casimir.value_at(&start)).abs() > 1e-6, "{algebra}");
    }
}

/// One spin in a field: ⟨s₃⟩ = coth x − 1/x with x = B/kT. The means of 400 paths of 50 relaxation times each.
#[test]
fn a_spin_at_a_temperature_has_langevins_mean() {
    let (field, temperature) = (1.0_f64, 0.5);
    let texts = Texts { friction: Some(1.0), temperature: Some(temperature), ..Texts::default() };
    let spin = open("so(3)", "-Pi3", &texts, 0.05).unwrap();
    let start = [1.0, 0.0, 0.0];
    let integrator =
        spin.tangent_integrator(&method(&spin, "collective", "gauss-4"), &start).unwrap();
    let means: Vec<f64> = (0..100)
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
    assert!((mean - exact).abs() < 4.0 * error && error < 0.02, "{mean} ± {error} for {exact}");
    // Control: the mean of another temperature is far off.
    assert!((mean - (1.0 / (2.0 * x).tanh() - 0.5 / x)).abs() > 4.0 * error);
}
