//! Events and dense output: a trajectory between its samples.

use collective_integrators::{
    Collective, DenseOutput, Direct, Direction, Events, HamiltonianField, LiftFree, RungeKutta,
    Start, fitted_order,
};
use heavytop::{EulerSolution, Invariant, RigidBody};
use lie_poisson::{Covector, Hamiltonian, LiePoisson, Se3Dual, So3, larger};
use momentum_map::{DualQuaternions, HOPF, Quaternions};
use nalgebra::Vector3;
use std::error::Error;
use workspace_tests::tops;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;
type Momentum = Covector<Vector3<f64>>;

/// The round-off of 400 steps. Gauss with 6 stages and steps of 1/20 has no truncation error in double precision; the
/// steps accumulate some 1e-14, and t up to 20 in the elliptic functions as much.
const ROUND_OFF: f64 = 2e-13;

fn body() -> Outcome<(RigidBody, Momentum)> {
    let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5))?;
    Ok((body, Covector(Vector3::new(2.7, -1.2, 3.6))))
}

/// Returns the events Π₂ = 0 up to t = 20.
fn crossings<I>(
    integrator: &I,
    start: &Momentum,
    step: f64,
    direction: Direction,
) -> Outcome<Vec<(f64, Vector3<f64>)>>
where
    I: Start<Momentum = Momentum>,
{
    let run = integrator.trajectory(start, step)?.take(1 + (20.0 / step).round() as usize);
    let events = Events::new(integrator, run, |pi: &Momentum| pi.0.y, direction);
    events.map(|event| Ok(event.map(|e| (e.time, e.momentum.0))?)).collect()
}

/// Returns the times in (0, 20) at which Π₂ of the closed form crosses zero, with its direction, by bisection.
fn exact_crossings(solution: &EulerSolution) -> Vec<(f64, bool)> {
    let at = |t: f64| solution.at(t).y;
    let grid = (0..2000_u32).map(|n| 0.01 * f64::from(n));
    let brackets = grid.filter(|&t| (at(t) < 0.0) != (at(t + 0.01) < 0.0));
    brackets
        .map(|t| {
            let up = at(t) < 0.0;
            let (mut left, mut right) = (t, t + 0.01);
            for _ in 0..60 {
                let middle = 0.5 * (left + right);
                if (at(middle) < 0.0) == up { left = middle } else { right = middle }
            }
            (left, up)
        })
        .collect()
}

#[test]
fn sections_of_the_free_rigid_body_against_the_closed_form() -> Outcome {
    let (body, start) = body()?;
    let solution = EulerSolution::new(&body, start.0)?;
    let exact = exact_crossings(&solution);
    assert!(exact.len() >= 4);
    let scheme = RungeKutta::gauss(6)?;
    let lifted = Collective::new(scheme.clone(), HOPF, body);
    let free = LiftFree::new(scheme.clone(), Quaternions, body);
    let field = HamiltonianField { space: LiePoisson::minus(So3), hamiltonian: body };
    let direct = Direct::new(scheme, field);
    for found in [
        crossings(&lifted, &start, 0.05, Direction::Both)?,
        crossings(&free, &start, 0.05, Direction::Both)?,
        crossings(&direct, &start, 0.05, Direction::Both)?,
    ] {
        assert_eq!(found.len(), exact.len());
        let mut worst = 0.0;
        for ((time, pi), (expected, _)) in found.iter().zip(&exact) {
            let error = (pi - solution.at(*expected)).norm();
            worst = larger(worst, larger((time - expected).abs(), error));
            // The points are on the section and on the sphere, to round-off.
            assert!(pi.y.abs() < 1e-15, "{pi}");
            assert!((pi.norm() - start.0.norm()).abs() < ROUND_OFF);
        }
        assert!(worst < ROUND_OFF, "{worst:e}");
    }
    // Each direction has its own crossings.
    let up = crossings(&lifted, &start, 0.05, Direction::Up)?;
    let down = crossings(&lifted, &start, 0.05, Direction::Down)?;
    assert_eq!(up.len() + down.len(), exact.len());
    for (found, side) in [(up, true), (down, false)] {
        let expected = exact.iter().filter(|(_, up)| *up == side);
        for ((time, _), (exact, _)) in found.iter().zip(expected) {
            assert!((time - exact).abs() < ROUND_OFF);
        }
    }
    Ok(())
}

/// The location of a section adds no error: the error of the midpoint rule falls as h².
#[test]
fn sections_are_as_accurate_as_the_integrator() -> Outcome {
    let (body, start) = body()?;
    let exact = exact_crossings(&EulerSolution::new(&body, start.0)?);
    let midpoint = LiftFree::new(RungeKutta::implicit_midpoint(), Quaternions, body);
    let mut points = vec![];
    for h in [0.1, 0.05, 0.025, 0.0125] {
        let found = crossings(&midpoint, &start, h, Direction::Both)?;
        let error = |((a, _), (b, _)): (&(f64, _), &(f64, _))| (a - b).abs();
        points.push((h, found.iter().zip(&exact).map(error).fold(0.0, larger)));
    }
    let slope = fitted_order(&points, 1e-12)?;
    assert!((slope - 2.0).abs() < 0.02, "{slope}");
    Ok(())
}

#[test]
fn dense_output_against_the_closed_form() -> Outcome {
    let (body, start) = body()?;
    let solution = EulerSolution::new(&body, start.0)?;
    let gauss = Collective::new(RungeKutta::gauss(6)?, HOPF, body);
    let mut run = DenseOutput::new(&gauss, gauss.trajectory(&start, 0.05)?);
    for n in 0..500_u32 {
        let t = 0.0371 * f64::from(n);
        let error = (run.at(t)?.momentum.0 - solution.at(t)).norm();
        assert!(error < ROUND_OFF, "{t}: {error:e}");
    }
    assert!(run.at(0.0).is_err());
    Ok(())
}

/// A Poincaré section of a top lies on the energy surface and on the section.
#[test]
fn a_section_of_the_paper_top() -> Outcome {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let gauss = LiftFree::new(RungeKutta::gauss(4)?, DualQuaternions, top);
    let run = gauss.trajectory(&start, 0.05)?.take(4001);
    let mut count = 0;
    for event in Events::new(&gauss, run, |mu: &Se3Dual| mu.0.1.x, Direction::Up) {
        let mu = event?.momentum;
        count += 1;
        assert!(mu.0.1.x.abs() < 1e-15);
        let energy: f64 = top.value(&mu) - top.value(&start);
        assert!(energy.abs() < 1e-6, "{energy:e}");
        let casimirs = [Invariant::VerticalSquared, Invariant::VerticalMomentum];
        for casimir in casimirs {
            let change = casimir.value(&top, &mu) - casimir.value(&top, &start);
            assert!(change.abs() < ROUND_OFF, "{change:e}");
        }
        // Γ₁ increases: (Γ × Ω)₁ > 0.
        let omega: Vector3<f64> = top.differential(&mu).0;
        assert!(mu.0.1.cross(&omega).x > 0.0);
    }
    assert!(count > 50, "{count}");
    Ok(())
}
