//! Clebsch maps: their laws, their lifts for momenta of every size, their second momentum map, and their errors.

use crate::support::{TOLERANCE, holds, laws, samples};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::{Vector1, Vector3};
use proptest::prelude::*;

fn map_laws<R: Representation>(r: &R) {
    for side in [Side::Left, Side::Right] {
        let map = clebsch_map(r.clone(), side);
        holds(laws::poisson_map(&map, &samples()).unwrap());
        holds(laws::symplectic_space(&map.source(), &samples()).unwrap());
    }
    let lifted = CotangentRepresentation(r.clone());
    holds(lie_poisson::laws::representation(&lifted, &samples(), &samples()).unwrap());
}

#[test]
fn clebsch_maps_obey_the_laws() {
    map_laws(&InfinitesimalAdjoint(So3));
    map_laws(&InfinitesimalAdjoint(UnitaryAlgebra::<2>));
    map_laws(&Diagonal::<_, 2>(InfinitesimalAdjoint(Se3::default())));
    map_laws(&Contragredient(InfinitesimalAdjoint(Se3::default())));
    map_laws(&ExtendedAdjoint::of(Se3::default()).unwrap());
    map_laws(&ExtendedCoadjoint::of(So3).unwrap());
    map_laws(&SU2OnC2);
}

/// With a group, the Clebsch map is the momentum map of the cotangent lift of the adjoint action.
#[test]
fn a_group_gives_the_same_map() {
    let by_group = MomentumMap(LinearAction(Adjoint(SE3::default())));
    let opposite = MomentumMap(Opposite(LinearAction(Adjoint(SE3::default()))));
    let left = clebsch_map(InfinitesimalAdjoint(Se3::default()), Side::Left);
    let right = clebsch_map(InfinitesimalAdjoint(Se3::default()), Side::Right);
    for z in samples() {
        assert!((by_group.apply::<f64>(&z) - left.apply::<f64>(&z)).max_abs() < TOLERANCE);
        assert!((opposite.apply::<f64>(&z) - right.apply::<f64>(&z)).max_abs() < TOLERANCE);
        for xi in samples() {
            let difference = by_group.generator::<f64>(&xi, &z) - left.generator::<f64>(&xi, &z);
            assert!(difference.max_abs() < TOLERANCE);
        }
    }
}

/// The nonlinear (local) action q ↦ q/(1 − rsq) of R on R, with the generator rq² for the rate r.
#[derive(Clone)]
pub(crate) struct Curved(pub(crate) f64);

impl GroupAction for Curved {
    type Group = RealSpace<1>;
    type Space = RealSpace<1>;
    const SIDE: Side = Side::Left;
    fn group(&self) -> RealSpace<1> {
        RealSpace
    }
    fn space(&self) -> RealSpace<1> {
        RealSpace
    }
    fn act<T: Real>(&self, s: &Vector1<T>, q: &Vector1<T>) -> Vector1<T> {
        Vector1::new(q.x / (T::one() - s.x * q.x * self.0))
    }
}

