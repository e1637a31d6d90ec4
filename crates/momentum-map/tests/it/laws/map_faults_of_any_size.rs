//! Residuals are relative to what enters a law: the suites see a fault of small and of large elements as well as one of
//! elements near 1, and allow round-off where group elements are large.

use crate::clebsch_maps::Curved;
use crate::support::faulty::{FaultyHopf, FaultyRotations, WrongSide};
use crate::support::{holds, laws, laws::Faulty, samples};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::{Matrix3, Vector2, Vector3};

/// Sizes of samples, far from 1 on both sides.
const SIZES: [f64; 3] = [1e-30, 1.0, 1e30];

fn scaled<V: Vector<Scalar = f64>>(size: f64) -> Vec<V> {
    samples::<V>().iter().map(|v| v.scaled(size)).collect()
}

/// Returns the laws that fail by a hundredth or more.
fn broken(report: &laws::Report) -> Vec<&'static str> {
    let laws = report.residuals().iter();
    laws.filter(|(_, residual)| *residual > 0.01).map(|(law, _)| *law).collect()
}

#[test]
fn of_actions() {
    for size in [1.0, 1e30] {
        let report = laws::group_action(&WrongSide, &samples(), &scaled(size)).unwrap();
        assert_eq!(broken(&report), ["composition", "generators and brackets"], "{size:e}");
        let report = laws::equivariance(&WrongSide, &samples(), &scaled(size)).unwrap();
        assert_eq!(broken(&report), ["equivariance"], "{size:e}");
        for xi in SIZES {
            let wrong = FaultyRotations::Generator;
            let report = laws::group_action(&wrong, &scaled(xi), &scaled(size)).unwrap();
            assert_eq!(
                broken(&report),
                ["generator", "generators and brackets"],
                "{xi:e} {size:e}"
            );
            let wrong = FaultyRotations::Momentum;
            let report = laws::cotangent_lift(&wrong, &scaled(xi), &scaled(size)).unwrap();
            assert_eq!(broken(&report), ["momentum"], "{xi:e} {size:e}");
            let wrong = FaultyRotations::Lift;
            let report = laws::cotangent_lift(&wrong, &scaled(xi), &scaled(size)).unwrap();
            assert_eq!(broken(&report), ["lifted generator"], "{xi:e} {size:e}");
        }
    }
}

/// The maps 2R q are no action: 1 doubles q and p, and so p dq is four times as large.
#[derive(Clone)]
struct Doubled;

impl GroupAction for Doubled {
    type Group = SO3;
    type Space = RealSpace<3>;
    const SIDE: Side = Side::Left;
    fn group(&self) -> SO3 {
        SO3
    }
    fn space(&self) -> RealSpace<3> {
        RealSpace
    }
    fn act<T: Real>(&self, g: &Matrix3<T>, q: &Vector3<T>) -> Vector3<T> {
        g * q * T::from_f64(2.0)
    }
}

/// A momentum with the wrong sign is wrong by 2s² at q = s e₁ and p = s e₂, and its unit is (1 + s)²; a generator with the
/// wrong sign is wrong by 2s, and its unit is 1 + s.
#[test]
fn units_of_cotangent_lifts() {
    for (s, xi) in [(1e-6, 1.0), (1.0, 1e6), (1e6, 1e-6), (3.0, 0.5)] {
        let (q, p) = (Vector3::x() * s, Covector(Vector3::y() * s));
        let residual = |wrong, law| {
            let (xi, points) = ([Vector3::z() * xi], [Cotangent::new(q, p)]);
            laws::cotangent_lift(&wrong, &xi, &points).unwrap().residual(law).unwrap()
        };
        let part = s / (1.0 + s);
        let ratio = residual(FaultyRotations::Momentum, "momentum") / (2.0 * part * part);
        // Some ten roundings.
        assert!((ratio - 1.0).abs() < 1e-14, "{s:e} {xi:e}: {ratio}");
        let ratio = residual(FaultyRotations::Lift, "lifted generator") / (2.0 * part);
        assert!((ratio - 1.0).abs() < 1e-14, "{s:e} {xi:e}: {ratio}");
        // The fault of 1, which is 3s, is relative to the doubled p, or to 1 if that is larger, and to the doubled dq.
        let points = [Cotangent::new(q, p)];
        let report = laws::cotangent_lift(&Doubled, &[Vector3::zeros()], &points).unwrap();
        let expected = 3.0 * s / ((2.0 * s).max(1.0) * 2.0);
        let ratio = report.residual("canonical form").unwrap() / expected;
        assert!((ratio - 1.0).abs() < 1e-14, "{s:e}: {ratio}");
    }
}

