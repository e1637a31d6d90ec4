//! Orders, spectra and published formulas.

use crate::examples::{Quadratic, casimirs, distance, generic};
use isospectral_flows::collective_integrators::diagnostics::reversibility_defect;
use isospectral_flows::collective_integrators::{
    Composition, Direct, Integrator, LiftFree, RungeKutta, Start, Substeps, fitted_order,
};
use isospectral_flows::lie_poisson::{
    Automatic, Covector, Energy, LiePoisson, Real, SkewHermitian, State, UnitaryAlgebra, larger,
};
use isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, IsospectralField, IsospectralRungeKutta,
    LargeMatrix, LargeSkewHermitian, Products,
};
use momentum_map::ComplexMatrices;
use num_complex::Complex;

const SIZE: usize = 6;

type Large = LargeSkewHermitian;

fn after<I>(integrator: &I, start: &Large, h: f64, steps: u64) -> Large
where
    I: Start<State = Large, Momentum = Large>,
{
    integrator.after(start, h, steps).unwrap().state
}

fn reference(start: &Large) -> Large {
    after(&GaussMagnus::new(3, Quadratic(SIZE)).unwrap(), start, 1.0 / 256.0, 256)
}

/// Asserts that the error at t = 1 has the given order.
fn assert_order<I>(integrator: &I, order: f64, steps: [u64; 4])
where
    I: Start<State = Large, Momentum = Large>,
{
    let start = generic(SIZE, 0.3);
    let end = reference(&start);
    let error = |n: u64| distance(&after(integrator, &start, 1.0 / n as f64, n), &end);
    let errors = steps.map(|n| (1.0 / n as f64, error(n)));
    let fitted = fitted_order(&errors, 1e-12).unwrap();
    assert!((fitted - order).abs() < 0.2, "order {fitted} instead of {order}: {errors:?}");
}

#[test]
fn orders_are_as_documented() {
    let field = || Quadratic(SIZE);
    for (stages, steps) in [(1, [8, 16, 32, 64]), (2, [8, 16, 32, 64]), (3, [6, 9, 12, 18])] {
        let magnus = GaussMagnus::new(stages, field()).unwrap();
        assert_eq!(magnus.order(), 2 * stages);
        assert_order(&magnus, magnus.order() as f64, steps);
    }
    let midpoint = ExponentialMidpoint::new(field());
    assert_order(&midpoint, 2.0, [8, 16, 32, 64]);
    assert_order(&Composition::new(midpoint, Substeps::suzuki4()), 4.0, [8, 16, 24, 32]);
    let collective = |scheme| IsospectralRungeKutta::new(scheme, field());
    assert_order(&collective(RungeKutta::implicit_midpoint()), 2.0, [8, 16, 32, 64]);
    assert_order(&collective(RungeKutta::gauss(2).unwrap()), 4.0, [8, 16, 32, 64]);
    let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(field()));
    assert_order(&direct, 4.0, [32, 64, 128, 256]);
}

/// Returns the largest drift of a Casimir over a run.
fn drift<I>(integrator: &I) -> f64
where
    I: Start<State = Large, Momentum = Large>,
{
    let start = generic(SIZE, 0.3);
    let (before, end) = (casimirs(&start, start.norm()), after(integrator, &start, 0.1, 200));
    assert!(distance(&start, &end) > 0.1);
    before.iter().zip(casimirs(&end, start.norm())).map(|(a, b)| (a - b).abs()).fold(0.0, larger)
}

#[test]
fn spectra_are_conserved_to_round_off_and_by_explicit_methods_not() {
    // 200 steps with a few rounding errors each, which are unbiased
    let round_off = 1e-14;
    for stages in [1, 2, 3] {
        assert!(drift(&GaussMagnus::new(stages, Quadratic(SIZE)).unwrap()) < round_off);
        let loose = GaussMagnus::new(stages, Quadratic(SIZE)).unwrap().with_tolerance(1e-3);
        assert!(drift(&loose) < round_off);
    }
    assert!(drift(&ExponentialMidpoint::new(Quadratic(SIZE))) < round_off);
    let gauss = RungeKutta::gauss(3).unwrap();
    assert!(drift(&IsospectralRungeKutta::new(gauss, Quadratic(SIZE))) < round_off);
    let rk4 = Direct::new(RungeKutta::rk4(), CommutatorField::new(Quadratic(SIZE)));
    assert!(drift(&rk4) > 1e-9);
    let explicit = IsospectralRungeKutta::new(RungeKutta::rk4(), Quadratic(SIZE));
    assert!(drift(&explicit) > 1e-9, "a method that is not symplectic gives no unitary Q");
}

