//! The laws of u(N), su(N) and so(N) and of their duals, with N known when the program runs.

use isospectral_flows::lie_poisson::{
    Covector, LieAlgebra, SkewHermitian, State, UnitaryAlgebra, Vector, larger,
};
use isospectral_flows::{LargeMatrix, LargeSkewHermitian, Products};
use num_complex::Complex;

type Large = LargeSkewHermitian;

/// The sizes of the matrices: the smallest ones, and those around the tiles of products and of the mirror.
const SIZES: [usize; 8] = [0, 1, 2, 3, 7, 16, 33, 50];

fn bracket(v: &Large, w: &Large) -> Large {
    let mut bracket = v.zeros_like();
    Products::default().commutator(v, w, &mut bracket);
    bracket
}

/// Returns the largest magnitude of a coordinate of a sum of matrices with factors.
fn largest(terms: &[(f64, &Large)]) -> f64 {
    let coordinate = |i| terms.iter().map(|(a, w)| a * w.coordinate(i)).sum::<f64>().abs();
    (0..terms[0].1.dimension()).map(coordinate).fold(0.0, larger)
}

/// The round-off of N products in each of three nested sums, relative to the norms of the factors.
fn round_off(size: usize) -> f64 {
    8.0 * f64::EPSILON * size as f64
}

/// Returns the largest defects of antisymmetry, of Jacobi's identity and of ⟨[U, V], W⟩ = ⟨U, [V, W]⟩.
fn defects(bracket: impl Fn(&Large, &Large) -> Large, [u, v, w]: &[Large; 3]) -> [f64; 3] {
    let both = largest(&[(1.0, &bracket(u, v)), (1.0, &bracket(v, u))]);
    let terms =
        [bracket(u, &bracket(v, w)), bracket(v, &bracket(w, u)), bracket(w, &bracket(u, v))];
    let cyclic = largest(&[(1.0, &terms[0]), (1.0, &terms[1]), (1.0, &terms[2])]);
    let moved = bracket(u, v).scalar_product(w) - u.scalar_product(&bracket(v, w));
    [both, cyclic, moved.abs()]
}

/// Returns three independent matrices: on the span of two, Jacobi's identity holds for every antisymmetric bracket.
fn three(size: usize) -> [Large; 3] {
    [0.2_f64, 1.1, 2.9].map(|seed| {
        Large::from_upper(size, |j, k| {
            let x = (j * size + k) as f64 + 1.0;
            Complex::new(((3.1 + seed) * x).sin(), ((1.7 + seed) * x).cos())
        })
    })
}

#[test]
fn matrices_of_every_size_are_lie_algebras() {
    for size in SIZES {
        let samples = three(size);
        let [a, b, c] = samples.each_ref().map(Large::norm);
        let [both, cyclic, moved] = defects(bracket, &samples);
        assert!(both <= round_off(size) * a * b, "{size}: {both:e}");
        assert!(cyclic <= round_off(size) * a * b * c, "{size}: {cyclic:e}");
        assert!(moved <= round_off(size) * a * b * c, "{size}: {moved:e}");
    }
    // control: a product with a wrong weight in one row is antisymmetric, and not a Lie bracket
    let weighted = |v: &Large, w: &Large| {
        let mut bracket = bracket(v, w);
        bracket.change_upper(|re, im| {
            (0..7).for_each(|k| (re[7 * k], im[7 * k]) = (1.5 * re[7 * k], 1.5 * im[7 * k]));
        });
        bracket
    };
    let [both, cyclic, moved] = defects(weighted, &three(7));
    assert!(both < 1e-13 && cyclic > 0.1 && moved > 0.1, "{both:e} {cyclic:e} {moved:e}");
}

#[test]
fn matrices_without_trace_and_real_ones_are_subalgebras() {
    for size in SIZES {
        let [v, w, _] = three(size);
        // su(N) contains all brackets of u(N).
        let trace = bracket(&v, &w).trace();
        assert!(trace.abs() <= round_off(size) * v.norm() * w.norm(), "{size}: {trace:e}");
        let real = |w: &Large| Large::from_upper(size, |j, k| Complex::from(w.at(j, k).re));
        let of_real = bracket(&real(&v), &real(&w));
        assert!(of_real.matrix().imaginary().iter().all(|x| *x == 0.0), "{size}");
        // control: imaginary symmetric matrices are no subalgebra, their brackets are real
        let imaginary =
            |w: &Large| Large::from_upper(size, |j, k| Complex::new(0.0, w.at(j, k).im));
        let of_imaginary = bracket(&imaginary(&v), &imaginary(&w));
        let largest = of_imaginary.matrix().real().iter().fold(0.0, |m, x| larger(m, x.abs()));
        assert!(size < 2 || largest > 0.1, "{size}");
    }
}

/// Ad_U is an automorphism, and its transpose with respect to ⟨V, W⟩ = −tr(V W) is Ad of U*.
#[test]
fn conjugations_are_automorphisms_and_orthogonal() {
    for size in SIZES {
        let [v, w, omega] = three(size);
        let (mut products, mut z) = (Products::default(), LargeMatrix::zeros(size));
        products.exponential_minus_one(&omega, &mut z);
        let moved = |w: &Large| {
            let mut moved = w.zeros_like();
            Products::default().conjugate(&z, w, &mut moved);
            moved
        };
        let (first, second) = (moved(&bracket(&v, &w)), bracket(&moved(&v), &moved(&w)));
        // Z itself has the rounding errors of N terms of size |Ω|.
        let bound = 4.0 * round_off(size) * (1.0 + omega.norm()) * v.norm() * w.norm();
        let defect = largest(&[(1.0, &first), (-1.0, &second)]);
        assert!(defect <= bound, "{size}: {defect:e} {bound:e}");
        let product = moved(&v).scalar_product(&moved(&w)) - v.scalar_product(&w);
        assert!(product.abs() <= bound, "{size}: {product:e} {bound:e}");
        // control: the conjugation moves the matrices
        assert!(size < 2 || largest(&[(1.0, &moved(&v)), (-1.0, &v)]) > 0.1, "{size}");
    }
}

/// Compares the bracket with that of the algebra whose size the compiler knows.
fn same_as_small<const N: usize>() {
    let [v, w, _] = three(N);
    let small = |w: &Large| SkewHermitian::<f64, N>::from_coordinates(|i| w.coordinate(i));
    let expected = UnitaryAlgebra::<N>.bracket::<f64>(&small(&v), &small(&w));
    let found = bracket(&v, &w);
    for i in 0..N * N {
        let error = (found.coordinate(i) - expected.coordinate(i)).abs();
        assert!(error <= round_off(N) * v.norm() * w.norm(), "{N}, {i}: {error:e}");
    }
    // ad*_ξ μ belongs to [μ, ξ] in the scalar product, in which coordinates off the diagonal count twice.
    let weight = |i: usize| if i % N == i / N { 1.0 } else { 2.0 };
    let mu = Covector(SkewHermitian::<f64, N>::from_coordinates(|i| w.coordinate(i) * weight(i)));
    let rate = UnitaryAlgebra::<N>.coadjoint::<f64>(&small(&v), &mu);
    let commutator = bracket(&w, &v);
    for i in 0..N * N {
        let error = (rate.coordinate(i) - commutator.coordinate(i) * weight(i)).abs();
        assert!(error <= round_off(N) * v.norm() * w.norm(), "{N}, {i}: {error:e}");
    }
}

#[test]
fn a_size_at_run_time_changes_no_bracket() {
    same_as_small::<1>();
    same_as_small::<2>();
    same_as_small::<3>();
    same_as_small::<8>();
    same_as_small::<20>();
}
