//! Motions backward in time, by negative steps: every method by its name, the events along it, and many tops at once.

use collective_integrators::{
    AnyIntegrator, AnyState, BatchIntegrator, DenseOutput, Direction, Ensemble, EventSearch, Start,
};
use heavytop::methods::{Formulation, Method, SchemeName};
use heavytop::{
    Coordinate, EnergyLevel, GaussBatch, HeavyTop, Invariant, MidpointBatch, Section, Surface,
    TopMidpoint,
};
use lie_poisson::{Se3Dual, Vector};
use nalgebra::Vector3;

fn top() -> HeavyTop {
    HeavyTop::kovalevskaya(1.0, 1.0).unwrap()
}

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8))
}

/// Returns the momentum with the coordinates of a sample.
fn momentum(mu: &AnyState) -> Se3Dual {
    Vector::from_coordinates(|i| mu.as_slice()[i])
}

/// Returns the distance from the start after going forward by some steps, and backward by as many.
fn defect(formulation: Formulation, scheme: SchemeName, step: f64) -> f64 {
    let steps = (2.0 / step).round() as u64;
    let integrator = Method::new(formulation, scheme, 0.0).unwrap().integrator(&top()).unwrap();
    let there = integrator.after(&AnyState::of(&start()), step, steps).unwrap();
    assert_eq!(there.time, steps as f64 * step);
    let back = integrator.after(&there.momentum, -step, steps).unwrap();
    assert_eq!(back.time, -there.time);
    (momentum(&back.momentum) - start()).max_abs()
}

/// A symmetric method is its own inverse with the negative step, Φ₋ₕ ∘ Φₕ = 1. For others the errors of odd order cancel:
/// those of the two orders here, 2 and 4, return to O(h³) and O(h⁵).
#[test]
fn every_symmetric_method_returns_and_others_do_by_their_order() {
    let (mut symmetric, mut others) = (0, 0);
    for &(_, formulation) in Formulation::NAMES {
        for scheme in formulation.schemes() {
            let name = scheme.name();
            let defect = |step| defect(formulation, scheme, step);
            match scheme {
                // Not a map of se(3)∗: the way back begins at another point of the fibre.
                SchemeName::Partitioned(_) => assert!(defect(0.1) > 1e-10, "{formulation} {name}"),
                SchemeName::ExplicitMidpoint | SchemeName::Rk4 => {
                    others += 1;
                    let ratio = defect(0.02) / defect(0.01);
                    let expected = 2_f64.powi(scheme.order() as i32 + 1);
                    assert!(ratio > 0.8 * expected && ratio < 1.25 * expected, "{name}: {ratio}");
                    assert!(defect(0.02) > 1e-9, "{formulation} {name}");
                }
                _ => {
                    symmetric += 1;
                    // Rounding errors of 80 steps, which a motion of ten radians magnifies.
                    let defect = defect(0.05);
                    assert!(defect < 1e-12, "{formulation} {name}: {defect:e}");
                }
            }
        }
    }
    assert!(symmetric > 30 && others == 4, "{symmetric} {others}");
}

/// Many tops at once return, too, and make the steps of one alone.
#[test]
fn many_tops_return() {
    fn returns<B: BatchIntegrator>(batch: B, member: B::Member, mu: impl Fn(&B::Member) -> Se3Dual)
    where
        B::Member: Copy,
    {
        let ensemble = Ensemble::new(batch);
        let mut members = [member; 19];
        assert!(ensemble.advance(&mut members, 0.05, 0..40).is_empty());
        // Control: they have gone somewhere.
        assert!(members.iter().all(|member| (mu(member) - start()).max_abs() > 0.1));
        assert!(ensemble.advance(&mut members, -0.05, 0..40).is_empty());
        assert!(members.iter().all(|member| (mu(member) - start()).max_abs() < 1e-12));
    }
    returns(TopMidpoint::new(top()), start(), |mu| *mu);
    returns(MidpointBatch::new(), (top(), start()), |(_, mu)| *mu);
    returns(GaussBatch::<2>::new().unwrap(), (top(), start()), |(_, mu)| *mu);
    returns(GaussBatch::<4>::new().unwrap(), (top(), start()), |(_, mu)| *mu);
}

