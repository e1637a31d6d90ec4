//! Reports on tops: measured rates against closed forms, and steady rotations against the equations of motion.

use heavytop::methods::{Formulation, Method, SchemeName};
use heavytop::{Body, HeavyTop};
use lie_poisson::Se3Dual;
use lie_poisson_runs::{Experiment, Pace, Schedule, SteadyRotation, TopInAxes, TopReport};
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;
use std::f64::consts::TAU;

fn report(top: HeavyTop, start: &Se3Dual, step: f64, end: f64) -> TopReport {
    let run = Experiment {
        start: TopInAxes::coordinates(start).to_vec(),
        method: Method::new(Formulation::Collective, SchemeName::Gauss(5), 0.0).unwrap(),
        pace: Pace { schedule: Schedule::new(step, end).unwrap(), every: 1 },
        attitude: false,
        model: TopInAxes::from(top),
    };
    TopReport::new(&run, None).unwrap()
}

/// Returns the measured number of the line that begins so, and the number of its formula that begins so.
fn line(report: &TopReport, name: &str, formula: &str) -> (f64, f64) {
    let line = report.lines.iter().find(|line| line.name.starts_with(name)).unwrap();
    let value = line.formulas.iter().find(|(text, _)| text.starts_with(formula));
    (line.measured.unwrap(), value.map_or(f64::NAN, |(_, value)| *value))
}

proptest! {
    /// The nutation and the turning points of Lagrange's top are those of the closed form, in all units.
    #[test]
    fn lagrange_tops_nutate_as_the_closed_form(
        pi in prop::array::uniform3(-1.5..1.5_f64),
        spin in 2.0..6.0_f64,
        inclination in 0.3..2.5_f64,
        units in prop::array::uniform3(-30..30_i32),
    ) {
        let [mass, length, time] = units.map(|power| 10.0_f64.powi(power));
        let (inertia, energy) = (mass * length * length, mass * length * length / time / time);
        let top = HeavyTop::lagrange(2.0 * inertia, inertia, energy).unwrap();
        let momentum = Vector3::new(pi[0], pi[1], spin) * (inertia / time);
        let vertical = Vector3::new(inclination.sin(), 0.0, inclination.cos());
        let report = report(top, &Se3Dual::new(momentum, vertical), 0.05 * time, 60.0 * time);
        let (measured, exact) = line(&report, "nutation", "closed form");
        // Gauss of order ten at 0.05 of the fastest rate has an error of 1e-9 after 60 units of time.
        prop_assert!((measured / exact - 1.0).abs() < 1e-8, "{measured} {exact}");
        for name in ["least inclination", "largest inclination"] {
            let (measured, exact) = line(&report, name, "closed form");
            prop_assert!((measured - exact).abs() < 1e-6, "{name} {measured} {exact}");
        }
        // Control: the formula of a fast top is another number.
        let (_, fast) = line(&report, "nutation", "I₃ω₃/I₁");
        prop_assert!((measured / fast - 1.0).abs() > 1e-8);
    }

    /// Steady rotations obey Π × Ω + m g l Γ × c = 0 with Ω = ωΓ, Π = IΩ, and have the momentum asked for, in all units.
    #[test]
    fn steady_rotations_are_equilibria(
        moments in prop::array::uniform3(1.0..1.9_f64),
        center in prop::array::uniform3(-1.0..1.0_f64),
        momentum in -3.0..3.0_f64,
        units in prop::array::uniform2(-30..30_i32),
    ) {
        let [mass, rate] = units.map(|power| 10.0_f64.powi(power));
        let center = Vector3::from(center);
        prop_assume!(center.norm() > 0.1 && momentum.abs() > 0.1);
        let top = HeavyTop::new(&Body {
            inertia: Vector3::from(moments) * mass,
            mass: mass * rate * rate,
            gravity: 1.0,
            length: 1.0,
            center_of_mass: center.normalize(),
        }).unwrap();
        let momentum = momentum * mass * rate;
        let found = SteadyRotation::all(&top, momentum);
        // A function on the sphere has a minimum and a maximum, and as many saddles as Morse's relation asks for.
        prop_assert!(found.len() >= 2 && found.len().is_multiple_of(2), "{found:?}");
        for rotation in &found {
            let omega = rotation.vertical * rotation.rate;
            let pi = top.inertia().component_mul(&omega);
            let torque = top.center_of_mass() * top.weight_moment();
            let change = pi.cross(&omega) + rotation.vertical.cross(&torque);
            let size = pi.norm() * omega.norm() + torque.norm();
            prop_assert!(change.norm() < 1e-10 * size, "{rotation:?}");
            prop_assert!((pi.dot(&rotation.vertical) / momentum - 1.0).abs() < 1e-14);
        }
        // The rotation of least energy is stable, and a control shows that another direction is none.
        prop_assert!(found[0].growth == 0.0);
        let wrong = (found[0].vertical + Vector3::new(0.01, -0.02, 0.03)).normalize();
        let near = found.iter().any(|rotation| (rotation.vertical - wrong).norm() < 1e-6);
        prop_assert!(!near);
    }
}

