//! Zeitlin's model: the operator from spin matrices, exact waves, invariants, and numbers of an independent program.

use lie_poisson_systems::collective_integrators::{
    Direct, Integrator, RungeKutta, Start, fitted_order,
};
use lie_poisson_systems::isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, IsospectralField, IsospectralRungeKutta,
    LargeMatrix, LargeSkewHermitian, Products,
};
use lie_poisson_systems::lie_poisson::{State, larger};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{
    QuantisedLaplacian, SystemError, VorticityCoefficients, Zeitlin, associated_legendre,
};
use std::f64::consts::PI;

pub fn largest(w: &LargeSkewHermitian) -> f64 {
    (0..w.dimension()).map(|i| w.coordinate(i).abs()).fold(0.0, larger)
}

pub fn difference(a: &LargeSkewHermitian, b: &LargeSkewHermitian) -> f64 {
    let mut c = a.clone();
    c.subtract_in_place(b);
    largest(&c)
}

/// Returns a matrix without trace whose entries look random.
fn generic(size: usize) -> LargeSkewHermitian {
    let entry = |j: usize, k: usize| {
        let x = (j * size + k) as f64 + 1.0;
        Complex::new((12.9898 * x).sin(), (12.9898 * 2.7 * x + 0.3).sin())
    };
    let mean = (0..size).map(|j| entry(j, j).im).sum::<f64>() / size as f64;
    LargeSkewHermitian::from_upper(size, |j, k| {
        entry(j, k) - if j == k { Complex::new(0.0, mean) } else { Complex::ZERO }
    })
}

/// Returns a smooth vorticity of degree 1 to `most`.
fn smooth(size: usize, most: usize) -> VorticityCoefficients {
    VorticityCoefficients::from_fn(size, |l, m| {
        let x = (7 * l + m) as f64;
        let value = Complex::new((3.1 * x).sin(), (5.3 * x).cos()) / l as f64;
        if (1..=most).contains(&l) { value } else { Complex::ZERO }
    })
}

/// Returns i S₁, i S₂ and i S₃.
fn spins(size: usize) -> [LargeSkewHermitian; 3] {
    let raise = |j: usize, k: usize| {
        if k == j + 1 { 0.5 * ((k * (size - k)) as f64).sqrt() } else { 0.0 }
    };
    let height = |j: usize| 0.5 * (size as f64 - 1.0) - j as f64;
    [
        LargeSkewHermitian::from_upper(size, |j, k| Complex::new(0.0, raise(j, k))),
        LargeSkewHermitian::from_upper(size, |j, k| Complex::new(raise(j, k), 0.0)),
        LargeSkewHermitian::from_upper(size, |j, k| {
            Complex::new(0.0, if j == k { height(j) } else { 0.0 })
        }),
    ]
}

#[test]
fn the_operator_is_the_sum_of_double_commutators_with_spins() {
    for size in [2, 3, 8, 17] {
        let (laplacian, w) = (QuantisedLaplacian::new(size).unwrap(), generic(size));
        let (mut image, mut once, mut twice) = (w.clone(), w.clone(), w.clone());
        let (mut sum, mut products) = (w.zeros_like(), Products::default());
        for spin in spins(size) {
            // −[S, [S, W]] = [iS, [iS, W]]
            products.commutator(&spin, &w, &mut once);
            products.commutator(&spin, &once, &mut twice);
            sum.add_in_place(&twice);
        }
        laplacian.apply(&w, &mut image);
        let round_off = f64::EPSILON * (size * size) as f64;
        assert!(difference(&image, &sum) < 16.0 * round_off, "{size}");
        let mut back = w.clone();
        laplacian.solve(1.0, &image, &mut back);
        assert!(difference(&back, &w) < 64.0 * round_off, "{size} {:e}", difference(&back, &w));
        laplacian.solve(-2.0, &image, &mut back);
        back.scale_in_place(-0.5);
        assert!(difference(&back, &w) < 64.0 * round_off);
    }
}

