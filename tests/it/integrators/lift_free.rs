//! Collective methods without a lift: they equal those with one, and keep their promises.

use collective_integrators::diagnostics::step_poisson_defect;
use collective_integrators::{Collective, Integrator, LiftFree, RungeKutta, Start};
use heavytop::{Body, HeavyTop, RigidBody, SpinorRealisation};
use lie_poisson::{
    Covector, DualNumber, Hamiltonian, LiePoisson, Se3, Se3Dual, SkewHermitian, State,
    UnitaryAlgebra, Vector, from_closure,
};
use lie_poisson_systems::{Kirchhoff, PointVortices};
use momentum_map::{
    ComplexMatrices, DualQuaternions, HOPF, PowerMap, PowerMultipliers, Quaternions,
    unitary_realisation,
};
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use workspace_tests::{momentum_with_vertical, persistent};

fn schemes() -> Vec<RungeKutta> {
    let gauss = [1, 2, 3, 8].map(|s| RungeKutta::gauss(s).unwrap());
    gauss.into_iter().chain([RungeKutta::rk4(), RungeKutta::explicit_midpoint()]).collect()
}

fn generic_top() -> HeavyTop {
    let body = Body {
        inertia: Vector3::new(1.1, 1.7, 2.2),
        mass: 1.3,
        gravity: 0.9,
        length: 0.8,
        center_of_mass: Vector3::new(0.48, -0.64, 0.6),
    };
    HeavyTop::new(&body).unwrap()
}

fn vehicle() -> Kirchhoff {
    let a = Matrix3::new(0.9, 0.1, 0.0, 0.1, 0.6, 0.05, 0.0, 0.05, 0.4);
    let b = Matrix3::new(0.1, -0.05, 0.02, 0.0, 0.08, 0.1, -0.07, 0.0, 0.03);
    Kirchhoff::new(a, b, Matrix3::new(0.5, 0.0, 0.1, 0.0, 0.7, -0.1, 0.1, -0.1, 0.3)).unwrap()
}

/// Returns the distance of the two forms after `steps` steps, relative to the size of the start.
fn distance<H>(scheme: &RungeKutta, h: &H, start: &Se3Dual, step: f64, steps: usize) -> f64
where
    H: Hamiltonian<LiePoisson<Se3>> + Clone,
{
    let lifted = Collective::new(scheme.clone(), SpinorRealisation, h.clone());
    let free = LiftFree::new(scheme.clone(), DualQuaternions, h.clone());
    let lifted = lifted.trajectory(start, step).unwrap().nth(steps).unwrap().unwrap();
    let free = free.trajectory(start, step).unwrap().nth(steps).unwrap().unwrap();
    (lifted.momentum - free.momentum).max_abs() / start.max_abs()
}

proptest! {
    #![proptest_config(persistent())]

    /// M ∘ Φ ∘ lift and the lift-free form differ by the round-off of one step.
    #[test]
    fn one_step_is_the_same(start in momentum_with_vertical(), step in 0.01..0.2) {
        prop_assume!(start.max_abs() < 10.0 && start.0.1.norm() > 0.1);
        for scheme in schemes().iter().filter(|s| s.tableau().is_symplectic()) {
            // A lift for small Γ is long: χ has the size |Π|/√|Γ|.
            let tolerance = 2e-14 * (1.0 + start.0.0.norm() / start.0.1.norm());
            prop_assert!(distance(scheme, &generic_top(), &start, step, 1) < tolerance);
            prop_assert!(distance(scheme, &vehicle(), &start, step, 1) < tolerance);
        }
    }
}

#[test]
#[ignore = "long"]
fn ten_thousand_steps_are_the_same_to_what_round_off_grows_to() {
    let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
    let kovalevskaya = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    for scheme in [RungeKutta::implicit_midpoint(), RungeKutta::gauss(2).unwrap()] {
        let gap = distance(&scheme, &kovalevskaya, &start, 0.02, 10_000);
        assert!(gap < 2e-11, "{gap:e}");
        // This vehicle is chaotic: the growth of an error of 10⁻¹² bounds the growth of round-off.
        let gentle = Se3Dual::new(Vector3::new(0.4, -0.8, 0.6), Vector3::new(0.5, 0.3, -0.9));
        let nudged = Se3Dual::new(Vector3::new(0.4 + 1e-12, -0.8, 0.6), gentle.0.1);
        let free = LiftFree::new(scheme.clone(), DualQuaternions, vehicle());
        let end = |start| free.trajectory(start, 0.02).unwrap().nth(10_000).unwrap().unwrap();
        let amplified = (end(&gentle).momentum - end(&nudged).momentum).max_abs();
        let gap = distance(&scheme, &vehicle(), &gentle, 0.02, 10_000);
        assert!(gap < 0.1 * amplified && gap < 1e-8, "{gap:e} {amplified:e}");
    }
}

#[test]
fn an_explicit_method_is_the_same_up_to_what_it_does_to_the_casimirs() {
    // The lift-free form moves μ by the normalised multiplier; RK4 changes |Q|² at order 5.
    let start = Se3Dual::new(Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.6, 0.0, 0.8));
    let gap = |step| distance(&RungeKutta::rk4(), &generic_top(), &start, step, 1);
    let slope = (gap(0.1) / gap(0.05)).log2();
    assert!((slope - 6.0).abs() < 0.5 || (slope - 5.0).abs() < 0.5, "{slope}");
}

