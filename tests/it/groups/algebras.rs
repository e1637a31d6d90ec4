//! The algebras: Jacobi's identity, ad* against its definition, bases, inner products (2.1), (A.1), (A.2), and the
//! Casimirs.

use heavytop::SpinorAlgebra;
use lie_poisson::{
    Casimirs, Covector, LieAlgebra, Momentum, Pair, Real, SU2OnC2, Se3, SemidirectAlgebra, So3,
    State, Su2, Vector,
};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{Derived, assert_close, assert_near, persistent, point};

const SPINORS: SpinorAlgebra = SemidirectAlgebra(SU2OnC2);

/// The round-off of a dozen triple products of numbers up to 3.
const ROUND_OFF: f64 = 1e-13;

type Element<A> = <A as LieAlgebra>::Element<f64>;

/// Returns the Jacobi sum [ξ,[η,ζ]] + [η,[ζ,ξ]] + [ζ,[ξ,η]].
fn jacobi<A: LieAlgebra>(algebra: &A, x: &[Element<A>; 3]) -> f64 {
    let term = |i: usize| {
        let inner = algebra.bracket::<f64>(&x[(i + 1) % 3], &x[(i + 2) % 3]);
        algebra.bracket::<f64>(&x[i], &inner)
    };
    (term(0) + term(1) + term(2)).max_abs()
}

fn laws<A: LieAlgebra>(algebra: &A, x: &[Element<A>; 3], mu: &Momentum<A>) {
    let [xi, eta, zeta] = x;
    let bracket = |a: &Element<A>, b: &Element<A>| algebra.bracket::<f64>(a, b);
    assert!(jacobi(algebra, x) <= ROUND_OFF);
    assert_near(&bracket(xi, eta), &-bracket(eta, xi), 0.0);
    let mut combination = *eta;
    combination.add_multiple(-1.5, zeta);
    let mut expected = bracket(xi, eta);
    expected.add_multiple(-1.5, &bracket(xi, zeta));
    assert_near(&bracket(xi, &combination), &expected, ROUND_OFF);

    // The pairing ⟨ad*_ξ μ, η⟩ = ⟨μ, [ξ, η]⟩, and the trait's own definition.
    let coadjoint = algebra.coadjoint::<f64>(xi, mu);
    assert_close(coadjoint.pairing(eta), mu.pairing(&bracket(xi, eta)), ROUND_OFF);
    assert_near(&coadjoint, &Derived(algebra.clone()).coadjoint::<f64>(xi, mu), ROUND_OFF);

    // ad*_[ξ,η] = −[ad*_ξ, ad*_η]
    let twice = |a: &Element<A>, b: &Element<A>| {
        algebra.coadjoint::<f64>(a, &algebra.coadjoint::<f64>(b, mu))
    };
    let commutator = twice(xi, eta) - twice(eta, xi);
    assert_near(&algebra.coadjoint::<f64>(&bracket(xi, eta), mu), &-commutator, ROUND_OFF);
}

/// Checks ad*_{dc(μ)} μ = 0 for every Casimir, and that its differential is the derivative of its value.
fn casimirs<A: Casimirs>(algebra: &A, mu: &Momentum<A>) {
    for index in 0..A::COUNT {
        let dc = algebra.casimir_differential::<f64>(index, mu);
        assert!(algebra.coadjoint::<f64>(&dc, mu).max_abs() <= ROUND_OFF);
    }
    assert_close(algebra.casimir::<f64>(A::COUNT, mu), 0.0, 0.0);
}

macro_rules! algebra_laws {
    ($($name:ident: $algebra:expr, $type:ty;)*) => { proptest! {
        #![proptest_config(persistent())]
        $(
        #[test]
        fn $name(
            xi in point::<Element<$type>>(), eta in point::<Element<$type>>(),
            zeta in point::<Element<$type>>(), mu in point::<Momentum<$type>>(),
        ) {
            laws(&$algebra, &[xi, eta, zeta], &mu);
        }
    )* } };
}
algebra_laws! {
    so3_is_a_lie_algebra: So3, So3;
    su2_is_a_lie_algebra: Su2, Su2;
    se3_is_a_lie_algebra: Se3::default(), Se3;
    su2_with_c2_is_a_lie_algebra: SPINORS, SpinorAlgebra;
}

