//! §2.3: the momentum map L, derived from the action, against the paper's closed form; its equivariance; and Remark
//! 2.1, the momentum map of SE(3) acting on R³.

use heavytop::{SPINOR_MOTIONS, SpinorGroup, SpinorMotions, SpinorPoint, SpinorRealisation};
use lie_poisson::{
    AlgebraElement, Covector, LieGroup, Momentum, Pair, Point, Real, RealSpace, SE3, SU2OnC2,
    Se3Dual, SemidirectGroup, Su2, Vector,
};
use momentum_map::{
    Cotangent, CotangentBundle, CotangentLift, GroupAction, Lift, MomentumMap, PARTICLE,
    PoissonMap, Side,
};
use nalgebra::{Matrix2, Matrix3, Vector3};
use num_complex::Complex;
use proptest::prelude::*;
use workspace_tests::{Derived, assert_close, assert_near, element, map_defect, persistent, point};

const GROUP: SpinorGroup = SemidirectGroup(SU2OnC2);
const L: MomentumMap<SpinorMotions> = MomentumMap(SPINOR_MOTIONS);

type SpinorMomentum = Momentum<heavytop::SpinorAlgebra>;

/// Returns L(χ,ψ) = (¼(χψ* − ψχ* − i Im(ψ*χ) I), −ψ), with the matrix read off in the basis e_j.
fn closed_form(z: &SpinorPoint) -> SpinorMomentum {
    let (chi, psi) = (z.q, z.p.0);
    let trace = Complex::new(0.0, psi.dotc(&chi).im);
    let matrix = chi * psi.adjoint() - psi * chi.adjoint() - Matrix2::identity() * trace;
    assert!(matrix.trace().norm() <= 1e-14, "the paper's extra term makes it traceless");
    Covector(Pair(Su2.coordinates(&(matrix * Complex::new(0.25, 0.0))), -psi))
}

proptest! {
    #![proptest_config(persistent())]

    #[test]
    fn l_has_the_closed_form(z in point::<SpinorPoint>()) {
        assert_near(&L.apply::<f64>(&z), &closed_form(&z), 1e-15);
    }

    /// The map L pairs as it is defined: ⟨L(χ,ψ), (ξ,φ)⟩ = Θ₁·(ξ,φ)_{C²} = −Re(ψ*(ξχ + φ)).
    #[test]
    fn l_pairs_as_defined(z in point::<SpinorPoint>(), x in point::<AlgebraElement<SpinorGroup>>()) {
        let expected = -z.p.0.dotc(&(Su2.matrix(&x.0) * z.q + x.1)).re;
        // The bound is for eight products of three numbers up to 3.
        assert_close(L.apply::<f64>(&z).pairing(&x), expected, 1e-14);
    }

    /// The generator of the map is the Hamiltonian vector field of ⟨L, (ξ,φ)⟩.
    #[test]
    fn the_generator_is_hamiltonian(
        z in point::<SpinorPoint>(), x in point::<AlgebraElement<SpinorGroup>>(),
    ) {
        assert_near(&L.generator::<f64>(&x, &z), &Derived(L).generator::<f64>(&x, &z), 1e-15);
    }

    /// The map L is equivariant: L ∘ T*Ψ_{(U,ρ)⁻¹} = Ad*_{(U,ρ)} ∘ L.
    #[test]
    fn l_is_equivariant(z in point::<SpinorPoint>(), g in element(GROUP)) {
        let moved = CotangentLift(SPINOR_MOTIONS).act::<f64>(&g, &z);
        let expected = GROUP.coadjoint::<f64>(&g, &L.apply::<f64>(&z));
        assert_near(&L.apply::<f64>(&moved), &expected, 1e-14);
    }
}

fn generic() -> SpinorPoint {
    let x = [0.3, -1.1, 0.7, 1.9, -0.4, 1.3, 0.8, -2.1];
    SpinorPoint::from_coordinates(|i| x[i])
}

