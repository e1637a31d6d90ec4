//! A matrix at a temperature, whose mean energy is known, with both rules and with long steps.

use crate::open_systems::support::{Large, on_path};
use isospectral_flows::collective_integrators::{BrownianPaths, Integrator, NoiseRule, RungeKutta};
use isospectral_flows::lie_poisson::{Sign, State};
use isospectral_flows::{
    IsospectralDoubleBracket, IsospectralField, IsotropicIsospectralNoise, NoisyIsospectral,
};
use num_complex::Complex;

/// h = ⟨D, W⟩ with |D| = 1 on the sphere of the matrices of trace 0 and |W| = 1.
struct Linear;

impl IsospectralField for Linear {
    fn size(&self) -> usize {
        2
    }

    fn generator_into(&self, _: &Large, generator: &mut Large) {
        *generator = axis();
        generator.scale_in_place(-1.0);
    }
}

fn axis() -> Large {
    let sign = |j: usize| if j == 0 { 0.5_f64.sqrt() } else { -0.5_f64.sqrt() };
    Large::from_upper(2, |j, k| Complex::new(0.0, if j == k { sign(j) } else { 0.0 }))
}

const FRICTION: f64 = 0.5;

const TEMPERATURE: f64 = 0.5;

/// ⟨h⟩ = −(coth x − 1/x), x = 1/kT.
fn langevin(temperature: f64) -> f64 {
    temperature - temperature.recip().tanh().recip()
}

fn thermal() -> IsotropicIsospectralNoise {
    IsotropicIsospectralNoise::thermal(2, (FRICTION, TEMPERATURE)).unwrap()
}

/// Returns the mean of h over so many blocks of 1000 steps, and four standard errors.
fn mean_energy(
    (noise, rule): (IsotropicIsospectralNoise, NoiseRule),
    step: f64,
    blocks: u64,
) -> (f64, f64) {
    let damped = IsospectralDoubleBracket::new(Linear, FRICTION, Sign::Minus).unwrap();
    let paths = BrownianPaths::new(5, step).unwrap();
    let midpoint = RungeKutta::implicit_midpoint();
    let noisy = NoisyIsospectral::new(midpoint, damped, noise, paths).with_rule(rule);
    let w =
        Large::from_upper(2, |j, k| Complex::new(if j == k { 0.0 } else { 0.5_f64.sqrt() }, 0.0));
    let (mut state, mut workspace) = (on_path(w, 1), noisy.workspace());
    let mut mean = |block: u64| {
        let mut sum = 0.0;
        for n in block * 1000..(block + 1) * 1000 {
            noisy.advance(&mut state, step, n..n + 1, &mut workspace).unwrap();
            sum += axis().scalar_product(&state.0) / 1000.0;
        }
        sum
    };
    mean(0);
    let means: Vec<f64> = (1..=blocks).map(&mut mean).collect();
    let number = blocks as f64;
    let found = means.iter().sum::<f64>() / number;
    let variance = means.iter().map(|m| (m - found).powi(2)).sum::<f64>() / (number - 1.0);
    (found, 4.0 * (variance / number).sqrt())
}

#[test]
#[ignore = "long"]
fn a_matrix_at_a_temperature_has_langevins_mean() {
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let (found, error) = mean_energy((thermal(), rule), 0.05, 40);
        assert!((found - langevin(TEMPERATURE)).abs() < error, "{found} ± {error}");
        // Control: another temperature.
        assert!((found - langevin(TEMPERATURE / 0.7)).abs() > error, "{found} ± {error}");
    }
}

/// Steps so long that σ²hN/12, by which the increments are squeezed, counts: 1/30 and 1/15.
#[test]
#[ignore = "takes a minute"]
fn many_times_the_temperature_of_long_steps_is_that_of_the_weak_order_two() {
    for step in [0.4, 0.8] {
        let part = thermal().strength.powi(2) * step / 6.0;
        // Noise which is stronger by 1/c: the increments as they are, at a temperature that is too high by this part.
        let whole = IsotropicIsospectralNoise {
            size: 2,
            strength: thermal().strength / (1.0 - part).sqrt(),
        };
        let [(found, error), (other, error_of_other)] =
            [thermal(), whole].map(|noise| mean_energy((noise, NoiseRule::Alternating), step, 200));
        let exact = langevin(TEMPERATURE);
        println!("{step}: {} {error}, {} {error_of_other}", found - exact, other - exact);
        // The error of Strang's splitting.
        let bias = 0.01 * step * step;
        assert!((found - exact).abs() < error + bias, "{step}: {found} ± {error}");
        assert!(
            (other - exact).abs() > error_of_other + bias,
            "{step}: {other} ± {error_of_other}"
        );
    }
}
