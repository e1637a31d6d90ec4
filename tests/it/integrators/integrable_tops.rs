//! §5.2: the Kovalevskaya invariant, the values at the start, and the invariants of the other
//! integrable tops.

use collective_integrators::{Collective, RungeKutta};
use heavytop::{Body, HeavyTop, HeavyTopSpace, Invariant, SpinorRealisation, TopError};
use lie_poisson::{
    Covector, DualNumber, Hamiltonian, LiePoisson, Pair, PoissonSpace, Se3, Se3Dual, seed,
};
use nalgebra::Vector3;
use num_complex::Complex;
use proptest::prelude::*;
use std::error::Error;
use workspace_tests::{assert_close, largest_deviation, persistent, point, tops};

/// Returns d/dt of an invariant along the heavy top equations, {f, h}(μ), by dual numbers.
fn rate(invariant: Invariant, top: &HeavyTop, mu: &Se3Dual) -> f64 {
    let space: HeavyTopSpace = LiePoisson::minus(Se3::default());
    let velocity = space.hamiltonian_vector::<f64>(mu, &top.differential(mu));
    let along: Se3Dual<DualNumber> = seed(mu, &velocity);
    invariant.value(top, &along).derivative()
}

fn top(
    inertia: Vector3<f64>,
    moment: f64,
    center_of_mass: Vector3<f64>,
) -> Result<HeavyTop, TestCaseError> {
    let body = Body { inertia, mass: moment, gravity: 1.0, length: 1.0, center_of_mass };
    fail(HeavyTop::new(&body))
}

fn fail(top: Result<HeavyTop, TopError>) -> Result<HeavyTop, TestCaseError> {
    top.map_err(|e| TestCaseError::fail(e.to_string()))
}

fn equator(angle: f64) -> Vector3<f64> {
    Vector3::new(angle.cos(), angle.sin(), 0.0)
}

/// At the start h = 11.75, f₁ = 1, f₂ = 1+2√3 and K = 193, to the round-off of a dozen operations.
#[test]
fn the_values_at_the_start() -> Result<(), TopError> {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let expected = [11.75, 1.0, 1.0 + 2.0 * 3.0_f64.sqrt(), 193.0];
    let invariants = top.invariants();
    assert_eq!(
        invariants,
        [
            Invariant::Energy,
            Invariant::VerticalSquared,
            Invariant::VerticalMomentum,
            Invariant::Kovalevskaya
        ]
    );
    for (invariant, expected) in invariants.iter().zip(expected) {
        assert_close(invariant.value(&top, &start), expected, 1e-15);
    }
    // Negative control: with the other sign in front of Γ, K is not 193.
    let spin = Complex::new(2.0, 3.0);
    let k = |sign: f64| (spin * spin + Complex::new(sign * 4.0 * 0.5, 0.0)).norm_sqr();
    assert_close(k(-1.0), 193.0, 1e-15);
    assert!((k(1.0) - 193.0).abs() > 1.0);
    Ok(())
}

proptest! {
    #![proptest_config(persistent())]

    /// {K, h} = 0 for I₁ = I₂ = 2I₃ and c anywhere on the equator.
    #[test]
    fn k_is_conserved_by_kovalevskaya_s_top(
        mu in point::<Se3Dual>(), angle in -3.2..3.2_f64, moment in 0.0..3.0_f64,
    ) {
        let top = top(Vector3::new(1.4, 1.4, 0.7), moment, equator(angle))?;
        prop_assert!(top.is_kovalevskaya());
        // The bound is for a few dozen products of five numbers up to 10, which cancel.
        prop_assert!(rate(Invariant::Kovalevskaya, &top, &mu).abs() <= 2e-11);
        let by_hand = {
            let Covector(Pair(pi, gamma)) = mu;
            let c = Complex::from_polar(1.0, angle);
            let w = Complex::new(pi.x, pi.y);
            (w * w - Complex::new(gamma.x, gamma.y) * c * (4.0 * moment * 0.7)).norm_sqr()
        };
        assert_close(Invariant::Kovalevskaya.value(&top, &mu), by_hand, 1e-13);
    }

    /// The invariant G changes by dG/dt = −mgl Π₂ (Π·Γ) for c = e₁; in general Π₂ becomes c₁Π₂ − c₂Π₁.
    #[test]
    fn g_changes_as_documented(mu in point::<Se3Dual>(), angle in -3.2..3.2_f64) {
        let inertia = Vector3::new(2.8, 2.8, 0.7);
        let Covector(Pair(pi, gamma)) = mu;
        for angle in [0.0, angle] {
            let (c, moment) = (equator(angle), 1.7);
            let top = top(inertia, moment, c)?;
            prop_assert!(top.is_goryachev_chaplygin());
            let expected = -moment * (c.x * pi.y - c.y * pi.x) * pi.dot(&gamma);
            assert_close(rate(Invariant::GoryachevChaplygin, &top, &mu), expected, 2e-13);
        }
        // On the level Π·Γ = 0 it is conserved.
        let gamma = pi.cross(&gamma);
        let level = Se3Dual::new(pi, gamma);
        let top = top(inertia, 1.7, equator(0.0))?;
        prop_assert!(rate(Invariant::GoryachevChaplygin, &top, &level).abs() <= 2e-12);
    }

    /// The invariant f₃ = Π₃ is conserved by Lagrange's top; h, f₁ and f₂ by all tops.
    #[test]
    fn the_other_invariants_are_conserved(mu in point::<Se3Dual>()) {
        let lagrange = fail(HeavyTop::lagrange(1.5, 0.8, 2.0))?;
        prop_assert!(rate(Invariant::AxialMomentum, &lagrange, &mu).abs() <= 1e-14);
        let generic = fail(tops::generic())?;
        for invariant in [Invariant::Energy, Invariant::VerticalSquared, Invariant::VerticalMomentum] {
            prop_assert!(rate(invariant, &generic, &mu).abs() <= 2e-13);
            prop_assert!(rate(invariant, &lagrange, &mu).abs() <= 2e-13);
        }
    }
}

