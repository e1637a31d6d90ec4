//! Lifts of momenta of every size, from the smallest number to the largest.

use core::fmt::Debug;
use lie_poisson::{
    Covector, DefaultLanes, Lanes, Pair, Power, SL2OnR2, Se3Dual, State, Sum, Vector,
    map_coordinates,
};
use momentum_map::{
    Cotangent, HOPF, HopfRealisation, Lift, LiftError, PARTICLE, PoissonMap, QuadraticMomentumMap,
    RecentringWorkspace, Reversed, Side, So3OnC2, SourcePoint, TWO_FIELDS, TargetPoint,
    UnitaryRealisation, hopf_map, hopf_section, unitary_realisation,
};
use nalgebra::{SVector, Vector3};
use num_complex::Complex;

/// Sizes at which squares underflow and overflow, down to the smallest number.
const SIZES: [f64; 9] = [5e-324, 1e-310, 1e-200, 1e-100, 1.0, 1e100, 1e160, 1e200, 1e307];

/// Returns whether two vectors agree to a dozen rounding errors, each at least half of the smallest number.
fn near<V: Vector<Scalar = f64>>(a: &V, b: &V) -> bool {
    (*a - *b).max_abs() <= 1e-14 * b.max_abs() + 8.0 * 5e-324
}

/// Checks that M(lift(μ)) = μ.
fn lifts<M: Lift + Debug>(map: &M, mu: &TargetPoint<M>) -> SourcePoint<M> {
    let z = map.lift::<f64>(mu).unwrap_or_else(|error| panic!("{map:?}, {mu:?}: {error}"));
    let image = map.apply::<f64>(&z);
    assert!(near(&image, mu), "{map:?}: {image:?} instead of {mu:?}");
    z
}

/// Returns the error of a momentum without a lift.
fn reason<M: Lift + Debug>(map: &M, mu: &TargetPoint<M>) -> LiftError {
    match map.lift::<f64>(mu) {
        Err(error) => error,
        Ok(z) => panic!("{map:?} lifts {mu:?} to {z:?}"),
    }
}

/// Returns directions with small coordinates next to large ones.
fn directions() -> Vec<Vector3<f64>> {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let mut directions: Vec<_> = axes.iter().flat_map(|axis| [*axis, -axis]).collect();
    directions.extend([Vector3::new(1.0, 1.0, 1.0), Vector3::new(-0.5, 1.0, -1.0)]);
    directions.extend([Vector3::new(1e-9, -1e-12, -1.0), Vector3::new(0.3, 1e-20, 1.0)]);
    directions
}

#[test]
fn hopf_sections_have_every_size() {
    for direction in directions() {
        for size in SIZES.into_iter().chain([8e307]) {
            let gamma = direction * size;
            let psi = hopf_section(&gamma);
            assert!(near(&hopf_map(&psi), &gamma), "{gamma:?}");
            let side = QuadraticMomentumMap::new(So3OnC2, Side::Left);
            if size < 5e307 {
                lifts(&HOPF, &Covector(gamma));
                lifts(&side, &Covector(gamma));
            }
        }
    }
    // |Γ| overflows, and its square root does not.
    let huge = hopf_section(&(Vector3::new(1.0, 1.0, 1.0) * 1.5e308));
    let square = (huge / Complex::from(1e154)).norm_squared();
    assert!((square / (1.5 * 3_f64.sqrt()) - 1.0).abs() < 1e-14, "{square}");
}

#[test]
fn realisations_lift_every_size() {
    let definite = QuadraticMomentumMap::new(Sum(SL2OnR2, SL2OnR2), Side::Left);
    let hyperbolic = QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Right);
    let unitary = unitary_realisation::<3>();
    let spin = SVector::<Complex<f64>, 3>::from_fn(|i, _| Complex::new(0.5, 0.25 * i as f64));
    let image = unitary.apply::<f64>(&spin);
    for size in SIZES {
        lifts(&definite, &Covector(Vector3::new(0.0, size, -size)));
        lifts(&hyperbolic, &Covector(Vector3::new(size, 0.0, 0.0)));
        let axis = TargetPoint::<UnitaryRealisation<3>>::basis(0);
        let sign = unitary.apply::<f64>(&Vector::basis(0)).coordinate(0).signum();
        lifts(&unitary, &axis.scaled(sign * size));
        if size > 1e-300 {
            lifts(&definite, &Covector(Vector3::new(-0.3, 1.0, -0.5) * size));
            lifts(&hyperbolic, &Covector(Vector3::new(1.0, 0.2, 0.3) * size));
            lifts(&unitary, &image.scaled(size));
        }
        // Π and Γ of different sizes, as far as |Π|/|Γ| is a number.
        for other in SIZES.into_iter().filter(|other| (1e-290..1e290).contains(&(size / other))) {
            let (along, across) = (Vector3::x(), Vector3::new(0.0, 1.0, 1.0));
            lifts(&PARTICLE, &Se3Dual::new(across * size, along * other));
            let seen = Power([along * other, across * other]);
            lifts(&TWO_FIELDS, &Covector(Pair(Vector3::new(0.3, 1.0, -0.6) * size, seen)));
        }
    }
}