#[test]
fn quaternions_are_the_hopf_map() {
    let body = RigidBody::new(Vector3::new(1.0, 1.4, 2.1)).unwrap();
    let start = Covector(Vector3::new(0.3, -1.2, 0.8));
    for s in [1, 2, 4] {
        let scheme = RungeKutta::gauss(s).unwrap();
        let lifted = Collective::new(scheme.clone(), HOPF, body);
        let free = LiftFree::new(scheme, Quaternions, body);
        let lifted = lifted.trajectory(&start, 0.1).unwrap();
        for (a, b) in lifted.zip(free.trajectory(&start, 0.1).unwrap()).take(500) {
            let gap = (a.unwrap().momentum - b.unwrap().momentum).max_abs();
            assert!(gap < 1e-12, "{gap:e}");
        }
    }
}

#[test]
fn powers_of_quaternions_are_powers_of_the_hopf_map() {
    let vortices = PointVortices::new([1.0, -0.7, 1.5]).unwrap();
    let x = [Vector3::x(), Vector3::new(0.0, 0.6, 0.8), Vector3::new(-0.8, 0.0, 0.6)];
    let start = vortices.momentum(&x);
    let scheme = RungeKutta::gauss(2).unwrap();
    let lifted = Collective::new(scheme.clone(), PowerMap::<_, 3>(HOPF), vortices);
    let free = LiftFree::new(scheme, PowerMultipliers::<_, 3>(Quaternions), vortices);
    let lifted = lifted.trajectory(&start, 0.1).unwrap();
    for (a, b) in lifted.zip(free.trajectory(&start, 0.1).unwrap()).take(300) {
        let gap = (a.unwrap().momentum - b.unwrap().momentum).max_abs();
        assert!(gap < 1e-12, "{gap:e}");
    }
}

#[test]
fn complex_matrices_are_outer_products_and_go_beyond_rank_one() {
    let h = |mu: &Covector<SkewHermitian<DualNumber, 3>>| {
        let weight = |i: usize| mu.coordinate(i) * mu.coordinate(i) * (0.1 + 0.07 * i as f64);
        (0..9).fold(DualNumber::constant(0.0), |sum, i| sum + weight(i))
    };
    let h = from_closure::<LiePoisson<UnitaryAlgebra<3>>, _>(h);
    let scheme = RungeKutta::gauss(2).unwrap();
    let free = LiftFree::new(scheme.clone(), ComplexMatrices::<3>, &h);
    let lifted = Collective::new(scheme, unitary_realisation::<3>(), &h);
    let z = Vector3::from_fn(|i, _| num_complex::Complex::new(0.5 + i as f64, 0.3));
    let one = lifted.momentum(&z);
    let (a, b) = (lifted.trajectory_from(z, 0.02), free.trajectory_from(one, 0.02));
    for (a, b) in a.zip(b).take(100) {
        let gap = (a.unwrap().momentum - b.unwrap().momentum).max_abs();
        assert!(gap < 1e-11, "{gap:e}");
    }
    // A momentum of rank three has no lift, and its spectrum is conserved.
    let full = Covector(SkewHermitian::from_coordinates(|i| 0.3 - 0.1 * i as f64));
    assert!(momentum_map::Lift::lift::<f64>(&unitary_realisation::<3>(), &full).is_err());
    let spectrum = |mu: &Covector<SkewHermitian<f64, 3>>| {
        let h = UnitaryAlgebra.hermitian(mu);
        [(h * h).trace().re, (h * h * h).trace().re]
    };
    let last = free.trajectory_from(full, 0.1).nth(200).unwrap().unwrap().momentum;
    for (a, b) in spectrum(&full).iter().zip(spectrum(&last)) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

fn poisson_defect(free: &LiftFree<RungeKutta, DualQuaternions, HeavyTop>, step: f64) -> f64 {
    let start = Se3Dual::new(Vector3::new(1.0, -2.0, 0.5), Vector3::new(0.6, 0.0, 0.8));
    step_poisson_defect(&LiePoisson::minus(Se3::default()), free, &start, step).unwrap()
}

#[test]
fn lift_free_gauss_methods_are_poisson_and_rk4_is_not() {
    for s in 1..=4 {
        let free = LiftFree::new(RungeKutta::gauss(s).unwrap(), DualQuaternions, generic_top());
        for step in [0.02, 0.1, 0.5] {
            let defect = poisson_defect(&free, step);
            assert!(defect < 1e-13, "{s} {step}: {defect:e}");
        }
    }
    let rk4 = LiftFree::new(RungeKutta::rk4(), DualQuaternions, generic_top());
    assert!(poisson_defect(&rk4, 0.5) > 1e-4);
}

/// The largest |χ| over a run of the collective midpoint rule differs with and without the gauge; the momentum does
/// not.
#[test]
fn the_gauge_keeps_chi_bounded_and_the_momentum_as_it_is() {
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0).unwrap();
    // Upright, γ·Γ = m g l for ever: Re(ψ*χ) grows by 2 per unit of time.
    let start = Se3Dual::new(Vector3::new(0.01, 0.0, 6.0), Vector3::z());
    let scheme = RungeKutta::implicit_midpoint();
    let gauged = Collective::new(scheme.clone(), SpinorRealisation, top);
    let free = Collective::that_does_not_descend(scheme, SpinorRealisation, top);
    let run = |integrator: &Collective<RungeKutta, SpinorRealisation, HeavyTop>| {
        let samples = integrator.trajectory(&start, 0.05).unwrap().take(5001);
        samples.map(Result::unwrap).fold((0.0, start), |(size, _), sample| {
            (lie_poisson::larger(size, sample.state.q.norm()), sample.momentum)
        })
    };
    let ((bounded, a), (growing, b)) = (run(&gauged), run(&free));
    // The least χ has the length 12.0 throughout; it grows to √2 of that before it is shortened.
    assert!(bounded < 17.5, "{bounded}");
    assert!(growing > 400.0, "{growing}");
    // The long χ makes the other run lose digits.
    assert!((a - b).max_abs() < 1e-9, "{:e}", (a - b).max_abs());
}
