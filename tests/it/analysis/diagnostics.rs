//! The diagnostics tell methods that keep a promise from those that do not.

use collective_integrators::diagnostics::{
    Drift, EnsembleGrowth, StepMapError, fibre_defects, fitted_order, poisson_defect,
    reversibility_defect, step_map, step_poisson_defect, step_symplecticity_defect,
    symplecticity_defect, tangent_map,
};
use collective_integrators::{
    Collective, Direct, HamiltonianField, LiftFree, RungeKutta, Sample, Scheme, StageWorkspace,
    Start, Step, StepError, VectorField,
};
use heavytop::{HeavyTop, HeavyTopSpace, Invariant, SpinorPoint, SpinorRealisation};
use lie_poisson::{
    DualNumber, Hamiltonian, LiePoisson, Real, SO3OnR3, Se3Dual, SemidirectAlgebra, State, Vector,
};
use momentum_map::{
    CollectiveHamiltonian, DualQuaternions, FibreSymmetry, Lift, LiftError, PoissonMap,
};
use nalgebra::Vector3;
use std::error::Error;
use workspace_tests::tops;

type Outcome = Result<(), Box<dyn Error>>;

const SPACE: HeavyTopSpace = LiePoisson::minus(SemidirectAlgebra(SO3OnR3));

/// The round-off of sums of 36 or 64 products of three numbers up to 4.
const ROUND_OFF: f64 = 1e-13;

const STEPS: [f64; 5] = [0.04, 0.02, 0.01, 0.005, 0.0025];

fn experiments() -> Result<[(HeavyTop, Se3Dual); 2], Box<dyn Error>> {
    Ok([(tops::paper()?, tops::paper_start()), (tops::generic()?, tops::generic_start())])
}

fn direct_midpoint(top: HeavyTop) -> Direct<RungeKutta, HamiltonianField<HeavyTopSpace, HeavyTop>> {
    let field = HamiltonianField { space: SPACE, hamiltonian: top };
    Direct::new(RungeKutta::implicit_midpoint(), field)
}

#[test]
fn gauss_methods_are_poisson_with_and_without_a_lift() -> Outcome {
    for (top, start) in experiments()? {
        for stages in [1, 2, 3] {
            let scheme = RungeKutta::gauss(stages)?;
            let lifted = Collective::new(scheme.clone(), SpinorRealisation, top);
            let free = LiftFree::new(scheme, DualQuaternions, top);
            for h in [0.02, 0.1] {
                assert!(step_poisson_defect(&SPACE, &lifted, &start, h)? <= ROUND_OFF);
                assert!(step_poisson_defect(&SPACE, &free, &start, h)? <= ROUND_OFF);
            }
        }
        let rk4 = Collective::new(RungeKutta::rk4(), SpinorRealisation, top);
        assert!(step_poisson_defect(&SPACE, &rk4, &start, 0.1)? > 1e-7);
    }
    Ok(())
}

/// The defect of the direct midpoint rule is 3e-5 at the paper's step, and falls as h³.
#[test]
fn the_defect_of_the_direct_midpoint_rule_is_of_third_order() -> Outcome {
    let (midpoint, start) = (direct_midpoint(tops::paper()?), tops::paper_start());
    let at_paper = step_poisson_defect(&SPACE, &midpoint, &start, 0.02)?;
    assert!((at_paper / 3e-5 - 1.0).abs() < 0.5, "{at_paper:e}");
    let mut points = vec![];
    for h in STEPS {
        points.push((h, step_poisson_defect(&SPACE, &midpoint, &start, h)?));
    }
    let slope = fitted_order(&points, ROUND_OFF)?;
    assert!((slope - 3.0).abs() < 0.05, "{slope}");
    Ok(())
}

