//! Every error of a run is what some call returns, and names the values.

use crate::support::{experiment, noisy, of_formula, pace};
use collective_integrators::{AnyState, Direction};
use core::ops::ControlFlow;
use heavytop::methods::{Formulation, MethodError, SchemeName};
use heavytop::{Body, HeavyTop};
use lie_poisson::{Se3, Se3Dual};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::{Coordinates, Formula, Parameters, Vocabulary};
use lie_poisson_runs::contests::{Contest, TimedProblem};
use lie_poisson_runs::{
    Arguments, ArrayKind, EventFunctions, Experiment, LatticeTerms, Model, OpenArrays,
    PathEnsemble, RunFailure, Saved, Schedule, SpinDamping, TangentGrowth, TopInAxes, step_angle,
};
use nalgebra::Vector3;
use std::collections::BTreeSet;

fn followed(run: &Experiment, from: Option<&Saved>) -> RunFailure {
    run.follow(from, |_| Ok::<_, RunFailure>(())).unwrap_err()
}

fn timed(start: Se3Dual) -> RunFailure {
    let states = vec![start];
    let (early, late) = (states.clone(), states.clone());
    let problem = TimedProblem {
        top: experiment("collective", "gauss-4", pace(0.1, 1.0, 1)).model.top,
        end: 20.0,
        tops: 1,
        starts: states,
        early,
        late,
    };
    let (mut others, mut done) = (BTreeSet::new(), |_| ());
    let only = Some("Gauss-12");
    Contest { problem: &problem, only, others: &mut others, done: &mut done }.run().unwrap_err()
}

/// Returns the variants in the source.
fn declared() -> BTreeSet<String> {
    let lines = include_str!("../../src/error.rs").lines();
    let variants = lines.filter_map(|line| line.strip_prefix("    "));
    let variants = variants.filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase()));
    let name = |line: &str| line.split(|c: char| !c.is_alphanumeric()).next().map(str::to_owned);
    variants.filter_map(name).collect()
}

/// Follows a tangent vector of z from the origin, where all of them have the image 0.
fn lost() -> RunFailure {
    let algebra = SystemAlgebra::of_brackets(
        Coordinates::scalars(["x", "y", "z"]).unwrap(),
        [("x, y", "z"), ("x, z", "y")],
        &Parameters::new(),
    );
    let system = FormulaSystem::new(algebra.unwrap(), "x + y^2", &Parameters::new()).unwrap();
    let names = (Formulation::Collective, SchemeName::Gauss(4));
    let method = system.algebra().method(names.0, names.1, 0.0).unwrap();
    let origin = [0.0; 3];
    let integrator = system.tangent_integrator(&method, &origin).unwrap();
    let (origin, schedule) = (AnyState::from_slice(&origin), Schedule::new(1.0, 3.0).unwrap());
    TangentGrowth::follow(&integrator, &origin, schedule, (1, &method), &mut |_, _| ()).unwrap_err()
}

/// Returns why so many paths of a noise, which moves a formula out of its domain, have no statistics.
fn paths(paths: u64, rows: u64) -> RunFailure {
    let run = noisy("so(3)", "ln(Pi3 + 0.9)", pace(1.0 / rows as f64, 100.0, 1));
    PathEnsemble { paths, quantiles: vec![0.5] }.follow(&run, |_| true).unwrap_err()
}

/// Searches the zeros of a function that has no value later.
fn no_event() -> RunFailure {
    let names = Vocabulary::of(&Se3::default(), &Parameters::new()).unwrap();
    let functions = vec![Formula::new("ln(Gamma1*Gamma1 - 0.3)", &names).unwrap()];
    let events = EventFunctions { functions, direction: Direction::Both };
    let run = experiment("collective", "gauss-4", pace(0.1, 10.0, 1));
    let going = |_, _: &[f64]| Ok::<_, RunFailure>(ControlFlow::Continue(()));
    events.follow(&run, |_| Ok(()), going).unwrap_err()
}

/// Returns a thin rod, which has no angular momentum about itself.
fn rod() -> TopInAxes {
    let inertia = Vector3::new(0.12, 0.12, 0.0);
    let body =
        Body { inertia, mass: 1.0, gravity: 9.81, length: 0.3, center_of_mass: Vector3::z() };
    HeavyTop::new(&body).unwrap().into()
}

