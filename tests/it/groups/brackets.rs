//! The brackets of the paper, (1.2), (2.2), (2.4) and (3.3), and eq. (1.1), which follows from (1.2).

use heavytop::{Body, HeavyTop, HeavyTopSpace, Invariant, SpinorAlgebra, SpinorPoint, TopError};
use lie_poisson::{
    ComplexSpace, Covector, DualNumber, Hamiltonian, LieAlgebra, LiePoisson, Momentum, Pair,
    PoissonSpace, SU2OnC2, Se3, Se3Dual, SemidirectAlgebra, So3, State, Su2, Vector,
    derivative_part, differential, seed,
};
use momentum_map::{CotangentBundle, SymplecticSpace};
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{assert_close, assert_near, persistent, point, tops};

/// The round-off of a dozen products of three numbers up to 3.
const ROUND_OFF: f64 = 1e-13;

type Covector6 = Pair<Vector3<f64>, Vector3<f64>>;
type SpinorElement = <SpinorAlgebra as LieAlgebra>::Element<f64>;

const SPACE: HeavyTopSpace = LiePoisson::minus(SemidirectAlgebra(lie_poisson::SO3OnR3));

/// Returns the bracket of eq. (1.2): −Π·(f_Π × h_Π) − Γ·(f_Π × h_Γ − h_Π × f_Γ).
fn heavy_top_bracket(mu: &Se3Dual, df: &Covector6, dh: &Covector6) -> f64 {
    let Covector(Pair(pi, gamma)) = mu;
    -pi.dot(&df.0.cross(&dh.0)) - gamma.dot(&(df.0.cross(&dh.1) - dh.0.cross(&df.1)))
}

/// Returns the bracket of eq. (3.3), with matrices in so(3) and ½ tr(·ᵀ ·).
fn bracket_on_se3(mu: &Se3Dual, df: &Covector6, dh: &Covector6) -> f64 {
    let Covector(Pair(pi, gamma)) = mu;
    let (f, h) = (So3.hat(&df.0), So3.hat(&dh.0));
    let angular = 0.5 * (So3.hat(pi).transpose() * (f * h - h * f)).trace();
    -angular - gamma.dot(&(f * dh.1 - h * df.1))
}

/// Returns the bracket of eq. (2.4), with matrices in su(2) and 2 tr(·* ·).
fn bracket_on_spinors(mu: &Momentum<SpinorAlgebra>, df: &SpinorElement, dh: &SpinorElement) -> f64 {
    let Covector(Pair(mu, alpha)) = mu;
    let (f, h) = (Su2.matrix(&df.0), Su2.matrix(&dh.0));
    let angular = 2.0 * (Su2.matrix(mu).adjoint() * (f * h - h * f)).trace().re;
    -angular - alpha.dotc(&(f * dh.1 - h * df.1)).re
}

fn fail(top: Result<HeavyTop, TopError>) -> Result<HeavyTop, TestCaseError> {
    top.map_err(|e| TestCaseError::fail(e.to_string()))
}

