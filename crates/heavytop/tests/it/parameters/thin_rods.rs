//! Thin rods: tops whose moment about one axis is zero, which are spherical pendulums.

use collective_integrators::{
    AlternatingSubsteps, AnyState, BatchIntegrator, Direction, Ensemble, Start,
};
use heavytop::methods::{Formulation, Method};
use heavytop::{
    Body, EnergyLevel, EulerSolution, GaussBatch, HeavyTop, MidpointBatch, RigidBody, Section,
    SectionError, Surface, SymmetricTopBatch, SymmetricTopSplitting, TopError,
};
use lie_poisson::{Se3Dual, Vector};
use nalgebra::Vector3;

/// A rod along an axis, with the moment I across it and the centre of mass on it.
fn rod(axis: usize, moment: f64, weight: f64) -> Body {
    let mut inertia = Vector3::repeat(moment);
    inertia[axis] = 0.0;
    let center_of_mass = Vector3::ith(axis, 1.0);
    Body { inertia, mass: weight, gravity: 1.0, length: 1.0, center_of_mass }
}

/// The direction of the rod in space by Kutta's method, from I d²q/dt² = m g l ((q·e₃)q − e₃) − I |dq/dt|² q.
fn pendulum(q: Vector3<f64>, rate: Vector3<f64>, ratio: f64, end: f64) -> Vector3<f64> {
    let up = Vector3::z();
    let field = |(q, v): &(Vector3<f64>, Vector3<f64>)| {
        (*v, (q * q.dot(&up) - up) * ratio - q * v.norm_squared())
    };
    let (steps, mut state) = (20_000, (q, rate));
    let h = end / f64::from(steps);
    let add = |a: &(Vector3<f64>, Vector3<f64>), b: &(Vector3<f64>, Vector3<f64>), h: f64| {
        (a.0 + b.0 * h, a.1 + b.1 * h)
    };
    for _ in 0..steps {
        let k1 = field(&state);
        let k2 = field(&add(&state, &k1, 0.5 * h));
        let k3 = field(&add(&state, &k2, 0.5 * h));
        let k4 = field(&add(&state, &k3, h));
        for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            state = add(&state, &k, weight * h / 6.0);
        }
    }
    state.0
}

/// The height of the rod is that of the pendulum, Π along the rod stays zero, and so does Ω.
#[test]
fn a_rod_is_a_spherical_pendulum() {
    for axis in 0..3 {
        let (moment, weight) = (0.12, 2.943);
        let top = HeavyTop::new(&rod(axis, moment, weight)).unwrap();
        assert_eq!((top.rod_axis(), top.inertia()[axis]), (Some(axis), 0.0));
        let [x, y] = [(axis + 1) % 3, (axis + 2) % 3];
        let (mut pi, mut gamma) = (Vector3::zeros(), Vector3::zeros());
        (pi[x], pi[y]) = (0.1, 0.2);
        (gamma[axis], gamma[x]) = (-0.8, 0.6);
        let start = Se3Dual::new(pi, gamma);
        top.require_state(&start).unwrap();
        let end = top.gauss(5).unwrap().after(&start, 0.01, 200).unwrap().momentum;
        // In space, with an attitude that has this Γ: q = Re_axis, dq/dt = R(Ω × e_axis).
        let attitude = heavytop::attitude_of_vertical(&gamma);
        let rate = attitude.rotate(&(pi / moment).cross(&Vector3::ith(axis, 1.0)));
        let q = attitude.rotate(&Vector3::ith(axis, 1.0));
        let height = pendulum(q, rate, weight / moment, 2.0).z;
        assert!((end.0.1[axis] - height).abs() < 1e-10, "{axis}: {end:?} {height}");
        assert!(end.0.0[axis].abs() < 1e-15 && top.angular_velocity(&end.0.0)[axis].abs() < 1e-13);
    }
}

