//! A heavy top at a temperature, against quadratures of its Gibbs measure.

use collective_integrators::{
    BrownianPaths, Integrator, NoiseRule, Noisy, NoisyReduced, RungeKutta, StageSolver, Start,
};
use heavytop::{Body, HeavyTop, SpinorRealisation};
use lie_poisson::{
    Autonomous, Covector, DoubleBracket, InnerProduct, IsotropicNoise, LiePoisson, OrbitField,
    Pair, PathNumber, PoissonSpace, Se3, Time, Vector,
};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

const FRICTION: f64 = 0.7;
const TEMPERATURE: f64 = 0.8;
const STEP: f64 = 0.05;

const INERTIA: Vector3<f64> = Vector3::new(2.0, 1.5, 1.0);
const CENTRE: Vector3<f64> = Vector3::new(0.6, 0.0, 0.8);

/// f₁ = |Γ|² = 1, f₂ = Π·Γ = 0.3
const START: Covector<Pair<Vector3<f64>, Vector3<f64>>> =
    Covector(Pair(Vector3::new(0.5, 0.2, 0.3), Vector3::new(0.0, 0.0, 1.0)));

/// The top with friction.
fn damped() -> DoubleBracket<LiePoisson<Se3>, Autonomous<HeavyTop>> {
    let body =
        Body { inertia: INERTIA, mass: 1.0, gravity: 1.0, length: 1.0, center_of_mass: CENTRE };
    let (top, space) = (HeavyTop::new(&body).unwrap(), LiePoisson::minus(Se3::default()));
    DoubleBracket::new(space, Autonomous(top), FRICTION, InnerProduct::euclidean()).unwrap()
}

/// Returns ½Π·Ω, Γ·c, (Γ·c)² and Π₃².
fn measured(pi: &Vector3<f64>, gamma: &Vector3<f64>) -> [f64; 4] {
    let height = gamma.dot(&CENTRE);
    [0.5 * pi.component_div(&INERTIA).dot(pi), height, height * height, pi.z * pi.z]
}

/// Returns the means of ½Π·Ω, Γ·c, (Γ·c)² and Π₃² over a path after it has forgotten its start, with standard errors from
/// blocks that are much longer than the memory of the motion; and the largest changes of |Γ|² and Π·Γ. The fields of noise alternate:
/// the error of a step is of the second order, below the standard errors.
fn means(step: f64, steps: u64) -> ([(f64, f64); 4], [f64; 2]) {
    const BLOCKS: u64 = 50;
    let inner_product = InnerProduct::euclidean();
    let noise = IsotropicNoise::thermal(inner_product, (FRICTION, TEMPERATURE)).unwrap();
    let paths = BrownianPaths::new(2, step).unwrap();
    let scheme = RungeKutta::implicit_midpoint();
    let langevin = Noisy::new(scheme, SpinorRealisation, damped(), noise, paths)
        .with_rule(NoiseRule::Alternating);
    let clock = Pair(PathNumber(1.0), Time(0.0));
    let mut state = langevin.start(&Pair(START, clock)).unwrap();
    let (mut workspace, mut blocks, mut lost) = (langevin.workspace(), Vec::new(), [0.0_f64; 2]);
    let length = steps / (BLOCKS + 10);
    for block in 0..BLOCKS + 10 {
        let mut sums = [0.0; 4];
        for made in (block * length..).take(length as usize) {
            langevin.advance(&mut state, step, made..made + 1, &mut workspace).unwrap();
            let Pair(Covector(Pair(pi, gamma)), _) = langevin.momentum(&state);
            sums.iter_mut().zip(measured(&pi, &gamma)).for_each(|(sum, x)| *sum += x);
            let casimirs = [gamma.norm_squared() - 1.0, pi.dot(&gamma) - 0.3];
            lost.iter_mut().zip(casimirs).for_each(|(lost, x)| *lost = lost.max(x.abs()));
        }
        if block >= 10 {
            blocks.push(sums.map(|sum| sum / length as f64));
        }
    }
    let number = BLOCKS as f64;
    let means = core::array::from_fn(|k| {
        let mean = blocks.iter().map(|block| block[k]).sum::<f64>() / number;
        let squares = blocks.iter().map(|block| (block[k] - mean).powi(2)).sum::<f64>();
        (mean, (squares / (number * (number - 1.0))).sqrt())
    });
    (means, lost)
}