/// Maps say whether schemes that commute with affine maps descend, and wrappers ask what they wrap.
#[test]
fn maps_know_whether_equivariant_maps_descend() {
    let rates = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
        (0, 2, 0) => 1.0,
        (2, 0, 0) => -1.0,
        (1, 2, 1) => 2.0,
        (2, 1, 1) => -2.0,
        _ => 0.0,
    });
    let lacks = clebsch_realisation(InfinitesimalAdjoint(rates.unwrap()), Side::Left).unwrap();
    let has = clebsch_realisation(InfinitesimalAdjoint(So3), Side::Left).unwrap();
    assert!(has.equivariant_maps_descend() && has.map().equivariant_maps_descend());
    assert!(!lacks.equivariant_maps_descend() && !lacks.map().equivariant_maps_descend());
    assert!(PowerMap::<_, 2>(has.clone()).equivariant_maps_descend());
    assert!(!PowerMap::<_, 2>(lacks.clone()).equivariant_maps_descend());
    assert!(ProductMap(has.clone(), HOPF).equivariant_maps_descend());
    assert!(!ProductMap(has.clone(), lacks.clone()).equivariant_maps_descend());
    let product = ProductAlgebraMap::new(has.clone(), lacks.clone()).unwrap();
    assert!(!product.equivariant_maps_descend());
    let product = ProductAlgebraMap::new(has.clone(), has.clone()).unwrap();
    assert!(product.equivariant_maps_descend());
    let same = |inner: ClebschRealisation<InfinitesimalAdjoint<StructureConstants<3>>>| {
        ComposedMap { outer: Identity(inner.target()), inner }.equivariant_maps_descend()
    };
    assert!(!same(lacks.clone()));
    assert!(ComposedMap { outer: Identity(has.target()), inner: has }.equivariant_maps_descend());
    // Quadratic maps: of one representation twice, and of two that scale their cubes differently.
    let quadratic = |r| QuadraticMomentumMap::new(r, Side::Left).equivariant_maps_descend();
    assert!(quadratic(Sum(SL2OnR2, SL2OnR2)));
    let adjoint = CotangentRepresentation(InfinitesimalAdjoint(Sl2));
    assert!(
        !QuadraticMomentumMap::new(Sum(SL2OnR2, adjoint), Side::Left).equivariant_maps_descend()
    );
    // Momentum maps of actions: affine ones, with and without their odd powers, and one that is not affine.
    assert!(PARTICLE.equivariant_maps_descend());
    assert!(
        MomentumMap(Opposite(LinearAction(Adjoint(SE3::default())))).equivariant_maps_descend()
    );
    assert!(!MomentumMap(LinearAction(Adjoint(UnitaryGroup::<3>))).equivariant_maps_descend());
    // The unit of time of a generator that is not affine does not matter.
    for rate in [1e-200, 1e-14, 1.0, 1e14, 1e200] {
        assert!(!MomentumMap(Curved(rate)).equivariant_maps_descend(), "{rate:e}");
    }
}

/// J(q, p) vanishes on q, whatever p is.
#[test]
fn what_one_copy_cannot_reach() {
    type Point = SourcePoint<ClebschMap<InfinitesimalAdjoint<UnitaryAlgebra<2>>>>;
    let map = clebsch_map(InfinitesimalAdjoint(UnitaryAlgebra::<2>), Side::Left);
    let mut on_others = 0.0;
    for z in samples::<Point>() {
        let j = map.apply::<f64>(&z);
        assert!(j.pairing(&z.q).abs() < TOLERANCE);
        on_others = larger(on_others, j.pairing(&samples()[0]).abs());
    }
    // Negative control: it does not vanish on other elements.
    assert!(on_others > 0.1, "{on_others}");
}

/// The dual pair: with an invariant form κ the functions κ(q, q), ⟨p, q⟩ and κ⁻¹(p, p) commute with J, and span sl(2, R).
/// Without one, ⟨p, q⟩ alone does.
#[test]
fn the_second_momentum_map_commutes_with_the_first() {
    let map = clebsch_map(InfinitesimalAdjoint(So3), Side::Left);
    let space = map.source();
    for z in samples::<Cotangent<Vector3<f64>>>() {
        let (q, p) = (z.q, z.p.0);
        let differentials = [
            Covector(Cotangent::new(q * 2.0, Covector(Vector3::zeros()))),
            Covector(Cotangent::new(p, Covector(q))),
            Covector(Cotangent::new(Vector3::zeros(), Covector(p * 2.0))),
        ];
        let bracket = |a: &_, b: &_| space.bracket::<f64>(&z, a, b);
        for i in 0..3 {
            let j = map.pull_back::<f64>(&Vector::basis(i), &z);
            for k in &differentials {
                assert!(bracket(&j, k).abs() < TOLERANCE);
            }
            // Negative control: |q + p|² + q₁ does not commute with J.
            let other = Covector(Cotangent::new(Vector3::x(), Covector(Vector3::y())));
            assert!(bracket(&j, &other).abs() > 1e-3);
        }
        let [a, b, c] = [0, 1, 2].map(|i| &differentials[i]);
        assert!((bracket(a, c) - 4.0 * q.dot(&p)).abs() < TOLERANCE);
        assert!((bracket(a, b) - 2.0 * q.dot(&q)).abs() < TOLERANCE);
        assert!((bracket(b, c) - 2.0 * p.dot(&p)).abs() < TOLERANCE);
    }
    let map = clebsch_map(InfinitesimalAdjoint(Se3::default()), Side::Left);
    for z in samples::<Cotangent<Pair<Vector3<f64>, Vector3<f64>>>>() {
        let scaling = Covector(Cotangent::new(z.p.0, Covector(z.q)));
        for i in 0..6 {
            let j = map.pull_back::<f64>(&Vector::basis(i), &z);
            assert!(map.source().bracket::<f64>(&z, &j, &scaling).abs() < TOLERANCE);
        }
    }
}

