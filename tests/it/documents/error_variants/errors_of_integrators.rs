//! Errors of steps, schemes, runs and their measurements.

use super::refused;
use collective_integrators::diagnostics::{Drift, EnsembleGrowth, fitted_order, step_map};
use collective_integrators::{
    BrownianPaths, Collective, ConstantTorque, DenseOutput, Direct, Direction, Events, FirstHalf,
    Integrator, LyapunovExponents, PartitionedRungeKutta, RungeKutta, StageSolver, Start,
    StepError, StepParts, Substeps, Tableau, TorqueFlow, Torqued, VectorField, ViscousMatrix,
    ViscousTorque,
};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::{DefaultLanes, Lanes, Real, Se3Dual};
use momentum_map::PARTICLE;

use nalgebra::{Matrix2, Vector1, Vector3};
use workspace_tests::tops;

/// The field ẋ = x², whose solution from 1 is infinite at t = 1.
#[derive(Clone, Copy)]
struct Square;

impl<T: Real> VectorField<T> for Square {
    type Point = Vector1<T>;

    fn at(&self, x: &Vector1<T>) -> Vector1<T> {
        Vector1::new(x.x * x.x)
    }
}

/// The field ẋ = 100 x²/(100 + x²), which is near x² for small x. For a midpoint step of 1 from 1 only the solution near
/// 100 is left of those of the stage equation.
#[derive(Clone, Copy)]
struct Saturating;

impl<T: Real> VectorField<T> for Saturating {
    type Point = Vector1<T>;

    fn at(&self, x: &Vector1<T>) -> Vector1<T> {
        let square = x.x * x.x;
        Vector1::new(square * 100.0 / (square + 100.0))
    }
}

/// The torque F = Γ, which takes Π out of the plane across Γ.
struct AlongGamma;

impl TorqueFlow<Se3Dual> for AlongGamma {
    fn flow(&self, mu: &mut Se3Dual, step: f64) -> Result<(), StepError> {
        mu.0.0 += mu.0.1 * step;
        Ok(())
    }
}

const RK4: fn() -> Direct<RungeKutta, Square> = || Direct::new(RungeKutta::rk4(), Square);

/// Returns the reason why the step of this number fails from x, in a run that continues after `made` steps.
fn failure(
    integrator: &impl Integrator<State = Vector1<f64>>,
    x: f64,
    (made, step): (u64, f64),
    number: usize,
) -> Result<(), StepError> {
    let sample = integrator.trajectory_resumed(Vector1::new(x), made, step).nth(number);
    sample.unwrap().map(|_| ()).map_err(|error| error.source)
}