/// A SIMD lane does not depend on its neighbours, however small or large these are.
#[test]
fn every_lane_has_the_bits_of_its_own_lift() {
    let sizes = [1e-200, 1.0, 1e200, 3e-308];
    let member = |lane: usize| Covector(Vector3::new(0.3, -0.4, 0.5) * sizes[lane % 4]);
    let mu =
        Covector::from_coordinates(|i| DefaultLanes::from_lanes(|lane| member(lane).coordinate(i)));
    let z = HOPF.lift::<DefaultLanes>(&mu).unwrap();
    for lane in 0..DefaultLanes::COUNT {
        let alone = HOPF.lift::<f64>(&member(lane)).unwrap();
        assert_eq!(map_coordinates::<_, SourcePoint<HopfRealisation>>(&z, |x| x.lane(lane)), alone);
    }
}

#[test]
fn reasons_name_what_is_wrong() {
    let contains = |error: LiftError, words: &str| {
        assert!(error.to_string().contains(words), "{error}");
    };
    let (nan, infinite) = (Vector3::new(0.0, f64::NAN, 1.0), Vector3::x() * f64::NEG_INFINITY);
    for bad in [nan, infinite] {
        contains(reason(&HOPF, &Covector(bad)), "Π must be finite (|Π|");
        contains(reason(&PARTICLE, &Se3Dual::new(bad, Vector3::z())), "must be finite");
        contains(reason(&PARTICLE, &Se3Dual::new(Vector3::z(), bad)), "must be finite");
        let map = QuadraticMomentumMap::new(Sum(SL2OnR2, SL2OnR2), Side::Left);
        contains(reason(&map, &Covector(bad)), "μ must be finite");
        let mu = TargetPoint::<UnitaryRealisation<2>>::from_coordinates(|i| bad[i % 3]);
        contains(reason(&unitary_realisation::<2>(), &mu), "H must be finite");
    }
    contains(reason(&HOPF, &Covector(Vector3::zeros())), "different from 0");
    let zero = Se3Dual::new(Vector3::x(), Vector3::zeros());
    contains(reason(&PARTICLE, &zero), "Γ must be different from 0");
    let parallel = Covector(Pair(Vector3::x(), Power([Vector3::z(); 2])));
    contains(reason(&TWO_FIELDS, &parallel), "not parallel (|sin(Γ₁, Γ₂)| = 0e0)");
    let none = TargetPoint::<UnitaryRealisation<2>>::zero();
    contains(reason(&unitary_realisation::<2>(), &none), "H must be different from 0");
    let huge = Vector3::new(1.0, 1.0, 1.0) * 1.5e308;
    contains(reason(&HOPF, &Covector(huge)), "below 5e307");
    let steep = Se3Dual::new(Vector3::x() * 1e200, Vector3::y() * 1e-200);
    contains(reason(&PARTICLE, &steep), "|Π|/|Γ|");
    // Products of these vectors underflow or overflow; the lift must still see that they are not perpendicular.
    for size in SIZES {
        let mu = Se3Dual::new(Vector3::new(size, 0.0, size), Vector3::x() * size);
        contains(reason(&PARTICLE, &mu), "perpendicular");
    }
}

/// The fibres of the particle are the lines q + s p. A point far out loses the digits of q × p, and comes back.
#[test]
fn points_far_out_on_their_fibres_come_back() {
    let (q, p) = (Vector3::new(0.6, -0.3, 1.1), Covector(Vector3::new(-0.8, 0.5, 0.9)));
    for s in [1e3_f64, -1e5] {
        let far = Cotangent::new(q + p.0 * s, p);
        let space = &mut RecentringWorkspace::default();
        let near = PARTICLE.recentred::<f64>(&far, space);
        // Each of eight iterations halves the distance.
        assert!(near.q.norm() < far.q.norm() / 200.0, "{}", near.q.norm());
        let lost = (PARTICLE.apply::<f64>(&near) - PARTICLE.apply::<f64>(&far)).max_abs();
        // The momentum is known to the rounding of terms of size s.
        assert!(lost < 16.0 * f64::EPSILON * s.abs() * 3.0, "{lost:e}");
        // control: a point near the origin stays
        let start = Cotangent::new(q, p);
        assert_eq!(PARTICLE.recentred::<f64>(&start, space), start);
    }
}

/// Powers of two as units of q and of p multiply the point that is found, to the last bit.
#[test]
fn units_do_not_matter_on_the_way_back() {
    let (q, p) = (Vector3::new(0.6, -0.3, 1.1), Vector3::new(-0.8, 0.5, 0.9));
    let in_units = |a: f64, b: f64| {
        let far = Cotangent::new((q + p * 1e4) * a, Covector(p * b));
        (far, PARTICLE.recentred::<f64>(&far, &mut RecentringWorkspace::default()))
    };
    let (far, near) = in_units(1.0, 1.0);
    assert!(near.q.norm() < far.q.norm() / 200.0);
    for (a, b) in [(-60, 0), (60, 0), (0, -60), (0, 60), (-80, 80), (70, 50)] {
        let (a, b) = (2.0_f64.powi(a), 2.0_f64.powi(b));
        assert_eq!(in_units(a, b).1, Cotangent::new(near.q * a, near.p.scaled(b)), "{a:e} {b:e}");
        // A point that has lost no more than a digit stays.
        let start = Cotangent::new((q + p * 5.0) * a, Covector(p * b));
        let stays = PARTICLE.recentred::<f64>(&start, &mut RecentringWorkspace::default());
        assert_eq!(stays, start, "{a:e} {b:e}");
    }
}