proptest! {
    /// One copy of so(3) by Newton's iteration, two copies by linear equations, each for every direction and size.
    #[test]
    fn lifts_are_sections(
        direction in prop::array::uniform3(-1.0..1.0_f64),
        exponent in -300..300_i32,
        sheet in prop::bool::ANY,
    ) {
        let direction = Vector3::from(direction);
        prop_assume!(direction.norm() > 1e-3);
        let size = 10_f64.powi(exponent);
        let mu = Covector(direction * size);
        let side = if sheet { Side::Left } else { Side::Right };
        let one = clebsch_realisation(InfinitesimalAdjoint(So3), side).unwrap();
        let two = clebsch_realisation(Diagonal::<_, 2>(InfinitesimalAdjoint(So3)), side).unwrap();
        let (z, w) = (one.lift::<f64>(&mu).unwrap(), two.lift::<f64>(&mu).unwrap());
        prop_assert!((one.apply::<f64>(&z) - mu).max_abs() < TOLERANCE * size);
        prop_assert!((two.apply::<f64>(&w) - mu).max_abs() < TOLERANCE * size);
        // The least point has |q|² = |p|² = |μ|; the lift is not far from it.
        let norm = euclidean_norm(&z.q);
        prop_assert!((euclidean_norm(&z.p) / norm - 1.0).abs() < 1e-13);
        prop_assert!(norm < 30.0 * euclidean_norm(&mu).sqrt(), "{norm:e}");
    }
}

/// Each axis of so(3)∗ and of sl(2, R)∗, where a start may be degenerate, and both sheets of the hyperboloid.
#[test]
fn degenerate_directions_have_lifts() {
    let turned = clebsch_realisation(InfinitesimalAdjoint(So3), Side::Right).unwrap();
    let hyperbolic = clebsch_realisation(InfinitesimalAdjoint(Sl2), Side::Right).unwrap();
    for axis in [Vector3::x(), Vector3::y(), Vector3::z(), Vector3::new(0.0, 1.0, -1.0)] {
        for mu in [Covector(axis), Covector(-axis)] {
            let residual = (turned.apply::<f64>(&turned.lift::<f64>(&mu).unwrap()) - mu).max_abs();
            assert!(residual < TOLERANCE, "{mu:?}: {residual:e}");
            let lifted = hyperbolic.lift::<f64>(&mu);
            let residual = (hyperbolic.apply::<f64>(&lifted.unwrap()) - mu).max_abs();
            assert!(residual < TOLERANCE, "{mu:?}: {residual:e}");
        }
    }
    let zero = Covector(Vector3::zeros());
    assert_eq!(turned.lift::<f64>(&zero).unwrap(), Cotangent::new(Vector3::zeros(), zero));
}

#[test]
fn errors_name_what_is_wrong() {
    let map = clebsch_realisation(InfinitesimalAdjoint(So3), Side::Right).unwrap();
    let nan = Covector(Vector3::new(f64::NAN, 0.0, 0.0));
    assert!(map.lift::<f64>(&nan).unwrap_err().to_string().contains("μ must be finite"));
    let abelian = StructureConstants::<2>::new(|_, _, _| 0.0).unwrap();
    let nothing = clebsch_realisation(InfinitesimalAdjoint(abelian.clone()), Side::Left).unwrap();
    let mu = Covector(nalgebra::Vector2::new(1.0, -2.0));
    let error = nothing.lift::<f64>(&mu).unwrap_err();
    assert_eq!((error.value, nothing.fibres().rank()), (1.0, 0));
    assert!(error.to_string().contains("not in the image"), "{error}");
    // The extension by a derivation, which is the identity here, reaches it.
    let extended = clebsch_realisation(ExtendedAdjoint::of(abelian).unwrap(), Side::Left).unwrap();
    assert!((extended.apply::<f64>(&extended.lift::<f64>(&mu).unwrap()) - mu).max_abs() < 1e-15);
    // Matrix elements without a reciprocal.
    let tiny = StructureConstants::<2>::new(|i, j, k| match (i, j, k) {
        (0, 1, 1) => 5e-324,
        (1, 0, 1) => -5e-324,
        _ => 0.0,
    });
    let error = clebsch_realisation(InfinitesimalAdjoint(tiny.unwrap()), Side::Left).unwrap_err();
    assert!(error.to_string().contains("reciprocal"), "{error}");
}