/// Tangent vectors of a fluid, whose products of matrices are of numbers alone.
fn fluid_without_tangents() -> RunFailure {
    let kind = ArrayKind::named("sphere-fluid").unwrap();
    let fluid = kind.system(&Arguments::new().number("size", 4.0)).unwrap();
    let method = fluid.method(None, SchemeName::Gauss(2), 0.0).unwrap();
    fluid.tangent_integrator(&method, &[0.0; 16]).unwrap_err()
}

/// Tangent vectors of a lattice with friction.
fn damped_without_tangents() -> RunFailure {
    let kind = ArrayKind::named("spin-lattice").unwrap();
    let given = Arguments::new().list("shape", vec![2.0]).number("exchange", 1.0);
    let terms =
        LatticeTerms { damping: Some(SpinDamping::Gilbert(0.1)), ..LatticeTerms::default() };
    let lattice = OpenArrays::new(kind.system(&given).unwrap(), terms, 0.1).unwrap();
    let method = lattice.method(None, None, 0.0).unwrap();
    lattice.tangent_integrator(&method, &[0.0; 6]).unwrap_err()
}

#[test]
fn every_error_names_what_is_wrong() {
    let run = experiment("collective", "gauss-4", pace(0.1, 1.0, 1));
    let mut no_start = run.clone();
    no_start.start = vec![0.0; 6];
    let mut no_attitude = experiment("direct", "rk4", pace(0.1, 1.0, 1));
    no_attitude.attitude = true;
    let failing = experiment("collective", "lobatto-iiia-iiib-4", pace(2.0, 4.0, 1));
    let algebra = ("so(3)", "Pi1 + 1e-9*ln(Pi2)");
    let no_value = of_formula(algebra, &[0.0, 1.0, 0.0], ("direct", "rk4"), pace(0.1, 5.0, 1));
    let mut no_body = no_value.clone();
    no_body.attitude = true;
    let mut short = run.clone();
    short.start.pop();
    assert!(run.model.start(&[1.0; 7]).is_err());
    let mut of_another = no_value.clone();
    of_another.start.pop();
    let fast = Se3Dual::new(Vector3::new(0.0, 0.0, 1e200), Vector3::z());
    let schedule = |step, end| Schedule::new(step, end).unwrap_err();
    let early = TimedProblem::with_references(run.model.top, 10.0, vec![fast]).unwrap_err();
    let errors = [
        (followed(&no_start, None), "no lift"),
        (RunFailure::from(MethodError::Tolerance { value: -1.0 }), "-1"),
        (followed(&of_another, None), "2"),
        (rod().start(&[0.1, 0.0, 0.3, 0.0, 0.0, 1.0]).unwrap_err(), "0.3"),
        (followed(&no_attitude, None), "direct has no attitude"),
        (followed(&no_body, None), "so(3) has no attitude"),
        (fluid_without_tangents(), "sphere-fluid"),
        (damped_without_tangents(), "spin-lattice with friction or noise has no tangent vectors"),
        (followed(&short, None), "5"),
        (followed(&run, Some(&Saved { step: 1024, state: vec![0.0] })), "has 1 numbers"),
        (schedule(0.0, 1.0), "step must be finite and different from 0, got 0"),
        (schedule(-0.1, 1.0), "-0.1 s do not reach end = 1"),
        (step_angle::require_turn(1.0, 1e3).unwrap_err(), "1.000e3 rad; it must be at most 100"),
        (schedule(1e-300, 1.0), "more than 1e12"),
        (schedule(0.03, 1.0), "the nearest ends are 0.99 and 1.02"),
        (followed(&failing, None), "collective, lobatto-iiia-iiib-4"),
        (followed(&no_value, None), "at t = "),
        (no_event(), "ln(Gamma1*Gamma1 - 0.3) has no value at t = "),
        (lost(), "tangent vector"),
        (
            run.balances(&|| true).unwrap_err(),
            "a drive, damping, a torque or the time in its energy",
        ),
        (paths(1, 1), "2 paths or more, got 1"),
        (paths(2, 1_000_000), "2000000 are the most"),
        (paths(2, 1), "path 0"),
        (early, "more than 10, got 10"),
        (timed(fast), "Gauss-12"),
    ];
    let variant = |error: &RunFailure| {
        let text = format!("{error:?}");
        text.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default().to_owned()
    };
    let found: BTreeSet<String> = errors.iter().map(|(error, _)| variant(error)).collect();
    assert_eq!(found, declared());
    for (error, part) in errors {
        assert!(error.to_string().contains(part), "{error}: {part}");
    }
}