/// A rotation of the body frame that permutes the axes changes neither what is conserved nor its value.
#[test]
fn the_symmetry_axis_may_be_any_of_the_three() -> Result<(), TestCaseError> {
    let turned = |v: Vector3<f64>, by: usize| Vector3::from_fn(|i, _| v[(i + 3 - by) % 3]);
    let (pi, gamma) = (Vector3::new(1.3, -0.7, 2.1), Vector3::new(0.48, 0.6, 0.64));
    for (inertia, center, invariant) in [
        (Vector3::new(1.5, 1.5, 0.8), Vector3::z(), Invariant::AxialMomentum),
        (Vector3::new(1.4, 1.4, 0.7), equator(0.4), Invariant::Kovalevskaya),
        (Vector3::new(2.8, 2.8, 0.7), equator(0.4), Invariant::GoryachevChaplygin),
    ] {
        let third = top(inertia, 1.2, center)?;
        let value = invariant.value(&third, &Se3Dual::new(pi, gamma));
        for by in 1..3 {
            let other = top(turned(inertia, by), 1.2, turned(center, by))?;
            // At rest Π·Γ = 0, where G is conserved.
            let rest = Se3Dual::new(Vector3::zeros(), turned(gamma, by));
            assert_eq!(other.invariants_from(&rest).last(), Some(&invariant));
            let mu = Se3Dual::new(turned(pi, by), turned(gamma, by));
            assert_close(invariant.value(&other, &mu), value, 1e-15);
            // Control: the state in the frame of the other top has another value.
            let unturned = Se3Dual::new(pi, gamma);
            assert!((invariant.value(&other, &unturned) - value).abs() > 0.1);
        }
    }
    Ok(())
}

/// The rate of C = |Π|² is that of 2Π·(m g l Γ × c): zero for a free body alone.
#[test]
fn c_is_conserved_without_gravity() -> Result<(), TestCaseError> {
    let (mu, inertia) = (tops::generic_start(), Vector3::new(1.0, 1.4, 2.1));
    let free = fail(HeavyTop::free_rigid_body(inertia))?;
    assert_eq!(free.invariants().last(), Some(&Invariant::MomentumSquared));
    // The bound is for three products of four numbers of size 1, which cancel.
    assert!(rate(Invariant::MomentumSquared, &free, &mu).abs() <= 1e-14);
    let heavy = top(inertia, 1.0, Vector3::z())?;
    assert!(!heavy.invariants().contains(&Invariant::MomentumSquared));
    assert!(rate(Invariant::MomentumSquared, &heavy, &mu).abs() > 0.1);
    Ok(())
}

/// Negative controls: each fourth invariant is conserved by its own top alone.
#[test]
fn other_tops_do_not_conserve_them() -> Result<(), TestCaseError> {
    let mu = tops::generic_start();
    let nearly = top(Vector3::new(1.4, 1.4, 0.71), 1.0, equator(0.3))?;
    assert!(!nearly.is_kovalevskaya());
    assert!(rate(Invariant::Kovalevskaya, &nearly, &mu).abs() > 1e-3);
    let tilted = top(Vector3::new(1.4, 1.4, 0.7), 1.0, Vector3::new(0.6, 0.0, 0.8))?;
    assert!(rate(Invariant::Kovalevskaya, &tilted, &mu).abs() > 0.1);
    let kovalevskaya = fail(tops::paper())?;
    assert!(rate(Invariant::AxialMomentum, &kovalevskaya, &mu).abs() > 0.1);
    assert!(rate(Invariant::GoryachevChaplygin, &kovalevskaya, &mu).abs() > 0.1);
    for top in [nearly, tilted, fail(tops::generic())?] {
        assert_eq!(top.invariants().len(), 3);
    }
    Ok(())
}

/// The invariants are conserved along the exact flow, here a method of order 12 over ten time units.
#[test]
fn conserved_along_exact_solutions() -> Result<(), Box<dyn Error>> {
    let run = |top: HeavyTop, start: &Se3Dual, invariant: Invariant| {
        let gauss = Collective::new(RungeKutta::gauss(6)?, SpinorRealisation, top);
        let value = |mu: &Se3Dual| invariant.value(&top, mu);
        largest_deviation(&gauss, start, 0.02, 500, value)
    };
    let paper = tops::paper_start();
    // K = 193 has 500 rounding errors of terms of that size: 193 · √500 · 2e-16.
    assert!(run(tops::paper()?, &paper, Invariant::Kovalevskaya)? < 1e-11);
    let lagrange = HeavyTop::lagrange(1.5, 0.8, 2.0)?;
    assert!(run(lagrange, &paper, Invariant::AxialMomentum)? < 1e-13);
    let chaplygin = HeavyTop::goryachev_chaplygin(1.0, 1.0)?;
    let level = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.8, 0.0, -0.4));
    assert!(run(chaplygin, &level, Invariant::GoryachevChaplygin)? < 1e-11);
    // Negative control: off the level Π·Γ = 0.
    assert!(run(chaplygin, &paper, Invariant::GoryachevChaplygin)? > 1.0);
    Ok(())
}