/// Finds the zeros of Π₁ from a state to ±10 s, and the states at them by dense output.
fn zeros(integrator: &AnyIntegrator, from: &AnyState, step: f64, direction: Direction) -> Vec<f64> {
    let run = || integrator.trajectory(from, step).unwrap();
    let first = |mu: &AnyState| mu.as_slice()[0];
    let mut search = EventSearch::new(integrator, first, direction);
    let mut times = Vec::new();
    for sample in run().take(201) {
        let found = search.observe(&sample.unwrap()).unwrap();
        times.extend(found.into_iter().flatten().map(|zero| zero.time));
    }
    let mut dense = DenseOutput::new(integrator, run());
    for time in &times {
        assert!(first(&dense.at(*time).unwrap().momentum).abs() < 1e-10);
    }
    times
}

/// The zeros on the way back are those of the way there, in the reverse order. A direction is that along the run.
#[test]
fn events_on_the_way_back_are_those_of_the_way_there() {
    let method = Method::new(Formulation::Reduced, SchemeName::Gauss(6), 0.0).unwrap();
    let (integrator, start) = (method.integrator(&top()).unwrap(), AnyState::of(&start()));
    let end = integrator.after(&start, 0.05, 200).unwrap().momentum;
    let zeros = |from, step, direction| zeros(&integrator, from, step, direction);
    for (there, back) in [
        (Direction::Both, Direction::Both),
        (Direction::Up, Direction::Down),
        (Direction::Down, Direction::Up),
    ] {
        let there = zeros(&start, 0.05, there);
        let mut again: Vec<f64> = zeros(&end, -0.05, back).iter().map(|time| 10.0 + time).collect();
        again.reverse();
        assert!(there.len() > 2 && there.len() == again.len(), "{there:?} {again:?}");
        assert!(there.iter().zip(&again).all(|(a, b)| (a - b).abs() < 1e-9), "{there:?} {again:?}");
    }
    // Control: the same direction along the run finds other zeros.
    let up = zeros(&start, 0.05, Direction::Up);
    let other = zeros(&end, -0.05, Direction::Up);
    assert!(other.iter().all(|time| up.iter().all(|zero| (zero - time - 10.0).abs() > 1e-3)));
}

/// A section is a set of states: the antecedents of a point lie on it, and the first of them returns to the point.
#[test]
fn a_section_is_the_same_backward() {
    let level = EnergyLevel { top: top(), energy: 2.0, vertical_momentum: 0.3 };
    let surface =
        Surface { variable: Coordinate::Gamma3.into(), level: 0.0, direction: Direction::Up };
    let section = Section::new(level, surface).unwrap();
    let method = Method::new(Formulation::Reduced, SchemeName::Gauss(6), 0.0).unwrap();
    let integrator = method.integrator(&top()).unwrap();
    let returns = |from: Se3Dual, step| -> Vec<Se3Dual> {
        let returns = section.crossings(&integrator, &AnyState::of(&from), step, 4000).unwrap();
        returns.take(3).map(|sample| momentum(&sample.unwrap().momentum)).collect()
    };
    for start in section.starts(5, 0).unwrap() {
        let antecedents = returns(start, -0.05);
        assert_eq!(antecedents.len(), 3);
        for antecedent in &antecedents {
            assert!((Invariant::Energy.value(&top(), antecedent) - 2.0).abs() < 1e-10);
            // It crosses the surface in the direction of the section, as one of its states does.
            let mut states = section.states(&section.plane(antecedent));
            assert!(states.any(|state| (state - *antecedent).max_abs() < 1e-7));
        }
        let again = returns(antecedents[0], 0.05)[0];
        assert!((again - start).max_abs() < 1e-7, "{again:?} {start:?}");
    }
}