/// Returns the 24 rotations that exchange the axes of a body or turn them round.
fn rotations_of_axes() -> Vec<Matrix3<f64>> {
    let ends = [-1.0, 1.0].map(|sign| [0, 1, 2].map(|i| Vector3::ith(i, sign))).concat();
    let pairs = ends.iter().flat_map(|x| ends.iter().map(move |y| (*x, *y)));
    let frames = pairs.filter(|(x, y)| x.dot(y) == 0.0);
    frames.map(|(x, y)| Matrix3::from_columns(&[x, y, x.cross(&y)])).collect()
}

/// Nothing depends on which axes of the body carry which numbers, and which way they point.
#[test]
#[ignore = "long"]
fn reports_do_not_know_the_names_of_the_axes() {
    let bodies = [
        (Vector3::new(2.0, 2.0, 1.0), Vector3::z(), 1.0),
        (Vector3::new(2.0, 2.0, 1.0), Vector3::new(1.0, 0.0, 0.0), 1.0),
        (Vector3::new(2.0, 1.5, 1.0), Vector3::new(0.0, 0.6, 0.8), 1.0),
        (Vector3::new(2.0, 2.0, 2.0), Vector3::new(0.6, -0.8, 0.0), 1.0),
        (Vector3::new(1.0, 2.0, 2.5), Vector3::z(), 0.0),
        (Vector3::new(2.0, 2.0, 3.0), Vector3::z(), 0.0),
    ];
    assert_eq!(rotations_of_axes().len(), 24);
    for (inertia, center_of_mass, gravity) in bodies {
        let [pi, gamma] = [Vector3::new(0.5, 1.2, -0.7), Vector3::new(0.6, 0.0, 0.8)];
        let turned = |r: &Matrix3<f64>| {
            let inertia = (r * Matrix3::from_diagonal(&inertia) * r.transpose()).diagonal();
            let body = Body {
                inertia,
                mass: 1.0,
                gravity,
                length: 1.0,
                center_of_mass: r * center_of_mass,
            };
            report(HeavyTop::new(&body).unwrap(), &Se3Dual::new(r * pi, r * gamma), 0.1, 12.0)
        };
        let own = turned(&Matrix3::identity());
        // Lagrange's top has its formulas along every axis, and so has a heavy sphere.
        let has_formulas = own.lines.iter().any(|line| !line.formulas.is_empty());
        let is_symmetric =
            inertia.x == inertia.y && (center_of_mass.z == 1.0 || inertia.y == inertia.z);
        assert_eq!(has_formulas, is_symmetric || gravity == 0.0);
        for r in rotations_of_axes() {
            let other = turned(&r);
            assert_eq!((own.kind, own.steady.len()), (other.kind, other.steady.len()), "{r}");
            for (one, other) in own.lines.iter().zip(&other.lines) {
                // A few hundred roundings; the run is the same in other axes.
                let is_same = match (one.measured, other.measured) {
                    (Some(one), Some(other)) => (one - other).abs() < 1e-9,
                    (one, other) => one == other,
                };
                assert!(is_same, "{r} {one:?} {other:?}");
                for ((_, one), (_, other)) in one.formulas.iter().zip(&other.formulas) {
                    assert!((one - other).abs() < 1e-11, "{r} {one} {other}");
                }
            }
            for (one, other) in own.steady.iter().zip(&other.steady) {
                assert!((one.energy - other.energy).abs() < 1e-12, "{r} {one:?} {other:?}");
                assert!(
                    (one.vertical.norm() - 1.0).abs() < 1e-12
                        && (other.vertical.norm() - 1.0).abs() < 1e-12
                );
                assert!((one.growth - other.growth).abs() < 1e-7, "{r} {one:?} {other:?}");
            }
        }
    }
}

#[test]
fn a_symmetric_body_precesses_about_its_momentum() {
    let top = HeavyTop::free_rigid_body(Vector3::new(2.0, 2.0, 3.0)).unwrap();
    let momentum = Vector3::new(1.0, -0.5, 2.0);
    let report = report(top, &Se3Dual::new(momentum, Vector3::z()), 0.05, 100.0);
    for (name, formula) in [("precession", "L/I₁"), ("spin", "ω₃")] {
        let (measured, exact) = line(&report, name, formula);
        assert!((measured - exact).abs() < 1e-10, "{name}: {measured} {exact}");
    }
    let (inclination, _) = line(&report, "largest inclination", "");
    assert!((inclination.to_radians() - (2.0 / momentum.norm()).acos()).abs() < 1e-12);
}

