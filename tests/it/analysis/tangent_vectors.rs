//! Tangent vectors along trajectories, and the Lyapunov exponents of tops.

use collective_integrators::{
    Collective, Direct, HamiltonianField, Integrator, LiftFree, LyapunovExponents,
    MaximalLyapunovExponent, RungeKutta, Start, TangentIntegrator, VariationalFlow,
};
use heavytop::{HeavyTop, HeavyTopSpace, SpinorPoint, SpinorRealisation};
use lie_poisson::{
    DualNumber, LiePoisson, PoissonSpace, SO3OnR3, Se3Dual, SemidirectAlgebra, State, Vector,
    derivative_part, seed,
};
use momentum_map::{DualQuaternions, PoissonMap};
use nalgebra::{DMatrix, Vector3};
use std::error::Error;
use workspace_tests::{largest, relative_error, tops};

type Outcome = Result<(), Box<dyn Error>>;

const SPACE: HeavyTopSpace = LiePoisson::minus(SemidirectAlgebra(SO3OnR3));

/// The flow satisfies DΦ Λ DΦᵀ = Λ∘Φ over many steps, by the tangent vectors of a lift-free run.
#[test]
fn the_variational_flow_preserves_the_poisson_tensor() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    let gauss = LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, top);
    let defect = |steps: usize| -> Result<f64, Box<dyn Error>> {
        let basis = core::array::from_fn(Se3Dual::basis);
        let mut flow = VariationalFlow::<_, 6>::new(&gauss, start, basis, 0.05);
        for _ in 0..steps {
            flow.advance()?;
        }
        let tangent = DMatrix::from_fn(6, 6, |i, j| flow.tangents()[j].coordinate(i));
        let after = SPACE.poisson_tensor::<f64>(flow.state());
        let moved = &tangent * SPACE.poisson_tensor::<f64>(&start) * tangent.transpose();
        // The error is relative to the terms that cancel.
        Ok(largest(&(moved - after)) / tangent.norm_squared())
    };
    for steps in [1, 10, 100] {
        let defect = defect(steps)?;
        assert!(defect < 1e-14, "{steps}: {defect:e}");
    }
    Ok(())
}

/// Returns the last of `steps` items.
fn spectrum<I, const K: usize>(
    integrator: &I,
    start: <I as Integrator>::State,
    step: f64,
    steps: usize,
) -> Result<[f64; K], Box<dyn Error>>
where
    I: TangentIntegrator + Integrator<State: Vector>,
{
    let mut items = LyapunovExponents::<_, K>::new(integrator, start, step);
    let last = items.nth(steps - 1).ok_or("no item")??;
    assert_eq!(last.step, steps as u64);
    Ok(last.exponents)
}

/// Returns a top that starts near upright with more energy than it needs to fall: far from integrable.
fn chaotic() -> Result<(HeavyTop, Se3Dual), Box<dyn Error>> {
    let start = Se3Dual::new(Vector3::new(0.5, 1.5, -0.3), Vector3::new(2.0, -3.0, 6.0) / 7.0);
    Ok((tops::generic()?, start))
}

#[test]
#[ignore = "long"]
fn the_spectrum_of_a_generic_top_is_positive_and_symmetric() -> Outcome {
    let (top, start) = chaotic()?;
    let gauss = LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, top);
    let lambda: [f64; 6] = spectrum(&gauss, start, 0.05, 20_000)?;
    // Means over 1000 s are 0.07 to 0.16, since the motion stays near islands at times; `lyapunov_exponents` compares
    // values.
    assert!((0.05..0.25).contains(&lambda[0]), "{lambda:?}");
    // det DΦ = 1: the Poisson tensor, the Casimirs and hence the volume are conserved.
    let sum: f64 = lambda.iter().sum();
    assert!(sum.abs() < 1e-12, "{sum:e}");
    // There are one pair ±λ and four zeros, up to (ln t)/t = 7e-3.
    assert!((lambda[0] + lambda[5]).abs() < 2e-2, "{lambda:?}");
    assert!(lambda[1..5].iter().all(|x| x.abs() < 3e-2), "{lambda:?}");
    Ok(())
}

/// M∘Φ = φ∘M, so that DM takes tangent vectors on T*C² to those on se(3)*.
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
        // The bound is the round-off of 1000 steps, stretched like the tangent vectors: up to 5000.
        assert!(error < 1e-10, "{error:e}");
    }
    Ok(())
}

/// The same body near its stable equilibrium has quasi-periodic motion, and no positive exponent.
#[test]
#[ignore = "long"]
fn a_generic_top_at_low_energy_is_regular() -> Outcome {
    let start = Se3Dual::new(Vector3::new(0.1, -0.2, 0.1), Vector3::new(2.0, 6.0, -3.0) / 7.0);
    let gauss = LiftFree::new(RungeKutta::gauss(2)?, DualQuaternions, tops::generic()?);
    let [lambda] = spectrum(&gauss, start, 0.05, 20_000)?;
    assert!(lambda.abs() < 1e-2, "{lambda}");
    Ok(())
}

/// Negative control of the sum: an explicit method, which is not Poisson, contracts or expands.
#[test]
fn the_sum_of_the_spectrum_of_an_explicit_method_is_not_zero() -> Outcome {
    let (top, start) = chaotic()?;
    let field = HamiltonianField { space: SPACE, hamiltonian: top };
    let direct = Direct::new(RungeKutta::explicit_midpoint(), field);
    let lambda: [f64; 6] = spectrum(&direct, start, 0.05, 2000)?;
    let sum: f64 = lambda.iter().sum();
    assert!(sum.abs() > 1e-5, "{sum:e}");
    Ok(())
}

/// Tangent vectors of an integrable top grow linearly: λ(t) ≤ (ln t + c)/t.
#[test]
#[ignore = "long"]
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
