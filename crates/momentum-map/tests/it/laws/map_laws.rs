//! The law suites of actions, momentum maps and realisations: every type of the crate obeys its laws, and each law
//! rejects something that breaks it.

use crate::support::faulty::{FaultyHopf, FaultyRotations, WrongSide};
use crate::support::{TOLERANCE, holds, laws, samples};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::{Vector2, Vector3};

fn action_laws<A: GroupAction>(action: &A) {
    holds(laws::group_action(action, &samples(), &samples()).unwrap());
    holds(laws::group_action(&CotangentLift(action.clone()), &samples(), &samples()).unwrap());
    holds(laws::cotangent_lift(action, &samples(), &samples()).unwrap());
    holds(laws::equivariance(action, &samples(), &samples()).unwrap());
    holds(laws::poisson_map(&MomentumMap(action.clone()), &samples()).unwrap());
}

#[test]
fn linear_actions_on_real_complex_and_quaternionic_spaces() {
    action_laws(&LinearAction(SO3OnR3));
    action_laws(&Opposite(LinearAction(SL2OnR2)));
    action_laws(&LinearAction(SU2OnC2));
    action_laws(&Opposite(LinearAction(UnitaryOnComplexSpace::<2>)));
    action_laws(&LinearAction(SP1OnQuaternions::<1>));
}

#[test]
fn affine_actions() {
    action_laws(&AffineAction(SO2OnR2));
    action_laws(&Opposite(AffineAction(SO3OnR3)));
    action_laws(&Opposite(AffineAction(SU2OnC2)));
}

#[test]
fn actions_on_products() {
    action_laws(&ProductAction(AffineAction(SO2OnR2), LinearAction(SO3OnR3)));
}

/// A nonlinear action of (R, +) on the plane, the flow of a vector field that is not affine: q₁ moves by q₂³ per unit
/// of time.
#[derive(Clone)]
struct Shear;

impl GroupAction for Shear {
    type Group = RealSpace<1>;
    type Space = RealSpace<2>;
    const SIDE: Side = Side::Left;
    fn group(&self) -> RealSpace<1> {
        RealSpace
    }
    fn space(&self) -> RealSpace<2> {
        RealSpace
    }
    fn act<T: Real>(&self, g: &nalgebra::Vector1<T>, q: &Vector2<T>) -> Vector2<T> {
        Vector2::new(q.x + q.y * q.y * q.y * g.x, q.y)
    }
}

#[test]
fn an_action_that_is_not_affine() {
    action_laws(&Shear);
}

/// Checks the map, the fibre symmetry and the lift of the images of samples.
fn realisation_laws<M: FibreSymmetry + Lift>(map: &M) {
    let points = samples();
    let momenta: Vec<_> = points.iter().map(|z| map.apply::<f64>(z)).collect();
    holds(laws::poisson_map(map, &points).unwrap());
    holds(laws::fibre_symmetry(map, &points, &[0.3, -1.2]).unwrap());
    // The lift divides by sizes that a sample may make small.
    laws::lift(map, &momenta).unwrap().check(10.0 * TOLERANCE).unwrap();
    // There is no group beyond the last one.
    for z in &points {
        assert_eq!(map.flow::<f64>(M::COUNT, 0.3, z), *z);
        assert_eq!(map.momentum::<f64>(M::COUNT, z), 0.0);
    }
}

#[test]
fn realisations() {
    for side in [Side::Left, Side::Right] {
        realisation_laws(&QuadraticMomentumMap::new(So3OnC2, side));
        realisation_laws(&QuadraticMomentumMap::new(UnitaryOnComplexSpace::<1>, side));
        realisation_laws(&QuadraticMomentumMap::new(UnitaryOnComplexSpace::<3>, side));
        realisation_laws(&QuadraticMomentumMap::new(Sum(SL2OnR2, SL2OnR2), side));
        realisation_laws(&QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), side));
        let negative = Sum(Reversed(SL2OnR2), Reversed(SL2OnR2));
        realisation_laws(&QuadraticMomentumMap::new(negative, side));
    }
    realisation_laws(&PARTICLE);
    realisation_laws(&TWO_FIELDS);
    realisation_laws(&PowerMap::<_, 1>(HOPF));
    realisation_laws(&PowerMap::<_, 3>(HOPF));
    realisation_laws(&PowerMap::<_, 12>(HOPF));
    realisation_laws(&ProductMap(
        PowerMap::<_, 2>(HOPF),
        Identity(CotangentBundle(RealSpace::<2>)),
    ));
    realisation_laws(&ProductMap(PARTICLE, ProductMap(HOPF, PowerMap::<_, 2>(HOPF))));
}

