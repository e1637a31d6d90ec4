//! The closed form of the midpoint rule on se(3)*, against the collective rule.

use collective_integrators::diagnostics::step_poisson_defect;
use collective_integrators::{Composition, LiftFree, RungeKutta, Start, Substeps, fitted_order};
use heavytop::{HeavyTop, ReducedMidpoint, TopMidpoint};
use lie_poisson::{Hamiltonian, LiePoisson, Se3, Se3Dual, Vector};
use lie_poisson_systems::Kirchhoff;
use momentum_map::DualQuaternions;
use nalgebra::{Matrix3, Vector3};

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(0.4, -0.8, 1.6), Vector3::new(0.6, 0.0, -0.8))
}

fn top() -> HeavyTop {
    HeavyTop::kovalevskaya(1.0, 1.0).unwrap()
}

fn vehicle() -> Kirchhoff {
    let a = Matrix3::new(0.9, 0.1, 0.0, 0.1, 0.6, 0.05, 0.0, 0.05, 0.4);
    let b = Matrix3::new(0.1, -0.05, 0.02, 0.0, 0.08, 0.1, -0.07, 0.0, 0.03);
    Kirchhoff::new(a, b, Matrix3::new(0.5, 0.0, 0.1, 0.0, 0.7, -0.1, 0.1, -0.1, 0.3)).unwrap()
}

fn gap<H: Hamiltonian<LiePoisson<Se3>> + Clone>(h: &H, step: f64, steps: usize) -> f64 {
    let scheme = RungeKutta::implicit_midpoint();
    let stages = LiftFree::new(scheme, DualQuaternions, h.clone());
    let closed = ReducedMidpoint::new(h.clone());
    let end = |sample: Se3Dual| sample;
    let a = stages.trajectory(&start(), step).unwrap().nth(steps).unwrap().unwrap().momentum;
    let b = closed.trajectory(&start(), step).unwrap().nth(steps).unwrap().unwrap().momentum;
    (end(a) - end(b)).max_abs()
}

#[test]
fn the_closed_form_is_the_one_stage_method() {
    for step in [0.01, 0.1, 0.4] {
        assert!(gap(&top(), step, 1) < 1e-14);
        assert!(gap(&vehicle(), step, 1) < 1e-14);
    }
    assert!(gap(&top(), 0.02, 5000) < 1e-11, "{:e}", gap(&top(), 0.02, 5000));
    // Control: another step is another map.
    let other = ReducedMidpoint::new(top());
    let mut ends = [0.1, 0.1 + 1e-9]
        .map(|step| other.trajectory(&start(), step).unwrap().nth(1).unwrap().unwrap().momentum);
    ends[0] -= ends[1];
    assert!(ends[0].max_abs() > 1e-11);
}

#[test]
fn it_is_poisson_and_its_compositions_are_of_their_order() {
    let space = LiePoisson::minus(Se3::default());
    for step in [0.02, 0.1, 0.4] {
        let defect = step_poisson_defect(&space, &ReducedMidpoint::new(vehicle()), &start(), step);
        assert!(defect.unwrap() < 1e-13);
    }
    let gauss = LiftFree::new(RungeKutta::gauss(8).unwrap(), DualQuaternions, top());
    let exact = gauss.trajectory(&start(), 0.02).unwrap().nth(50).unwrap().unwrap().momentum;
    for (substeps, order) in [(Substeps::yoshida4(), 4.0), (Substeps::kahan_li6(), 6.0)] {
        let scheme = Composition::new(TopMidpoint::new(top()), substeps);
        let errors = [4, 6, 8, 12, 16].map(|count| {
            let run = scheme.trajectory(&start(), 1.0 / f64::from(count)).unwrap();
            let end = run.take(count as usize + 1).last().unwrap().unwrap();
            (1.0 / f64::from(count), (end.momentum - exact).max_abs())
        });
        let slope = fitted_order(&errors, 1e-13).unwrap();
        assert!((slope - order).abs() < 0.4, "{slope}");
    }
}
