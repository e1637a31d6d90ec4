//! The law suites on states whose dimension is known when the program runs.

use collective_integrators::{
    Composition, Direct, RungeKutta, SphericalMidpoint, Start, Substeps, laws,
};
use isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, IsospectralRungeKutta, LargeSkewHermitian,
};
use lie_poisson::{Covector, Sites, State};
use lie_poisson_systems::{GeneralisedRigidBody, HeisenbergLattice, ManyVortices, Zeitlin};
use nalgebra::Vector3;
use std::error::Error;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;
type Vectors = Covector<Sites<Vector3<f64>>>;

/// The size of the steps.
const STEP: f64 = 0.05;

/// Rounding errors of a step of size 0, and of a hundred steps.
const ROUND_OFF: f64 = 1e-13;

/// A unit vector without a pattern.
fn direction(i: usize) -> Vector3<f64> {
    let x = i as f64;
    Vector3::new((2.3 * x).sin(), (1.7 * x).cos(), (0.9 * x + 0.2).sin()).normalize()
}

/// Checks the laws of an integrator from two momenta, and that it conserves some functions.
fn obeys<V: State<Scalar = f64>>(
    integrator: &impl Start<State = V, Momentum = V>,
    momenta: &[V; 2],
    invariants: &[&dyn Fn(&V) -> f64],
) -> Outcome {
    laws::start(integrator, momenta, STEP)?.check(ROUND_OFF)?;
    laws::invariants(integrator, momenta, STEP, invariants)?.check(ROUND_OFF)?;
    Ok(())
}

#[test]
#[ignore = "long"]
fn integrators_of_spins_and_vortices() -> Outcome {
    let vortices = ManyVortices::new(vec![0.2; 12])?;
    let momenta = [0, 40].map(|n| vortices.momentum((n..n + 12).map(direction)));
    let [first, second] = momenta;
    let momenta = [first?, second?];
    let moment = |m: &Vectors| m.0.iter().sum::<Vector3<f64>>().x;
    let length = |m: &Vectors| m.0[3].norm();
    let midpoint = SphericalMidpoint::new(vortices.clone());
    obeys(&midpoint, &momenta, &[&moment, &length])?;
    let composed = Composition::new(midpoint, Substeps::suzuki4());
    obeys(&composed, &momenta, &[&moment, &length])?;
    let gauss = Direct::new(RungeKutta::gauss(2)?, vortices.clone());
    obeys(&gauss, &momenta, &[&moment, &length])?;
    // control: an explicit method leaves the spheres
    let rk4 = Direct::new(RungeKutta::rk4(), vortices);
    let report = laws::invariants(&rk4, &momenta, 4.0 * STEP, &[&length])?;
    assert!(report.check(ROUND_OFF).is_err());
    laws::start(&rk4, &momenta, STEP)?.check(0.0)?;

    let lattice = HeisenbergLattice::new([3, 2, 2])?.with_exchange([1, 0, 0], 1.0)?;
    let lattice = lattice.with_exchange([0, 1, 1], -0.4)?;
    let spins = [0, 40].map(|n| Covector((n..n + 12).map(direction).collect()));
    let midpoint = SphericalMidpoint::new(lattice);
    obeys(&midpoint, &spins, &[&moment, &length])
}

/// Returns two matrices for a body, whose norm is one of the Casimirs.
fn matrices(body: &GeneralisedRigidBody) -> [LargeSkewHermitian; 2] {
    [1.3, 2.9].map(|seed| body.momentum(|j, k| 0.3 * (seed * (3 * j + k) as f64).sin()))
}

#[test]
#[ignore = "long"]
fn integrators_of_matrices() -> Outcome {
    let body = GeneralisedRigidBody::new((1..=6).map(f64::from).collect())?;
    let momenta = matrices(&body);
    let norm = |w: &LargeSkewHermitian| w.norm();
    obeys(&GaussMagnus::new(1, &body)?, &momenta, &[&norm])?;
    obeys(&GaussMagnus::new(3, &body)?.with_tolerance(1e-6), &momenta, &[&norm])?;
    let midpoint = ExponentialMidpoint::new(&body);
    obeys(&midpoint, &momenta, &[&norm])?;
    obeys(&Composition::new(midpoint, Substeps::yoshida4()), &momenta, &[&norm])?;
    obeys(&IsospectralRungeKutta::new(RungeKutta::gauss(2)?, &body), &momenta, &[&norm])?;
    // control: an explicit method loses the spectrum; it repeats its bits, and a step of size 0 is exact
    let rk4 = Direct::new(RungeKutta::rk4(), CommutatorField::new(&body));
    assert!(laws::invariants(&rk4, &momenta, 4.0 * STEP, &[&norm])?.check(ROUND_OFF).is_err());
    laws::start(&rk4, &momenta, STEP)?.check(0.0)?;

    let fluid = Zeitlin::new(6)?;
    let without_trace = momenta.map(|mut w| {
        let trace = (0..6).map(|j| w.at(j, j)).sum::<num_complex::Complex<f64>>() / 6.0;
        w.change_upper(|_, im| (0..6).for_each(|j| im[7 * j] -= trace.im));
        w
    });
    let angular = |w: &LargeSkewHermitian| fluid.angular_momentum(w)[2];
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2)?, &fluid);
    obeys(&gauss, &without_trace, &[&norm, &angular])
}
