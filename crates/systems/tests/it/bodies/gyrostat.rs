//! The heavy gyrostat: what a collective Gauss method conserves, and which parameters are refused.

use crate::all_systems::drifts::{ROUND_OFF, drifts, energy_bound, schemes};
use collective_integrators::LiftFree;
use lie_poisson::{Hamiltonian, Se3Dual};
use lie_poisson_systems::{Gyrostat, SystemError};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

const MOMENTS: Vector3<f64> = Vector3::new(2.0, 2.0, 1.0);

#[test]
fn the_gyrostat_conserves_energy_and_casimirs() {
    let rotor = Vector3::new(0.1, -0.2, 0.7);
    let gyrostat = Gyrostat::new(MOMENTS, 1.0, Vector3::x(), rotor).unwrap();
    let start = Se3Dual::new(Vector3::new(0.4, -0.8, 0.6), Vector3::new(0.6, 0.0, -0.8));
    for scheme in schemes() {
        let gauss = LiftFree::new(scheme.clone(), DualQuaternions, gyrostat);
        let [energy, square, level] = drifts(&gauss, &start, (0.05, 1000), |mu| {
            [gyrostat.value(mu), mu.0.1.dot(&mu.0.1), mu.0.0.dot(&mu.0.1)]
        });
        assert!(square < ROUND_OFF && level < ROUND_OFF, "{square:e} {level:e}");
        assert!(energy < energy_bound(&scheme, 0.05), "{energy:e}");
    }
}

#[test]
fn the_parameters_are_checked() {
    let (zero, x) = (Vector3::zeros(), Vector3::x());
    let refused = |inertia, weight, center, rotor| Gyrostat::new(inertia, weight, center, rotor);
    assert!(matches!(
        refused(MOMENTS, 1.0, x, x * f64::INFINITY),
        Err(SystemError::NotFinite { name: "rotor[0]", .. })
    ));
    assert!(matches!(
        refused(Vector3::new(1.0, 1.0, 2.1), 1.0, x, zero),
        Err(SystemError::Triangle { .. })
    ));
    assert!(matches!(
        refused(Vector3::new(1.0, -1.0, 1.0), 1.0, x, zero),
        Err(SystemError::NotPositive { name: "inertia[1]", .. })
    ));
    assert!(matches!(
        refused(MOMENTS, 1.0, Vector3::new(0.0, f64::NAN, 0.0), zero),
        Err(SystemError::NotFinite { name: "center_of_mass[1]", .. })
    ));
    assert!(matches!(refused(MOMENTS, -1.0, x, zero), Err(SystemError::Negative { .. })));
    assert!(matches!(
        refused(MOMENTS, 1e200, x * 1e200, zero),
        Err(SystemError::NotFinite { name: "weight·center_of_mass[0]", .. })
    ));
    assert!(matches!(
        refused(MOMENTS * 1e-320, 1.0, x, zero),
        Err(SystemError::NotFinite { name: "1/inertia[0]", .. })
    ));
}
