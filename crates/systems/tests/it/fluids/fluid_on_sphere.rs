//! What fluids on the sphere have in common with functions on it: symmetry, angular momentum, and rest.

use crate::fluids::zeitlin::{difference, largest};
use lie_poisson_systems::lie_poisson::State;
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{QuantisedLaplacian, VorticityCoefficients, Zeitlin};
use std::f64::consts::PI;

/// T_lm with odd l − m is odd about the middle of its diagonal.
#[test]
fn odd_harmonics_vanish_in_the_middle() {
    let laplacian = QuantisedLaplacian::new(9).unwrap();
    for (l, m) in [(1, 0), (7, 0), (3, 2), (7, 4), (8, 8)] {
        let middle = laplacian.harmonic(l, m)[(8 - m) / 2];
        assert_eq!(middle == 0.0, l > m && (l - m) % 2 == 1, "{l} {m}: {middle:e}");
    }
}

/// Returns the coefficients of x₁, x₂ or x₃: x₁ + i x₂ = −√(8π/3) Y₁₁ and x₃ = √(4π/3) Y₁₀.
fn coordinate(size: usize, axis: usize) -> VorticityCoefficients {
    let tilted = -(2.0 * PI / 3.0).sqrt();
    let mut x = VorticityCoefficients::zeros(size);
    match axis {
        0 => x.set(1, 1, Complex::new(tilted, 0.0)),
        1 => x.set(1, 1, Complex::new(0.0, -tilted)),
        _ => x.set(1, 0, Complex::new((4.0 * PI / 3.0).sqrt(), 0.0)),
    }
    x
}

/// ∫ x_i x_j = (4π/3) δ_ij; other degrees have no angular momentum.
#[test]
fn the_angular_momentum_is_that_of_the_first_degree() {
    let fluid = Zeitlin::new(12).unwrap();
    for axis in 0..3 {
        let x = coordinate(12, axis);
        // the coordinate at a point
        let (colatitude, longitude) = (0.7_f64, 2.1_f64);
        let sine = colatitude.sin();
        let point = [sine * longitude.cos(), sine * longitude.sin(), colatitude.cos()];
        assert!((x.value(colatitude, longitude) - point[axis]).abs() < 1e-15);
        let momentum = fluid.angular_momentum(&fluid.vorticity(&x));
        for (i, found) in momentum.into_iter().enumerate() {
            let expected = if i == axis { 4.0 * PI / 3.0 } else { 0.0 };
            assert!((found - expected).abs() < 1e-14, "{axis} {i}: {found}");
        }
    }
    let second = VorticityCoefficients::from_fn(12, |l, _| Complex::from(f64::from(l > 1)));
    let none = fluid.angular_momentum(&fluid.vorticity(&second));
    assert!(none.iter().all(|x| x.abs() < 1e-13), "{none:?}");
}

/// A fluid that rests on the rotating sphere has the vorticity f = 2Ω x₃ and no energy. Its stream function is 0, and that
/// of a fluid without vorticity is Ω x₃.
#[test]
fn a_fluid_at_rest_turns_with_the_sphere() {
    let (size, rotation) = (7, 1.5);
    let fluid = Zeitlin::new(size).unwrap().with_rotation(rotation).unwrap();
    let mut turning = fluid.vorticity(&coordinate(size, 2));
    let mut stream = turning.zeros_like();
    fluid.stream_into(&turning.zeros_like(), &mut stream);
    stream.scale_in_place(1.0 / rotation);
    // A few roundings of numbers of size 1.
    assert!(difference(&stream, &turning) < 1e-14);
    turning.scale_in_place(2.0 * rotation);
    fluid.stream_into(&turning, &mut stream);
    assert!(largest(&stream) < 1e-14 && fluid.energy(&turning).abs() < 1e-13);
    // control: the same vorticity on a sphere at rest
    let still = Zeitlin::new(size).unwrap();
    assert!(still.energy(&turning) > 1.0);
}