/// Negative control: with Ad* of the inverse, as for a left action, equivariance fails.
#[test]
fn the_side_of_the_coadjoint_action_matters() {
    let x = [0.4, -1.3, 0.7, 0.2, 1.1, -0.6, 0.9];
    let g = GROUP.exp::<f64>(&Vector::from_coordinates(|i| x[i]));
    let moved = L.apply::<f64>(&CotangentLift(SPINOR_MOTIONS).act::<f64>(&g, &generic()));
    let right = GROUP.coadjoint::<f64>(&g, &L.apply::<f64>(&generic()));
    let inverse = GROUP.inverse::<f64>(&g);
    let wrong = GROUP.coadjoint::<f64>(&inverse, &L.apply::<f64>(&generic()));
    assert!((moved - right).max_abs() < 1e-14);
    assert!((moved - wrong).max_abs() > 0.1);
}

/// Negative control: without the term that makes it traceless the matrix is not in su(2), though
/// its projection is the same.
#[test]
fn the_extra_term_is_needed_for_su2() {
    let z = generic();
    let matrix = z.q * z.p.0.adjoint() - z.p.0 * z.q.adjoint();
    assert!(matrix.trace().norm() > 0.1);
    let projected = Su2.coordinates(&(matrix * Complex::new(0.25, 0.0)));
    assert_near(&projected, &closed_form(&z).0.0, 1e-15);
}

/// The right action x ↦ Rᵀ(x − a) of SE(3) on R³.
#[derive(Clone)]
struct RigidMotions;

impl GroupAction for RigidMotions {
    type Group = SE3;
    type Space = RealSpace<3>;
    const SIDE: Side = Side::Right;

    fn group(&self) -> SE3 {
        SE3::default()
    }

    fn space(&self) -> RealSpace<3> {
        RealSpace
    }

    fn act<T: Real>(&self, g: &Pair<Matrix3<T>, Vector3<T>>, x: &Vector3<T>) -> Vector3<T> {
        g.0.transpose() * (x - g.1)
    }
}

type Phase = Point<CotangentBundle<RealSpace<3>>>;

proptest! {
    #![proptest_config(persistent())]

    /// Remark 2.1: M̃(q, p) = −(q × p, p), Poisson and equivariant, but with Π ⊥ Γ always.
    #[test]
    fn rigid_motions_reach_only_perpendicular_pairs(
        z in point::<Phase>(), g in element(SE3::default()),
    ) {
        let map = MomentumMap(RigidMotions);
        let image = map.apply::<f64>(&z);
        assert_near(&image, &PARTICLE.apply::<f64>(&z), 1e-15);
        let (q, p) = (z.q, z.p.0);
        assert_near(&image, &Se3Dual::new(-q.cross(&p), -p), 1e-15);
        let Covector(Pair(pi, gamma)) = image;
        // The bound is for six products of three numbers up to 3, which cancel.
        prop_assert!(pi.dot(&gamma).abs() <= 1e-13);
        prop_assert!(map_defect(&map, &z) <= 1e-13);
        let moved = CotangentLift(RigidMotions).act::<f64>(&g, &z);
        let expected = SE3::default().coadjoint::<f64>(&g, &image);
        assert_near(&map.apply::<f64>(&moved), &expected, 1e-14);
    }
}

/// Remark 2.1: the upright top, Π ∥ Γ ∥ e₃, is not in the image of M̃, since Π·Γ = 0 there; it is in
/// that of M, where Π·Γ takes any value.
#[test]
fn the_upright_top_is_in_the_image_of_m_alone() -> Result<(), momentum_map::LiftError> {
    let upright = Se3Dual::new(Vector3::z() * 3.0, Vector3::z());
    assert_near(&SpinorRealisation.apply(&SpinorRealisation.lift(&upright)?), &upright, 1e-15);
    assert_eq!(upright.0.0.dot(&upright.0.1), 3.0);
    assert!(PARTICLE.lift::<f64>(&upright).is_err());
    // The only candidate has p = −Γ; every choice of q misses Π by |Π| at least.
    for q in [Vector3::zeros(), Vector3::x(), Vector3::new(5.0, -2.0, 1.0)] {
        let z = Cotangent::new(q, Covector(-Vector3::z()));
        let image = MomentumMap(RigidMotions).apply::<f64>(&z);
        assert!((image.0.0 - upright.0.0).norm() >= 3.0);
    }
    Ok(())
}
