//! Points of a fibre near the origin, and collective runs that continue from them.

use collective_integrators::{CHECKPOINT, Collective, Integrator, RungeKutta, Start};
use lie_poisson::{
    Automatic, Covector, DefaultLanes, Diagonal, DualNumber, Lanes, Pair, Point, Power, SL2OnR2,
    SO3OnR3, Se3Dual, State, Sum, Vector, derivative_part, map_coordinates, seed,
};
use momentum_map::{
    AffineAction, Cotangent, FibreSymmetry, HOPF, Lift, MomentumMap, Opposite, PARTICLE,
    ParticleRealisation, PoissonMap, ProductMap, QuadraticMomentumMap, RecentringWorkspace,
    Reversed, Side, SourcePoint,
};
use nalgebra::{Vector2, Vector3};
use proptest::prelude::*;
use workspace_tests::{Quadratic, persistent, point};

fn recentred<M: PoissonMap>(map: &M, z: &SourcePoint<M>) -> SourcePoint<M> {
    map.recentred::<f64>(z, &mut RecentringWorkspace::default())
}

type TwoFields = MomentumMap<Opposite<AffineAction<Diagonal<SO3OnR3, 2>>>>;

/// A body in two fields: its fibres are spaces of three dimensions.
const TWO_FIELDS: TwoFields = MomentumMap(Opposite(AffineAction(Diagonal(SO3OnR3))));

fn midpoint<M: PoissonMap>(map: M) -> Collective<RungeKutta, M, Automatic<Quadratic<M::Target>>> {
    Collective::new(RungeKutta::implicit_midpoint(), map, Automatic(Quadratic::default()))
}

/// Returns the momentum after some steps of 1/20 from z.
fn after<M: PoissonMap>(map: M, z: SourcePoint<M>, steps: usize) -> Point<M::Target> {
    let integrator = midpoint(map);
    let last = integrator.trajectory_from(z, 0.05).nth(steps);
    last.unwrap().unwrap().momentum
}

proptest! {
    #![proptest_config(persistent())]

    /// The least point of the line q + sp is known. A call leaves 1/256 of the way to it; a point within some thirty
    /// times its distance from the origin stays.
    #[test]
    fn a_particle_comes_back_along_its_line(
        q in point::<Vector3<f64>>(), p in point::<Vector3<f64>>(), s in 50.0..1e6_f64, a in -100..100_i32, b in -100..100_i32,
    ) {
        prop_assume!(q.cross(&p).norm() > 0.1);
        let (a, b) = (2.0_f64.powi(a), 2.0_f64.powi(b));
        let far = Cotangent::new((q + p * s) * a, Covector(p * b));
        let near = recentred(&PARTICLE, &recentred(&PARTICLE, &far));
        let least = PARTICLE.lift(&Se3Dual::new(-q.cross(&p) * (a * b), -p * b)).unwrap();
        let (moved, length) = ((near.q - least.q).norm() / a, least.q.norm() / a);
        prop_assert!(moved < s * p.norm() / 1e4 || moved < 32.0 * length, "{moved} {length}");
        // M(z) is known to the round-off of s |p|².
        let off = PARTICLE.apply(&near) - PARTICLE.apply(&far);
        let known = 64.0 * f64::EPSILON * s * p.norm_squared();
        prop_assert!(off.0.0.norm() / (a * b) < known, "{:e}", off.0.0.norm() / (a * b));
        prop_assert!(off.0.1.norm() / b < known);
    }

    /// The fibres are hyperbolas, along which z grows exponentially.
    #[test]
    fn a_plane_of_opposite_forms_comes_back(
        u in point::<Vector3<f64>>(), v in point::<Vector3<f64>>(), s in 3.0..9.0_f64, sign in prop::bool::ANY,
    ) {
        let map = QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Right);
        let z = Pair(u.xy(), v.xy());
        prop_assume!((u.x * v.y - u.y * v.x).abs() > 0.1);
        let far = map.flow(0, if sign { s } else { -s }, &z);
        let near = recentred(&map, &far);
        let (least, size) = (z.max_abs(), near.max_abs());
        prop_assert!(size < 0.02 * far.max_abs() || size < 8.0 * least, "{size} {least}");
        let known = 64.0 * f64::EPSILON * far.max_abs().powi(2);
        prop_assert!((map.apply(&near) - map.apply(&far)).max_abs() < known);
    }
}

#[test]
fn z_stays_where_its_momentum_has_all_digits() {
    let (q, p) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5));
    let z = Cotangent::new(q + p, Covector(p));
    assert_eq!(recentred(&PARTICLE, &z), z);
    let spin =
        Vector2::new(num_complex::Complex::new(0.3, 0.1), num_complex::Complex::new(-1.0, 2.0));
    assert_eq!(recentred(&HOPF, &spin), spin);
}

#[test]
fn z_stays_where_m_is_not_regular_or_z_no_number() {
    let at = |q: Vector3<f64>, p: Vector3<f64>| Cotangent::new(q, Covector(p));
    for z in [
        at(Vector3::zeros(), Vector3::zeros()),
        at(Vector3::x() * 1e6, Vector3::zeros()),
        at(Vector3::x() * f64::INFINITY, Vector3::x()),
        at(Vector3::repeat(f64::NAN), Vector3::x()),
        at(Vector3::x(), Vector3::repeat(f64::MAX)),
    ] {
        assert!(same_bits(&recentred(&PARTICLE, &z), &z), "{z:?}");
    }
    // q along p: the momentum is 0, and its fibre has a singular point.
    let moved = recentred(&PARTICLE, &at(Vector3::x() * 1e9, Vector3::x()));
    assert_eq!(PARTICLE.apply(&moved), Se3Dual::new(Vector3::zeros(), -Vector3::x()));
}