#[test]
fn of_maps_and_fibres() {
    for size in SIZES {
        let report = laws::poisson_map(&FaultyHopf::Mirrored, &scaled(size)).unwrap();
        assert_eq!(broken(&report), ["generator", "Poisson"], "{size:e}");
        let faulty = |method| Faulty::new(&HOPF, method, 0);
        let map = |method| broken(&laws::poisson_map(&faulty(method), &scaled(size)).unwrap());
        assert_eq!(map("apply"), ["pull-back", "generator", "Poisson"], "{size:e}");
        assert_eq!(map("generator"), ["generator"], "{size:e}");
        assert_eq!(map("pull_back"), ["pull-back"], "{size:e}");
        let momenta: Vec<_> = scaled(size).iter().map(|z| HOPF.apply::<f64>(z)).collect();
        let report = laws::lift(&faulty("lift"), &momenta).unwrap();
        assert_eq!(broken(&report), ["section"], "{size:e}");
        let report = laws::fibre_symmetry(&faulty("flow"), &scaled(size), &[0.3]).unwrap();
        let laws = ["invariance", "one-parameter group", "momentum"];
        assert!(laws.iter().all(|law| broken(&report).contains(law)), "{size:e}");
        let report = laws::fibre_symmetry(&FaultyHopf::Gauge, &scaled(size), &[0.3]).unwrap();
        assert!(broken(&report).contains(&"gauge"), "{size:e}");
    }
}

/// Elements of SL(2, R) and translations have no bound, and rounding errors grow with them. Those of small elements are of
/// the size of the point.
#[test]
fn round_off_is_allowed_for_elements_of_any_size() {
    fn check<A: GroupAction>(action: &A, xi: f64, q: f64) {
        holds(laws::group_action(action, &scaled(xi), &scaled(q)).unwrap());
        holds(laws::cotangent_lift(action, &scaled(xi), &scaled(q)).unwrap());
        holds(laws::equivariance(action, &scaled(xi), &scaled(q)).unwrap());
    }
    for q in SIZES {
        check(&LinearAction(SL2OnR2), 10.0, q);
        check(&AffineAction(SO2OnR2), 1e-30, q);
        check(&Opposite(AffineAction(SO2OnR2)), 10.0, q);
    }
    // The elements of a vector group may be zero.
    check(&Curved(1.0), 1e-30, 1.0);
    check(&Curved(1.0), 0.2, 1.0);
}

/// A plane with one thing wrong: with the flat of −x, or with the form of a dot product.
#[derive(Clone, PartialEq)]
enum FaultyPlane {
    Flat,
    Form,
}

impl VectorSpace for FaultyPlane {
    type Point<T: Real> = Vector2<T>;
}

impl PoissonSpace for FaultyPlane {
    fn hamiltonian_vector<T: Real>(&self, _: &Vector2<T>, dh: &Covector<Vector2<T>>) -> Vector2<T> {
        Vector2::new(dh.0.y, -dh.0.x)
    }
}

impl SymplecticSpace for FaultyPlane {
    fn symplectic_form<T: Real>(&self, u: &Vector2<T>, v: &Vector2<T>) -> T {
        if *self == Self::Form { u.dot(v) } else { u.x * v.y - u.y * v.x }
    }
    fn flat<T: Real>(&self, x: &Vector2<T>) -> Covector<Vector2<T>> {
        let flat = Covector(Vector2::new(-x.y, x.x));
        if *self == Self::Flat { -flat } else { flat }
    }
}

#[test]
fn of_symplectic_spaces() {
    for size in SIZES {
        let plane = |wrong| broken(&laws::symplectic_space(&wrong, &scaled(size)).unwrap());
        assert_eq!(plane(FaultyPlane::Flat), ["flat inverts sharp"], "{size:e}");
        assert_eq!(plane(FaultyPlane::Form), ["antisymmetry"], "{size:e}");
    }
}

#[test]
fn of_the_identity_and_of_the_canonical_form() {
    let report = laws::group_action(&FaultyRotations::Swollen, &samples(), &samples()).unwrap();
    assert!(report.residual("identity").unwrap() > 0.1);
    let report = laws::cotangent_lift(&FaultyRotations::Swollen, &samples(), &samples()).unwrap();
    assert!(report.residual("canonical form").unwrap() > 0.1);
}
