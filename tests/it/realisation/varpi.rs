//! §3 and Appendix B: the Hopf map ϖ₂, its tangent map, and the reason why ϖ is Poisson.

use heavytop::{SpinorAlgebra, Varpi};
use lie_poisson::{Covector, DualNumber, Momentum, Pair, Se3Dual, So3, Su2, derivative_part, seed};
use momentum_map::{PoissonMap, hopf_map, hopf_pull_back};
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{Derived, assert_close, assert_near, persistent, point};

type Spinor = Vector2<Complex<f64>>;

/// Returns T_α ϖ₂(δα) by dual numbers.
fn tangent(alpha: &Spinor, delta: &Spinor) -> Vector3<f64> {
    let moved: Vector2<Complex<DualNumber>> = seed(alpha, delta);
    derivative_part(&hopf_map(&moved))
}

/// Returns the first form of T_α ϖ₂ in Appendix B, with the given sign before Im(ᾱ₁ δα₂).
fn first_form(alpha: &Spinor, delta: &Spinor, sign: f64) -> Vector3<f64> {
    Vector3::new(
        (delta.x.conj() * alpha.y).re + (alpha.x.conj() * delta.y).re,
        (delta.x.conj() * alpha.y).im + sign * (alpha.x.conj() * delta.y).im,
        (alpha.x * delta.x.conj()).re - (alpha.y * delta.y.conj()).re,
    ) * 2.0
}

/// Returns the second form of T_α ϖ₂ in Appendix B.
fn second_form(alpha: &Spinor, delta: &Spinor) -> Vector3<f64> {
    let i = Complex::new(0.0, 1.0);
    Vector3::new(
        (alpha.y * delta.x.conj()).re + (alpha.x * delta.y.conj()).re,
        -(i * alpha.y * delta.x.conj()).re + (i * alpha.x * delta.y.conj()).re,
        (alpha.x * delta.x.conj()).re - (alpha.y * delta.y.conj()).re,
    ) * 2.0
}

/// Returns δ(f∘ϖ)/δα for ∇_a f = gamma, as printed in Appendix B.
fn derivative_along_alpha(gamma: &Vector3<f64>, alpha: &Spinor) -> Spinor {
    let i = Complex::new(0.0, 1.0);
    Vector2::new(
        alpha.y * gamma.x - i * alpha.y * gamma.y + alpha.x * gamma.z,
        alpha.x * gamma.x + i * alpha.x * gamma.y - alpha.y * gamma.z,
    ) * Complex::new(2.0, 0.0)
}

/// Returns ¼(αβ* − βα*) as a vector.
fn quarter_commutator(alpha: &Spinor, beta: &Spinor) -> Vector3<f64> {
    let matrix = alpha * beta.adjoint() - beta * alpha.adjoint();
    Su2.coordinates(&(matrix * Complex::new(0.25, 0.0)))
}

