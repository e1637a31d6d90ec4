//! Remark 4.3: h, f₁, f₂, f₃ of a Lagrange top are in involution, and H_L, F₁, F₂, F₃ with them;
//! eqs. (4.2) and (4.5), the collective Hamiltonians written out.

use heavytop::{HeavyTop, HeavyTopSpace, Invariant, SpinorPoint, SpinorRealisation, TopError};
use lie_poisson::{DualNumber, LiePoisson, PoissonSpace, Se3, Se3Dual, Vector, differential};
use momentum_map::PoissonMap;
use nalgebra::DMatrix;
use proptest::prelude::*;
use workspace_tests::{assert_close, largest, persistent, point, tops};

const FOUR: [Invariant; 4] = [
    Invariant::Energy,
    Invariant::VerticalSquared,
    Invariant::VerticalMomentum,
    Invariant::AxialMomentum,
];

const M: SpinorRealisation = SpinorRealisation;

/// Returns {a, b}(μ) for all pairs of the four functions, with derivatives by dual numbers.
fn brackets(top: &HeavyTop, mu: &Se3Dual) -> DMatrix<f64> {
    let space: HeavyTopSpace = LiePoisson::minus(Se3::default());
    let d = FOUR.map(|f| differential(|mu: &Se3Dual<DualNumber>| f.value(top, mu), mu));
    DMatrix::from_fn(4, 4, |i, j| space.bracket::<f64>(mu, &d[i], &d[j]))
}

/// Returns the same brackets for the pull-backs F∘M on T*C².
fn canonical_brackets(top: &HeavyTop, z: &SpinorPoint) -> DMatrix<f64> {
    let d = FOUR.map(|f| {
        differential(|z: &SpinorPoint<DualNumber>| f.value(top, &M.apply::<DualNumber>(z)), z)
    });
    DMatrix::from_fn(4, 4, |i, j| M.source().bracket::<f64>(z, &d[i], &d[j]))
}

fn lagrange() -> Result<HeavyTop, TestCaseError> {
    fail(HeavyTop::lagrange(1.5, 0.8, 2.0))
}

fn fail(top: Result<HeavyTop, TopError>) -> Result<HeavyTop, TestCaseError> {
    top.map_err(|e| TestCaseError::fail(e.to_string()))
}

/// Returns the collective Hamiltonian of eq. (4.2).
fn expanded(top: &HeavyTop, z: &SpinorPoint) -> f64 {
    let (chi, psi) = (z.q, z.p.0);
    let (i, c) = (top.inertia(), top.center_of_mass());
    let first = (chi.x * psi.y.conj() + chi.y * psi.x.conj()).im.powi(2) / i.x;
    let second = (chi.y * psi.x.conj() - chi.x * psi.y.conj()).re.powi(2) / i.y;
    let third = (chi.y * psi.y.conj() - chi.x * psi.x.conj()).im.powi(2) / i.z;
    let overlap = psi.x.conj() * psi.y;
    let height = 2.0 * overlap.re * c.x
        + 2.0 * overlap.im * c.y
        + (psi.x.norm_sqr() - psi.y.norm_sqr()) * c.z;
    (first + second + third) / 8.0 + top.weight_moment() * height
}

/// Returns the collective Hamiltonian of eq. (4.5); `sign` is that of its −2 Re(χ₁ψ̄₂χ₂ψ̄₁).
fn expanded_lagrange(top: &HeavyTop, z: &SpinorPoint, sign: f64) -> f64 {
    let (chi, psi) = (z.q, z.p.0);
    let (a, b) = (chi.x * psi.y.conj(), chi.y * psi.x.conj());
    let transverse = a.norm_sqr() + b.norm_sqr() + sign * 2.0 * (a * b).re;
    let axial = (chi.y * psi.y.conj() - chi.x * psi.x.conj()).im.powi(2);
    let (i, height) = (top.inertia(), psi.x.norm_sqr() - psi.y.norm_sqr());
    (transverse / i.x + axial / i.z) / 8.0 + top.weight_moment() * height
}

proptest! {
    #![proptest_config(persistent())]

    #[test]
    fn a_lagrange_top_is_in_involution(mu in point::<Se3Dual>()) {
        // The bound is for sums of a dozen products of four numbers up to 3.
        prop_assert!(largest(&brackets(&lagrange()?, &mu)) <= 1e-13);
    }

    #[test]
    fn its_pull_backs_are_in_involution(z in point::<SpinorPoint>()) {
        // The bound is for products of eight numbers up to 3, since f₁∘M and f₂∘M are of degree four.
        prop_assert!(largest(&canonical_brackets(&lagrange()?, &z)) <= 2e-11);
    }

    /// The Casimirs are in involution with every function, for any top.
    #[test]
    fn casimirs_are_in_involution_with_everything(mu in point::<Se3Dual>()) {
        let brackets = brackets(&fail(tops::generic())?, &mu);
        prop_assert!(largest(&brackets.rows(1, 2).into_owned()) <= 1e-13);
        prop_assert!(largest(&(&brackets + brackets.transpose())) <= 1e-13);
    }

    #[test]
    fn the_collective_hamiltonian_is_as_printed(z in point::<SpinorPoint>()) {
        let (generic, lagrange) = (fail(tops::generic())?, lagrange()?);
        let h = |top: &HeavyTop| Invariant::Energy.value(top, &M.apply(&z));
        assert_close(expanded(&generic, &z), h(&generic), 1e-14);
        assert_close(expanded(&lagrange, &z), h(&lagrange), 1e-14);
        assert_close(expanded_lagrange(&lagrange, &z, -1.0), h(&lagrange), 1e-14);
    }
}

/// Negative control: f₃ of a generic top is not in involution with h, on se(3)* or on T*C², and (4.5) with the other
/// sign is another function.
#[test]
fn a_generic_top_is_not() -> Result<(), TestCaseError> {
    let x = [0.3, -1.1, 0.7, 1.9, -0.4, 1.3, 0.8, -2.1];
    let z = SpinorPoint::from_coordinates(|i| x[i]);
    let generic = fail(tops::generic())?;
    let bracket = brackets(&generic, &M.apply(&z))[(0, 3)];
    assert!(bracket.abs() > 0.1);
    // M is Poisson: the bracket on T*C² is the pull-back of the one on se(3)*, to the round-off of products of eight
    // numbers.
    assert_close(canonical_brackets(&generic, &z)[(0, 3)], bracket, 1e-13);
    let (top, mu) = (lagrange()?, M.apply(&z));
    let turned = expanded_lagrange(&top, &z, 1.0);
    assert!((turned - Invariant::Energy.value(&top, &mu)).abs() > 0.1);
    Ok(())
}