/// Symplectic schemes are symplectic on T*C², without the motion along the fibres that the collective integrator
/// makes.
#[test]
fn symplectic_schemes_are_symplectic_on_the_cotangent_bundle() -> Outcome {
    for (top, start) in experiments()? {
        let z = SpinorRealisation.lift(&start)?;
        let system = CollectiveHamiltonian::new(SpinorRealisation, top);
        let space = SpinorRealisation.source();
        let defect = |scheme: RungeKutta, h: f64| {
            step_symplecticity_defect(&space, &Direct::new(scheme, system), &z, h)
        };
        for stages in [1, 2, 3] {
            let defect = defect(RungeKutta::gauss(stages)?, 0.1)?;
            assert!(defect <= ROUND_OFF, "{stages}: {defect:e}");
        }
        // A method of order p is symplectic up to h^{p+1}; corrections are of relative order h.
        for (scheme, power, scale) in
            [(RungeKutta::explicit_midpoint(), 3.0, 0.1), (RungeKutta::rk4(), 5.0, 0.5)]
        {
            let mut points = vec![];
            for h in STEPS.map(|h| scale * h) {
                points.push((h, defect(scheme.clone(), h)?));
            }
            let slope = fitted_order(&points, ROUND_OFF)?;
            assert!((slope - power).abs() < 0.2, "{power} {slope}");
        }
    }
    Ok(())
}

/// The diagnostics take closures: the flow of the fibre symmetry is canonical, and a reflection is not Poisson.
#[test]
fn maps_by_closure() -> Outcome {
    let z = SpinorRealisation.lift(&tops::generic_start())?;
    for index in 0..SpinorRealisation::COUNT {
        let s = DualNumber::constant(0.7);
        let flow = |z: &SpinorPoint<DualNumber>| SpinorRealisation.flow(index, s, z);
        let defect = symplecticity_defect(&SpinorRealisation.source(), flow, &z);
        assert!(defect <= ROUND_OFF, "{index}: {defect:e}");
    }
    let mu = tops::generic_start();
    let reflection = |mu: &Se3Dual<DualNumber>| -*mu;
    // −Λ in place of Λ.
    assert!((poisson_defect(&SPACE, reflection, &mu) - 2.0).abs() < 1e-15);
    // M ∘ lift = id, through the derivatives of both
    let nan = Se3Dual::from_coordinates(|_| DualNumber::constant(f64::NAN));
    let identity = |mu: &Se3Dual<DualNumber>| {
        SpinorRealisation.lift(mu).map_or(nan, |z| SpinorRealisation.apply(&z))
    };
    let tangent = tangent_map(identity, &mu);
    assert!((tangent.clone() - nalgebra::DMatrix::identity(6, 6)).amax() <= ROUND_OFF);
    assert!(poisson_defect(&SPACE, |_| nan, &mu).is_nan());
    Ok(())
}

#[test]
fn symmetric_methods_are_reversible() -> Outcome {
    for (top, start) in experiments()? {
        let (lifted, free) = (
            |s| Collective::new(s, SpinorRealisation, top),
            |s| LiftFree::new(s, DualQuaternions, top),
        );
        for stages in [1, 2] {
            let gauss = RungeKutta::gauss(stages)?;
            assert!(gauss.is_symmetric());
            let (lifted, free) = (lifted(gauss.clone()), free(gauss));
            let state = lifted.start(&start)?;
            assert!(reversibility_defect(&lifted, &state, 0.1)? <= ROUND_OFF);
            assert!(reversibility_defect(&free, &start, 0.1)? <= ROUND_OFF);
        }
        let rk4 = free(RungeKutta::rk4());
        assert!(reversibility_defect(&rk4, &start, 0.1)? > 1e-7);
        let mut points = vec![];
        for h in STEPS {
            points.push((
                h,
                reversibility_defect(&free(RungeKutta::explicit_midpoint()), &start, h)?,
            ));
        }
        let slope = fitted_order(&points, ROUND_OFF)?;
        // The leading errors h³ of the two steps cancel.
        assert!((slope - 4.0).abs() < 0.1, "{slope}");
    }
    Ok(())
}

/// The midpoint rule, followed by a stretch of the first coordinate, which commutes with no symmetry of the fibres.
#[derive(Clone)]
struct Stretched(RungeKutta);

impl Scheme for Stretched {
    type Workspace<V: State> = StageWorkspace<V>;

    fn workspace<V: State>(&self) -> StageWorkspace<V> {
        self.0.workspace()
    }

    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut StageWorkspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        let mut next = self.0.increment(field, z, step, workspace)?;
        let (first, change) = (z.coordinate(0), next.point.coordinate(0));
        next.point.set_coordinate(0, change + (first + change) * step);
        Ok(next)
    }

    fn forget<V: State>(&self, workspace: &mut StageWorkspace<V>) {
        self.0.forget(workspace);
    }

    fn order(&self) -> usize {
        0
    }

    fn is_symplectic(&self) -> bool {
        false
    }

    fn is_symmetric(&self) -> bool {
        false
    }
}