/// The rule without a lift makes the same steps, also where Γ = 0, where there is no lift.
#[test]
fn a_step_without_a_lift_is_that_of_the_lift() {
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let product = InnerProduct::euclidean;
    let noise = || IsotropicNoise::thermal(product(), (FRICTION, TEMPERATURE)).unwrap();
    let space = LiePoisson::minus(Se3::default());
    let field = || DoubleBracket::new(space, Autonomous(top), FRICTION, product()).unwrap();
    let paths = BrownianPaths::new(2, STEP).unwrap();
    let scheme = RungeKutta::implicit_midpoint();
    let lifted = Noisy::new(scheme, SpinorRealisation, field(), noise(), paths);
    let reduced = NoisyReduced::new(DualQuaternions, field(), noise(), paths);
    let at = |gamma: Vector3<f64>, path: f64| {
        let momentum = Covector(Pair(Vector3::new(0.5, 0.2, 0.3), gamma));
        Pair(momentum, Pair(PathNumber(path), Time(0.0)))
    };
    let end = |path: f64| reduced.after(&at(Vector3::z(), path), STEP, 200).unwrap().momentum.0;
    let expected = lifted.after(&at(Vector3::z(), 4.0), STEP, 200).unwrap().momentum.0;
    // Two hundred steps of some ten roundings, which grow with the motion.
    assert!((end(4.0) - expected).max_abs() < 1e-11, "{:e}", (end(4.0) - expected).max_abs());
    assert!((end(5.0) - expected).max_abs() > 0.1);
    let Covector(Pair(pi, gamma)) = end(4.0);
    assert!((gamma.norm_squared() - 1.0).abs() < 1e-13 && (pi.dot(&gamma) - 0.3).abs() < 1e-13);
    let near = reduced.clone().with_solver(StageSolver { tolerance: 1e-6, ..Default::default() });
    let Covector(Pair(pi, gamma)) =
        near.after(&at(Vector3::z(), 4.0), STEP, 200).unwrap().momentum.0;
    assert!((gamma.norm_squared() - 1.0).abs() < 1e-13 && (pi.dot(&gamma) - 0.3).abs() < 1e-13);
    assert!((pi - end(4.0).0.0).norm() > 1e-12);
    let still = reduced.after(&at(Vector3::zeros(), 4.0), STEP, 200).unwrap().momentum.0;
    assert!((still.0.0.norm_squared() - 0.38).abs() < 1e-13 && still.0.1 == Vector3::zeros());
}

/// By quadrature: given Γ, Π is normal in the plane Π·Γ = f₂; it is integrated out, and then Γ over the sphere.
const EXACT: [f64; 4] = [0.831_776_45, -0.385_231_66, 0.401_048_23, 0.575_531_47];

fn require_gibbs(step: f64, steps: u64) {
    let (found, lost) = means(step, steps);
    for ((mean, error), exact) in found.iter().zip(EXACT) {
        assert!((mean - exact).abs() < 4.0 * error, "{found:?}");
        assert!(*error < 0.1, "{found:?}");
    }
    // Some ten roundings of each step, whose sum grows as the root of their number; ten times that.
    let bound = 5e-15 * (steps as f64).sqrt();
    assert!(lost.iter().all(|lost| *lost < bound), "{lost:?}");
}

#[test]
#[ignore = "long"]
fn a_heavy_top_has_the_means_of_gibbs_on_its_orbit() {
    require_gibbs(0.1, 20_000);
}

#[test]
#[ignore = "takes a minute"]
fn many_times_a_heavy_top_has_the_means_of_gibbs() {
    require_gibbs(0.05, 1_000_000);
}

/// Control: steps of Euler and Maruyama of Itô's equation, of the same size and scaled back to the orbit, have no means: the friction,
/// which grows as Π², throws them out. Their drift has ½σ² Σ_k Λ(Λ(μ)e_k)e_k besides.
#[test]
#[ignore = "long"]
fn steps_of_euler_and_maruyama_of_a_heavy_top_leave_every_bound() {
    let (field, space) = (damped(), LiePoisson::minus(Se3::default()));
    let strength = (2.0 * FRICTION * TEMPERATURE).sqrt();
    let paths = BrownianPaths::new(2, STEP).unwrap();
    let mut mu = START;
    let grown = (0..40_000).position(|n| {
        let mut noise = [0.0; 6];
        paths.write_increments(1, f64::from(n), f64::from(n) + 1.0, &mut noise);
        let along = |xi: &Pair<_, _>| space.hamiltonian_vector::<f64>(&mu, xi);
        let mut change = along(&field.element(&mu, 0.0)).scaled(STEP);
        for (k, increment) in noise.into_iter().enumerate() {
            let e = Vector::basis(k);
            let turn = along(&e);
            change += turn.scaled(strength * increment);
            let second = space.hamiltonian_vector::<f64>(&turn, &e);
            change += second.scaled(0.5 * strength * strength * STEP);
        }
        let Covector(Pair(pi, gamma)) = mu + change;
        let gamma = gamma.normalize();
        mu = Covector(Pair(pi + gamma * (0.3 - pi.dot(&gamma)), gamma));
        // In the measure exp(−h/kT) states with |Π| = 50 have the weight exp(−700).
        mu.0.0.norm() > 50.0
    });
    assert!(grown.is_some(), "{mu:?}");
}