fn same_bits<V: Vector<Scalar = f64>>(a: &V, b: &V) -> bool {
    (0..V::DIM).all(|i| a.coordinate(i).to_bits() == b.coordinate(i).to_bits())
}

#[test]
fn products_of_maps_move_their_factors_apart() {
    let (q, p) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5));
    let (near, far) = (Cotangent::new(q, Covector(p)), Cotangent::new(q + p * 1e3, Covector(p)));
    let moved = recentred(&PARTICLE, &far);
    assert_ne!(moved, far);
    assert_eq!(recentred(&ProductMap(PARTICLE, PARTICLE), &Pair(near, far)), Pair(near, moved));
}

/// Each lane is moved, or not, as it would be alone; derivatives come along.
#[test]
fn lanes_and_tangent_vectors_are_moved_alike() {
    let (q, p) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5));
    let far = |i: usize| Cotangent::new(q + p * [0.0, 70.0, 1e5, 1.0][i], Covector(p));
    let lanes: SourcePoint<ParticleRealisation, DefaultLanes> =
        Vector::from_coordinates(|c| DefaultLanes::from_lanes(|i| far(i).coordinate(c)));
    let together = PARTICLE.recentred::<DefaultLanes>(&lanes, &mut RecentringWorkspace::default());
    for i in 0..4 {
        let alone = recentred(&PARTICLE, &far(i));
        assert!((0..6).all(|c| together.coordinate(c).lane(i) == alone.coordinate(c)), "{i}");
        assert_eq!(alone == far(i), i % 3 == 0);
    }
    // DM(z′) δz′ = DM(z) δz
    let tangent =
        Cotangent::new(Vector3::new(1.0, 2.0, -0.5), Covector(Vector3::new(0.1, -0.3, 0.2)));
    let z: SourcePoint<ParticleRealisation, DualNumber> = seed(&far(1), &tangent);
    let moved = PARTICLE.recentred::<DualNumber>(&z, &mut RecentringWorkspace::default());
    let image = |z| derivative_part::<f64, _, Se3Dual>(&PARTICLE.apply::<DualNumber>(z));
    assert!((image(&moved) - image(&z)).max_abs() < 1e-11);
    let value: SourcePoint<ParticleRealisation> =
        map_coordinates(&moved, |x| x.value_without_derivative());
    assert!(value != far(1));
}

/// The stage equations of a z far along its fibre are solvable only to the round-off of M.
#[test]
fn a_run_from_a_far_point_of_the_fibre_is_the_run_from_a_near_one() {
    let (u, v) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5));
    let p = [v + u.cross(&v), u - v];
    // The momentum Σ w_i × p_i is 0.
    let w = [p[1], p[0]];
    assert!((w[0].cross(&p[0]) + w[1].cross(&p[1])).norm() < 1e-15);
    let at = |s: f64| Cotangent::new(Power([u + w[0] * s, v + w[1] * s]), Covector(Power(p)));
    let reference = after(TWO_FIELDS, at(0.0), 100);
    for s in [10.0, 1e3, 1e5] {
        let gap = (after(TWO_FIELDS, at(s), 100) - reference).max_abs();
        // The bound is the rounding error of the start, and its growth over 100 steps.
        assert!(gap < 1e-13 * s, "{s} {gap:e}");
    }
}

/// A long run keeps z within a few hundred, though z drifts by a number like 1 in a unit of time.
#[test]
fn long_runs_stay_near_and_resume_to_the_bit() {
    let z = Cotangent::new(Vector3::new(0.3, -1.0, 0.7), Covector(Vector3::new(0.9, 0.4, -0.5)));
    let integrator = midpoint(PARTICLE);
    let run: Vec<_> =
        integrator.trajectory_from(z, 0.05).take(20_001).collect::<Result<_, _>>().unwrap();
    let farthest = run.iter().map(|sample| sample.state.q.norm()).fold(0.0, f64::max);
    assert!(farthest > 20.0 && farthest < 200.0, "{farthest}");
    let square = |mu: &Se3Dual| mu.0.1.norm_squared();
    for sample in &run {
        assert!((square(&sample.momentum) / square(&run[0].momentum) - 1.0).abs() < 1e-12);
    }
    let from = &run[4 * CHECKPOINT as usize];
    let resumed = integrator.trajectory_resumed(from.state, from.step, 0.05);
    for (a, b) in run[4 * CHECKPOINT as usize..].iter().zip(resumed.take(3000)) {
        assert_eq!(a.state, b.unwrap().state);
    }
}

/// Compensated runs stay near, too, and a change of lift does not enlarge their errors.
#[test]
fn compensated_runs_stay_near_too() {
    compensated_run_stays_near(5_001);
}

#[test]
#[ignore = "long"]
fn long_compensated_runs_stay_near_too() {
    compensated_run_stays_near(20_001);
}

fn compensated_run_stays_near(samples: usize) {
    let mu = Se3Dual::new(Vector3::new(0.5, 1.0, -0.5), Vector3::new(1.0, 0.0, 1.0));
    let casimir = |mu: &Se3Dual| mu.0.1.norm_squared();
    let integrator = midpoint(PARTICLE).compensated();
    for sample in integrator.trajectory(&mu, 0.05).unwrap().take(samples) {
        let sample = sample.unwrap();
        assert!(sample.state.0.q.norm() < 200.0);
        assert!((casimir(&sample.momentum) / casimir(&mu) - 1.0).abs() < 1e-13);
    }
}
