//! §2.2–2.3: SU(2) ⋉ C² and SE(3): as groups, as matrices, and their exponentials.

use collective_integrators::Tableau;
use heavytop::SpinorGroup;
use lie_poisson::{
    AlgebraElement, DualNumber, LieAlgebra, LieGroup, Pair, SE3, SO3, SU2, SU2OnC2,
    SemidirectGroup, So3, Su2, Vector, derivative_part, map_coordinates,
};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{Derived, assert_near, element, persistent, point};

type Complex3 = Matrix3<Complex<f64>>;
type Motion = Pair<Matrix2<Complex<f64>>, Vector2<Complex<f64>>>;

const GROUP: SpinorGroup = SemidirectGroup(SU2OnC2);

/// The round-off of a few products of 3×3 matrices with entries up to 30.
const ROUND_OFF: f64 = 1e-14;

/// Returns the group element as the matrix (U ρ; 0 1), or the algebra element as (ξ φ; 0 0).
fn matrix(block: &Matrix2<Complex<f64>>, column: &Vector2<Complex<f64>>, corner: f64) -> Complex3 {
    let mut full = Complex3::zeros();
    full.fixed_view_mut::<2, 2>(0, 0).copy_from(block);
    full.fixed_view_mut::<2, 1>(0, 2).copy_from(column);
    full[(2, 2)] = Complex::new(corner, 0.0);
    full
}

fn of_group(g: &Motion) -> Complex3 {
    matrix(&g.0, &g.1, 1.0)
}

fn of_algebra(x: &AlgebraElement<SpinorGroup>) -> Complex3 {
    matrix(&Su2.matrix(&x.0), &x.1, 0.0)
}

/// Returns the exponential by its series, with scaling by 2¹⁰.
fn matrix_exponential(x: &Complex3) -> Complex3 {
    let small = x / Complex::new(1024.0, 0.0);
    let mut sum = Complex3::identity();
    for k in (1..=14_u32).rev() {
        sum = Complex3::identity() + small * sum / Complex::new(f64::from(k), 0.0);
    }
    (0..10).fold(sum, |power, _| power * power)
}

/// Checks the laws that every group obeys with its algebra.
fn laws<G: LieGroup>(
    group: &G,
    [g, h, k]: [&G::Element<f64>; 3],
    [xi, eta]: [&AlgebraElement<G>; 2],
) {
    let e = group.identity::<f64>();
    let product = |a: &G::Element<f64>, b: &G::Element<f64>| group.compose::<f64>(a, b);
    assert_near(&product(g, &product(h, k)), &product(&product(g, h), k), ROUND_OFF);
    assert_near(&product(g, &e), g, 0.0);
    assert_near(&product(&e, g), g, 0.0);
    assert_near(&product(g, &group.inverse::<f64>(g)), &e, ROUND_OFF);
    assert_near(&product(&group.inverse::<f64>(g), g), &e, ROUND_OFF);

    // exp((s+t)ξ) = exp(sξ) exp(tξ)
    let exp = |s: f64| group.exp::<f64>(&xi.scaled(s));
    assert_near(&product(&exp(0.3), &exp(0.9)), &exp(1.2), ROUND_OFF);

    // d/ds exp(sξ) = ξ at s = 0, in the sense of d/ds exp(sξ) g = ξ-direction: linear in ξ
    let tangent = |x: &AlgebraElement<G>| -> G::Element<f64> {
        let along: AlgebraElement<G, DualNumber> = map_coordinates(x, |x| DualNumber::new(0.0, x));
        derivative_part(&group.exp::<DualNumber>(&along))
    };
    assert_near(&tangent(&(*xi + *eta)), &(tangent(xi) + tangent(eta)), ROUND_OFF);

    // Ad_g ξ = d/ds g exp(sξ) g⁻¹, as a tangent vector at e
    let along: AlgebraElement<G, DualNumber> = map_coordinates(xi, |x| DualNumber::new(0.0, x));
    let lifted: G::Element<DualNumber> = map_coordinates(g, DualNumber::constant);
    let conjugate = group.compose::<DualNumber>(
        &group.compose::<DualNumber>(&lifted, &group.exp::<DualNumber>(&along)),
        &group.inverse::<DualNumber>(&lifted),
    );
    let conjugate: G::Element<f64> = derivative_part(&conjugate);
    assert_near(&conjugate, &tangent(&group.adjoint::<f64>(g, xi)), ROUND_OFF);

    // Ad_g [ξ, η] = [Ad_g ξ, Ad_g η], Ad_{gh} = Ad_g Ad_h
    let adjoint = |g: &G::Element<f64>, x: &AlgebraElement<G>| group.adjoint::<f64>(g, x);
    let algebra = group.algebra();
    assert_near(
        &adjoint(g, &algebra.bracket::<f64>(xi, eta)),
        &algebra.bracket::<f64>(&adjoint(g, xi), &adjoint(g, eta)),
        10.0 * ROUND_OFF,
    );
    assert_near(&adjoint(&product(g, h), xi), &adjoint(g, &adjoint(h, xi)), 10.0 * ROUND_OFF);

    // d/ds Ad_{exp(sξ)} η = [ξ, η] at s = 0
    let constant: AlgebraElement<G, DualNumber> = map_coordinates(eta, DualNumber::constant);
    let turned = group.adjoint::<DualNumber>(&group.exp::<DualNumber>(&along), &constant);
    let rate: AlgebraElement<G> = derivative_part(&turned);
    assert_near(&rate, &algebra.bracket::<f64>(xi, eta), ROUND_OFF);

    // Ad* by hand is the transpose of Ad
    let mu = map_coordinates(eta, |x| x + 0.5);
    assert_near(
        &group.coadjoint::<f64>(g, &mu),
        &Derived(group.clone()).coadjoint::<f64>(g, &mu),
        ROUND_OFF,
    );
}