proptest! {
    #![proptest_config(persistent())]

    #[test]
    fn casimirs_annihilate_ad_star(mu in point::<Momentum<Se3>>()) {
        casimirs(&So3, &Covector(mu.0.0));
        casimirs(&Su2, &Covector(mu.0.0));
        casimirs(&Se3::default(), &mu);
    }

    /// The inner product of eq. (2.1): Re(ψ*φ) is the dot product on R⁴, and the pairing of T*C² with it.
    #[test]
    fn the_inner_product_of_c2(
        psi in point::<Vector2<Complex<f64>>>(), phi in point::<Vector2<Complex<f64>>>(),
    ) {
        let inner = psi.dotc(&phi).re;
        let dot: f64 = (0..4).map(|i| psi.coordinate(i) * phi.coordinate(i)).sum();
        assert_close(inner, dot, 1e-15);
        assert_close(Covector(psi).pairing(&phi), inner, 1e-15);
    }

    /// The inner products of eqs. (A.1) and (A.2): 2 tr(ξ*η) = ½ tr(ξ̂ᵀη̂) = ξ·η.
    #[test]
    fn the_inner_products_of_su2_and_so3(
        xi in point::<Vector3<f64>>(), eta in point::<Vector3<f64>>(),
    ) {
        let on_su2 = 2.0 * (Su2.matrix(&xi).adjoint() * Su2.matrix(&eta)).trace();
        let on_so3 = 0.5 * (So3.hat(&xi).transpose() * So3.hat(&eta)).trace();
        assert_close(on_su2.re, xi.dot(&eta), 1e-15);
        assert_close(on_su2.im, 0.0, 1e-15);
        assert_close(on_so3, xi.dot(&eta), 1e-15);
        prop_assert_eq!(Su2.coordinates(&Su2.matrix(&xi)), xi);
    }
}

/// Appendix A.1: the bases are as printed, and [e_i, e_j], [ê_i, ê_j], e_i × e_j are the same.
#[test]
fn the_bases_are_those_of_the_appendix() {
    let c = Complex::new;
    let (o, half) = (c(0.0, 0.0), c(0.0, -0.5));
    let one = c(1.0, 0.0);
    let sigma = [
        Matrix2::new(o, one, one, o),
        Matrix2::new(o, c(0.0, -1.0), c(0.0, 1.0), o),
        Matrix2::new(one, o, o, -one),
    ];
    #[rustfmt::skip]
    let hats = [
        Matrix3::new(0.0, 0.0, 0.0,  0.0, 0.0, -1.0,  0.0, 1.0, 0.0),
        Matrix3::new(0.0, 0.0, 1.0,  0.0, 0.0, 0.0,  -1.0, 0.0, 0.0),
        Matrix3::new(0.0, -1.0, 0.0,  1.0, 0.0, 0.0,  0.0, 0.0, 0.0),
    ];
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    for i in 0..3 {
        assert_eq!(Su2.matrix(&axes[i]), sigma[i].map(|z| z * half));
        assert_eq!(So3.hat(&axes[i]), hats[i]);
        for j in 0..3 {
            let cross = axes[i].cross(&axes[j]);
            let (a, b) = (Su2.matrix(&axes[i]), Su2.matrix(&axes[j]));
            assert_eq!(a * b - b * a, Su2.matrix(&cross));
            assert_eq!(hats[i] * hats[j] - hats[j] * hats[i], So3.hat(&cross));
            assert_eq!(So3.bracket(&axes[i], &axes[j]), cross);
            assert_eq!(Su2.bracket(&axes[i], &axes[j]), cross);
        }
    }
}

/// The algebra se(3) with a doubled action of rotations on translations: bilinear and antisymmetric, but ξ ↦ 2ξ× is
/// no representation.
#[derive(Clone)]
struct Doubled;

impl LieAlgebra for Doubled {
    type Element<T: Real> = Pair<Vector3<T>, Vector3<T>>;

    fn bracket<T: Real>(
        &self,
        xi: &Pair<Vector3<T>, Vector3<T>>,
        eta: &Pair<Vector3<T>, Vector3<T>>,
    ) -> Pair<Vector3<T>, Vector3<T>> {
        let Pair(turn, shift) = Se3::default().bracket::<T>(xi, eta);
        Pair(turn, shift.scaled(T::from_f64(2.0)))
    }
}

/// Negative controls: the broken bracket fails Jacobi's identity though it is antisymmetric, ad* with the other sign
/// does not pair, and functions that are no Casimirs change μ.
#[test]
fn broken_laws_are_seen() {
    let v = Vector3::new;
    let x = [
        Pair(v(1.0, 0.3, -0.5), v(0.2, 0.9, -1.4)),
        Pair(v(-0.7, 1.6, 0.4), v(1.1, -0.8, 0.3)),
        Pair(v(0.5, -0.2, 1.9), v(-0.6, 0.1, 2.2)),
    ];
    assert!(jacobi(&Se3::default(), &x) < ROUND_OFF);
    assert!(jacobi(&Doubled, &x) > 0.1);
    let sum = Doubled.bracket::<f64>(&x[0], &x[1]) + Doubled.bracket::<f64>(&x[1], &x[0]);
    assert_eq!(sum.max_abs(), 0.0);

    let mu = Covector(x[2]);
    let rate = Se3::default().coadjoint::<f64>(&x[0], &mu);
    let pairing = mu.pairing(&Se3::default().bracket::<f64>(&x[0], &x[1]));
    assert!((rate.pairing(&x[1]) + pairing).abs() > 0.1);
    // |Π|² is a Casimir of so(3), not of se(3)
    let spin = Pair(mu.0.0 * 2.0, Vector3::zeros());
    assert!(Se3::default().coadjoint::<f64>(&spin, &mu).max_abs() > 0.1);
}