/// Returns the errors of steps of a run, and of the construction of schemes.
pub fn steps_and_schemes() -> Vec<String> {
    let rk4 = RK4();
    let hasty = StageSolver { max_iterations: 1, newton: false, ..StageSolver::default() };
    let hasty = Direct::new(RungeKutta::implicit_midpoint().with_solver(hasty), Square);
    let midpoint = || Tableau::gauss(1).unwrap();
    let across = Se3Dual::new(Vector3::x(), Vector3::z());
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let particle = Collective::new(RungeKutta::implicit_midpoint(), PARTICLE, top);
    let torqued = Torqued::new(particle, AlongGamma);
    // Lanes at 0, 1/8, …, with a breakpoint at ½.
    let times = DefaultLanes::from_lanes(|lane| 0.125 * lane as f64);
    let next_break = |time: f64, _| (time < 0.5).then_some(0.5);
    let across_a_break = StepParts { interval: 1.0, noise: None }.make(
        (DefaultLanes::from_f64(0.0), times),
        1.0,
        next_break,
        |_, _| Ok(1),
    );
    let astray = Direct::new(RungeKutta::implicit_midpoint(), Saturating);
    assert!(failure(&astray, 1.0, (0, 0.4), 1).is_ok());
    vec![
        refused(failure(&astray, 1.0, (0, 1.0), 1)),
        refused(failure(&hasty, 1.0, (0, 0.1), 1)),
        refused(failure(&rk4, 1e200, (0, 1.0), 1)),
        refused(failure(&rk4, f64::NAN, (0, 0.1), 0)),
        refused(failure(&rk4, 1.0, (0, f64::INFINITY), 0)),
        refused(failure(&rk4, 0.0, (u64::MAX, 0.1), 1)),
        refused(torqued.step(&across, 0.1, &mut torqued.workspace())),
        refused(across_a_break),
        refused(ConstantTorque::new(Vector1::new(f64::NAN))),
        refused(ViscousTorque::new(Vector1::new(-1.0_f64))),
        refused(ViscousMatrix::new(&Matrix2::new(1.0, 0.0, 0.0, f64::NAN))),
        refused(ViscousMatrix::new(&Matrix2::new(1.0, 0.5, 0.0, 1.0))),
        refused(BrownianPaths::new(1, 0.0)),
        refused(BrownianPaths::new(1, 0.1).unwrap().with_bound(0.5)),
        refused(RungeKutta::gauss(0)),
        refused(Tableau::new(&[1.0], &[0.5, 0.5])),
        refused(Tableau::new(&[f64::NAN], &[1.0])),
        refused(Substeps::new(&[0.5, 0.25])),
        refused(PartitionedRungeKutta::<FirstHalf>::new(midpoint(), Tableau::gauss(2).unwrap())),
        refused(Substeps::triple_jump(3)),
        refused(Tableau::lobatto_iiia(5)),
    ]
}

/// Returns the errors of whole runs, of events and other times, and of what is measured along them.
pub fn runs_and_measurements() -> Vec<String> {
    let rk4 = RK4();
    let start = Vector1::new(1.0);
    let run = |step| rk4.trajectory_from(start, step);
    let mut dense = DenseOutput::new(&rk4, run(0.1).take(5));
    assert!(dense.at(0.25).is_ok());
    let events = |g: fn(&Vector1<f64>) -> f64, step| {
        Events::new(&rk4, run(step), g, Direction::Both).next().unwrap()
    };
    let exponents =
        |x: f64, step| LyapunovExponents::<_, 1>::new(&rk4, Vector1::new(x), step).next();
    let growing = |times: [f64; 2]| times.map(|time| (time, time));
    let mut ensemble = EnsembleGrowth::default();
    ensemble.add(growing([0.0, 1.0])).unwrap();
    // Γ = 0 is the momentum of no pair of spinors.
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let collective = Collective::new(RungeKutta::implicit_midpoint(), SpinorRealisation, top);
    let lifeless = Se3Dual::<f64>::new(Vector3::x(), Vector3::zeros());
    vec![
        refused(collective.after(&lifeless, 0.1, 1)),
        refused(collective.after(&tops::paper_start(), f64::NAN, 1)),
        refused(step_map(&collective, &lifeless, 0.1)),
        refused(step_map(&rk4, &Vector1::new(1e200), 1.0)),
        refused(DenseOutput::new(&rk4, run(f64::NAN)).at(0.1)),
        refused(dense.at(0.15)),
        refused(dense.at(7.0)),
        refused(events(|x| x.x - 2.0, f64::NAN)),
        refused(events(|_| f64::NAN, 0.1)),
        refused(exponents(f64::NAN, 0.1).unwrap()),
        refused(exponents(1.0, 0.0).unwrap()),
        refused(LyapunovExponents::<_, 2>::new(&rk4, start, 0.1).next().unwrap()),
        refused(Drift::along(run(f64::NAN).take(2), |x| x.x)),
        refused(Drift::of([(0.0, 1.0)])),
        refused(Drift::of([(0.0, 1.0), (1.0, f64::INFINITY)])),
        refused(ensemble.add(growing([0.0, 2.0]))),
        refused(ensemble.exponent(0.0)),
        refused(fitted_order(&[(0.1, 1.0)], 0.0)),
        refused(fitted_order(&[(0.1, f64::NAN)], 0.0)),
        refused(fitted_order(&[(0.1, 1.0); 3], 0.0)),
    ]
}
