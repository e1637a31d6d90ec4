//! Starts that are not finite numbers: every formulation refuses them, with the same error.

use collective_integrators::{
    AlternatingSubsteps, BatchIntegrator, Collective, Composition, Direct, Ensemble,
    HamiltonianField, Integrator, Laned, LiftFree, RunError, RungeKutta, Splitting, Start,
    StepError, Substeps, TangentIntegrator, VariationalFlow,
};
use heavytop::{
    CollectiveGauss, GaussBatch, HeavyTop, MidpointBatch, ReducedMidpoint, RotorSplitting,
    SpinorRealisation, SymmetricTopBatch, SymmetricTopSplitting, TopMidpoint, WithAttitude,
};
use lie_poisson::{LiePoisson, Se3, Se3Dual, State, Vector};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8))
}

/// Returns the start with a coordinate that is no finite number, in every place.
fn bad_starts() -> impl Iterator<Item = (usize, Se3Dual)> {
    let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    bad.into_iter().flat_map(|x| {
        (0..6).map(move |coordinate| {
            let at = |i| if i == coordinate { x } else { start().coordinate(i) };
            (coordinate, Se3Dual::from_coordinates(at))
        })
    })
}

fn names(error: StepError, at: usize) -> bool {
    matches!(error, StepError::NotFiniteStart { coordinate, size }
        if coordinate == at && !size.is_finite())
}

fn refused_as(error: RunError, at: usize) -> bool {
    matches!(error, RunError::Integration(e) if e.step == 1 && names(e.source, at))
}

fn refuses<I: Start<State: Vector, Momentum = Se3Dual>>(name: &str, integrator: &I) {
    for (coordinate, mu) in bad_starts() {
        let refused =
            [integrator.trajectory(&mu, 0.02).err(), integrator.after(&mu, 0.02, 3).err()];
        for refused in refused {
            assert!(refused.is_some_and(|e| refused_as(e, coordinate)), "{name}: {refused:?}");
        }
    }
    // Bad numbers are also refused as a state, where the state is made otherwise.
    for x in [f64::NAN, f64::INFINITY] {
        let state = integrator.start(&start()).unwrap();
        let bad = I::State::from_coordinates(|i| if i == 1 { x } else { state.coordinate(i) });
        let item = integrator.trajectory_from(bad, 0.02).next().unwrap();
        assert!(item.is_err_and(|e| e.step == 1 && names(e.source, 1)), "{name}");
        let resumed = integrator.trajectory_resumed(bad, 1024, 0.02).nth(9).unwrap();
        assert!(resumed.is_err_and(|e| e.step == 1025 && names(e.source, 1)), "{name}");
    }
    // Control: the start itself is accepted.
    let first = integrator.trajectory(&start(), 0.02).unwrap().next().unwrap();
    assert!(first.is_ok_and(|sample| (sample.momentum - start()).max_abs() < 1e-14), "{name}");
}

#[test]
fn every_formulation_refuses_starts_that_are_not_finite() {
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let gauss = || RungeKutta::gauss(2).unwrap();
    let field = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
    let symmetric = SymmetricTopSplitting::new(top).unwrap();
    refuses("collective", &Collective::new(gauss(), SpinorRealisation, top));
    refuses("compensated", &Collective::new(gauss(), SpinorRealisation, top).compensated());
    refuses("lift-free", &LiftFree::new(gauss(), DualQuaternions, top));
    refuses("direct", &Direct::new(RungeKutta::rk4(), field));
    refuses("reduced midpoint", &ReducedMidpoint::new(top));
    refuses("midpoint of tops", &TopMidpoint::new(top));
    refuses("collective Gauss", &CollectiveGauss::new(3, top).unwrap());
    refuses("rotors", &Splitting::strang(RotorSplitting(top)));
    refuses("symmetric", &Splitting::strang(symmetric));
    refuses("alternating", &Splitting::alternating(symmetric, AlternatingSubsteps::blanes_moan4()));
    refuses("composed", &Composition::new(TopMidpoint::new(top), Substeps::yoshida4()));
    refuses("attitude", &WithAttitude(LiftFree::new(gauss(), DualQuaternions, top)));
}

fn batch_refuses<B: BatchIntegrator>(name: &str, batch: B, member: impl Fn(Se3Dual) -> B::Member) {
    for (coordinate, mu) in bad_starts() {
        for position in [0, 5, 17] {
            let mut members = vec![member(start()); 18];
            members[position] = member(mu);
            let mut failures = Vec::new();
            batch.advance(&mut members, 0.02, 1024..1030, &mut batch.workspace(), &mut |i, e| {
                failures.push((i, e));
            });
            assert_eq!(failures.len(), 1, "{name}: {failures:?}");
            let (index, error) = failures[0];
            assert_eq!((index, error.step), (position, 1025), "{name}");
            assert!(names(error.source, coordinate), "{name}: {error:?}");
        }
    }
}

#[test]
fn every_ensemble_refuses_members_that_are_not_finite() {
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let splitting = SymmetricTopSplitting::new(top).unwrap();
    let lift_free = LiftFree::new(RungeKutta::gauss(2).unwrap(), DualQuaternions, top);
    batch_refuses("lanes", Laned::new(lift_free), |mu| mu);
    batch_refuses("lanes of the midpoint", Laned::new(ReducedMidpoint::new(top)), |mu| mu);
    batch_refuses("midpoint", TopMidpoint::new(top), |mu| mu);
    batch_refuses("sweep", MidpointBatch::new(), |mu| (top, mu));
    batch_refuses("Gauss", GaussBatch::<3>::new().unwrap(), |mu| (top, mu));
    let symmetric = SymmetricTopBatch::new(AlternatingSubsteps::blanes_moan4());
    batch_refuses("symmetric", symmetric, |mu| (splitting, mu));

    let mut members = [start(), bad_starts().next().unwrap().1];
    let failures = Ensemble::new(TopMidpoint::new(top)).advance(&mut members, 0.02, 0..3);
    assert!(failures.len() == 1 && names(failures[0].source.source, 0));
}

#[test]
fn tangent_vectors_are_not_carried_from_a_start_that_is_not_finite() {
    fn refuses<I>(integrator: &I)
    where
        I: TangentIntegrator + Integrator<State = Se3Dual>,
    {
        for (coordinate, mu) in bad_starts() {
            let mut flow = VariationalFlow::new(integrator, mu, [Se3Dual::basis(0)], 0.02);
            let text = flow.advance().unwrap_err().to_string();
            assert!(text.contains("step 1") && flow.steps() == 0, "{coordinate}: {text}");
        }
    }
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    refuses(&ReducedMidpoint::new(top));
    refuses(&LiftFree::new(RungeKutta::rk4(), DualQuaternions, top));
}