#[test]
fn harmonics_are_orthonormal_eigenvectors() {
    let size = 24;
    let laplacian = QuantisedLaplacian::new(size).unwrap();
    for (l, m) in [(0, 0), (1, 0), (1, 1), (5, 2), (12, 0), (13, 12), (23, 0), (23, 11), (23, 23)] {
        let mut omega = VorticityCoefficients::zeros(size);
        omega.set(l, m, Complex::new(1.0, 0.5));
        let w = omega.matrix(&laplacian);
        let (mut image, mut expected) = (w.clone(), w.clone());
        laplacian.apply(&w, &mut image);
        expected.scale_in_place(-((l * (l + 1)) as f64));
        let error = difference(&image, &expected) / largest(&w);
        assert!(error < 16.0 * f64::EPSILON * (size * size) as f64, "{l} {m} {error:e}");
        let back = VorticityCoefficients::of_matrix(&laplacian, &w);
        for (k, n) in (0..size).flat_map(|k| (0..=k).map(move |n| (k, n))) {
            let error = (back.at(k, n) - omega.at(k, n)).norm();
            assert!(error < 1e-13, "{l} {m}, {k} {n}: {error:e}");
        }
    }
    assert!(laplacian.harmonic(3, 4).is_empty() && laplacian.harmonic(24, 0).is_empty());
    // The entries of a matrix of size 512 neither overflow nor vanish.
    let large = QuantisedLaplacian::new(512).unwrap();
    for (l, m) in [(511, 0), (511, 255), (300, 299), (511, 128)] {
        let square: f64 = large.harmonic(l, m).iter().map(|x| x * x).sum();
        assert!((square * 4.0 * PI / 512.0 - 1.0).abs() < 1e-12);
    }
    // Nor do those of a matrix so large that the numbers of the recurrence would overflow.
    let huge = QuantisedLaplacian::new(4096).unwrap();
    for (l, m) in [(4095, 0), (2048, 2000), (4095, 3000), (4090, 4089)] {
        let entries = huge.harmonic(l, m);
        let square: f64 = entries.iter().map(|x| x * x).sum();
        assert!((square * 4.0 * PI / 4096.0 - 1.0).abs() < 1e-12, "{l} {m}: {square}");
    }
}

/// T_lm is Y_lm at the heights of its entries, up to 1/N².
#[test]
fn harmonics_become_functions() {
    let error = |size: usize, l: usize, m: usize| {
        let laplacian = QuantisedLaplacian::new(size).unwrap();
        let middle = 0.5 * (size as f64 - 1.0 - m as f64);
        let value =
            |j: usize| associated_legendre(l, m, 2.0 * (middle - j as f64) / size as f64)[l - m];
        let entries = laplacian.harmonic(l, m);
        (0..size - m).map(|j| (entries[j] - value(j)).abs()).fold(0.0, larger)
    };
    for (l, m) in [(1, 0), (1, 1), (2, 1), (3, 2), (6, 0), (6, 5)] {
        let errors = [50, 100, 200].map(|size| (1.0 / size as f64, error(size, l, m)));
        let order = fitted_order(&errors, 1e-12).unwrap();
        assert!(order > 0.9 && errors[2].1 < 2e-2, "{l} {m}: order {order}, {errors:?}");
    }
}

#[test]
fn functions_are_sums_of_harmonics() {
    let omega = smooth(9, 8);
    // ∫ω² over the sphere, by a rule that is exact for the degree
    let (rows, columns) = (64, 20);
    let mut integral = 0.0;
    for row in 0..rows {
        let colatitude = PI * (row as f64 + 0.5) / rows as f64;
        // Fejér's first rule in cos θ
        let weight = 2.0 / rows as f64
            * (1.0
                - 2.0
                    * (1..=rows / 2)
                        .map(|j| (2.0 * j as f64 * colatitude).cos() / (4.0 * (j * j) as f64 - 1.0))
                        .sum::<f64>());
        let circle = omega.values_on_circle(colatitude, columns);
        integral += weight * circle.iter().map(|x| x * x).sum::<f64>() * 2.0 * PI / columns as f64;
        let longitude = 2.0 * PI * 7.0 / columns as f64;
        assert!((omega.value(colatitude, longitude) - circle[7]).abs() < 1e-13);
    }
    let fluid = Zeitlin::new(9).unwrap();
    let enstrophy = fluid.enstrophy(&fluid.vorticity(&omega));
    assert!((integral - enstrophy).abs() < 1e-11 * enstrophy, "{integral} {enstrophy}");
}

