//! The rigid body in N dimensions: Euler's equations for N = 3, integrals, and parameters.

use lie_poisson_systems::collective_integrators::{Direct, HamiltonianField, RungeKutta, Start};
use lie_poisson_systems::isospectral_flows::{
    IsospectralField, IsospectralRungeKutta, LargeSkewHermitian,
};
use lie_poisson_systems::lie_poisson::{Covector, LiePoisson, So3, State, from_closure};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{GeneralisedRigidBody, SystemError};

#[test]
fn the_body_in_three_dimensions_is_that_of_euler() {
    let moments = [1.0, 2.0, 3.5];
    let body = GeneralisedRigidBody::new(moments.to_vec()).unwrap();
    let pi = Vector3::new(0.3, -0.8, 0.5);
    // M₃₂ = Π₁, M₁₃ = Π₂, M₂₁ = Π₃
    let m = body.momentum(|j, k| [-pi.z, pi.y, -pi.x][j + k - 1]);
    assert_eq!(body.moments(), moments);
    let inertia =
        Vector3::new(moments[1] + moments[2], moments[0] + moments[2], moments[0] + moments[1]);
    let energy = 0.5 * pi.component_mul(&pi).component_div(&inertia).sum();
    assert!((body.energy(&m) - energy).abs() < 1e-15);
    let square = |j: usize| moments[j] * moments[j];
    let manakov = -0.5
        * (pi.z * pi.z * (square(0) + square(1))
            + pi.y * pi.y * (square(0) + square(2))
            + pi.x * pi.x * (square(1) + square(2)));
    assert!((body.manakov_integral(&m) - manakov).abs() < 1e-14);
    let rate = body.rate(&m);
    let expected = pi.cross(&pi.component_div(&inertia));
    let found = Vector3::new(rate.at(2, 1).re, rate.at(0, 2).re, rate.at(1, 0).re);
    assert!((found - expected).norm() < 1e-15, "{found} {expected}");
    let hamiltonian = from_closure::<LiePoisson<So3>, _>(move |Covector(pi)| {
        (pi.x * pi.x / inertia.x + pi.y * pi.y / inertia.y + pi.z * pi.z / inertia.z) * 0.5
    });
    let field = HamiltonianField { space: LiePoisson::minus(So3), hamiltonian };
    let reference =
        Direct::new(RungeKutta::dop853(), field).after(&Covector(pi), 0.01, 500).unwrap().state.0;
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(4).unwrap(), body);
    let end = gauss.after(&m, 0.05, 100).unwrap().state;
    let found = Vector3::new(end.at(2, 1).re, end.at(0, 2).re, end.at(1, 0).re);
    assert!((found - reference).norm() < 1e-12, "{:e}", (found - reference).norm());
    assert!((found - pi).norm() > 0.1);
}

#[test]
fn integrals_are_conserved() {
    let body = GeneralisedRigidBody::new((1..=9).map(|j| j as f64).collect()).unwrap();
    let m = body.momentum(|j, k| ((j * j + 7 * k) as f64).cos());
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(4).unwrap(), body.clone());
    let end = gauss.after(&m, 0.05, 200).unwrap().state;
    assert!((body.energy(&m) - body.energy(&end)).abs() < 1e-11);
    let second = (body.manakov_integral(&m) - body.manakov_integral(&end)).abs();
    assert!(second < 1e-8, "{second:e}");
    assert!((m.norm() - end.norm()).abs() < 1e-13);
    // The control: another quadratic function is not conserved.
    let other = GeneralisedRigidBody::new((1..=9).map(|j| 1.0 / j as f64).collect()).unwrap();
    assert!((other.energy(&m) - other.energy(&end)).abs() > 1e-3);
}

#[test]
fn moments_that_are_not_positive_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = GeneralisedRigidBody::new(vec![1.0, bad, 2.0]);
        assert!(matches!(
            refused,
            Err(SystemError::NotPositive { .. } | SystemError::NotFinite { .. })
        ));
    }
    let body = GeneralisedRigidBody::new(vec![1.0]).unwrap();
    let other = LargeSkewHermitian::zeros(2);
    assert!(body.energy(&other).is_nan() && body.manakov_integral(&other).is_nan());
    let (flat, mut generator) =
        (GeneralisedRigidBody::new(vec![1.0, 2.0]).unwrap(), LargeSkewHermitian::zeros(2));
    flat.generator_into(&LargeSkewHermitian::zeros(3), &mut generator);
    assert!(!generator.is_finite());
    // Moments at the ends of the range: a finite rate, or a refusal.
    let large = GeneralisedRigidBody::new(vec![1e308; 3]).unwrap();
    assert!(large.energy(&large.momentum(|_, _| 1.0)) > 0.0);
    assert!(GeneralisedRigidBody::new(vec![5e-324, 5e-324]).is_err());
}
