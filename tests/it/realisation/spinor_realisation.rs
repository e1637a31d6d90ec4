//! §4.1: M in closed form is the composition ϖ∘L, and its generator is a Hamiltonian vector field.

use collective_integrators::VectorField;
use heavytop::{SPINOR_MOTIONS, SpinorMotions, SpinorPoint, SpinorRealisation, Varpi};
use lie_poisson::{
    Covector, Hamiltonian, Pair, PoissonSpace, State, Vector, differential, from_closure,
};
use momentum_map::{
    CollectiveHamiltonian, ComposedMap, Cotangent, HOPF, HopfRealisation, MomentumMap, PoissonMap,
    SourcePoint, SymplecticSpace,
};
use nalgebra::{Matrix2, Vector2, Vector3};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{Derived, assert_close, assert_near, persistent, point, tops};

const COMPOSED: ComposedMap<Varpi, MomentumMap<SpinorMotions>> =
    ComposedMap { outer: Varpi, inner: MomentumMap(SPINOR_MOTIONS) };

/// The round-off of sums of up to eight products of three numbers up to 3.
const ROUND_OFF: f64 = 1e-14;

type Covector6 = Pair<Vector3<f64>, Vector3<f64>>;

/// Returns the matrix v·σ.
fn pauli(v: &Vector3<f64>) -> Matrix2<Complex<f64>> {
    let c = Complex::new;
    Matrix2::new(c(v.z, 0.0), c(v.x, -v.y), c(v.x, v.y), c(-v.z, 0.0))
}

