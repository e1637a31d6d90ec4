//! A fluid on the sphere that is stirred by forces white in time: variances and rates, strong orders, units, and what
//! is refused.

use crate::fluids::zeitlin::{difference, largest};
use crate::open_fluids::support::{eddies, mean, on_path, paths};
use lie_poisson_systems::collective_integrators::{Integrator, Start, StepError, fitted_order};
use lie_poisson_systems::isospectral_flows::LargeSkewHermitian;
use lie_poisson_systems::lie_poisson::{Pair, State};
use lie_poisson_systems::{
    HarmonicNoise, StochasticFluid, SystemError, ViscousForcing, VorticityCoefficients, Zeitlin,
};

/// Returns the ends of so many paths of a small fluid that is stirred from rest, as coefficients.
fn ends(
    method: &StochasticFluid,
    (step, steps): (f64, u64),
    count: u64,
) -> Vec<VorticityCoefficients> {
    let fluid = method.forcing().fluid();
    let rest = LargeSkewHermitian::zeros(fluid.laplacian().size());
    let end = |path| method.after(&on_path(rest.clone(), path), step, steps).unwrap().momentum.0;
    (0..count).map(|path| fluid.coefficients(&end(path))).collect()
}

/// A stirred harmonic with damping has the variance σ²/2λ, also with steps that are longer than 1/λ.
#[test]
fn stirring_and_damping_balance_at_every_step_size() {
    let (sigma, drag, step, count) = (0.4, 1.5, 2.0, 1500);
    let fluid = Zeitlin::new(2).unwrap();
    let forcing = ViscousForcing::new(fluid.clone()).with_drag(drag).unwrap();
    let stirring = HarmonicNoise::none(&fluid).with_shell([1, 1], sigma).unwrap();
    let method = StochasticFluid::new(forcing, paths(step)).with_stirring(stirring).unwrap();
    let ends = ends(&method, (step, 5), count);
    let expected = sigma * sigma / (2.0 * drag);
    // The three standard errors of a variance, and of |ω₁₁|², whose mean is that of one real and one imaginary part
    let error = 3.0 * (2.0 / count as f64).sqrt();
    let zonal = mean(ends.iter().map(|end| end.at(1, 0).re.powi(2)));
    assert!((zonal / expected - 1.0).abs() < error, "{zonal} {expected}");
    let tilted = mean(ends.iter().map(|end| end.at(1, 1).norm_sqr()));
    assert!((tilted / expected - 1.0).abs() < error, "{tilted} {expected}");
    // Control: the variance of half a step of increments without the factor, σ² (h/2)/(1 − e^(−λh)), is far away.
    assert!(0.5 * step * 2.0 * drag / (1.0 - (-drag * step).exp()) > 1.0 + 3.0 * error);
}

#[test]
#[ignore = "long"]
fn stirring_feeds_energy_and_enstrophy_at_its_rates() {
    let (size, step, steps, count) = (4, 0.05, 20, 400);
    let fluid = Zeitlin::new(size).unwrap();
    let stirring = HarmonicNoise::none(&fluid).with_shell([2, 3], 0.5).unwrap();
    let carrying = HarmonicNoise::none(&fluid).with_shell([1, 1], 0.1).unwrap();
    let rates = [stirring.energy_injection(), stirring.enstrophy_injection()];
    assert!((rates[1] - 0.25 * (5.0 + 7.0)).abs() < 1e-14);
    assert!((rates[0] - 0.25 * (5.0 / 12.0 + 7.0 / 24.0)).abs() < 1e-14);
    let none = ViscousForcing::new(fluid.clone());
    let method = StochasticFluid::new(none, paths(step)).with_transport(carrying).unwrap();
    let method = method.with_stirring(stirring).unwrap();
    let ends = ends(&method, (step, steps), count);
    let mean_of = |f: &dyn Fn(&LargeSkewHermitian) -> f64| {
        mean(ends.iter().map(|end| f(&fluid.vorticity(end))))
    };
    let found = [mean_of(&|w| fluid.energy(w)), mean_of(&|w| fluid.enstrophy(w))];
    // Three standard errors of a sum of 5 squares, the fewest that carry most of it
    let error = 3.0 * (2.0 / (5 * count) as f64).sqrt();
    for (found, rate) in found.iter().zip(rates) {
        let expected = rate * step * steps as f64;
        assert!((found / expected - 1.0).abs() < error, "{found} {expected}");
    }
}

/// Returns the order of the root mean square distances of paths at t = 1 from those of a short step.
fn strong_order(method: &StochasticFluid, omega: &VorticityCoefficients, fine: f64) -> f64 {
    let (start, paths) = (method.forcing().fluid().vorticity(omega), 24);
    let end = |path: u64, step: f64| {
        let steps = (1.0 / step).round() as u64;
        method.after(&on_path(start.clone(), path), step, steps).unwrap().momentum.0
    };
    let exact: Vec<_> = (0..paths).map(|path| end(path, fine)).collect();
    let errors = [0.25, 0.125, 0.0625, 0.03125].map(|step| {
        let pairs = (0..).zip(&exact);
        let squares = pairs.map(|(path, exact)| difference(&end(path, step), exact).powi(2));
        (step, mean(squares).sqrt())
    });
    fitted_order(&errors, 1e-14).unwrap()
}