/// Coefficients that no function of the size has stay 0, and orders without coefficients add nothing to a circle.
#[test]
fn one_coefficient_is_one_harmonic() {
    let mut omega = VorticityCoefficients::zeros(4);
    assert_eq!(omega.size(), 4);
    omega.set(2, 1, Complex::new(0.3, -0.2));
    let one = omega.clone();
    omega.set(4, 0, Complex::from(1.0));
    omega.set(2, 3, Complex::from(1.0));
    assert_eq!(omega, one);
    let (colatitude, columns) = (0.7_f64, 5);
    let height = associated_legendre(2, 1, colatitude.cos())[1];
    for (n, value) in one.values_on_circle(colatitude, columns).into_iter().enumerate() {
        let longitude = 2.0 * PI * n as f64 / columns as f64;
        // ω_21 Y_21 and its conjugate for m = −1
        let expected = 2.0 * height * (0.3 * longitude.cos() + 0.2 * longitude.sin());
        assert!((value - expected).abs() < 4.0 * f64::EPSILON, "{n} {value} {expected}");
    }
}

/// The angular velocity of a Rossby–Haurwitz wave is exact for every N, so that errors are those of the methods.
#[test]
fn waves_turn_at_the_exact_rate() {
    let (size, c, rotation, l, m) = (12, 0.8, 0.6, 5, 3);
    let fluid = Zeitlin::new(size).unwrap().with_rotation(rotation).unwrap();
    let mut omega = VorticityCoefficients::zeros(size);
    omega.set(1, 0, Complex::from((c + 2.0 * rotation) * (4.0 * PI / 3.0).sqrt()));
    omega.set(l, m, Complex::new(0.3, 0.1));
    omega.set(l, 1, Complex::new(0.2, -0.1));
    let sigma = (c + 2.0 * rotation) / (l * (l + 1)) as f64 - c / 2.0;
    let start = fluid.vorticity(&omega);
    let errors = |end: &dyn Fn(f64, u64) -> LargeSkewHermitian| {
        [10, 20, 40].map(|n| {
            let (h, end) = (2.0 / n as f64, fluid.coefficients(&end(2.0 / n as f64, n)));
            let error = |m: usize| {
                let wave = Complex::from_polar(1.0, m as f64 * sigma * 2.0);
                (end.at(l, m) - omega.at(l, m) * wave).norm()
            };
            (h, error(m).max(error(1)).max((end.at(1, 0) - omega.at(1, 0)).norm()))
        })
    };
    let assert_order = |name: &str, order: f64, end: &dyn Fn(f64, u64) -> LargeSkewHermitian| {
        let errors = errors(end);
        let fitted = fitted_order(&errors, 1e-13).unwrap();
        assert!((fitted - order).abs() < 0.3, "{name}: {fitted} {errors:?}");
    };
    let magnus = GaussMagnus::new(2, &fluid).unwrap();
    assert_order("Gauss–Magnus", 4.0, &|h, n| magnus.after(&start, h, n).unwrap().state);
    let midpoint = ExponentialMidpoint::new(&fluid);
    assert_order("exponential", 2.0, &|h, n| midpoint.after(&start, h, n).unwrap().state);
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2).unwrap(), &fluid);
    assert_order("Gauss", 4.0, &|h, n| gauss.after(&start, h, n).unwrap().state);
    let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(&fluid));
    assert_order("RK4", 4.0, &|h, n| direct.after(&start, h, n).unwrap().state);
}

