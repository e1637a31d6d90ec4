//! Kida's elliptical vortex: Kirchhoff's rate, the equations of Kida, and what a collective Gauss method conserves over
//! t ≤ 1000, where an explicit method does not.

use crate::all_systems::drifts::drifts;
use collective_integrators::{Collective, Direct, HamiltonianField, RungeKutta, Start};
use lie_poisson::{Casimirs, Hamiltonian, InfinitesimalAdjoint, LiePoisson, PoissonSpace};
use lie_poisson_systems::{KidaVortex, So21, SystemError};
use momentum_map::{Side, clebsch_realisation};
use nalgebra::Vector3;

const SPACE: LiePoisson<So21> = LiePoisson::plus(So21);

/// Kida's equations for the semi-axes and the angle: da/dt = e a cos 2φ, db/dt = −e b cos 2φ,
/// dφ/dt = ωab/(a+b)² + γ − e sin 2φ (a²+b²)/(a²−b²).
#[test]
fn the_equations_are_kidas() {
    let (k, e, gamma) = (1.3, 0.2, 0.07);
    let vortex = KidaVortex::new(k, e, gamma).unwrap();
    for (a, b, phi) in [(1.5, 0.5, 0.3), (2.0, 1.9, -1.1), (0.7, 0.1, 1.4)] {
        let mu = KidaVortex::momentum(a, b, phi).unwrap();
        let (major, minor) = KidaVortex::semi_axes(&mu);
        assert!((major - a).abs() + (minor - b).abs() < 1e-14);
        assert!((KidaVortex::angle(&mu) - phi).abs() < 1e-14);
        let rate = SPACE.hamiltonian_vector(&mu, &vortex.differential(&mu)).0;
        let cos = (2.0 * phi).cos();
        let (rate_a, rate_b) = (e * a * cos, -e * b * cos);
        let own = k / (a + b) / (a + b);
        let sum = (a * a + b * b) / (a * a - b * b);
        let rate_phi = own + gamma - e * (2.0 * phi).sin() * sum;
        let (twice, d) = (2.0 * phi, 0.5 * (a * a - b * b));
        let rate_d = a * rate_a - b * rate_b;
        let expected = Vector3::new(
            rate_d * twice.cos() - 2.0 * d * twice.sin() * rate_phi,
            rate_d * twice.sin() + 2.0 * d * twice.cos() * rate_phi,
            a * rate_a + b * rate_b,
        );
        // Rounding errors of numbers up to 5.
        assert!((rate - expected).norm() < 1e-13, "{rate} {expected}");
    }
}

/// Without strain the ellipse keeps its shape and turns at Kirchhoff's rate ωab/(a+b)².
#[test]
fn an_ellipse_without_strain_turns_at_kirchhoffs_rate() {
    let (a, b) = (1.5, 0.5);
    let vortex = KidaVortex::new(1.0, 0.0, 0.0).unwrap();
    let map = clebsch_realisation(InfinitesimalAdjoint(So21), Side::Left).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(3).unwrap(), map, vortex);
    let end = gauss.after(&KidaVortex::momentum(a, b, 0.0).unwrap(), 0.05, 100).unwrap().momentum;
    let expected = 5.0 / (a + b) / (a + b);
    // The error of order 6: 5 × 0.05⁶/2016 is 4e-11.
    assert!((KidaVortex::angle(&end) - expected).abs() < 1e-10, "{:e}", KidaVortex::angle(&end));
}

/// Fourth order, steps of 0.1, t ≤ 1000. The Gauss method conserves the Casimir to round-off and has no drift of h; the
/// explicit method loses both.
#[test]
fn gauss_conserves_over_a_long_time_what_an_explicit_method_loses() {
    let vortex = KidaVortex::new(1.0, 0.1, 0.05).unwrap();
    let start = KidaVortex::momentum(1.5, 0.5, 0.3).unwrap();
    let map = clebsch_realisation(InfinitesimalAdjoint(So21), Side::Left).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), map, vortex);
    let quantities = |m: &_| [vortex.value(m), So21.casimir(0, m)];
    let [energy, casimir] = drifts(&gauss, &start, (0.1, 10_000), quantities);
    let early = drifts(&gauss, &start, (0.1, 1000), quantities);
    let field = HamiltonianField { space: SPACE, hamiltonian: vortex };
    let direct = Direct::new(RungeKutta::rk4(), field);
    let lost = drifts(&direct, &start, (0.1, 10_000), quantities);
    let lost_early = drifts(&direct, &start, (0.1, 1000), quantities);
    println!("Gauss 4: h {energy:e}, early {:e}, Casimir {casimir:e}", early[0]);
    println!(
        "RK4: h {:e}, early {:e}, Casimir {:e}, early {:e}",
        lost[0], lost_early[0], lost[1], lost_early[1]
    );
    assert!(casimir < 1e-12, "{casimir:e}");
    assert!(energy < 1.5 * early[0], "no drift: {energy:e} {:e}", early[0]);
    // A drift grows tenfold in the tenfold time.
    assert!(lost[1] > 5.0 * lost_early[1] && lost[1] > 1e3 * casimir, "{lost:?}");
    assert!(lost[0] > 5.0 * lost_early[0], "{lost:?}");
}

#[test]
fn parameters_are_checked() {
    assert!(matches!(KidaVortex::new(f64::NAN, 0.0, 0.0), Err(SystemError::NotFinite { .. })));
    assert!(matches!(KidaVortex::momentum(1.0, 0.0, 0.0), Err(SystemError::NotPositive { .. })));
    assert!(matches!(
        KidaVortex::momentum(f64::INFINITY, 1.0, 0.0),
        Err(SystemError::NotFinite { name: "a", .. })
    ));
    let refused = |a: f64, b: f64| match KidaVortex::momentum(a, b, 0.3) {
        Err(SystemError::OutOfRange { name, value, least, most }) => {
            assert!(value < least || value > most);
            (name, value)
        }
        other => panic!("{a:e} {b:e}: {other:?}"),
    };
    // The momentum would be 0, its square infinite, and its Casimir 0.
    assert_eq!(refused(1e-200, 1e-200), ("a", 1e-200));
    assert_eq!(refused(1.0, 1e200), ("b", 1e200));
    assert_eq!(refused(1e70, 1e-70), ("a/b", 1e140));
    assert_eq!(refused(1e-7, 1.0), ("a/b", 1e-7));
    let error = KidaVortex::momentum(1e-200, 1.0, 0.0).unwrap_err();
    assert_eq!(error.to_string(), "a must be between 1e-76 and 1e76, got 1e-200");
}

/// All axes that are accepted come back, with the rounding error of the difference of squares.
#[test]
fn accepted_axes_come_back() {
    for size in [1.0001e-76, 1e-30, 1.0, 1e30, 0.999e76] {
        for ratio in [1.0, 0.1, 1e-3, 1.001e-6] {
            let shorter = size * ratio;
            if shorter < 1e-76 {
                continue;
            }
            let mu = KidaVortex::momentum(size, shorter, 0.3).unwrap();
            let (a, b) = KidaVortex::semi_axes(&mu);
            assert!((a / size - 1.0).abs() < 1e-15, "{size:e} {ratio:e}: {a:e}");
            assert!((b / shorter - 1.0).abs() < 1e-15 / ratio / ratio, "{size:e} {ratio:e}: {b:e}");
        }
    }
}