#[test]
fn runge_kutta_methods_descend() -> Outcome {
    for (top, start) in experiments()? {
        let z = SpinorRealisation.lift(&start)?;
        let system = CollectiveHamiltonian::new(SpinorRealisation, top);
        for scheme in [RungeKutta::implicit_midpoint(), RungeKutta::gauss(2)?, RungeKutta::rk4()] {
            for s in [-0.4, 0.9] {
                let defects = fibre_defects(&scheme, &system, &z, s, 0.1)?;
                assert!(defects.equivariance <= ROUND_OFF, "{defects:?}");
                assert!(defects.descent <= ROUND_OFF, "{defects:?}");
            }
        }
        let broken = Stretched(RungeKutta::implicit_midpoint());
        let defects = fibre_defects(&broken, &system, &z, 0.9, 0.1)?;
        assert!(defects.equivariance > 1e-3 && defects.descent > 1e-3, "{defects:?}");
    }
    Ok(())
}

/// A step without a result is an error, not a defect.
#[test]
fn a_step_without_a_result_is_an_error() -> Outcome {
    let gauss = Collective::new(RungeKutta::gauss(2)?, SpinorRealisation, tops::paper()?);
    let flat = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::zeros());
    let lift = |e| matches!(e, StepMapError::Lift(LiftError { .. }));
    assert!(step_poisson_defect(&SPACE, &gauss, &flat, 0.02).is_err_and(lift));
    assert!(step_map(&gauss, &flat, 0.02).is_err_and(lift));
    let far = step_poisson_defect(&SPACE, &gauss, &tops::paper_start(), 1e30);
    assert!(matches!(far, Err(StepMapError::Step(_))));
    let state = gauss.start(&tops::paper_start())?;
    assert!(reversibility_defect(&gauss, &state, f64::NAN).is_err());
    Ok(())
}

/// The energy oscillates with a Poisson integrator, and goes down with an explicit one.
#[test]
fn energy_drift() -> Outcome {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let drift = |scheme| -> Result<Drift, Box<dyn Error>> {
        let integrator = LiftFree::new(scheme, DualQuaternions, top);
        let run = integrator.trajectory(&start, 0.02)?.take(20_000);
        Ok(Drift::along(run, |mu| top.value(mu))?)
    };
    let (midpoint, explicit) =
        (drift(RungeKutta::implicit_midpoint())?, drift(RungeKutta::explicit_midpoint())?);
    // The oscillation divided by the length of the run, 400 time units, is 2e-6, and bounds the slope.
    assert!(midpoint.largest < 1e-3 && midpoint.slope.abs() < 1e-7, "{midpoint:?}");
    assert!(explicit.slope.abs() > 1e-4, "{explicit:?}");
    Ok(())
}

/// Casimirs of lift-free Gauss runs walk at random; those of a direct RK4 run go down steadily.
#[test]
#[ignore = "long"]
fn growth_of_the_deviation_of_a_casimir() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    let casimir = Invariant::VerticalSquared;
    let walk = LiftFree::new(RungeKutta::gauss(3)?, DualQuaternions, top);
    let field = HamiltonianField { space: SPACE, hamiltonian: top };
    let loss = Direct::new(RungeKutta::rk4(), field);
    let (mut random, mut steady) = (EnsembleGrowth::default(), EnsembleGrowth::default());
    for k in 0..32 {
        let mu = start.scaled(1.0 + 1e-3 * f64::from(k));
        // The rows are at 0 and at 16, 32, …, 4096 steps.
        let chosen = |step: u64| step == 0 || (step >= 16 && step.is_power_of_two());
        let values = |s: &Sample<Se3Dual, Se3Dual>| (s.time, casimir.value(&top, &s.momentum));
        let run = walk.trajectory(&mu, 0.05)?.take(4097).collect::<Result<Vec<_>, _>>()?;
        random.add(run.iter().filter(|s| chosen(s.step)).map(values))?;
        let run = loss.trajectory(&mu, 0.05)?.take(4097).collect::<Result<Vec<_>, _>>()?;
        steady.add(run.iter().filter(|s| chosen(s.step)).map(values))?;
    }
    assert_eq!(random.runs(), 32);
    let (random, steady) = (random.exponent(3e-16)?, steady.exponent(1e-13)?);
    assert!((random - 0.5).abs() < 0.15, "{random}");
    assert!((steady - 1.0).abs() < 0.15, "{steady}");
    Ok(())
}
