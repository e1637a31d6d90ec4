//! Runs that the tests share.

use collective_integrators::NoiseRule;
use heavytop::HeavyTop;
use heavytop::methods::Method;
use lie_poisson::InnerProduct;
use lie_poisson_formula_systems::{
    Damping, FormulaSystem, NoiseFields, NoiseTerms, OpenSystem, OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::Parameters;
use lie_poisson_runs::{Experiment, Pace, RunFailure, Saved, Schedule, TopInAxes};
use nalgebra::Vector3;

pub const INERTIA: [f64; 3] = [2.0, 3.0, 4.0];
pub const START: [f64; 6] = [1.0, -0.4, 0.7, 0.6, 0.0, 0.8];

/// Returns the steps of a run to `end`, of which every n-th is written.
pub fn pace(step: f64, end: f64, every: u64) -> Pace {
    Pace { schedule: Schedule::new(step, end).unwrap(), every }
}

/// Returns a top without symmetry, whose weight is (0.5, 0, 0.5) in the units of Γ.
pub fn top() -> HeavyTop {
    HeavyTop::new(&heavytop::Body {
        inertia: Vector3::from(INERTIA),
        mass: 1.0,
        gravity: 0.5_f64.sqrt(),
        length: 1.0,
        center_of_mass: Vector3::new(1.0, 0.0, 1.0).normalize(),
    })
    .unwrap()
}

/// Returns a run of the top.
pub fn experiment(formulation: &str, scheme: &str, pace: Pace) -> Experiment<TopInAxes> {
    Experiment {
        model: top().into(),
        start: START.to_vec(),
        method: Method::new(formulation.parse().unwrap(), scheme.parse().unwrap(), 0.0).unwrap(),
        pace,
        attitude: false,
    }
}

/// Returns a run of a system whose Hamiltonian is a formula.
pub fn of_formula(
    (algebra, hamiltonian): (&str, &str),
    start: &[f64],
    (formulation, scheme): (&str, &str),
    pace: Pace,
) -> Experiment<FormulaSystem> {
    let algebra = SystemAlgebra::named(algebra).unwrap();
    let (formulation, scheme) = (formulation.parse().unwrap(), scheme.parse().unwrap());
    let method = algebra.method(formulation, scheme, 0.0).unwrap();
    let model = FormulaSystem::new(algebra, hamiltonian, &Parameters::new()).unwrap();
    Experiment { model, start: start.to_vec(), method, pace, attitude: false }
}

/// Returns the run of a spin at the temperature 0.5, with friction 1, from (1, 0, 0).
pub fn noisy(algebra: &str, hamiltonian: &str, pace: Pace) -> Experiment<OpenSystem> {
    let algebra = SystemAlgebra::named(algebra).unwrap();
    let base = FormulaSystem::new(algebra, hamiltonian, &Parameters::new()).unwrap();
    let damping =
        Some(Damping::DoubleBracket { friction: 1.0, inner_product: InnerProduct::euclidean() });
    let fields = NoiseFields::thermal(damping.as_ref(), 0.5).unwrap();
    let (rule, interval, bound) = (NoiseRule::Together, None, None);
    let noise = Some(NoiseTerms { fields, seed: 1, path: 0, rule, interval, bound });
    let terms = OpenTerms { damping, noise, ..OpenTerms::default() };
    let model =
        OpenSystem::new(base.with_found_casimirs().unwrap(), terms, pace.schedule.step).unwrap();
    let scheme = "implicit-midpoint".parse().unwrap();
    let method = model.method("collective".parse().unwrap(), scheme, 0.0).unwrap();
    Experiment { model, start: vec![1.0, 0.0, 0.0], method, pace, attitude: false }
}

/// Returns the rows that are written from a saved moment on.
pub fn rows(run: &Experiment, from: Option<&Saved>) -> Vec<Vec<f64>> {
    let mut rows = Vec::new();
    run.follow(from, |moment| -> Result<(), RunFailure> {
        assert_eq!(moment.row.is_empty(), !run.pace.keeps(moment.step));
        if run.pace.keeps(moment.step) {
            rows.push(moment.row.to_vec());
        }
        Ok(())
    })
    .unwrap();
    rows
}

pub fn last(run: &Experiment) -> Vec<f64> {
    rows(run, None).pop().unwrap()
}