#[test]
#[ignore = "long"]
fn invariants_are_conserved() {
    let size = 16;
    let fluid = Zeitlin::new(size).unwrap();
    let start = fluid.vorticity(&smooth(size, 6));
    // the changes of Casimirs, relative to the enstrophy, of the angular momentum and of the energy
    let drift = |end: &LargeSkewHermitian| {
        let change = |before: &[f64], after: &[f64]| {
            before.iter().zip(after).map(|(a, b)| (a - b).abs()).fold(0.0, larger)
        };
        let casimirs = change(&fluid.casimirs(&start, 5), &fluid.casimirs(end, 5));
        let momentum = change(&fluid.angular_momentum(&start), &fluid.angular_momentum(end));
        (
            casimirs / fluid.enstrophy(&start),
            momentum,
            (fluid.energy(end) - fluid.energy(&start)).abs(),
        )
    };
    let after = |method: &dyn Fn(f64, u64) -> LargeSkewHermitian| {
        [200, 400].map(|steps| drift(&method(10.0 / steps as f64, steps)))
    };
    assert!((fluid.casimirs(&start, 2)[1] - fluid.enstrophy(&start)).abs() < 1e-12);
    // Rounding errors of 400 steps. The factor is the degree of the Casimirs times N.
    let round_off = 400.0 * f64::EPSILON * (5 * size) as f64;
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2).unwrap(), &fluid);
    let [coarse, fine] = after(&|h, steps| gauss.after(&start, h, steps).unwrap().state);
    for (casimirs, momentum, _) in [coarse, fine] {
        assert!(casimirs < round_off && momentum < round_off, "{casimirs:e} {momentum:e}");
    }
    assert!(coarse.2 > 12.0 * fine.2 && fine.2 > 0.0, "order 4: {:e} {:e}", coarse.2, fine.2);
    // The Gauss–Magnus method conserves Casimirs, and the angular momentum by its order only.
    let magnus = GaussMagnus::new(2, &fluid).unwrap();
    let [coarse, fine] = after(&|h, steps| magnus.after(&start, h, steps).unwrap().state);
    assert!(coarse.0 < round_off && fine.0 < round_off, "{:e} {:e}", coarse.0, fine.0);
    assert!(coarse.1 > 12.0 * fine.1 && fine.1 > round_off, "{:e} {:e}", coarse.1, fine.1);
    assert!(coarse.2 > 12.0 * fine.2, "{:e} {:e}", coarse.2, fine.2);
    // The control: an explicit method loses the Casimirs.
    let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(&fluid));
    let [coarse, fine] = after(&|h, steps| direct.after(&start, h, steps).unwrap().state);
    assert!(fine.0 > round_off && coarse.0 > fine.0, "{:e} {:e}", coarse.0, fine.0);
}

/// On and above the diagonal, row by row: P = Δ⁻¹W for [`generic`] and N = 5, and W after four steps of 1/20 of the
/// isospectral midpoint rule, both from quflow at commit b42eede (`solve_poisson`, and `isomp_fixedpoint` with
/// `tol=1e-16, maxit=200`).
const QUFLOW_STREAM: [(f64, f64); 15] = [
    (0.0, 0.0954101563065751),
    (-0.1324897474022421, -0.10769212695594901),
    (-0.07132698868530797, 0.07287272013303189),
    (-0.051365763922081455, -0.03463066561987653),
    (-0.042721316743036496, 0.01318657373324907),
    (0.0, -0.054143667059214334),
    (-0.06342431850416624, 0.0223685617057332),
    (0.020261837671229452, -0.01800712946595765),
    (0.04265061808657877, 0.0376220362847823),
    (0.0, -0.01708663055749779),
    (-0.059233463396342494, -0.02690285873294954),
    (0.0025883196277843136, 0.07477884319655947),
    (0.0, -0.06722232227878835),
    (-0.13839802271636362, 0.0988152578389931),
    (0.0, 0.0430424635889254),
];
const QUFLOW_END: [(f64, f64); 15] = [
    (0.0, -0.6448881338490655),
    (0.7393152156599897, 0.9729312261922215),
    (0.9712660826814719, -0.8604027586578806),
    (1.0048509288308303, 0.6459175016539476),
    (0.9427372540742804, -0.17415835039973382),
    (0.0, 0.9389127858857825),
    (-0.22169492974654947, -0.9797442410735534),
    (-0.5289480372006302, 0.9668058105694594),
    (-0.8824139903537553, -0.642074879554785),
    (0.0, -0.6616883670750696),
    (-0.38910244645063435, 0.976623478579892),
    (-0.006654093153389329, -0.8957698332340446),
    (0.0, 0.850562830579308),
    (0.8509802571719943, -0.9402486360404678),
    (0.0, -0.482899115540955),
];

