//! Trajectories between their samples: sections, dense output, tangent vectors.

use collective_integrators::{
    Collective, DenseOutput, Direct, Direction, Events, HamiltonianField, Integrator, LiftFree,
    LyapunovExponents, MaximalLyapunovExponent, RungeKutta, Start, VariationalFlow, fitted_order,
};
use heavytop::{EulerSolution, HeavyTop, Invariant, RigidBody, SpinorPoint, SpinorRealisation};
use lie_poisson::{
    Covector, DualNumber, Hamiltonian, LiePoisson, PoissonSpace, SO3OnR3, Se3Dual,
    SemidirectAlgebra, So3, Vector, derivative_part, larger, seed,
};
use momentum_map::{DualQuaternions, HOPF, PoissonMap, Quaternions};
use nalgebra::{DMatrix, Vector3};
use std::error::Error;
use workspace_tests::{largest, relative_error, tops};

type Outcome = Result<(), Box<dyn Error>>;
type Momentum = Covector<Vector3<f64>>;

/// Gauss with 6 stages and steps of 1/20 has no truncation error in double precision; 400 steps
/// gather some 1e-14, and t up to 20 in the elliptic functions as much.
const ROUND_OFF: f64 = 2e-13;

fn body() -> Result<(RigidBody, Momentum), Box<dyn Error>> {
    let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5))?;
    Ok((body, Covector(Vector3::new(2.7, -1.2, 3.6))))
}

/// The events Π₂ = 0 up to t = 20.
fn crossings<I>(
    integrator: &I,
    start: &Momentum,
    step: f64,
    direction: Direction,
) -> Result<Vec<(f64, Vector3<f64>)>, Box<dyn Error>>
where
    I: Start<Momentum = Momentum>,
{
    let run = integrator.trajectory(start, step)?.take(1 + (20.0 / step).round() as usize);
    let events = Events::new(integrator, run, |pi: &Momentum| pi.0.y, direction);
    events.map(|event| Ok(event.map(|e| (e.time, e.momentum.0))?)).collect()
}

/// The times in (0, 20) at which Π₂ of the closed form crosses zero, with its direction, by
/// bisection.
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
    let solution = EulerSolution::new(&body, start.0);
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
            // on the section to round-off, on the sphere to round-off
            assert!(pi.y.abs() < 1e-15, "{pi}");
            assert!((pi.norm() - start.0.norm()).abs() < ROUND_OFF);
        }
        assert!(worst < ROUND_OFF, "{worst:e}");
    }
    // each direction takes its own crossings, the wrong one takes none of them
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

/// The location adds no error: that of the midpoint rule goes as h².
#[test]
fn sections_are_as_accurate_as_the_integrator() -> Outcome {
    let (body, start) = body()?;
    let exact = exact_crossings(&EulerSolution::new(&body, start.0));
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
    let solution = EulerSolution::new(&body, start.0);
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

/// DΦ Λ DΦᵀ = Λ∘Φ over many steps, by the tangent vectors of a lift-free run.
#[test]
fn the_variational_flow_preserves_the_poisson_tensor() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    let space = LiePoisson::minus(SemidirectAlgebra(SO3OnR3));
    let gauss = LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, top);
    let defect = |steps: usize| -> Result<f64, Box<dyn Error>> {
        let basis = core::array::from_fn(Se3Dual::basis);
        let mut flow = VariationalFlow::<_, 6>::new(&gauss, start, basis, 0.05);
        for _ in 0..steps {
            flow.advance()?;
        }
        let tangent = DMatrix::from_fn(6, 6, |i, j| flow.tangents()[j].coordinate(i));
        let after = space.poisson_tensor::<f64>(flow.state());
        let moved = &tangent * space.poisson_tensor::<f64>(&start) * tangent.transpose();
        // relative to the terms that cancel
        Ok(largest(&(moved - after)) / tangent.norm_squared())
    };
    for steps in [1, 10, 100] {
        let defect = defect(steps)?;
        assert!(defect < 1e-14, "{steps}: {defect:e}");
    }
    Ok(())
}

/// The last of `steps` items.
fn spectrum<I, const K: usize>(
    integrator: &I,
    start: <I as Integrator>::State,
    step: f64,
    steps: usize,
) -> Result<[f64; K], Box<dyn Error>>
where
    I: Integrator + Integrator<DualNumber>,
{
    let mut items = LyapunovExponents::<_, K>::new(integrator, start, step);
    let last = items.nth(steps - 1).ok_or("no item")??;
    assert_eq!(last.step, steps as u64);
    Ok(last.exponents)
}