/// The product of maps to 𝔤∗ and 𝔥∗ is one to (𝔤 × 𝔥)∗, on which the Casimirs of both factors commute with everything.
#[test]
fn products_of_maps_to_duals_of_algebras() {
    let map =
        ProductAlgebraMap::new(HOPF, ProductAlgebraMap::new(PARTICLE, HOPF).unwrap()).unwrap();
    realisation_laws(&map);
    // Each copy has three symmetries.
    realisation_laws(&PowerMap::<_, 2>(map));
    fn count<M: FibreSymmetry>(_: &M) -> usize {
        M::COUNT
    }
    assert_eq!((count(&map), count(map.factors())), (3, 3));
    let algebra = *map.target().algebra();
    // The second flow moves the particle by 1000 p along its fibre.
    let far = map.flow::<f64>(1, 1e3, &samples()[0]);
    let near = map.recentred::<f64>(&far, &mut RecentringWorkspace::default());
    // Ten of the products that J subtracts are as large as q × p.
    let lost = 10.0 * far.max_abs() * f64::EPSILON;
    assert!((map.apply::<f64>(&near) - map.apply::<f64>(&far)).max_abs() < lost);
    assert!(near.max_abs() < 0.1 * far.max_abs());
    for z in samples() {
        let (mu, parts) = (map.apply::<f64>(&z), map.factors().apply::<f64>(&z));
        assert_eq!(mu, Covector::new(parts.0.0, parts.1.0));
        for index in 0..4 {
            let c = |mu: &_| algebra.casimir_differential::<f64>(index, mu);
            let rate = |xi: &_| map.target().hamiltonian_vector::<f64>(&mu, xi).max_abs();
            assert!(rate(&c(&mu)) < TOLERANCE);
            // A negative control: the differential at another momentum is not that of a Casimir.
            let other = Vector::from_coordinates(|i| (1.3 * i as f64).cos());
            assert!(rate(&c(&other)) > 1e-3, "{index}");
        }
    }
}

#[test]
fn factors_with_brackets_of_different_signs_are_refused() {
    let left = QuadraticMomentumMap::new(So3OnC2, Side::Left);
    let refused = ProductAlgebraMap::new(HOPF, left).unwrap_err();
    assert_eq!(refused, DifferentSigns { first: Sign::Minus, second: Sign::Plus });
    assert!(ProductAlgebraMap::new(left, left).is_ok());
}

#[test]
fn momenta_outside_the_image_have_no_lift() {
    let zero = Covector(Vector3::zeros());
    assert!(HOPF.lift::<f64>(&zero).is_err());
    let up = Se3Dual::new(Vector3::z(), Vector3::z());
    assert!(PARTICLE.lift::<f64>(&up).is_err());
    let seen = |second| Covector(Pair(Vector3::x(), Power([Vector3::z(), second])));
    for parallel in [Vector3::z(), Vector3::z() * -3.0, Vector3::zeros()] {
        assert!(TWO_FIELDS.lift::<f64>(&seen(parallel)).is_err());
    }
    assert!(TWO_FIELDS.lift::<f64>(&seen(Vector3::new(1e-9, 0.0, 1.0))).is_ok());
    let unitary = unitary_realisation::<2>();
    // The nearest matrix of rank one lacks half of this one, in any unit.
    for size in [1.0, 3.0, 1e-200, 1e200] {
        let rank_two = nalgebra::Matrix2::from_diagonal_element(num_complex::Complex::from(size));
        let refused = unitary.lift::<f64>(&UnitaryAlgebra.momentum(&rank_two)).unwrap_err();
        assert_eq!(refused.value, 1.0, "{size:e}");
    }
    let nan = Covector(Vector3::new(f64::NAN, 0.0, 0.0));
    assert!(HOPF.lift::<f64>(&nan).is_err());
    let elliptic = Covector(Vector3::new(0.0, 1.0, -1.0));
    let indefinite = QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Left);
    assert!(indefinite.lift::<f64>(&elliptic).is_err());
    let definite = QuadraticMomentumMap::new(Sum(SL2OnR2, SL2OnR2), Side::Left);
    // At the centre of the cone both eigenvalues agree.
    let lifted = definite.lift::<f64>(&elliptic).unwrap();
    assert!((definite.apply::<f64>(&lifted) - elliptic).max_abs() < 1e-15);
}