proptest! {
    #![proptest_config(persistent())]

    /// The composition M = ϖ∘L of eq. (3.2) agrees with its closed form, eq. (4.1).
    #[test]
    fn the_closed_form_is_the_composition(z in point::<SpinorPoint>(), dh in point::<Covector6>()) {
        assert_near(&SpinorRealisation.apply(&z), &COMPOSED.apply::<f64>(&z), ROUND_OFF);
        assert_near(
            &SpinorRealisation.pull_back::<f64>(&dh, &z),
            &COMPOSED.pull_back::<f64>(&dh, &z),
            ROUND_OFF,
        );
        assert_near(
            &SpinorRealisation.generator::<f64>(&dh, &z),
            &COMPOSED.generator::<f64>(&dh, &z),
            ROUND_OFF,
        );
    }

    /// The generator is Λ (TM)ᵀ, for M, for ϖ∘L and for the Hopf realisation.
    #[test]
    fn generators_are_hamiltonian_vector_fields(
        z in point::<SpinorPoint>(),
        dh in point::<Covector6>(),
        w in point::<SourcePoint<HopfRealisation>>(),
    ) {
        let expected = Derived(SpinorRealisation).generator::<f64>(&dh, &z);
        assert_near(&SpinorRealisation.generator::<f64>(&dh, &z), &expected, ROUND_OFF);
        assert_near(&COMPOSED.generator::<f64>(&dh, &z), &expected, ROUND_OFF);
        let by_hand = SpinorRealisation
            .source()
            .hamiltonian_vector::<f64>(&z, &SpinorRealisation.pull_back::<f64>(&dh, &z));
        assert_near(&by_hand, &expected, ROUND_OFF);
        assert_near(
            &HOPF.generator::<f64>(&dh.0, &w),
            &Derived(HOPF).generator::<f64>(&dh.0, &w),
            ROUND_OFF,
        );
    }

    /// The generator is χ̇ = (i/2)(Ω·σ)χ + 2(γ·σ)ψ, ψ̇ = (i/2)(Ω·σ)ψ, with Pauli matrices.
    #[test]
    fn the_generator_has_the_spinor_form(z in point::<SpinorPoint>(), dh in point::<Covector6>()) {
        let (chi, psi) = (z.q, z.p.0);
        let half = pauli(&dh.0) * Complex::new(0.0, 0.5);
        let push = pauli(&dh.1) * Complex::new(2.0, 0.0);
        let expected = Cotangent::new(half * chi + push * psi, Covector(half * psi));
        assert_near(&SpinorRealisation.generator::<f64>(&dh, &z), &expected, ROUND_OFF);
    }

    /// The canonical system in three forms. Eqs. (4.3) and (4.4b): X_H of H = h∘M by i_{X_H} Ω = dH and by (∂H/∂p,
    /// −∂H/∂q). Eq. (4.4a): χ̇ = 2 ∂H/∂ψ̄, ψ̇ = −2 ∂H/∂χ̄ with ∂/∂w̄ = ½(∂/∂Re w + i ∂/∂Im w).
    #[test]
    fn the_canonical_system(z in point::<SpinorPoint>()) {
        let top = tops::generic().map_err(|e| TestCaseError::fail(e.to_string()))?;
        let system = CollectiveHamiltonian::new(SpinorRealisation, top);
        let velocity = system.at(&z);
        let dh: Covector<SpinorPoint> = differential(
            |z| Hamiltonian::<_, lie_poisson::DualNumber>::value(&system, z),
            &z,
        );
        assert_near(&SpinorRealisation.source().flat::<f64>(&velocity), &dh, 1e-13);

        let Covector(Cotangent { q: by_q, p: Covector(by_p) }) = dh;
        let bar = |d: Vector2<Complex<f64>>| d.map(|d| Complex::new(0.5 * d.re, 0.5 * d.im));
        assert_near(&velocity.q, &(bar(by_p) * Complex::new(2.0, 0.0)), 1e-13);
        assert_near(&velocity.p.0, &(bar(by_q) * Complex::new(-2.0, 0.0)), 1e-13);
        for i in 0..4 {
            assert_close(velocity.q.coordinate(i), by_p.coordinate(i), 1e-13);
            assert_close(velocity.p.coordinate(i), -by_q.coordinate(i), 1e-13);
        }
        assert_near(&system.differential(&z), &dh, 1e-13);
    }

    /// Along the flow d/dt Re(ψ*χ) = 2 γ·Γ, which is why χ drifts along ψ.
    #[test]
    fn the_drift_along_the_fibre(z in point::<SpinorPoint>(), dh in point::<Covector6>()) {
        let v = SpinorRealisation.generator::<f64>(&dh, &z);
        let rate = v.p.0.dotc(&z.q).re + z.p.0.dotc(&v.q).re;
        let expected = 2.0 * dh.1.dot(&SpinorRealisation.apply(&z).0.1);
        assert_close(rate, expected, 3e-14);
    }
}

/// Negative controls: the generator with one wrong sign is not the Hamiltonian field, and a differential that is
/// wrong by a factor is not the collective one.
#[test]
fn wrong_generators_are_seen() {
    let x = [0.3, -1.1, 0.7, 1.9, -0.4, 1.3, 0.8, -2.1];
    let z = SpinorPoint::from_coordinates(|i| x[i]);
    let dh = Pair(Vector3::new(0.5, -1.0, 0.3), Vector3::new(1.2, 0.4, -0.9));
    let right = Derived(SpinorRealisation).generator::<f64>(&dh, &z);
    let turned = SpinorRealisation.generator::<f64>(&Pair(dh.0, -dh.1), &z);
    assert!((right - turned).max_abs() > 0.1);
    let conjugate = SpinorRealisation.generator::<f64>(&Pair(-dh.0, dh.1), &z);
    assert!((right - conjugate).max_abs() > 0.1);

    let quadratic = from_closure::<heavytop::HeavyTopSpace, _>(|mu| mu.0.0.dot(&mu.0.0));
    let system = CollectiveHamiltonian::new(SpinorRealisation, quadratic);
    let by_hand = Pair(SpinorRealisation.apply(&z).0.0 * 2.0, Vector3::zeros());
    assert_near(&system.at(&z), &SpinorRealisation.generator::<f64>(&by_hand, &z), ROUND_OFF);
}