/// A body that flips, and the growth ω √((I₂ − I₁)(I₃ − I₂)/(I₁I₃)) of its rotation about the middle axis.
#[test]
fn a_body_near_its_middle_axis_flips() {
    let moments = Vector3::new(1.0, 2.0, 3.0);
    let top = HeavyTop::free_rigid_body(moments).unwrap();
    let start = Se3Dual::new(Vector3::new(1e-3, 2.0, 0.0), Vector3::z());
    let report = report(top, &start, 0.02, 100.0);
    let (flip, exact) = line(&report, "time from flip to flip", "2K");
    assert!((flip / exact - 1.0).abs() < 1e-8 && flip > 10.0, "{flip} {exact}");
    let (period, _) = line(&report, "period", "4K");
    assert!((period - 2.0 * flip).abs() < 1e-12);
    let middle: Vec<_> = report.steady.iter().filter(|one| one.vertical.y.abs() > 0.9).collect();
    let rate = start.0.0.norm() / 2.0;
    let growth = rate * (1.0_f64 / 3.0).sqrt();
    assert_eq!((middle.len(), report.steady.len()), (2, 6));
    for rotation in middle {
        assert!((rotation.growth / growth - 1.0).abs() < 1e-8, "{rotation:?}");
        assert!(rotation.nearest < 1e-3);
    }
    // The rotations about the other axes are stable.
    let grows = report.steady.iter().filter(|one| one.growth > 0.0).count();
    assert_eq!(grows, 2);
}

/// A pendulum, of no vertical momentum, hangs and stands; the period of its swings is the closed form 4K/ω₀.
#[test]
fn a_pendulum_hangs_and_stands() {
    let top = HeavyTop::lagrange(1.0, 0.5, 1.0).unwrap();
    let found = SteadyRotation::all(&top, 0.0);
    let heights: Vec<_> = found.iter().map(|one| one.vertical.z).collect();
    assert_eq!(heights, [-1.0, 1.0]);
    assert!(found[0].growth == 0.0 && (found[1].growth - 1.0).abs() < 1e-8, "{found:?}");
    let swing = Se3Dual::new(Vector3::zeros(), Vector3::new(1.0, 0.0, 0.0));
    let report = report(top, &swing, 0.02, 60.0);
    // K(1/2) = 1.8540746773013719; the height has its maximum twice in a period.
    let (nutation, _) = line(&report, "nutation", "closed");
    assert!((TAU / nutation - 2.0 * 1.854_074_677_301_371_9).abs() < 1e-9, "{nutation}");
}

/// A top that stands upright has no precession of its own, and a sphere without weight no steady rotation of its own.
#[test]
fn what_has_no_meaning_is_not_told() {
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0).unwrap();
    for (vertical, inclination) in [(1.0, 0.0), (-1.0, 180.0)] {
        let start = Se3Dual::new(Vector3::new(0.0, 0.0, 4.0), Vector3::new(0.0, 0.0, vertical));
        let sleeping = report(top, &start, 0.05, 10.0);
        for name in ["precession", "spin, mean"] {
            let found = sleeping.lines.iter().find(|line| line.name.starts_with(name)).unwrap();
            assert_eq!(found.measured, None, "{name}");
        }
        assert_eq!(line(&sleeping, "least inclination", "").0, inclination);
    }
    // Control: at an angle it has both.
    let tilted =
        Se3Dual::new(Vector3::new(0.0, 0.0, 4.0), Vector3::new(1e-3, 0.0, 1.0).normalize());
    assert!(line(&report(top, &tilted, 0.05, 10.0), "precession", "").0.is_finite());
    let sphere = HeavyTop::free_rigid_body(Vector3::new(2.0, 2.0, 2.0)).unwrap();
    assert!(SteadyRotation::all(&sphere, 1.0).is_empty());
    let body = HeavyTop::free_rigid_body(Vector3::new(2.0, 2.0, 3.0)).unwrap();
    assert!(!SteadyRotation::all(&body, 1.0).is_empty());
}

/// A run without two highest points, and one whose formulation has no attitude.
#[test]
fn what_a_run_does_not_show_is_not_told() {
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0).unwrap();
    let start = Se3Dual::new(Vector3::new(0.5, 0.2, 3.0), Vector3::new(0.6, 0.0, 0.8));
    let short = report(top, &start, 0.02, 0.2);
    assert!(
        short.lines.iter().any(|line| line.name.starts_with("nutation") && line.measured.is_none())
    );
    let run = Experiment {
        start: TopInAxes::coordinates(&start).to_vec(),
        method: Method::new(Formulation::Direct, SchemeName::Gauss(2), 0.0).unwrap(),
        pace: Pace { schedule: Schedule::new(0.1, 1.0).unwrap(), every: 1 },
        attitude: false,
        model: TopInAxes::from(top),
    };
    assert!(TopReport::new(&run, None).is_err());
}
