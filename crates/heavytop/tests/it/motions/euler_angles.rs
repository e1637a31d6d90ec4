//! The Euler angles z–x–z of an attitude, against products of rotations about the axes.

use core::f64::consts::{FRAC_PI_2, PI};
use heavytop::EulerAngles;
use lie_poisson::{Quaternion, Vector};
use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;

/// Returns R₃(φ) R₁(θ) R₃(ψ), by the rotations of nalgebra.
fn product(angles: &EulerAngles) -> Rotation3<f64> {
    let EulerAngles { precession, nutation, spin } = *angles;
    let about = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
    about(Vector3::z_axis(), precession)
        * about(Vector3::x_axis(), nutation)
        * about(Vector3::z_axis(), spin)
}

/// Returns the largest difference between an attitude and a rotation.
fn difference(attitude: &Quaternion, rotation: &Rotation3<f64>) -> f64 {
    let column = |axis: Vector3<f64>| (attitude.rotate(&axis) - rotation * axis).norm();
    [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().map(column).fold(0.0, f64::max)
}

proptest! {
    #[test]
    fn attitudes_are_products_of_rotations(
        precession in -3.1..3.1_f64,
        nutation in 1e-3..3.1_f64,
        spin in -3.1..3.1_f64,
        exponent in -300..300_i32,
    ) {
        let angles = EulerAngles { precession, nutation, spin };
        let attitude = angles.attitude();
        // Products of three matrices whose entries are at most 1.
        prop_assert!(difference(&attitude, &product(&angles)) < 1e-14);
        // Near a pole the two turns are known to a rounding error divided by sin θ, and a quaternion has any length and sign.
        let size = 10.0_f64.powi(exponent);
        for size in [size, -size] {
            let again = EulerAngles::of(&attitude.scaled(size));
            let most = 4e-15 / nutation.sin().abs().max(1e-300);
            prop_assert!((again.precession - precession).abs() < most, "{again:?}");
            prop_assert!((again.nutation - nutation).abs() < 4e-15, "{again:?}");
            prop_assert!((again.spin - spin).abs() < most, "{again:?}");
        }
        // Control: the other order of the turns is another attitude.
        let other = EulerAngles { precession: spin, nutation, spin: precession };
        if (precession - spin).abs() > 0.1 && nutation > 0.1 && nutation < 3.0 {
            prop_assert!(difference(&attitude, &product(&other)) > 1e-3);
        }
    }

    /// Angles of any attitude, also at the poles, give this attitude again.
    #[test]
    fn angles_of_every_attitude_give_it_again(q in prop::array::uniform4(-1.0..1.0_f64), pole in 0..3) {
        // Without the first pair the body is upside down, and without the second it is upright.
        let zero = |at: i32, x: f64| if pole == at { 0.0 } else { x };
        let q = [zero(1, q[0]), zero(2, q[1]), zero(2, q[2]), zero(1, q[3])];
        let given = Quaternion { scalar: q[0], vector: Vector3::new(q[1], q[2], q[3]) };
        prop_assume!(given.norm_squared() > 1e-6);
        let angles = EulerAngles::of(&given);
        let again = angles.attitude();
        for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
            prop_assert!((again.rotate(&axis) - given.rotate(&axis)).norm() < 1e-14);
        }
        let EulerAngles { precession, nutation, spin } = angles;
        prop_assert!([precession, spin].iter().all(|angle| -PI < *angle && *angle <= PI));
        prop_assert!((0.0..=PI).contains(&nutation));
        let at_pole = [None, Some(PI), Some(0.0)][pole as usize];
        prop_assert!(at_pole.is_none_or(|angle| nutation == angle), "{angles:?}");
    }
}

#[test]
fn the_vertical_is_that_of_the_angles() {
    let angles = EulerAngles { precession: 0.3, nutation: FRAC_PI_2, spin: 0.0 };
    let attitude = angles.attitude();
    // A top that lies along the x-axis turned by φ − π/2: its e₃ is level, and its e₂ upright.
    assert!((attitude.conjugate().rotate(&Vector3::z()) - Vector3::y()).norm() < 1e-15);
    let axis = Vector3::new(0.3_f64.sin(), -0.3_f64.cos(), 0.0);
    assert!((attitude.rotate(&Vector3::z()) - axis).norm() < 1e-15);
    // What is no attitude has no angles.
    for wrong in [f64::NAN, f64::INFINITY] {
        let q = Quaternion { scalar: 1.0, vector: Vector3::new(0.0, wrong, 0.0) };
        assert!(EulerAngles::of(&q).nutation.is_nan());
    }
}
