//! §2.2–2.3: the action of SU(2) ⋉ C² on C², its generator and its cotangent lift.

use heavytop::{SPINOR_MOTIONS, SpinorGroup, SpinorPoint};
use lie_poisson::{
    AlgebraElement, Covector, DualNumber, LieGroup, Pair, Point, Real, SU2, Su2, map_coordinates,
};
use momentum_map::{CotangentLift, GroupAction, Side};
use nalgebra::{Matrix2, Vector2};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{OneForm, assert_near, element, persistent, point};

type Spinor<T = f64> = Vector2<Complex<T>>;
type Motion<T = f64> = Pair<Matrix2<Complex<T>>, Spinor<T>>;

const GROUP: SpinorGroup = lie_poisson::SemidirectGroup(lie_poisson::SU2OnC2);

/// The round-off of two matrix-vector products of numbers up to 10.
const ROUND_OFF: f64 = 1e-14;

/// Returns whether two points agree to round-off.
fn same(a: &Spinor, b: &Spinor) -> bool {
    (a - b).norm() <= ROUND_OFF * (1.0 + a.norm())
}

fn axioms<A: GroupAction>(
    action: &A,
    g: &<A::Group as LieGroup>::Element<f64>,
    h: &<A::Group as LieGroup>::Element<f64>,
    z: &Point<A::Space>,
) {
    let group = action.group();
    let e = group.identity::<f64>();
    assert_near(&action.act::<f64>(&e, z), z, 0.0);
    let twice = action.act::<f64>(g, &action.act::<f64>(h, z));
    let product = match A::SIDE {
        Side::Left => group.compose::<f64>(g, h),
        Side::Right => group.compose::<f64>(h, g),
    };
    assert_near(&action.act::<f64>(&product, z), &twice, ROUND_OFF);
    let back = action.act::<f64>(&group.inverse::<f64>(g), &action.act::<f64>(g, z));
    assert_near(&back, z, ROUND_OFF);
}

proptest! {
    #![proptest_config(persistent())]

    #[test]
    fn psi_is_a_right_action(g in element(GROUP), h in element(GROUP), chi in point::<Spinor>()) {
        axioms(&SPINOR_MOTIONS, &g, &h, &chi);
    }

    #[test]
    fn the_cotangent_lift_is_a_right_action(
        g in element(GROUP), h in element(GROUP), z in point::<SpinorPoint>(),
    ) {
        axioms(&CotangentLift(SPINOR_MOTIONS), &g, &h, &z);
    }

    /// Ψ_(U,ρ)(χ) = U*(χ − ρ), also in the paper's matrix form: (U ρ; 0 1)⁻¹ (χ; 1).
    #[test]
    fn psi_is_the_inverse_affine_map(g in element(GROUP), chi in point::<Spinor>()) {
        let Pair(u, rho) = g;
        let image = SPINOR_MOTIONS.act::<f64>(&g, &chi);
        assert_near(&image, &(u.adjoint() * (chi - rho)), ROUND_OFF);
        assert_near(&(u * image + rho), &chi, ROUND_OFF);
    }

    /// The generator is (ξ,φ)_{C²}(χ) = −ξχ − φ, derived through exp.
    #[test]
    fn the_generator_is_affine(
        x in point::<AlgebraElement<SpinorGroup>>(), chi in point::<Spinor>(),
    ) {
        let Pair(xi, phi) = x;
        let expected = -(Su2.matrix(&xi) * chi) - phi;
        assert_near(&SPINOR_MOTIONS.infinitesimal_generator::<f64>(&x, &chi), &expected, 1e-15);
    }

    /// The cotangent lift T*Ψ_{(U,ρ)⁻¹}(χ, ψ) = (U*(χ − ρ), U*ψ): derived, and in the paper's form.
    #[test]
    fn the_cotangent_lift_has_the_closed_form(g in element(GROUP), z in point::<SpinorPoint>()) {
        let lifted = CotangentLift(SPINOR_MOTIONS).act::<f64>(&g, &z);
        let Pair(u, rho) = g;
        assert_near(&lifted.q, &(u.adjoint() * (z.q - rho)), ROUND_OFF);
        assert_near(&lifted.p.0, &(u.adjoint() * z.p.0), ROUND_OFF);
    }

    /// The generator of the lifted action is (−ξχ − φ, −ξψ), the derivative of that action.
    #[test]
    fn the_lifted_generator_has_the_closed_form(
        x in point::<AlgebraElement<SpinorGroup>>(), z in point::<SpinorPoint>(),
    ) {
        let lift = CotangentLift(SPINOR_MOTIONS);
        let velocity = lift.infinitesimal_generator::<f64>(&x, &z);
        let xi = Su2.matrix(&x.0);
        assert_near(&velocity.q, &(-(xi * z.q) - x.1), 1e-15);
        assert_near(&velocity.p, &Covector(-(xi * z.p.0)), 1e-15);

        let along: AlgebraElement<SpinorGroup, DualNumber> =
            map_coordinates(&x, |x| DualNumber::new(0.0, x));
        let g = GROUP.exp::<DualNumber>(&along);
        let z: SpinorPoint<DualNumber> = map_coordinates(&z, DualNumber::constant);
        let derivative: SpinorPoint =
            lie_poisson::derivative_part(&lift.act::<DualNumber>(&g, &z));
        assert_near(&velocity, &derivative, ROUND_OFF);
    }

    /// The lifted action conserves Θ₁: (T*Ψ_{(U,ρ)⁻¹})*Θ₁ = Θ₁ for every (U, ρ).
    #[test]
    fn the_cotangent_lift_conserves_theta_1(g in element(GROUP), z in point::<SpinorPoint>()) {
        let g: Motion<DualNumber> = map_coordinates(&g, DualNumber::constant);
        let lift = CotangentLift(SPINOR_MOTIONS);
        let defect = OneForm::Theta1.defect(|z| lift.act::<DualNumber>(&g, z), &z);
        prop_assert!(defect <= ROUND_OFF, "{defect:e}");
    }
}

