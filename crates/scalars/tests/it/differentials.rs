//! Derivatives of maps between vector spaces, whose values are exact in floating-point numbers.

use generic_scalars::{
    Covector, DualNumber, Quaternion, Vector, derivative_part, differential, seed,
    transposed_tangent,
};
use nalgebra::{Vector2, Vector3};

/// f(x, y, z) = (x y, y z²), with the matrix of derivatives ((y, x, 0), (0, z², 2 y z)).
fn map(v: &Vector3<DualNumber>) -> Vector2<DualNumber> {
    Vector2::new(v.x * v.y, v.y * v.z * v.z)
}

const POINT: fn() -> Vector3<f64> = || Vector3::new(3.0, 5.0, -2.0);

#[test]
fn a_transposed_tangent_map_is_the_product_with_the_transposed_matrix() {
    let alpha = Covector(Vector2::new(7.0, 11.0));
    let found: Covector<Vector3<f64>> = transposed_tangent(map, &POINT(), &alpha);
    // (y α₀, x α₀ + z² α₁, 2 y z α₁)
    assert_eq!(found, Covector(Vector3::new(35.0, 21.0 + 44.0, -220.0)));
    // Negative control: the components of α belong to those of f.
    let exchanged = Covector(Vector2::new(11.0, 7.0));
    assert_ne!(transposed_tangent(map, &POINT(), &exchanged), found);
}

/// ⟨(T f)ᵀ α, v⟩ = ⟨α, T f v⟩, and both are the derivative of ⟨α, f⟩ along v.
#[test]
fn the_transposed_tangent_map_is_adjoint_to_the_tangent_map() {
    let alpha = Covector(Vector2::new(7.0, 11.0));
    let pulled_back: Covector<Vector3<f64>> = transposed_tangent(map, &POINT(), &alpha);
    let of_pairing = differential(
        |v: &Vector3<DualNumber>| {
            let image = map(v);
            image.x * 7.0 + image.y * 11.0
        },
        &POINT(),
    );
    assert_eq!(pulled_back, of_pairing);
    for i in 0..3 {
        let v = Vector3::basis(i) * 2.0;
        let image: Vector2<f64> = derivative_part(&map(&seed(&POINT(), &v)));
        assert_eq!(pulled_back.pairing(&v), alpha.pairing(&image));
    }
}

/// The derivative of q q* = |q|², with the conjugate q*, along q is 2 |q|², and along a rotation of q, which is normal to q, zero.
#[test]
fn derivatives_of_products_of_quaternions() {
    let q = Quaternion { scalar: 1.0, vector: Vector3::new(2.0, -3.0, 4.0) };
    let square = |v: Quaternion<f64>| -> Quaternion<f64> {
        let q: Quaternion<DualNumber> = seed(&q, &v);
        derivative_part(&(q * q.conjugate()))
    };
    assert_eq!(square(q), Quaternion { scalar: 60.0, vector: Vector3::zeros() });
    let rotated = q * Quaternion { scalar: 0.0, vector: Vector3::z() };
    assert_eq!(square(rotated), Vector::zero());
}