proptest! {
    #![proptest_config(persistent())]

    /// |ϖ₂(α)| = ‖α‖²: spheres of radius √R go to spheres of radius R.
    #[test]
    fn spheres_go_to_spheres(alpha in point::<Spinor>(), phase in -4.0..4.0_f64) {
        let image = hopf_map(&alpha);
        assert_close(image.norm(), alpha.norm_squared(), 1e-15);
        // The fibres are circles.
        let turned = alpha.map(|z| z * Complex::from_polar(1.0, phase));
        assert_near(&hopf_map(&turned), &image, 2e-15);
    }

    /// The map ϖ(μ, α) = (μ̂, ϖ₂(α)), eqs. (3.1a) and (3.1b), has these two parts.
    #[test]
    fn varpi_is_its_two_parts(z in point::<Momentum<SpinorAlgebra>>()) {
        let Covector(Pair(mu, alpha)) = z;
        let overlap = alpha.x.conj() * alpha.y;
        let height = alpha.x.norm_sqr() - alpha.y.norm_sqr();
        let expected = Se3Dual::new(mu, Vector3::new(2.0 * overlap.re, 2.0 * overlap.im, height));
        assert_near(&Varpi.apply(&z), &expected, 1e-15);
    }

    #[test]
    fn the_pull_back_is_the_transposed_tangent(
        z in point::<Momentum<SpinorAlgebra>>(), dh in point::<Pair<Vector3<f64>, Vector3<f64>>>(),
    ) {
        let closed = Varpi.pull_back::<f64>(&dh, &z);
        assert_near(&closed, &Derived(Varpi).pull_back::<f64>(&dh, &z), 1e-15);
        let alpha = z.0.1;
        assert_near(&closed.1, &derivative_along_alpha(&dh.1, &alpha), 1e-15);
        assert_near(&hopf_pull_back(&dh.1, &alpha), &closed.1, 0.0);
        // δ(f∘ϖ)/δμ = δf/δμ̂
        assert_near(&closed.0, &dh.0, 0.0);
    }

    /// Erratum 3: the first form of T_α ϖ₂ with "+", and the second as printed.
    #[test]
    fn both_forms_of_the_tangent_map(alpha in point::<Spinor>(), delta in point::<Spinor>()) {
        let exact = tangent(&alpha, &delta);
        assert_near(&first_form(&alpha, &delta, 1.0), &exact, 2e-15);
        assert_near(&second_form(&alpha, &delta), &exact, 2e-15);
    }

    /// The identity ¼(αβ* − βα*) = ∇_a f × a, with β = δ(f∘ϖ)/δα and a = ϖ₂(α).
    #[test]
    fn the_final_identity_of_appendix_b(alpha in point::<Spinor>(), gamma in point::<Vector3<f64>>()) {
        let beta = derivative_along_alpha(&gamma, &alpha);
        let expected = gamma.cross(&hopf_map(&alpha));
        // The bound is for sums of eight products of four numbers up to 3, which partly cancel.
        assert_near(&quarter_commutator(&alpha, &beta), &expected, 1e-14);
    }

    /// The two parts of the bracket, eqs. (B.1) and (B.2), are mapped to each other one by one.
    #[test]
    fn the_bracket_splits(
        z in point::<Momentum<SpinorAlgebra>>(),
        df in point::<Pair<Vector3<f64>, Vector3<f64>>>(),
        dh in point::<Pair<Vector3<f64>, Vector3<f64>>>(),
    ) {
        let Covector(Pair(mu, alpha)) = z;
        let Pair(xi, beta) = Varpi.pull_back::<f64>(&df, &z);
        let Pair(eta, gamma) = Varpi.pull_back::<f64>(&dh, &z);
        let (a, b, m) = (Su2.matrix(&xi), Su2.matrix(&eta), Su2.matrix(&mu));
        // (B.1): −⟨μ, [ξ, η]⟩ on su(2)* with 2 tr(·* ·), on so(3)* with ½ tr(·ᵀ ·)
        let on_su2 = -2.0 * (m.adjoint() * (a * b - b * a)).trace().re;
        let (c, d) = (So3.hat(&df.0), So3.hat(&dh.0));
        let on_so3 = -0.5 * (So3.hat(&mu).transpose() * (c * d - d * c)).trace();
        assert_close(on_su2, on_so3, 1e-14);
        // (B.2): −Re(α*(ξγ − ηβ)) on (C²)*, −a·(ξ̂ ∇h − η̂ ∇f) on (R³)*
        let on_c2 = -alpha.dotc(&(a * gamma - b * beta)).re;
        let on_r3 = -hopf_map(&alpha).dot(&(c * dh.1 - d * df.1));
        // 24 products of four numbers up to 3, each rounded by ε/2: 24·81·1.1e-16.
        assert_close(on_c2, on_r3, 2.2e-13);
    }
}

/// Erratum 3: the sign printed in the first form of T_α ϖ₂ is wrong.
#[test]
fn the_printed_sign_is_wrong() {
    let alpha = Vector2::new(Complex::new(0.3, -1.1), Complex::new(0.7, 1.9));
    let delta = Vector2::new(Complex::new(-0.4, 1.3), Complex::new(0.8, -2.1));
    let printed = first_form(&alpha, &delta, -1.0);
    let exact = tangent(&alpha, &delta);
    // The two differ by twice the term, 4 Im(ᾱ₁ δα₂) = 1 here.
    assert_close(exact.y - printed.y, 4.0 * (alpha.x.conj() * delta.y).im, 1e-14);
    assert!((printed.y - exact.y).abs() > 0.9);
    assert_near(&Vector2::new(printed.x, printed.z), &Vector2::new(exact.x, exact.z), 1e-15);
}

/// Erratum 4: the "β =" before the final identity is spurious; β is a spinor whose coordinates are not those of the
/// vector. Negative control: a × ∇f, the other order, differs too.
#[test]
fn the_final_identity_is_not_about_beta() {
    let alpha = Vector2::new(Complex::new(0.3, -1.1), Complex::new(0.7, 1.9));
    let gamma = Vector3::new(0.5, -1.2, 0.8);
    let a = hopf_map(&alpha);
    let beta = derivative_along_alpha(&gamma, &alpha);
    let value = quarter_commutator(&alpha, &beta);
    assert!((beta.norm() - value.norm()).abs() > 0.1);
    assert!((value - gamma.cross(&a)).norm() < 1e-14);
    assert!((value - a.cross(&gamma)).norm() > 0.1);
}
