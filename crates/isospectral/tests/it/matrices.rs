//! Products, commutators and exponentials, against sums written out.

use crate::examples::{distance, generic};
use isospectral_flows::lie_poisson::State;
use isospectral_flows::{LargeMatrix, LargeSkewHermitian, Products};
use num_complex::Complex;
use proptest::prelude::*;

/// Returns A B by its definition.
fn product(a: &LargeMatrix, b: &LargeMatrix) -> LargeMatrix {
    let n = a.size();
    LargeMatrix::from_fn(n, |j, k| (0..n).map(|l| a.at(j, l) * b.at(l, k)).sum())
}

fn difference(a: &LargeMatrix, b: &LargeMatrix) -> f64 {
    let mut c = a.clone();
    c.subtract_in_place(b);
    c.norm()
}

fn complex(size: usize, seed: f64) -> LargeMatrix {
    LargeMatrix::from_fn(size, |j, k| {
        let x = (3 * j + 5 * k) as f64 + seed;
        Complex::new((7.1 * x).sin(), (3.3 * x).cos())
    })
}

proptest! {
    #[test]
    fn products_are_sums(size in 0_usize..40, seed in 0.0..1.0_f64) {
        let (a, b) = (complex(size, seed), complex(size, seed + 0.7));
        let mut ab = LargeMatrix::zeros(size);
        let mut products = Products::default();
        products.multiply(&a, &b, &mut ab);
        // N roundings of a sum of N products, three times
        let bound = 8.0 * f64::EPSILON * size as f64 * a.norm() * b.norm();
        prop_assert!(difference(&ab, &product(&a, &b)) <= bound);

        products.multiply_adjoint(&a, &b, &mut ab);
        prop_assert!(difference(&ab, &product(&a, &b.adjoint())) <= bound);

        let (v, w) = (generic(size, seed), generic(size, seed + 2.0));
        let mut commutator = LargeSkewHermitian::zeros(size);
        products.commutator(&v, &w, &mut commutator);
        let (vw, wv) = (product(v.matrix(), w.matrix()), product(w.matrix(), v.matrix()));
        for (j, k) in (0..size).flat_map(|j| (0..size).map(move |k| (j, k))) {
            let error = commutator.at(j, k) - (vw.at(j, k) - wv.at(j, k));
            prop_assert!(error.norm() <= 8.0 * f64::EPSILON * size as f64 * 4.0);
            prop_assert_eq!(commutator.at(j, k), -commutator.at(k, j).conj());
        }
        let square = product(v.matrix(), v.matrix());
        products.multiply_hermitian(v.matrix(), v.matrix(), &mut ab);
        prop_assert!(difference(&ab, &square) <= 8.0 * f64::EPSILON * size as f64 * v.norm().powi(2));
    }

    /// The coordinates of the vector space are those of the entries.
    #[test]
    fn coordinates_are_linear_and_complete(size in 1_usize..9, seed in 0.0..1.0_f64) {
        let (v, w) = (generic(size, seed), generic(size, seed + 1.0));
        let mut copy = v.zeros_like();
        copy.set_coordinates(|i| v.coordinate(i));
        prop_assert_eq!(&copy, &v);
        prop_assert_eq!(v.dimension(), size * size);
        copy.add_multiple(2.0, &w);
        copy.subtract_from(&w);
        for i in 0..v.dimension() {
            prop_assert_eq!(copy.coordinate(i), w.coordinate(i) - (v.coordinate(i) + 2.0 * w.coordinate(i)));
        }
    }
}

/// Returns the diagonal matrix of the numbers i x_j.
fn diagonal(x: &[f64]) -> LargeSkewHermitian {
    LargeSkewHermitian::from_upper(x.len(), |j, k| {
        if j == k { Complex::new(0.0, x[j]) } else { Complex::ZERO }
    })
}

/// exp(V D V*) = V exp(D) V* for a diagonal D and a unitary V, over the sizes of D at which the number of terms
/// changes, and beyond them.
#[test]
fn exponentials_have_the_exponentials_of_the_eigenvalues() {
    let (size, mut products) = (13, Products::default());
    let mut v = LargeMatrix::zeros(size);
    products.exponential_minus_one(&generic(size, 0.4), &mut v);
    for radius in [0.0, 1e-300, 1e-9, 0.008, 0.2, 0.3, 1.0, 1.2, 2.0, 3.5, 5.0, 40.0, 1e3] {
        let angles: Vec<f64> = (0..size).map(|j| radius * (1.7 * j as f64).cos()).collect();
        let mut omega = LargeSkewHermitian::zeros(size);
        products.conjugate(&v, &diagonal(&angles), &mut omega);
        let mut z = LargeMatrix::zeros(size);
        products.exponential_minus_one(&omega, &mut z);
        let mut one_and_v = v.clone();
        (0..size).for_each(|j| one_and_v.set(j, j, v.at(j, j) + Complex::ONE));
        // exp(ix) − 1 = −2 sin²(x/2) + i sin x
        let minus_one = |x: f64| Complex::new(-2.0 * (0.5 * x).sin().powi(2), x.sin());
        let expected = LargeMatrix::from_fn(size, |j, k| {
            (0..size)
                .map(|l| one_and_v.at(j, l) * minus_one(angles[l]) * one_and_v.at(k, l).conj())
                .sum()
        });
        // The rounding of Ω alone is N ε ρ.
        let bound = 8.0 * f64::EPSILON * size as f64 * radius;
        assert!(difference(&z, &expected) <= bound, "{radius} {:e}", difference(&z, &expected));
        // 1 + Z is unitary: Z + Z* + Z Z* = 0
        let mut defect = LargeMatrix::zeros(size);
        products.multiply_adjoint(&z, &z, &mut defect);
        defect.add_in_place(&z);
        defect.add_in_place(&z.adjoint());
        assert!(defect.norm() <= bound, "{radius} {:e}", defect.norm());
    }
}

