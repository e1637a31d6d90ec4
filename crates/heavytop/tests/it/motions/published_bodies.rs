//! Free rigid bodies whose motion others have published: a check case of simulation tools, and the tumbling asteroid
//! Toutatis.

use collective_integrators::{Collective, Integrator, RungeKutta, Start};
use heavytop::{EulerAngles, HeavyTop, RigidBody, SpinorRealisation, WithAttitude};
use lie_poisson::{Covector, Pair, Se3Dual};
use momentum_map::HOPF;
use nalgebra::Vector3;

fn degrees(values: [f64; 3]) -> Vector3<f64> {
    Vector3::from(values).map(f64::to_radians)
}

/// The moments of the brick of NASA's check case 2, slug ft².
const BRICK: Vector3<f64> = Vector3::new(0.001_894_220, 0.006_211_019, 0.007_194_665);

/// Its angular velocity at the start, °/s.
const SPIN: [f64; 3] = [10.0, 20.0, 30.0];

/// Returns the angular velocity of a brick at 5, 10, …, 30 s, °/s.
fn angular_velocities(inertia: Vector3<f64>) -> Vec<Vector3<f64>> {
    let gauss =
        Collective::new(RungeKutta::gauss(4).unwrap(), HOPF, RigidBody::new(inertia).unwrap());
    let start = Covector(degrees(SPIN).component_mul(&inertia));
    let run = gauss.trajectory(&start, 0.02).unwrap().take(1501).step_by(250).skip(1);
    run.map(|sample| sample.unwrap().momentum.0.component_div(&inertia).map(f64::to_degrees))
        .collect()
}

/// Source: E. B. Jackson et al., *Further development of verification check-cases for six-degree-of-freedom flight
/// vehicle simulations* and NASA/TM-2015-218675, check case 2. Its tools agree to 0.004 °/s.
#[test]
fn the_brick_of_nasas_check_case() {
    let found = angular_velocities(BRICK);
    let listed = [-16.940, -2.419, 18.437, -5.423, -15.184];
    for (found, listed) in found.iter().zip(listed) {
        assert!((found.x - listed).abs() < 0.004, "{found} {listed}");
    }
    let last = found[5];
    assert!((last - Vector3::new(12.618_42, -17.397_44, 31.119_60)).amax() < 0.004, "{last}");
    // Euler's equations by another method at 1e-13, with digits beyond those of the report.
    let digits = Vector3::new(12.618_390_78, -17.397_474_76, 31.119_588_89);
    assert!((last - digits).amax() < 1e-8, "{last}");
    // Control: moments that are larger in the fourth digit.
    let other = angular_velocities(Vector3::new(BRICK.x * 1.0005, BRICK.y, BRICK.z))[5];
    assert!((other - digits).amax() > 0.01, "{other}");
}

/// The moments of Toutatis along its axes, in units of the least.
const TOUTATIS: Vector3<f64> = Vector3::new(3.0836, 3.235, 1.0);

/// Returns an attitude from the Euler angles z–x–z, in degrees.
fn attitude([precession, nutation, spin]: [f64; 3]) -> lie_poisson::Quaternion {
    let [precession, nutation, spin] = [precession, nutation, spin].map(f64::to_radians);
    EulerAngles { precession, nutation, spin }.attitude()
}

/// Returns the distance of a model without torques from the observation of 1992-12-02T21:40 UTC: that of |ω|, relative,
/// then the angles, in degrees, between the directions of ω and between the first, second and third axes of the body.
fn distances(days: f64) -> [f64; 5] {
    let omega = degrees([14.51, 33.529, -98.709]);
    let turned = attitude([145.498, 65.865, 241.524]);
    let pi = omega.component_mul(&TOUTATIS);
    // The attitude is that of the run, from its own vertical.
    let gamma = turned.conjugate().rotate(&Vector3::z());
    let body = HeavyTop::free_rigid_body(TOUTATIS).unwrap();
    let gauss =
        WithAttitude(Collective::new(RungeKutta::gauss(4).unwrap(), SpinorRealisation, body));
    let mut state = gauss.start(&Se3Dual::new(pi, gamma)).unwrap();
    state.1 = turned;
    let steps = 4000;
    let run = gauss.trajectory_from(state, days / steps as f64);
    let end = run.take(1 + steps).last().unwrap().unwrap();
    let Covector(Pair(pi, _)) = end.momentum;
    let found = pi.component_div(&TOUTATIS);
    let (observed, axes) = (degrees([-35.6, 7.2, -97.0]), attitude([122.2, 86.5, 107.0]));
    let angle = |a: Vector3<f64>, b: Vector3<f64>| a.angle(&b).to_degrees();
    let [e1, e2, e3] = [Vector3::x(), Vector3::y(), Vector3::z()]
        .map(|axis| angle(end.state.1.rotate(&axis), axes.rotate(&axis)));
    [(found.norm() / observed.norm() - 1.0).abs(), angle(found, observed), e1, e2, e3]
}

/// From the state of 1992-11-09T17:49:47 UTC, which was fitted to the radar of 1992 to 2008, to the first of the
/// observations of 1992.
///
/// Source: Y. Takahashi, M. W. Busch & D. J. Scheeres, *Spin state and moment of inertia characterization of 4179
/// Toutatis*, Astron. J. 146 (2013); the distances of a model without torques are those that the project Principia
/// states, whose axes are e₃, e₁, e₂ here.
#[test]
fn toutatis_without_torques() {
    let days = 23.0 + (3.0 * 3600.0 + 50.0 * 60.0 + 13.0) / 86400.0;
    let found = distances(days);
    println!("{found:?}");
    // Half of a unit of the last digit that is stated.
    let [norm, direction, e1, e2, e3] = found;
    for (found, stated, digit) in
        [(norm, 0.011, 1e-3), (direction, 4.5, 0.1), (e3, 7.9, 0.1), (e1, 5.4, 0.1), (e2, 5.9, 0.1)]
    {
        assert!((found - stated).abs() <= 0.5 * digit, "{found} {stated}");
    }
    // Control: an hour later the body has turned on.
    let later = distances(days + 1.0 / 24.0);
    assert!((later[1] - 4.5).abs() > 0.1 && (later[2] - e1).abs() > 1.0, "{later:?}");
}