/// Wₘ of the published midpoint rule, from both of its equations.
#[test]
fn the_midpoint_rule_is_that_of_modin_and_viviani() {
    let (start, h) = (generic(SIZE, 0.8), 0.2);
    let midpoint = IsospectralRungeKutta::new(RungeKutta::implicit_midpoint(), Quadratic(SIZE));
    let end = midpoint.step(&start, h, &mut midpoint.workspace()).unwrap().point;
    // Wₘ = W₀ + (h/2)[B, Wₘ] + (h²/4) B Wₘ B by sweeps, W₁ = Wₘ + (h/2)[B, Wₘ] − (h²/4) B Wₘ B
    let (mut products, mut middle) = (Products::default(), start.clone());
    let mut b = start.zeros_like();
    let (mut commutator, mut once, mut twice) =
        (start.zeros_like(), LargeMatrix::zeros(SIZE), LargeMatrix::zeros(SIZE));
    let mut published = start.clone();
    for _ in 0..200 {
        Quadratic(SIZE).generator_into(&middle, &mut b);
        products.commutator(&b, &middle, &mut commutator);
        products.multiply(b.matrix(), middle.matrix(), &mut once);
        products.multiply(&once, b.matrix(), &mut twice);
        let square = LargeSkewHermitian::part_of(&twice);
        published = middle.clone();
        middle = start.clone();
        for (sign, sum) in [(1.0, &mut middle), (-1.0, &mut published)] {
            sum.add_multiple(0.5 * h, &commutator);
            sum.add_multiple(sign * 0.25 * h * h, &square);
        }
    }
    assert!(distance(&end, &published) < 1e-14, "{:e}", distance(&end, &published));
    assert!(distance(&end, &start) > 0.01);
}

const N: usize = 3;

/// The Hamiltonian Σ f_jk |H_jk|² with the factors of [`Quadratic`], for N known to the compiler.
#[derive(Clone, Copy)]
struct Fixed;

impl Energy for Fixed {
    type Space = LiePoisson<UnitaryAlgebra<N>>;

    fn energy<T: Real>(&self, mu: &Covector<SkewHermitian<T, N>>) -> T {
        let h = UnitaryAlgebra::<N>.hermitian(mu);
        let term =
            |i: usize| (h[i].re * h[i].re + h[i].im * h[i].im) * Quadratic::factor(i % N, i / N);
        (1..N * N).fold(term(0), |sum, i| sum + term(i))
    }
}

/// The collective integrators for N known to the compiler make the same steps, with the signs that are documented.
///
/// With H = −iW, ⟨μ, ξ⟩ = Re tr((iH)* ξ) is ⟨W, ξ⟩. The differential of Σ f_jk |W_jk|² is dh_jk = 2 f_jk W_jk. For the minus
/// bracket B = −dh, which is −2 times that of [`Quadratic`]: the same as steps of −2h.
#[test]
fn fixed_and_large_sizes_agree() {
    let start = generic(N, 0.2);
    let minus_i = -Complex::<f64>::I;
    let hermitian =
        nalgebra::SMatrix::<Complex<f64>, N, N>::from_fn(|j, k| minus_i * start.at(j, k));
    let mu = UnitaryAlgebra::<N>.momentum(&hermitian);
    let fixed =
        LiftFree::new(RungeKutta::gauss(2).unwrap(), ComplexMatrices::<N>, Automatic(Fixed));
    let fixed_end = UnitaryAlgebra::<N>.hermitian(&fixed.after(&mu, 0.02, 50).unwrap().momentum);
    let large = IsospectralRungeKutta::new(RungeKutta::gauss(2).unwrap(), Quadratic(N));
    let difference = |h: f64| {
        let end = after(&large, &start, h, 50);
        let places = (0..N).flat_map(|j| (0..N).map(move |k| (j, k)));
        let error = |(j, k)| (minus_i * end.at(j, k) - fixed_end[(j, k)]).norm();
        places.map(error).fold(0.0, larger)
    };
    assert!(difference(-0.04) < 1e-13, "{:e}", difference(-0.04));
    assert!(difference(0.04) > 0.1);
}

/// The error of the exponential methods does not grow with the spectral radius of B, and that of the collective midpoint
/// rule does.
///
/// The spectral radius of B is enlarged by a multiple of the unit, which does not change the solution.
#[test]
fn exponential_methods_do_not_see_what_commutes() {
    /// B = i r + the generator of [`Quadratic`].
    struct Rotating(f64);
    impl IsospectralField for Rotating {
        fn size(&self) -> usize {
            SIZE
        }
        fn generator_into(&self, w: &Large, b: &mut Large) {
            Quadratic(SIZE).generator_into(w, b);
            b.change_upper(|_, im| {
                (0..SIZE).for_each(|j| im[j + SIZE * j] += self.0);
            });
        }
    }
    let (start, h) = (generic(SIZE, 0.3), 0.25);
    let error = |end: Large, slow: Large| distance(&end, &slow);
    let magnus = |r: f64| after(&GaussMagnus::new(2, Rotating(r)).unwrap(), &start, h, 8);
    let exponential = |r: f64| after(&ExponentialMidpoint::new(Rotating(r)), &start, h, 8);
    let gauss = |r: f64| {
        let scheme = RungeKutta::implicit_midpoint();
        after(&IsospectralRungeKutta::new(scheme, Rotating(r)), &start, h, 8)
    };
    for r in [2.0, 6.0] {
        assert!(error(magnus(r), magnus(0.0)) < 1e-13);
        assert!(error(exponential(r), exponential(0.0)) < 1e-12);
        assert!(error(gauss(r), gauss(0.0)) > 1e-3, "{r}");
    }
}