/// i diag(x) has the trace i Σ x, which a change of basis keeps.
#[test]
fn traces_are_sums_of_eigenvalues() {
    let start = diagonal(&[0.5, -2.25, 4.0, 0.125]);
    assert_eq!(start.trace(), 2.375);
    assert_eq!(LargeSkewHermitian::zeros(3).trace(), 0.0);
}

#[test]
fn conjugation_is_a_change_of_basis() {
    let (size, mut products) = (11, Products::default());
    let (w, mut z) = (generic(size, 0.1), LargeMatrix::zeros(size));
    let mut moved = w.zeros_like();
    products.conjugate(&z, &w, &mut moved);
    assert_eq!(moved, w);
    products.exponential_minus_one(&generic(size, 0.9), &mut z);
    products.conjugate(&z, &w, &mut moved);
    let u = LargeMatrix::from_fn(size, |j, k| z.at(j, k) + if j == k { 1.0 } else { 0.0 });
    let expected = product(&product(&u, w.matrix()), &u.adjoint());
    assert!(difference(moved.matrix(), &expected) < 1e-13);
    assert!(distance(&moved, &w) > 0.1);
}

#[test]
fn matrices_of_different_sizes_give_nan() {
    let (a, b) = (complex(3, 0.0), complex(4, 0.0));
    let mut ab = LargeMatrix::zeros(7);
    Products::default().multiply(&a, &b, &mut ab);
    assert!(ab.size() == 3 && !ab.is_finite());
    assert!(generic(3, 0.0).scalar_product(&generic(4, 0.0)).is_nan());
    assert_eq!([a.at(3, 0), a.at(0, 3)], [Complex::ZERO; 2]);
    let mut z = LargeMatrix::zeros(3);
    let infinite = diagonal(&[f64::INFINITY, 0.0, 1.0]);
    Products::default().exponential_minus_one(&infinite, &mut z);
    assert!(!z.is_finite());
}

/// What is written takes the size of what it is computed from.
#[test]
fn results_of_another_size_are_resized() {
    let (v, w) = (generic(3, 0.2), generic(3, 0.7));
    let (mut small, mut right) = (LargeSkewHermitian::zeros(2), v.zeros_like());
    for result in [&mut small, &mut right] {
        Products::default().commutator(&v, &w, result);
    }
    assert!(small == right && small.norm() > 0.1);
    let z = complex(3, 0.5);
    let mut small = LargeSkewHermitian::zeros(2);
    small.set_difference_of(&z);
    assert_eq!(*small.matrix(), LargeMatrix::from_fn(3, |j, k| z.at(j, k) - z.at(k, j).conj()));
}

#[test]
fn entries_outside_of_a_matrix_are_not_there() {
    let (mut z, one) = (complex(3, 0.5), Complex::ONE);
    let before = z.clone();
    for (j, k) in [(3, 0), (0, 3), (4, 1), (3, 3)] {
        z.set(j, k, one);
        assert_eq!(z.at(j, k), Complex::ZERO);
    }
    assert_eq!(z, before);
    z.set(2, 1, one);
    assert!(z.at(2, 1) == one && z != before);
}

#[test]
fn exponentials_of_too_large_matrices_are_nan() {
    let mut z = LargeMatrix::zeros(2);
    for radius in [1e10, 1e200, f64::INFINITY, f64::NAN] {
        Products::default().exponential_minus_one(&diagonal(&[radius, 1.0]), &mut z);
        assert!(!z.is_finite(), "{radius:e}");
    }
    Products::default().exponential_minus_one(&diagonal(&[1e8, 1.0]), &mut z);
    // Each squaring doubles the error of the angle, and adds a few roundings of its own.
    let error = z.at(0, 0) + 1.0 - Complex::from_polar(1.0, 1e8);
    assert!(error.norm() < 4e8 * f64::EPSILON, "{:e}", error.norm());
}