#[test]
fn lifts_reach_the_whole_range_of_numbers() {
    let direction = Vector3::new(0.36, -0.48, -0.8);
    for size in [1e-300, 1e-170, 1e-155, 1.0, 1e155, 1e170, 1e300] {
        let mu = Covector(direction * size);
        let residual = (HOPF.apply::<f64>(&HOPF.lift::<f64>(&mu).unwrap()) - mu).max_abs();
        assert!(residual < 1e-15 * size, "{size:e}: {residual:e}");
    }
    let nothing = Covector(SkewHermitian::<f64, 0>::zero());
    assert!(unitary_realisation::<0>().lift::<f64>(&nothing).is_err());
}

#[test]
fn momenta_on_the_cone_of_sl2_have_a_lift() {
    let definite = QuadraticMomentumMap::new(Sum(SL2OnR2, SL2OnR2), Side::Left);
    for z in samples::<Vector2<f64>>() {
        let mu = definite.apply::<f64>(&Pair(z, Vector2::zeros()));
        let lifted = definite.lift::<f64>(&mu).unwrap();
        assert!((definite.apply::<f64>(&lifted) - mu).max_abs() < 1e-15);
    }
}

#[test]
fn laws_of_poisson_maps_reject_what_breaks_them() {
    let report = laws::poisson_map(&FaultyHopf::Mirrored, &samples()).unwrap();
    assert!(report.residual("Poisson").unwrap() > 0.1);
    assert!(report.residual("pull-back").unwrap() < TOLERANCE);
    let faulty = |method| laws::Faulty::new(&HOPF, method, 0);
    let report = laws::poisson_map(&faulty("generator"), &samples()).unwrap();
    assert!(report.residual("generator").unwrap() > 0.1);
    assert!(report.residual("Poisson").unwrap() < TOLERANCE);
    let report = laws::poisson_map(&faulty("pull_back"), &samples()).unwrap();
    assert!(report.residual("pull-back").unwrap() > 0.1);
    let report = laws::fibre_symmetry(&FaultyHopf::Fibres, &samples(), &[0.3]).unwrap();
    for law in ["invariance", "momentum", "one-parameter group", "commuting flows"] {
        assert!(report.residual(law).unwrap() > 0.01, "{law}");
    }
    let momenta: Vec<_> = samples().iter().map(|z| HOPF.apply::<f64>(z)).collect();
    assert!(laws::lift(&faulty("lift"), &momenta).unwrap().residual("section").unwrap() > 0.1);
}

#[test]
fn laws_of_actions_reject_the_wrong_side() {
    let report = laws::group_action(&WrongSide, &samples(), &samples()).unwrap();
    for law in ["composition", "generators and brackets"] {
        assert!(report.residual(law).unwrap() > 0.01, "{law}");
    }
    let report = laws::equivariance(&WrongSide, &samples(), &samples()).unwrap();
    assert!(report.residual("equivariance").unwrap() > 0.01);
    let report = laws::poisson_map(&MomentumMap(WrongSide), &samples()).unwrap();
    assert!(report.residual("Poisson").unwrap() > 0.1);
}

/// Residuals are relative to the elements, so that small ones count as much as others.
#[test]
fn a_wrong_generator_of_small_elements_is_rejected() {
    let report =
        laws::group_action(&FaultyRotations::GeneratorNearZero, &samples(), &samples()).unwrap();
    assert!(report.residual("generator").unwrap() > 0.1);
    assert!(report.residual("composition").unwrap() < TOLERANCE);
}

#[test]
fn no_samples_no_report() {
    let action = LinearAction(SO3OnR3);
    assert!(laws::group_action(&action, &[], &samples()).is_err());
    assert!(laws::group_action(&action, &samples(), &[]).is_err());
    assert!(laws::equivariance(&action, &[], &samples()).is_err());
    assert!(laws::poisson_map(&HOPF, &[]).is_err());
    assert!(laws::fibre_symmetry(&HOPF, &samples(), &[]).is_err());
    assert!(laws::lift(&HOPF, &[]).is_err());
}