proptest! {
    #![proptest_config(persistent())]

    /// The brackets (1.2) and (3.3) are the Lie–Poisson bracket of se(3), as numbers and as a tensor.
    #[test]
    fn the_heavy_top_bracket(
        mu in point::<Se3Dual>(), df in point::<Covector6>(), dh in point::<Covector6>(),
    ) {
        let bracket = SPACE.bracket::<f64>(&mu, &df, &dh);
        assert_close(bracket, heavy_top_bracket(&mu, &df, &dh), ROUND_OFF);
        assert_close(bracket, bracket_on_se3(&mu, &df, &dh), ROUND_OFF);
        assert_close(bracket, -mu.pairing(&Se3::default().bracket::<f64>(&df, &dh)), ROUND_OFF);
        let tensor = SPACE.poisson_tensor::<f64>(&mu);
        for i in 0..6 {
            for j in 0..6 {
                let expected = heavy_top_bracket(&mu, &Pair::basis(i), &Pair::basis(j));
                assert_close(tensor[(i, j)], expected, 0.0);
            }
        }
    }

    /// (2.4) is the Lie–Poisson bracket of su(2) ⋉ C².
    #[test]
    fn the_bracket_of_the_semidirect_product(
        mu in point::<Momentum<SpinorAlgebra>>(),
        df in point::<SpinorElement>(),
        dh in point::<SpinorElement>(),
    ) {
        let space = LiePoisson::minus(SemidirectAlgebra(SU2OnC2));
        let bracket = space.bracket::<f64>(&mu, &df, &dh);
        assert_close(bracket, bracket_on_spinors(&mu, &df, &dh), ROUND_OFF);
        let by_algebra = -mu.pairing(&space.algebra().bracket::<f64>(&df, &dh));
        assert_close(bracket, by_algebra, ROUND_OFF);
    }

    /// Eq. (2.5): ⟨δμ, δf/δμ⟩ + ⟨δα, δf/δα⟩ is the derivative of f along (δμ, δα), with the inner
    /// products of su(2) and C²; for f = |μ|² Re α₁ + Im(α₁ᾱ₂) μ₃.
    #[test]
    fn functional_derivatives(
        mu in point::<Momentum<SpinorAlgebra>>(), delta in point::<Momentum<SpinorAlgebra>>(),
    ) {
        let f = |z: &Momentum<SpinorAlgebra, DualNumber>| {
            let Covector(Pair(mu, alpha)) = z;
            mu.dot(mu) * alpha.x.re + (alpha.x * alpha.y.conj()).im * mu.z
        };
        let Pair(by_mu, by_alpha) = differential(f, &mu);
        let Covector(Pair(delta_mu, delta_alpha)) = delta;
        let on_su2 = 2.0 * (Su2.matrix(&delta_mu).adjoint() * Su2.matrix(&by_mu)).trace().re;
        let rate = f(&seed(&mu, &delta)).derivative();
        assert_close(on_su2 + delta_alpha.dotc(&by_alpha).re, rate, ROUND_OFF);
    }

    /// The canonical bracket of eq. (2.2) is ∂F/∂q·∂H/∂p − ∂F/∂p·∂H/∂q, and Ω(X_F, X_H) = {F, H} with Ω = Re(dχ ∧
    /// dψ̄).
    #[test]
    fn the_canonical_bracket(
        z in point::<SpinorPoint>(),
        df in point::<Covector<SpinorPoint>>(),
        dh in point::<Covector<SpinorPoint>>(),
    ) {
        let space = CotangentBundle(ComplexSpace::<2>);
        let c = |d: &Covector<SpinorPoint>, i: usize| d.coordinate(i);
        let expected: f64 =
            (0..4).map(|i| c(&df, i) * c(&dh, i + 4) - c(&df, i + 4) * c(&dh, i)).sum();
        assert_close(space.bracket::<f64>(&z, &df, &dh), expected, 1e-14);
        let (f, h) = (space.hamiltonian_vector::<f64>(&z, &df), space.hamiltonian_vector::<f64>(&z, &dh));
        assert_close(space.symplectic_form::<f64>(&f, &h), expected, 1e-14);
        let wedge = |u: &Vector2<Complex<f64>>, v: &Vector2<Complex<f64>>| v.dotc(u).re;
        assert_close(wedge(&f.q, &h.p.0) - wedge(&h.q, &f.p.0), expected, 1e-14);
        assert_near(&space.flat::<f64>(&h), &dh, 0.0);
    }

    /// The equations (1.1) and the Hamiltonian (1.3): Π̇ = Π × I⁻¹Π + mgl Γ × c, Γ̇ = Γ × I⁻¹Π follow from {·, h},
    /// with dh of (1.3) by dual numbers.
    #[test]
    fn the_heavy_top_equations(mu in point::<Se3Dual>()) {
        let body = Body {
            inertia: Vector3::new(1.0, 1.4, 2.1),
            mass: 0.7,
            gravity: 9.81,
            length: 0.2,
            center_of_mass: Vector3::new(2.0, -3.0, 6.0) / 7.0,
        };
        let top = fail(HeavyTop::new(&body))?;
        let Covector(Pair(pi, gamma)) = mu;
        let omega = pi.component_div(&body.inertia);
        let (moment, c) = (body.mass * body.gravity * body.length, body.center_of_mass);
        let expected = Se3Dual::new(
            pi.cross(&omega) + gamma.cross(&c) * moment,
            gamma.cross(&omega),
        );
        let rate = SPACE.hamiltonian_vector::<f64>(&mu, &top.differential(&mu));
        assert_near(&rate, &expected, 1e-14);

        let energy = |Covector(Pair(pi, gamma)): &Se3Dual<DualNumber>| {
            let term = |i: usize| pi[i] * pi[i] * (0.5 / body.inertia[i]) + gamma[i] * (moment * c[i]);
            term(0) + term(1) + term(2)
        };
        let dh = differential(energy, &mu);
        assert_near(&top.differential(&mu), &dh, 1e-14);
        let value = 0.5 * pi.dot(&omega) + moment * gamma.dot(&c);
        assert_close(top.value(&mu), value, 1e-14);
        for i in 0..6 {
            let by_bracket = heavy_top_bracket(&mu, &Pair::basis(i), &dh);
            assert_close(by_bracket, expected.coordinate(i), 1e-14);
        }
    }
}

/// Negative controls: the plus bracket reverses every motion, and (1.2) without its last term is not antisymmetric.
#[test]
fn other_brackets_are_seen() -> Result<(), TestCaseError> {
    let (top, mu) = (fail(tops::generic())?, tops::generic_start());
    let dh = top.differential(&mu);
    let right = SPACE.hamiltonian_vector::<f64>(&mu, &dh);
    let plus = LiePoisson::plus(Se3::default()).hamiltonian_vector::<f64>(&mu, &dh);
    assert_near(&plus, &-right, 0.0);
    assert!(right.max_abs() > 0.1);
    let truncated = |df: &Covector6, dh: &Covector6| {
        heavy_top_bracket(&mu, df, dh) - mu.0.1.dot(&dh.0.cross(&df.1))
    };
    let df = Pair(Vector3::new(0.3, 1.0, -0.4), Vector3::new(-1.2, 0.6, 0.9));
    assert!((truncated(&df, &dh) + truncated(&dh, &df)).abs() > 0.1);
    // h is conserved, the axial momentum of a generic top is not.
    let along: Se3Dual<DualNumber> = seed(&mu, &right);
    assert_close(Invariant::Energy.value(&top, &along).derivative(), 0.0, 1e-14);
    assert!(Invariant::AxialMomentum.value(&top, &along).derivative().abs() > 0.1);
    let unchanged: Se3Dual = derivative_part(&along);
    assert_near(&unchanged, &right, 0.0);
    Ok(())
}
