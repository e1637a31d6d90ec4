//! The multiplier of a lift-free step: the motion of the group that carries the momentum from the start to the end.

use collective_integrators::diagnostics::{Drift, DriftError};
use collective_integrators::{Integrator, LiftFree, RungeKutta, Start};
use lie_poisson::{Covector, Hamiltonian, LiePoisson, So3, from_closure};
use momentum_map::{Multipliers, Quaternions};
use nalgebra::Vector3;

const STEP: f64 = 0.1;

/// A few rounding errors of numbers of size 1.
const ROUND_OFF: f64 = 1e-15;

fn body() -> impl Hamiltonian<LiePoisson<So3>> + Clone {
    from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y + pi.z * 0.3)
}

fn start() -> Covector<Vector3<f64>> {
    Covector(Vector3::new(0.6, 0.5, -0.4))
}

#[test]
fn the_multiplier_of_a_step_carries_the_momentum() {
    let gauss = LiftFree::new(RungeKutta::gauss(2).unwrap(), Quaternions, body());
    let workspace = || Integrator::<f64>::workspace(&gauss);
    let multiplier =
        |step| gauss.step_with_multiplier::<f64>(&start(), step, &mut workspace()).unwrap().1;
    let end = gauss.step(&start(), STEP, &mut workspace()).unwrap().point;
    let plain = multiplier(STEP);
    let e = Covector(Vector3::zeros());
    let refined = gauss.increment_with_multiplier(&start(), &e, STEP, &mut workspace());
    let refined = refined.unwrap().1;
    for q in [plain, refined] {
        assert!((q.norm_squared() - 1.0).abs() < 4.0 * ROUND_OFF, "{q:?}");
        let carried = Quaternions.transport::<f64>(&q, &start());
        assert!((carried.0 - end.0).norm() < 4.0 * ROUND_OFF, "{carried:?}, not {end:?}");
    }
    // Negative control: the multiplier of a slightly longer step carries elsewhere.
    let longer = multiplier(STEP * 1.001);
    let carried = Quaternions.transport::<f64>(&longer, &start());
    assert!((carried.0 - end.0).norm() > 1e-6, "{carried:?}");
}

#[test]
fn a_multiplier_of_a_step_without_a_result_is_an_error() {
    let gauss = LiftFree::new(RungeKutta::gauss(2).unwrap(), Quaternions, body());
    let mut workspace = Integrator::<f64>::workspace(&gauss);
    let lost = Covector(Vector3::new(f64::NAN, 0.0, 1.0));
    assert!(gauss.step_with_multiplier(&lost, STEP, &mut workspace).is_err());
    let e = Covector(Vector3::zeros());
    assert!(gauss.increment_with_multiplier(&lost, &e, STEP, &mut workspace).is_err());
}

/// The drift along a run is that of the values which the run visits, and a run that ends early has none.
#[test]
fn the_drift_along_a_run_is_that_of_its_values() {
    let gauss = LiftFree::new(RungeKutta::gauss(2).unwrap(), Quaternions, body());
    let first = |Covector(pi): &Covector<Vector3<f64>>| pi.x;
    let run = || gauss.trajectory(&start(), STEP).unwrap().take(50);
    let values = run().map(|sample| {
        let sample = sample.unwrap();
        (sample.time, first(&sample.momentum))
    });
    let along = Drift::along(run(), first).unwrap();
    assert_eq!(Ok(along), Drift::of(values));
    assert!(along.samples == 50 && along.largest > 0.1, "{along:?}");
    // Negative control: another quantity drifts otherwise, and a run with an error has no drift.
    assert_ne!(Drift::along(run(), |Covector(pi)| pi.y).unwrap(), along);
    let lost = gauss.trajectory_from(Covector(Vector3::new(f64::NAN, 0.0, 1.0)), STEP).take(2);
    assert!(matches!(Drift::along(lost, first), Err(DriftError::Integration(_))));
}