/// Returns two motions and a point without symmetry.
fn generic() -> (Motion, Motion, SpinorPoint) {
    let x = [0.4, -1.3, 0.7, 0.2, 1.1, -0.6, 0.9, -0.5];
    let from = |shift: usize| -> AlgebraElement<SpinorGroup> {
        lie_poisson::Vector::from_coordinates(|i| x[(i + shift) % 8])
    };
    let (g, h) = (GROUP.exp::<f64>(&from(0)), GROUP.exp::<f64>(&from(3)));
    (g, h, lie_poisson::Vector::from_coordinates(|i| x[i]))
}

/// Negative controls: the action is not a left action; U instead of U* on ψ does not conserve Θ₁; translations do not
/// conserve Θ₂.
#[test]
fn wrong_sides_and_wrong_lifts_are_seen() {
    let (g, h, z) = generic();
    let twice = SPINOR_MOTIONS.act::<f64>(&g, &SPINOR_MOTIONS.act::<f64>(&h, &z.q));
    let wrong = SPINOR_MOTIONS.act::<f64>(&GROUP.compose::<f64>(&g, &h), &z.q);
    let right = SPINOR_MOTIONS.act::<f64>(&GROUP.compose::<f64>(&h, &g), &z.q);
    assert!(same(&twice, &right) && !same(&twice, &wrong));

    let g: Motion<DualNumber> = map_coordinates(&g, DualNumber::constant);
    let lift = CotangentLift(SPINOR_MOTIONS);
    let broken = |z: &SpinorPoint<DualNumber>| {
        let mut lifted = lift.act::<DualNumber>(&g, z);
        lifted.p = Covector(SU2.compose(&g.0, &Matrix2::identity()) * z.p.0);
        lifted
    };
    assert!(OneForm::Theta1.defect(broken, &z) > 0.1);
    assert!(OneForm::Theta2.defect(|z| lift.act::<DualNumber>(&g, z), &z) > 0.1);
    // Both forms are conserved by the linear part of the action.
    let linear = Pair(
        g.0,
        Vector2::repeat(Complex { re: DualNumber::from_f64(0.0), im: DualNumber::from_f64(0.0) }),
    );
    assert!(OneForm::Theta2.defect(|z| lift.act::<DualNumber>(&linear, z), &z) < ROUND_OFF);
}