/// A top that comes from upright with energy to spare: far from integrable.
fn chaotic() -> Result<(HeavyTop, Se3Dual), Box<dyn Error>> {
    let start = Se3Dual::new(Vector3::new(0.5, 1.5, -0.3), Vector3::new(2.0, -3.0, 6.0) / 7.0);
    Ok((tops::generic()?, start))
}

#[test]
fn the_spectrum_of_a_generic_top_is_positive_and_symmetric() -> Outcome {
    let (top, start) = chaotic()?;
    let gauss = LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, top);
    let lambda: [f64; 6] = spectrum(&gauss, start, 0.05, 20_000)?;
    assert!(lambda[0] > 0.05, "{lambda:?}");
    // det DΦ = 1: the Poisson tensor, the Casimirs and hence the volume are preserved
    let sum: f64 = lambda.iter().sum();
    assert!(sum.abs() < 1e-12, "{sum:e}");
    // one pair ±λ and four zeros, up to (ln t)/t = 7e-3
    assert!((lambda[0] + lambda[5]).abs() < 2e-2, "{lambda:?}");
    assert!(lambda[1..5].iter().all(|x| x.abs() < 3e-2), "{lambda:?}");
    Ok(())
}

/// M∘Φ = φ∘M, so that tangent vectors on T*C² are carried by DM to those on se(3)*.
#[test]
fn tangent_vectors_descend_with_the_collective_integrator() -> Outcome {
    let (top, start) = chaotic()?;
    let scheme = RungeKutta::gauss(2)?;
    let free = LiftFree::new(scheme.clone(), DualQuaternions, top);
    let lifted = Collective::new(scheme, SpinorRealisation, top);
    let descend = |z: &SpinorPoint, v: &SpinorPoint| -> Se3Dual {
        derivative_part(&SpinorRealisation.apply::<DualNumber>(&seed(z, v)))
    };
    let state = Start::<f64>::start(&lifted, &start)?;
    let above: [SpinorPoint; 8] = core::array::from_fn(SpinorPoint::basis);
    let below = above.map(|v| descend(&state, &v));
    let mut above = VariationalFlow::new(&lifted, state, above, 0.05);
    let mut below = VariationalFlow::new(&free, start, below, 0.05);
    for _ in 0..1000 {
        above.advance()?;
        below.advance()?;
    }
    for (v, w) in above.tangents().iter().zip(below.tangents()) {
        let error = relative_error(&descend(above.state(), v), w);
        // the round-off of 1000 steps, stretched as the tangent vectors: up to 5000
        assert!(error < 1e-10, "{error:e}");
    }
    Ok(())
}

/// The same body near its stable equilibrium: quasi-periodic motion, no exponent.
#[test]
fn a_generic_top_at_low_energy_is_regular() -> Outcome {
    let start = Se3Dual::new(Vector3::new(0.1, -0.2, 0.1), Vector3::new(2.0, 6.0, -3.0) / 7.0);
    let gauss = LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, tops::generic()?);
    let [lambda] = spectrum(&gauss, start, 0.05, 20_000)?;
    assert!(lambda < 1e-2, "{lambda}");
    Ok(())
}

/// Negative control of the sum: an explicit method, which is not Poisson, contracts or expands.
#[test]
fn the_sum_of_the_spectrum_of_an_explicit_method_is_not_zero() -> Outcome {
    let (top, start) = chaotic()?;
    let space = LiePoisson::minus(SemidirectAlgebra(SO3OnR3));
    let field = HamiltonianField { space, hamiltonian: top };
    let direct = Direct::new(RungeKutta::explicit_midpoint(), field);
    let lambda: [f64; 6] = spectrum(&direct, start, 0.05, 2000)?;
    let sum: f64 = lambda.iter().sum();
    assert!(sum.abs() > 1e-5, "{sum:e}");
    Ok(())
}

/// Tangent vectors of an integrable top grow linearly: λ(t) ≤ (ln t + c)/t.
#[test]
fn the_exponent_of_an_integrable_top_vanishes() -> Outcome {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let gauss = LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, top);
    let exponents = MaximalLyapunovExponent::new(&gauss, start, 0.05);
    for item in exponents.skip(1999).step_by(4000).take(5) {
        let item = item?;
        let bound = (item.time.ln() + 4.0) / item.time;
        assert!(item.exponents[0].abs() < bound, "{item:?}");
    }
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
        // Γ₁ increases: (Γ × Ω)₁ > 0
        let omega: Vector3<f64> = top.differential(&mu).0;
        assert!(mu.0.1.cross(&omega).x > 0.0);
    }
    assert!(count > 50, "{count}");
    Ok(())
}