/// Steps do not depend on units: W and B multiplied by s, and time divided by s.
#[test]
fn results_do_not_depend_on_units() {
    let start = generic(4, 0.6);
    let field = || Quadratic(4);
    let magnus = GaussMagnus::new(2, field()).unwrap();
    let exponential = ExponentialMidpoint::new(field());
    let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(2).unwrap(), field());
    for exponent in [-90, -30, 40, 100] {
        let s = 2.0_f64.powi(exponent);
        let mut scaled = start.clone();
        scaled.scale_in_place(s);
        let compare = |ends: [Large; 2]| {
            let [mut one, other] = ends;
            one.scale_in_place(s);
            assert!(distance(&one, &other) <= 8.0 * f64::EPSILON * s, "{exponent}");
        };
        compare([after(&magnus, &start, 0.1, 5), after(&magnus, &scaled, 0.1 / s, 5)]);
        compare([after(&exponential, &start, 0.1, 5), after(&exponential, &scaled, 0.1 / s, 5)]);
        compare([after(&gauss, &start, 0.1, 5), after(&gauss, &scaled, 0.1 / s, 5)]);
    }
}

/// A symmetric method returns by the negative step: Φ₋ₕ ∘ Φₕ = 1.
#[test]
fn symmetric_methods_return() {
    fn error<I: Integrator<State = Large>>(integrator: &I) -> f64 {
        reversibility_defect(integrator, &generic(SIZE, 0.3), 0.2).unwrap()
    }
    // The stages are solved to a few units of round-off of entries up to 1.
    let round_off = 64.0 * f64::EPSILON;
    assert!(error(&ExponentialMidpoint::new(Quadratic(SIZE))) < round_off);
    let collective = |scheme| IsospectralRungeKutta::new(scheme, Quadratic(SIZE));
    assert!(error(&collective(RungeKutta::gauss(2).unwrap())) < round_off);
    // The stages of a Gauss–Magnus method end at another point than its step.
    for stages in [1, 2, 3] {
        assert!(error(&GaussMagnus::new(stages, Quadratic(SIZE)).unwrap()) > 1e-8, "{stages}");
    }
}

/// The generators of the steps before predict that of the next step better than the field at its start does.
#[test]
fn predictions_save_sweeps() {
    let sweeps = |forgets: bool| -> usize {
        let midpoint = ExponentialMidpoint::new(Quadratic(SIZE));
        let (mut w, mut workspace) = (generic(SIZE, 0.3), midpoint.workspace());
        let sweeps = (0..20).map(|_| {
            if forgets {
                midpoint.forget(&mut workspace);
            }
            midpoint.step_in_place(&mut w, 0.05, &mut workspace).unwrap()
        });
        sweeps.sum()
    };
    let [with, without] = [false, true].map(sweeps);
    assert!(with + 20 < without, "{with} sweeps instead of {without}");
}

/// A tolerance saves sweeps, and costs as much accuracy as it says.
#[test]
fn tolerances_save_sweeps() {
    fn check<I: Integrator<State = Large>>(exact: &I, within: &I, tolerance: f64) {
        let start = generic(SIZE, 0.3);
        let steps = [exact, within].map(|integrator| {
            let mut w = start.clone();
            let sweeps = integrator.step_in_place(&mut w, 0.05, &mut integrator.workspace());
            (w, sweeps.unwrap())
        });
        let [(expected, most), (found, sweeps)] = steps;
        assert!(sweeps + 2 < most, "{sweeps} sweeps instead of {most}");
        let error = distance(&found, &expected);
        assert!(error < 10.0 * tolerance && error > 0.0, "{error:e}");
    }
    let tolerance = 1e-7;
    let midpoint = || ExponentialMidpoint::new(Quadratic(SIZE));
    check(&midpoint(), &midpoint().with_tolerance(tolerance), tolerance);
    for stages in 1..=3 {
        let magnus = || GaussMagnus::new(stages, Quadratic(SIZE)).unwrap();
        check(&magnus(), &magnus().with_tolerance(tolerance), tolerance);
    }
}
