//! Corollary 3.2: M is a Poisson map, and so are the maps of which it is composed.

use heavytop::{HeavyTopSpace, SPINOR_MOTIONS, SpinorPoint, SpinorRealisation, Varpi};
use lie_poisson::{
    ComplexSpace, DualNumber, LiePoisson, Real, Se3, Se3Dual, Sign, Vector, map_coordinates,
};
use momentum_map::{
    ComposedMap, Cotangent, CotangentBundle, HOPF, HopfRealisation, MomentumMap, PoissonMap,
    SourcePoint,
};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;
use workspace_tests::{assert_near, bracket_defects, largest, map_defect, persistent, point};

/// The round-off of brackets of quadratic maps, sums of at most 16 products of coordinates up to 3, with a factor 3
/// in hand.
const ROUND_OFF: f64 = 1e-13;

/// Returns M in real coordinates, as the paper prints it in eq. (4.1) or in the right form. In print the second row
/// of Γ and the sign in the first are wrong.
fn real_form<T: Real>(z: &SpinorPoint<T>, printed: bool) -> Se3Dual<T> {
    let q: SVector<T, 4> = map_coordinates(&z.q, |x| x);
    let p: SVector<T, 4> = map_coordinates(&z.p, |x| x);
    let pi = Vector3::new(
        q[0] * p[3] - q[3] * p[0] - q[1] * p[2] + q[2] * p[1],
        q[2] * p[0] - q[0] * p[2] - q[1] * p[3] + q[3] * p[1],
        q[0] * p[1] - q[1] * p[0] - q[2] * p[3] + q[3] * p[2],
    );
    let height = p[0] * p[0] + p[1] * p[1] - p[2] * p[2] - p[3] * p[3];
    let gamma = if printed {
        Vector3::new((p[0] * p[2] - p[1] * p[3]) * 2.0, (p[0] * p[3] + p[1] * p[2]) * -2.0, height)
    } else {
        Vector3::new((p[0] * p[2] + p[1] * p[3]) * 2.0, (p[0] * p[3] - p[1] * p[2]) * 2.0, height)
    };
    Se3Dual::new(pi * T::from_f64(0.5), gamma)
}

proptest! {
    #![proptest_config(persistent())]

    #[test]
    fn m_is_poisson(z in point::<SpinorPoint>()) {
        prop_assert!(map_defect(&SpinorRealisation, &z) <= ROUND_OFF);
    }

    #[test]
    fn the_momentum_map_l_is_poisson(z in point::<SpinorPoint>()) {
        prop_assert!(map_defect(&MomentumMap(SPINOR_MOTIONS), &z) <= ROUND_OFF);
    }

    #[test]
    fn varpi_is_poisson(z in point::<SourcePoint<Varpi>>()) {
        prop_assert!(map_defect(&Varpi, &z) <= ROUND_OFF);
    }

    #[test]
    fn the_composition_of_both_is_poisson(z in point::<SpinorPoint>()) {
        let m = ComposedMap { outer: Varpi, inner: MomentumMap(SPINOR_MOTIONS) };
        prop_assert!(map_defect(&m, &z) <= ROUND_OFF);
    }

    #[test]
    fn the_hopf_realisation_is_poisson(z in point::<SourcePoint<HopfRealisation>>()) {
        prop_assert!(map_defect(&HOPF, &z) <= ROUND_OFF);
    }

    /// The complex form of eq. (4.1) against its real form with Γ corrected.
    #[test]
    fn the_corrected_real_form_is_the_complex_form(z in point::<SpinorPoint>()) {
        // The bound is for three to five products each.
        assert_near(&SpinorRealisation.apply(&z), &real_form(&z, false), 1e-15);
    }
}

/// Returns a point where no bracket vanishes by accident.
fn generic() -> SpinorPoint {
    let x = [0.3, -1.1, 0.7, 1.9, -0.4, 1.3, 0.8, -2.1];
    SpinorPoint::from_coordinates(|i| x[i])
}

/// Erratum 1: of the 15 brackets of two coordinates, 8 fail in the printed real form.
#[test]
fn the_printed_real_form_is_not_poisson() {
    let space = CotangentBundle(ComplexSpace::<2>);
    let target: HeavyTopSpace = LiePoisson::minus(Se3::default());
    let defects = |printed: bool| {
        bracket_defects(&space, &target, |z| real_form::<DualNumber>(z, printed), &generic())
    };
    let failing = |printed: bool| {
        let defects = defects(printed);
        let pairs = (0..6).flat_map(|j| (0..j).map(move |i| (i, j)));
        pairs.filter(|&pair| defects[pair].abs() > 1e-3).count()
    };
    assert_eq!(failing(true), 8);
    assert_eq!(failing(false), 0);
    assert!(largest(&defects(false)) <= ROUND_OFF);
}

/// The misprint does not show where p₂ = p₄ = 0, as in the paper's initial condition, but for the
/// sign of Γ₂ = 0.
#[test]
fn the_misprint_hides_for_real_psi() {
    let x = [1.0, -8.8, 6.5, -1.8, 0.97, 0.0, 0.26, 0.0];
    let z = SpinorPoint::from_coordinates(|i| x[i]);
    assert_near(&real_form(&z, true), &real_form(&z, false), 0.0);
}

/// Negative controls of the measure itself: it detects the plus bracket, exchanged roles of q and p, and a factor 2.
#[test]
fn wrong_brackets_and_wrong_maps_are_seen() {
    let space = CotangentBundle(ComplexSpace::<2>);
    let apply = |z: &SpinorPoint<DualNumber>| SpinorRealisation.apply::<DualNumber>(z);
    let plus = LiePoisson::new(Se3::default(), Sign::Plus);
    assert!(largest(&bracket_defects(&space, &plus, apply, &generic())) > 0.1);

    let minus = LiePoisson::minus(Se3::default());
    let exchanged =
        |z: &SpinorPoint<DualNumber>| apply(&Cotangent::new(z.p.0, lie_poisson::Covector(z.q)));
    assert!(largest(&bracket_defects(&space, &minus, exchanged, &generic())) > 0.1);
    let doubled = |z: &SpinorPoint<DualNumber>| apply(z).scaled(DualNumber::from_f64(2.0));
    assert!(largest(&bracket_defects(&space, &minus, doubled, &generic())) > 0.1);
}