#[test]
#[ignore = "long"]
fn the_strong_order_is_one_with_stirring_and_one_half_with_isotropic_transport() {
    let (size, fine) = (4, 1.0 / 256.0);
    let fluid = Zeitlin::new(size).unwrap();
    let forcing = ViscousForcing::new(fluid.clone()).with_viscosity(0.05, 1).unwrap();
    let method = StochasticFluid::new(forcing.clone(), paths(fine));
    let noise = |shell, strength| HarmonicNoise::none(&fluid).with_shell(shell, strength).unwrap();
    let omega = eddies(size, [1, 3]);
    let stirred = method.clone().with_stirring(noise([1, 3], 0.5)).unwrap();
    let order = strong_order(&stirred, &omega, fine);
    assert!((order - 1.0).abs() < 0.2, "{order}");
    let one = HarmonicNoise::none(&fluid).with_harmonic(2, 0, 0.3).unwrap();
    let order = strong_order(&method.clone().with_transport(one).unwrap(), &omega, fine);
    assert!((order - 1.0).abs() < 0.25, "{order}");
    let all = method.with_transport(noise([2, 2], 0.3)).unwrap();
    let order = strong_order(&all, &omega, fine);
    assert!((order - 0.5).abs() < 0.2, "{order}");
}

#[test]
fn units_do_not_matter() {
    let size = 5;
    let end = |unit: f64, path: u64| {
        let fluid = Zeitlin::new(size).unwrap();
        let noise = |strength| HarmonicNoise::none(&fluid).with_shell([1, 3], strength).unwrap();
        let forcing = ViscousForcing::new(fluid.clone()).with_viscosity(0.05 * unit, 1).unwrap();
        let method = StochasticFluid::new(forcing, paths(0.1 / unit));
        let method = method.with_transport(noise(0.2 * unit.sqrt())).unwrap();
        let method = method.with_stirring(noise(0.3 * unit * unit.sqrt())).unwrap();
        let mut start = fluid.vorticity(&eddies(size, [1, 3]));
        start.scale_in_place(unit);
        let Pair(mut end, _) =
            method.after(&on_path(start, path), 0.1 / unit, 20).unwrap().momentum;
        end.scale_in_place(1.0 / unit);
        end
    };
    let here = end(1.0, 4);
    // About 1e30 and 1e-30, without rounding, and with square roots without rounding
    for unit in [100, -100].map(|power| 2.0_f64.powi(power)) {
        assert!(difference(&here, &end(unit, 4)) < 8.0 * f64::EPSILON * largest(&here), "{unit:e}");
    }
    // Control: the noise of another path
    assert!(difference(&here, &end(1.0, 5)) > 1e-3);
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let fluid = Zeitlin::new(4).unwrap();
    let none = || HarmonicNoise::none(&fluid);
    for (refused, expected) in [
        (
            none().with_harmonic(4, 0, 1.0),
            "the degree of noise must be between 1e0 and 3e0, got 4.0",
        ),
        (
            none().with_harmonic(0, 0, 1.0),
            "the degree of noise must be between 1e0 and 3e0, got 0.0",
        ),
        (
            none().with_harmonic(2, 3, 1.0),
            "the order of noise must be between 0e0 and 2e0, got 3.0",
        ),
        (none().with_harmonic(2, 1, -1.0), "the strength of noise must not be negative, got -1.0"),
        (
            none().with_shell([1, 2], f64::NAN),
            "the strength of noise must be a finite number, got NaN",
        ),
        (
            none().with_shell([1, 4], 1.0),
            "the largest degree of noise must be between 1e0 and 3e0, got 4.0",
        ),
        (
            none().with_shell([3, 2], 1.0),
            "the least degree of noise must be between 1e0 and 2e0, got 3.0",
        ),
    ] {
        assert_eq!(refused.unwrap_err().to_string(), expected);
    }
    let method = || StochasticFluid::new(ViscousForcing::new(fluid.clone()), paths(0.1));
    let other = || HarmonicNoise::none(&Zeitlin::new(5).unwrap());
    for refused in [method().with_transport(other()), method().with_stirring(other())] {
        assert!(matches!(refused, Err(SystemError::Count { expected: 4, found: 5, .. })));
    }
    // Backward in time with viscosity
    let viscous = ViscousForcing::new(fluid.clone()).with_viscosity(0.1, 1).unwrap();
    let method = StochasticFluid::new(viscous, paths(0.1));
    let start = on_path(fluid.vorticity(&eddies(4, [1, 3])), 0);
    let backward = method.step(&start, -0.1, &mut method.workspace());
    assert!(matches!(backward, Err(StepError::NoLift { .. })));
    let larger = on_path(LargeSkewHermitian::zeros(5), 0);
    let refused = method.step(&larger, 0.1, &mut method.workspace());
    assert!(matches!(refused, Err(StepError::Dimension { expected: 16, found: 25 })));
}