macro_rules! group_laws {
    ($($name:ident: $group:expr, $type:ty;)*) => { proptest! {
        #![proptest_config(persistent())]
        $(
        #[test]
        fn $name(
            g in element($group), h in element($group), k in element($group),
            xi in point::<AlgebraElement<$type>>(), eta in point::<AlgebraElement<$type>>(),
        ) {
            laws(&$group, [&g, &h, &k], [&xi, &eta]);
        }
    )* } };
}
group_laws! {
    so3_is_a_group: SO3, SO3;
    su2_is_a_group: SU2, SU2;
    se3_is_a_group: SE3::default(), SE3;
    su2_with_c2_is_a_group: GROUP, SpinorGroup;
}

proptest! {
    #![proptest_config(persistent())]

    /// The product (U, ρ)·(W, ϑ) = (UW, Uϑ + ρ) is that of the matrices (U ρ; 0 1).
    #[test]
    fn the_product_is_that_of_matrices(g in element(GROUP), h in element(GROUP)) {
        let product = GROUP.compose::<f64>(&g, &h);
        assert_near(&of_group(&product), &(of_group(&g) * of_group(&h)), ROUND_OFF);
        let Pair((u, rho), (w, theta)) = Pair((g.0, g.1), (h.0, h.1));
        assert_near(&product, &Pair(u * w, u * theta + rho), ROUND_OFF);
        let inverse = of_group(&GROUP.inverse::<f64>(&g));
        assert_near(&(inverse * of_group(&g)), &Complex3::identity(), ROUND_OFF);
    }

    /// The bracket, exp and Ad are those of matrices.
    #[test]
    fn the_algebra_is_that_of_matrices(
        x in point::<AlgebraElement<SpinorGroup>>(), y in point::<AlgebraElement<SpinorGroup>>(),
        g in element(GROUP),
    ) {
        let (a, b) = (of_algebra(&x), of_algebra(&y));
        let bracket = GROUP.algebra().bracket::<f64>(&x, &y);
        assert_near(&of_algebra(&bracket), &(a * b - b * a), ROUND_OFF);
        // Ten squarings amplify round-off by 2¹⁰.
        let exponential = of_group(&GROUP.exp::<f64>(&x));
        assert_near(&exponential, &matrix_exponential(&a), 1024.0 * 2e-16 * 4.0);
        let conjugate = of_group(&g) * a * of_group(&GROUP.inverse::<f64>(&g));
        assert_near(&of_algebra(&GROUP.adjoint::<f64>(&g, &x)), &conjugate, ROUND_OFF);
    }

    /// The exponential is exp(s(ξ,φ)) = (exp(sξ), ∫₀ˢ exp(σξ)φ dσ), with the integral by a 16-point Gauss rule.
    #[test]
    fn the_exponential_is_the_paper_s_integral(
        x in point::<AlgebraElement<SpinorGroup>>(), s in -1.0..1.0_f64,
    ) {
        let gauss = Tableau::gauss(16).map_err(|e| TestCaseError::fail(e.to_string()))?;
        let mut integral = Vector2::zeros();
        for (&weight, &node) in gauss.weights().iter().zip(gauss.nodes()) {
            let turned = SU2.exp(&(x.0 * (s * node))) * x.1;
            integral += turned.map(|z| z * (s * weight));
        }
        let expected = Pair(SU2.exp(&(x.0 * s)), integral);
        assert_near(&GROUP.exp::<f64>(&x.scaled(s)), &expected, ROUND_OFF);
    }
}

/// The derivative d/ds exp(s(ξ,φ)) at s = 0 is (ξ, φ), as matrices.
#[test]
fn the_exponential_has_the_right_tangent() {
    let x = Pair(
        Vector3::new(0.3, -0.8, 1.7),
        Vector2::new(Complex::new(0.5, -1.0), Complex::new(2.0, 0.1)),
    );
    let along: AlgebraElement<SpinorGroup, DualNumber> =
        map_coordinates(&x, |x| DualNumber::new(0.0, x));
    let tangent: Motion = derivative_part(&GROUP.exp::<DualNumber>(&along));
    assert_near(&matrix(&tangent.0, &tangent.1, 0.0), &of_algebra(&x), 1e-16);
    let along: Vector3<DualNumber> = map_coordinates(&x.0, |x| DualNumber::new(0.0, x));
    let tangent: Matrix3<f64> = derivative_part(&SO3.exp(&along));
    assert_near(&tangent, &So3.hat(&x.0), 1e-16);
}

/// Negative controls: the direct product's exponential and the bracket with one wrong sign are not those of the
/// matrices.
#[test]
fn wrong_formulas_are_seen() {
    let x = Pair(
        Vector3::new(0.3, -0.8, 1.7),
        Vector2::new(Complex::new(0.5, -1.0), Complex::new(2.0, 0.1)),
    );
    let y = Pair(x.0.yzx(), x.1.map(|z| z * Complex::new(0.3, 0.8)));
    let (a, b) = (of_algebra(&x), of_algebra(&y));
    let direct = matrix(&SU2.exp(&x.0), &x.1, 1.0);
    assert!((direct - matrix_exponential(&a)).norm() > 0.1);
    let (xi, eta) = (Su2.matrix(&x.0), Su2.matrix(&y.0));
    let turned = matrix(&(xi * eta - eta * xi), &(xi * y.1 + eta * x.1), 0.0);
    assert!((turned - (a * b - b * a)).norm() > 0.1);
}
