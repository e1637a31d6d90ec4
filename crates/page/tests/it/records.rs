//! What the page records: deviations, the section, and what follows a change.

use heavytop::{Coordinate, HeavyTop, Invariant};
use heavytop_page::{PageError, PageMethod, Simulation};
use lie_poisson::Se3Dual;
use nalgebra::Vector3;

type Failure = Box<dyn std::error::Error>;

fn thrown(method: PageMethod, step: f64) -> Result<Simulation, Failure> {
    let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
    Ok(Simulation::new(HeavyTop::kovalevskaya(1.0, 1.0)?, &start, method, step)?)
}

/// Returns the largest deviation of each invariant since the throw.
fn largest(simulation: &Simulation) -> Vec<f64> {
    let count = simulation.invariants().len();
    let of = |i| simulation.columns().iter().map(|column| column.largest[i]).fold(0.0, f64::max);
    (0..count).map(of).collect()
}

#[test]
fn poisson_methods_keep_the_casimirs_and_the_others_do_not() -> Result<(), Failure> {
    for method in PageMethod::ALL {
        let mut simulation = thrown(method, 0.02)?;
        assert_eq!(simulation.advance(100.0, u32::MAX)?, 5000);
        let is_direct = matches!(method, PageMethod::RungeKutta4 | PageMethod::ExplicitMidpoint);
        let [h, f1, f2, ..] = largest(&simulation)[..] else { return Err("three".into()) };
        // Rounding over 5000 steps on the one side, 5000 errors of the method on the other.
        assert_eq!(f1 < 1e-13 && f2 < 1e-12, !is_direct, "{method:?}: {f1:e}, {f2:e}");
        assert!(is_direct || h < 0.05, "{method:?}: {h:e}");
    }
    Ok(())
}

#[test]
fn the_method_and_the_step_change_while_it_moves() -> Result<(), Failure> {
    let mut simulation = thrown(PageMethod::Gauss { stages: 2 }, 0.02)?;
    simulation.advance(10.0, u32::MAX)?;
    let before = simulation.at(9.993);
    simulation.change_method(PageMethod::ExplicitMidpoint, 9.993)?;
    // It continues from what was shown.
    assert_eq!(simulation.time(), 9.993);
    let after = simulation.at(f64::INFINITY);
    assert!((after.momentum.0.0 - before.momentum.0.0).norm() < 1e-14);
    assert!((after.attitude.vector - before.attitude.vector).norm() < 1e-14);
    assert!(largest(&simulation)[0] < 1e-5);
    simulation.advance(20.0, u32::MAX)?;
    let ruined = largest(&simulation)[1];
    assert!(ruined > 1e-4, "{ruined:e}");
    // Of the new values nothing is lost by a Poisson method.
    simulation.change_method(PageMethod::Midpoint, simulation.time())?;
    simulation.change_step(0.05)?;
    simulation.measure_anew()?;
    simulation.advance(30.0, u32::MAX)?;
    assert!(largest(&simulation)[1] < 1e-13);
    assert_eq!(simulation.columns()[0].time, simulation.columns()[0].time.max(20.0));
    Ok(())
}

#[test]
fn the_section_fills_and_another_orbit_begins_on_it() -> Result<(), Failure> {
    let mut simulation = thrown(PageMethod::Gauss { stages: 4 }, 0.05)?;
    let (top, energy) = (*simulation.top(), simulation.values()[0]);
    simulation.change_section(Coordinate::Gamma1)?;
    simulation.advance(100.0, u32::MAX)?;
    let first = simulation.section_points().len();
    assert!(first > 20, "{first}");
    let point = simulation.section_points()[first / 2];
    simulation.begin_orbit(point.x, point.y)?;
    // The orbit of the point is that of the first throw.
    assert!((Invariant::Energy.value(&top, &simulation.at(0.0).momentum) - energy).abs() < 1e-6);
    assert_eq!((simulation.time(), simulation.steps()), (0.0, 0));
    simulation.advance(50.0, u32::MAX)?;
    let points = simulation.section_points();
    assert!(points.len() > first && points[first - 1].orbit == 0.0 && points[first].orbit == 1.0);
    let refused = simulation.begin_orbit(1.0, 1e3);
    assert_eq!(refused, Err(PageError::NotAccessible { x: 1.0, y: 1e3 }));

    simulation.change_section(Coordinate::Pi1)?;
    assert!(simulation.section_points().is_empty());
    simulation.advance(100.0, u32::MAX)?;
    let points = simulation.section_points();
    assert!(!points.is_empty() && points.iter().all(|point| point.y.abs() <= 1.0));
    Ok(())
}