/// Every method and every kernel moves a rod as it moves a sphere of the same moment without spin.
#[test]
fn every_method_moves_a_rod_as_a_sphere_without_spin() {
    for axis in 0..3 {
        let body = rod(axis, 0.5, 1.3);
        let sphere = Body { inertia: Vector3::repeat(0.5), ..body };
        let [rod, sphere] = [body, sphere].map(|body| HeavyTop::new(&body).unwrap());
        assert_ne!(rod, sphere);
        let mut pi = Vector3::new(0.3, 0.2, -0.4);
        pi[axis] = 0.0;
        let start = Se3Dual::new(pi, Vector3::new(0.48, 0.64, 0.6));
        for &(name, formulation) in Formulation::NAMES {
            for scheme in formulation.schemes() {
                let method = Method::new(formulation, scheme, 0.0).unwrap();
                let steps = |top: &HeavyTop| -> Se3Dual {
                    let integrator = method.integrator(top).unwrap();
                    let end = integrator.after(&AnyState::of(&start), 0.01, 20).unwrap().momentum;
                    Vector::from_coordinates(|i| end.as_slice()[i])
                };
                let difference = (steps(&rod) - steps(&sphere)).max_abs();
                // About e₁ and e₂ the rod is split as three rotors, and the sphere is not: errors of the methods.
                let is_other = formulation == Formulation::Splitting && axis < 2;
                let most = if is_other { 1e-5 } else { 1e-14 };
                assert!(difference < most, "{name} {scheme}: {difference:e}");
            }
        }
        let batch = |top: HeavyTop| {
            let mut ends = vec![many(MidpointBatch::new(), (top, start))];
            ends.push(many(GaussBatch::<3>::new().unwrap(), (top, start)));
            ends
        };
        for (one, other) in batch(rod).into_iter().zip(batch(sphere)) {
            assert!((one.1 - other.1).max_abs() < 1e-14);
        }
        if let Ok(splitting) = SymmetricTopSplitting::new(rod) {
            assert_eq!(axis, 2);
            let other = SymmetricTopSplitting::new(sphere).unwrap();
            let [one, other] = [splitting, other].map(|top| {
                let batch = SymmetricTopBatch::new(AlternatingSubsteps::blanes_moan4());
                many(batch, (top, start)).1
            });
            assert!((one - other).max_abs() < 1e-14);
        }
        let free = RigidBody::new(rod.inertia()).unwrap();
        // A free rod turns steadily about a fixed direction across it.
        assert_eq!(EulerSolution::new(&free, pi).unwrap().at(3.7), pi);
    }
}

/// Advances many copies of a member, and returns the last one.
fn many<B: BatchIntegrator<Member: Copy>>(integrator: B, member: B::Member) -> B::Member {
    let mut members = vec![member; 9];
    let failures = Ensemble::new(integrator).advance(&mut members, 0.01, 0..20);
    assert!(failures.is_empty(), "{failures:?}");
    members[8]
}

#[test]
fn what_is_no_rod_is_refused() {
    let refused = |body: Body| HeavyTop::new(&body).unwrap_err();
    let two = Body { inertia: Vector3::new(0.0, 0.0, 1.0), ..rod(2, 1.0, 1.0) };
    assert_eq!(refused(two), TopError::NotPositive { name: "inertia[0]", value: 0.0 });
    let unequal = Body { inertia: Vector3::new(1.0, 1.1, 0.0), ..rod(2, 1.0, 1.0) };
    assert!(matches!(refused(unequal), TopError::Triangle { .. }));
    let aside = Body { center_of_mass: Vector3::new(0.6, 0.0, 0.8), ..rod(2, 1.0, 1.0) };
    assert_eq!(refused(aside), TopError::RodCenter { axis: 2, across: 0.6 });
    // Without weight the place of the centre of mass plays no part.
    HeavyTop::new(&Body { gravity: 0.0, ..aside }).unwrap();
    let top = HeavyTop::new(&rod(2, 1.0, 1.0)).unwrap();
    let spinning = Se3Dual::new(Vector3::new(1.0, 0.0, 1e-6), Vector3::z());
    assert_eq!(top.require_state(&spinning), Err(TopError::RodSpin { axis: 2, momentum: 1e-6 }));
    HeavyTop::lagrange(1.0, 1e-3, 1.0).unwrap().require_state(&spinning).unwrap();
    let level = EnergyLevel { top, energy: 1.0, vertical_momentum: 0.1 };
    assert_eq!(level.states(&Vector3::new(0.6, 0.0, 0.8), 0, 0.1), None);
    let variable = heavytop::Coordinate::Gamma1.into();
    let surface = Surface { variable, level: 0.0, direction: Direction::Up };
    assert_eq!(Section::new(level, surface), Err(SectionError::ThinRod));
}

/// A rod has no moment about itself: upright it has the potential energy if Π·Γ = 0, and no energy suffices otherwise.
#[test]
fn the_amended_potential_of_a_rod_along_the_vertical() {
    for axis in 0..3 {
        let top = HeavyTop::new(&rod(axis, 0.12, 2.943)).unwrap();
        let level = |vertical_momentum| EnergyLevel { top, energy: 1.0, vertical_momentum };
        for (sign, potential) in [(1.0, 2.943), (-1.0, -2.943)] {
            let gamma = Vector3::ith(axis, sign);
            assert_eq!(level(0.0).amended_potential(&gamma), potential);
            assert_eq!(level(0.3).amended_potential(&gamma), f64::INFINITY);
        }
        // Control: across the rod there is a moment, m g l Γ·c = 0, and c²/2I.
        let across = Vector3::ith((axis + 1) % 3, 1.0);
        assert_eq!(level(0.0).amended_potential(&across), 0.0);
        assert!((level(0.3).amended_potential(&across) / (0.09 / 0.24) - 1.0).abs() < 1e-15);
    }
}
