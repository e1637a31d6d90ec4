//! §5.1: the collective integrator φ = M∘Φ_h∘(lift) is a Poisson map of se(3)*, exactly; the
//! implicit midpoint rule applied directly is not.

use collective_integrators::{
    Collective, Direct, HamiltonianField, RungeKutta, Scheme, StageSolver, Start, fitted_order,
};
use heavytop::{HeavyTop, HeavyTopSpace, Invariant, SpinorRealisation};
use lie_poisson::{DualNumber, LiePoisson, SO3OnR3, Se3Dual, SemidirectAlgebra, Vector, seed};
use std::error::Error;
use workspace_tests::{bracket_defects, largest, tops};

type Outcome = Result<(), Box<dyn Error>>;

const SPACE: HeavyTopSpace = LiePoisson::minus(SemidirectAlgebra(SO3OnR3));

/// The round-off of the entries of Dφ Λ Dφᵀ, sums of 36 products of three numbers up to 4.
const ROUND_OFF: f64 = 1e-13;

/// Returns one step of an integrator as a map of se(3)* over dual numbers; NaN where a step fails, so that every
/// comparison fails.
fn map<I>(integrator: &I, mu: &Se3Dual<DualNumber>, h: f64) -> Se3Dual<DualNumber>
where
    I: Start<DualNumber, Momentum = Se3Dual<DualNumber>>,
{
    let step = || -> Result<Se3Dual<DualNumber>, Box<dyn Error>> {
        let state = integrator.start(mu)?;
        let next = integrator.step(&state, h, &mut integrator.workspace())?;
        Ok(integrator.momentum(&next.point))
    };
    step().unwrap_or_else(|_| Vector::from_coordinates(|_| DualNumber::constant(f64::NAN)))
}

/// Returns max |Dφ Λ Dφᵀ − Λ∘φ| at μ, with Dφ by dual numbers.
fn defect<I>(integrator: &I, mu: &Se3Dual, h: f64) -> f64
where
    I: Start<DualNumber, Momentum = Se3Dual<DualNumber>>,
{
    largest(&bracket_defects(&SPACE, &SPACE, |mu| map(integrator, mu, h), mu))
}

fn experiments() -> Result<[(HeavyTop, Se3Dual); 2], Box<dyn Error>> {
    Ok([(tops::paper()?, tops::paper_start()), (tops::generic()?, tops::generic_start())])
}

#[test]
fn symplectic_methods_descend_to_poisson_maps() -> Outcome {
    for (top, start) in experiments()? {
        for stages in [1, 2, 3] {
            // With h|Ω|/2 ≈ 1 the iteration for the largest step contracts slowly.
            let solver = StageSolver { max_iterations: 1000, ..StageSolver::default() };
            let scheme = RungeKutta::gauss(stages)?.with_solver(solver);
            let gauss = Collective::new(scheme, SpinorRealisation, top);
            assert!(gauss.scheme().is_symplectic());
            for h in [0.02, 0.1, 0.5] {
                let defect = defect(&gauss, &start, h);
                assert!(defect <= ROUND_OFF, "{stages} stages, step {h}: {defect:e}");
            }
        }
    }
    Ok(())
}

/// The Casimirs of the image have the same differentials: d(c∘φ) = dc, for Gauss methods and not for others.
#[test]
fn casimirs_are_carried_over() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    let change = |scheme: RungeKutta, invariant: Invariant| {
        let integrator = Collective::new(scheme, SpinorRealisation, top);
        let value = |mu: &Se3Dual<DualNumber>| invariant.value(&top, mu);
        (0..6)
            .map(|k| {
                let mu: Se3Dual<DualNumber> = seed(&start, &Vector::basis(k));
                let after = value(&map(&integrator, &mu, 0.2));
                (after - value(&mu)).derivative().abs()
            })
            .fold(0.0, lie_poisson::larger)
    };
    for casimir in [Invariant::VerticalSquared, Invariant::VerticalMomentum] {
        assert!(change(RungeKutta::gauss(2)?, casimir) <= ROUND_OFF);
        assert!(change(RungeKutta::rk4(), casimir) > 1e-6);
    }
    assert!(change(RungeKutta::gauss(2)?, Invariant::AxialMomentum) > 1e-2);
    Ok(())
}

/// Negative control: explicit methods are not symplectic on T*C², and their images not Poisson.
#[test]
fn explicit_methods_do_not() -> Outcome {
    for (top, start) in experiments()? {
        for (scheme, least) in [(RungeKutta::explicit_midpoint(), 1e-3), (RungeKutta::rk4(), 1e-7)]
        {
            let integrator = Collective::new(scheme, SpinorRealisation, top);
            let defect = defect(&integrator, &start, 0.1);
            assert!(defect > least, "{defect:e}");
        }
    }
    Ok(())
}

/// The direct implicit midpoint rule conserves h, f₁ and f₂ but is not Poisson: the defect is 3e-5
/// at the paper's step and goes as h³.
#[test]
fn the_direct_midpoint_rule_is_not_poisson() -> Outcome {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let field = HamiltonianField { space: SPACE, hamiltonian: top };
    let midpoint = Direct::new(RungeKutta::implicit_midpoint(), field);
    let at = |h: f64| defect(&midpoint, &start, h);
    assert!((at(0.02) / 3e-5 - 1.0).abs() < 0.5, "{:e}", at(0.02));
    let points = [0.04, 0.02, 0.01, 0.005, 0.0025].map(|h| (h, at(h)));
    let slope = fitted_order(&points, ROUND_OFF)?;
    // corrections are of relative order h²
    assert!((slope - 3.0).abs() < 0.05, "{slope}");
    Ok(())
}

/// A failed step is not a small defect.
#[test]
fn a_step_without_a_result_is_seen() -> Outcome {
    let gauss = Collective::new(RungeKutta::gauss(2)?, SpinorRealisation, tops::paper()?);
    let mu = Se3Dual::new(tops::paper_start().0.0, nalgebra::Vector3::zeros());
    assert!(defect(&gauss, &mu, 0.02).is_nan());
    Ok(())
}
