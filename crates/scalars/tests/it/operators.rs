//! Operators: of vectors coordinate by coordinate, and of dual numbers against the rules of differentiation.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Neg, Sub, SubAssign};
use generic_scalars::{Covector, DualNumber, Pair, Power, Quaternion, Vector, map_coordinates};
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;

/// The coordinates are dyadic numbers, so that sums are exact.
fn check<V>()
where
    V: Vector<Scalar = f64> + Debug,
    V: Add<Output = V> + Sub<Output = V> + Neg<Output = V> + AddAssign + SubAssign,
{
    let (f, g) = (|i: usize| 1.5 - 0.25 * i as f64, |i: usize| 3.0 + 0.5 * (i * i) as f64);
    let (u, v) = (V::from_coordinates(f), V::from_coordinates(g));
    let equal = |found: V, expected: &dyn Fn(usize) -> f64| {
        (0..V::DIM).for_each(|i| assert_eq!(found.coordinate(i), expected(i), "{found:?} at {i}"));
    };
    equal(u + v, &|i| f(i) + g(i));
    equal(u - v, &|i| f(i) - g(i));
    equal(-u, &|i| -f(i));
    let (mut sum, mut difference) = (u, u);
    sum += v;
    difference -= v;
    assert_eq!((sum, difference), (u + v, u - v));
}

#[test]
fn vectors_are_added_coordinate_by_coordinate() {
    check::<Vector3<f64>>();
    check::<Vector2<Complex<f64>>>();
    check::<Covector<Vector3<f64>>>();
    check::<Pair<Vector2<f64>, Covector<Vector3<f64>>>>();
    check::<Power<Vector2<f64>, 3>>();
    check::<Quaternion<f64>>();
    check::<Covector<Pair<Quaternion<f64>, Power<Vector2<f64>, 2>>>>();
}

/// The rules of differentiation, with exact numbers.
#[test]
fn operators_of_dual_numbers_are_the_rules_of_differentiation() {
    let (x, y) = (DualNumber::new(5.0, 3.0), DualNumber::new(-2.0, 0.5));
    let parts = |x: DualNumber| (x.value_without_derivative(), x.derivative());
    assert_eq!(parts(x + y), (3.0, 3.5));
    assert_eq!(parts(x - y), (7.0, 2.5));
    assert_eq!(parts(x * y), (-10.0, 3.0 * -2.0 + 5.0 * 0.5));
    // (x′y − xy′)/y²
    assert_eq!(parts(x / y), (-2.5, (3.0 * -2.0 - 5.0 * 0.5) / 4.0));
    // 5 = (−2)(−2) + 1, and the quotient −2 is a constant.
    assert_eq!(parts(x % y), (1.0, 3.0 - -2.0 * 0.5));
    assert_eq!(parts(-x), (-5.0, -3.0));
    let assigned = |change: &dyn Fn(&mut DualNumber)| {
        let mut changed = x;
        change(&mut changed);
        changed
    };
    assert_eq!(assigned(&|x| *x += y), x + y);
    assert_eq!(assigned(&|x| *x -= y), x - y);
    assert_eq!(assigned(&|x| *x *= y), x * y);
    assert_eq!(assigned(&|x| *x /= y), x / y);
    assert_eq!(assigned(&|x| *x %= y), x % y);
    // A number is a constant.
    let c = DualNumber::constant(4.0);
    assert_eq!((x + 4.0, x - 4.0, x * 4.0, x / 4.0), (x + c, x - c, x * c, x / c));
}

/// Hamilton's i² = j² = k² = ijk = −1, and the norm of a product is the product of the norms.
#[test]
fn quaternions_obey_the_rules_of_hamilton() {
    let unit = |axis| Quaternion { scalar: 0.0, vector: axis };
    let [i, j, k] = [Vector3::x(), Vector3::y(), Vector3::z()].map(unit);
    let minus_one = Quaternion { scalar: -1.0, vector: Vector3::zeros() };
    assert_eq!([i * i, j * j, k * k, i * j * k], [minus_one; 4]);
    let p = Quaternion { scalar: 2.0, vector: Vector3::new(-1.0, 3.0, 5.0) };
    let q = Quaternion { scalar: 7.0, vector: Vector3::new(4.0, -2.0, 6.0) };
    let square = |q: Quaternion<f64>| q.scalar * q.scalar + q.vector.dot(&q.vector);
    assert_eq!(square(p * q), square(p) * square(q));
    assert_eq!((p + q) * (p - q), p * p - p * q + q * p - q * q);
    let doubled: Quaternion = map_coordinates(&p, |x: f64| x + x);
    assert_eq!(doubled, p + p);
}
