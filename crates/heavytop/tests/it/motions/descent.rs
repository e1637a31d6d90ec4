//! The schemes on T*C² that give maps of se(3)*, and those that do not: the paper's experiment, 1000 steps of 1/50.

use collective_integrators::*;
use heavytop::{HeavyTop, Invariant, SpinorPoint, SpinorRealisation};
use lie_poisson::{Se3Dual, Vector};
use momentum_map::{FibreSymmetry, Lift, PoissonMap};
use nalgebra::Vector3;

type Partitioned = PartitionedRungeKutta<FirstHalf>;

const STEP: f64 = 0.02;

fn start() -> SpinorPoint {
    let gamma = Vector3::new(0.5, 0.0, 0.75_f64.sqrt());
    let mu = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), gamma);
    SpinorRealisation.lift_with(&mu, 1.0).unwrap()
}

fn top() -> HeavyTop {
    HeavyTop::kovalevskaya(1.0, 1.0).unwrap()
}

/// Returns the deviation of an invariant that is largest over the run, with its sign.
fn deviation<S: Scheme>(scheme: S, invariant: Invariant) -> f64 {
    let integrator = Collective::that_does_not_descend(scheme, SpinorRealisation, top());
    let values = integrator.trajectory_from(start(), STEP).take(1001).map(|sample| {
        let of = |mu| invariant.value(&top(), &mu);
        of(sample.unwrap().momentum) - of(SpinorRealisation.apply(&start()))
    });
    values.fold(0.0, |worst: f64, x| if x.abs() > worst.abs() { x } else { worst })
}

/// Returns |M(Φ(z)) − M(Φ(z + bψ))| for the minimal lift z and b = −5/2.
fn disagreement<S: Scheme>(scheme: S) -> f64 {
    let integrator = Collective::that_does_not_descend(scheme, SpinorRealisation, top());
    let image = |z: SpinorPoint| {
        let mut workspace = Integrator::<f64>::workspace(&integrator);
        let after = Integrator::<f64>::step(&integrator, &z, STEP, &mut workspace).unwrap().point;
        SpinorRealisation.apply(&after)
    };
    let minimal = SpinorRealisation.lift(&SpinorRealisation.apply(&start())).unwrap();
    let difference = image(minimal) - image(SpinorRealisation.flow(0, -2.5, &minimal));
    difference.pairing(&difference.0).sqrt()
}

/// Deviations of f₁ and disagreements of two lifts, measured once to three digits.
#[test]
fn partitioned_schemes_do_not_descend() {
    let close = |x: f64, y: f64| (x / y - 1.0).abs() < 0.01;
    let lobatto = Partitioned::lobatto_iiia_iiib(3).unwrap();
    let table = [
        (Partitioned::symplectic_euler_implicit_in_p(), -0.983, 2.67e-3),
        (Partitioned::symplectic_euler_implicit_in_q(), 33.9, 2.76e-3),
        (Partitioned::kick_drift_kick(), -0.0325, 1.70e-5),
        (Partitioned::drift_kick_drift(), -0.0326, 1.47e-5),
        (lobatto, -7.91e-8, 4.09e-10),
    ];
    for (scheme, f1, lifts) in table {
        assert!(scheme.is_symplectic());
        let measured = deviation(scheme.clone(), Invariant::VerticalSquared);
        assert!(close(measured, f1), "{measured:e} {f1:e}");
        let measured = disagreement(scheme);
        assert!(close(measured, lifts), "{measured:e} {lifts:e}");
    }
}

#[test]
fn equivariant_schemes_descend() {
    fn check<S: Equivariant>(scheme: S) {
        for invariant in [Invariant::VerticalSquared, Invariant::VerticalMomentum] {
            let deviation = deviation(scheme.clone(), invariant).abs();
            assert!(deviation < 1e-12, "{deviation:e}");
        }
        let apart = disagreement(scheme);
        // On the longer lift |χ| is near 10.
        assert!(apart < 1e-13, "{apart:e}");
    }
    check(RungeKutta::implicit_midpoint());
    check(RungeKutta::gauss(3).unwrap());
    check(RungeKutta::sanz_serna_abia());
    check(RungeKutta::new(Tableau::semiexplicit(&Substeps::yoshida4()).unwrap()));
    for substeps in [Substeps::suzuki4(), Substeps::kahan_li6(), Substeps::kahan_li8()] {
        check(Composition::new(RungeKutta::implicit_midpoint(), substeps));
    }
}