#[test]
fn numbers_are_those_of_quflow() {
    let (size, w) = (5, generic(5));
    let fluid = Zeitlin::new(size).unwrap();
    let compare = |w: &LargeSkewHermitian, numbers: &[(f64, f64)]| {
        let places = (0..size).flat_map(|j| (j..size).map(move |k| (j, k)));
        for ((j, k), (re, im)) in places.zip(numbers) {
            let error = (w.at(j, k) - Complex::new(*re, *im)).norm();
            assert!(error < 4e-15, "{j} {k} {error:e}");
        }
    };
    let mut p = w.clone();
    fluid.stream_into(&w, &mut p);
    compare(&p, &QUFLOW_STREAM);
    let midpoint = IsospectralRungeKutta::new(RungeKutta::implicit_midpoint(), &fluid);
    compare(&midpoint.after(&w, 0.05, 4).unwrap().state, &QUFLOW_END);
    let magnus = GaussMagnus::new(1, &fluid).unwrap().after(&w, 0.05, 4).unwrap().state;
    assert!(difference(&magnus, &midpoint.after(&w, 0.05, 4).unwrap().state) > 1e-6);
}

#[test]
fn rates_are_those_of_the_bracket() {
    let fluid = Zeitlin::new(7).unwrap();
    let (w, mut p) = (generic(7), generic(7));
    fluid.stream_into(&w, &mut p);
    let product = |a: &LargeSkewHermitian, b: &LargeSkewHermitian| {
        LargeMatrix::from_fn(7, |j, k| (0..7).map(|l| a.at(j, l) * b.at(l, k)).sum())
    };
    let (pw, wp, rate) = (product(&p, &w), product(&w, &p), fluid.rate(&w));
    for (j, k) in (0..7).flat_map(|j| (0..7).map(move |k| (j, k))) {
        let expected = (pw.at(j, k) - wp.at(j, k)) / fluid.planck_constant();
        assert!((rate.at(j, k) - expected).norm() < 1e-13);
    }
}

#[test]
fn sizes_and_rotations_are_checked() {
    for size in [0, 1] {
        assert!(
            matches!(Zeitlin::new(size), Err(SystemError::Count { found, .. }) if found == size)
        );
    }
    for rotation in [f64::NAN, f64::INFINITY] {
        let refused = Zeitlin::new(4).unwrap().with_rotation(rotation);
        assert!(matches!(refused, Err(SystemError::NotFinite { .. })));
    }
    let fluid = Zeitlin::new(4).unwrap();
    let magnus = GaussMagnus::new(1, &fluid).unwrap();
    assert!(magnus.step(&generic(5), 0.1, &mut magnus.workspace()).is_err());
    let mut p = generic(4);
    fluid.stream_into(&generic(5), &mut p);
    assert!(!p.is_finite());
    assert!(fluid.coefficients(&generic(5)).at(1, 0).is_nan());
    assert!(fluid.angular_momentum(&generic(5))[0].is_nan());
    let laplacian = fluid.laplacian();
    assert_eq!(laplacian.size(), 4);
    for (w, mut image) in [(generic(5), generic(4)), (generic(4), generic(5))] {
        laplacian.apply(&w, &mut image);
        assert!(!image.is_finite());
    }
    let huge = QuantisedLaplacian::new(usize::MAX);
    assert!(matches!(huge, Err(SystemError::TooMany { .. })));
    assert!(associated_legendre(3, 1, f64::NAN).iter().all(|x| x.is_nan()));
    assert!(associated_legendre(2, 3, 0.5).is_empty());
}
