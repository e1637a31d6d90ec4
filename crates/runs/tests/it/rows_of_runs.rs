//! The rows of a run are the samples of its integrator, whatever it follows.

use crate::support::{START, experiment, of_formula, pace, top};
use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyIntegrator, AnyState, AnyTangents, Start};
use core::ops::Range;
use heavytop::methods::Method;
use heavytop::{EulerAngles, PrincipalAxes};
use lie_poisson::{Quaternion, Se3Dual};
use lie_poisson_formula_systems::{FormulaSystem, SystemKind};
use lie_poisson_formulas::Parameters;
use lie_poisson_runs::{Conserved, Experiment, Model, RunFailure, TopInAxes};
use nalgebra::{Matrix3, Vector3};

/// Returns the rows that a run writes.
fn rows(run: &Experiment) -> Vec<Vec<f64>> {
    let (mut rows, pace) = (Vec::new(), run.pace);
    let visit = |moment: &lie_poisson_runs::Moment<'_>| -> Result<(), RunFailure> {
        if pace.keeps(moment.step) {
            rows.push(moment.row.to_vec());
        }
        Ok(())
    };
    run.follow(None, visit).unwrap();
    rows
}

/// The Hamiltonian of the top of the tests as a formula.
const HAMILTONIAN: &str = "(Pi1^2/2 + Pi2^2/3 + Pi3^2/4)/2 + (Gamma1 + Gamma3)/2";

/// One top as a top and as a system by formula has the same rows, to the round-off of the two forms of its equations.
#[test]
fn a_top_and_its_formula_have_the_same_rows() {
    for (formulation, scheme) in
        [("collective", "gauss-8"), ("reduced", "gauss-4"), ("direct", "rk4")]
    {
        let pace = pace(0.05, 10.0, 50);
        let as_top = rows(&experiment(formulation, scheme, pace));
        let formula = of_formula(("se(3)", HAMILTONIAN), &START, (formulation, scheme), pace);
        let as_system = rows(&formula);
        assert_eq!((as_top.len(), as_system.len()), (5, 5));
        for (one, other) in as_top.iter().zip(&as_system) {
            for (x, y) in one.iter().zip(other).take(8) {
                assert!((x - y).abs() < 1e-12, "{formulation} {one:?} {other:?}");
            }
        }
        // Control: the motion is far from its start.
        assert!((as_top[4][1] - START[0]).abs() > 0.01);
    }
}

/// A run from an attitude has it in its first row, in the axes of the users, and turns about the vertical as a whole; what is
/// drawn in the principal axes begins there, too.
#[test]
fn a_run_begins_with_the_attitude_that_is_given() {
    let inertia = Matrix3::new(2.0, 0.3, 0.1, 0.3, 1.5, -0.2, 0.1, -0.2, 1.2);
    let skew = PrincipalAxes::of(&inertia).unwrap();
    for axes in [PrincipalAxes::aligned(top().inertia()), skew] {
        let initial = EulerAngles { precession: 2.0, nutation: 0.9, spin: -1.3 }.attitude();
        let given =
            Se3Dual::new(Vector3::new(0.4, -0.8, 1.6), initial.conjugate().rotate(&Vector3::z()));
        let start = TopInAxes::coordinates(&axes.state_to_principal(&given)).to_vec();
        let model = |initial_attitude| TopInAxes { top: top(), axes, initial_attitude };
        let run = |attitude| Experiment {
            start: start.clone(),
            model: model(attitude),
            attitude: true,
            ..experiment("collective", "gauss-4", pace(0.1, 2.0, 10))
        };
        let attitudes = |run: &Experiment| -> Vec<Quaternion> {
            let of = |row: &Vec<f64>| {
                let [scalar, x, y, z] = *row.last_chunk::<4>().unwrap();
                Quaternion { scalar, vector: Vector3::new(x, y, z) }
            };
            rows(run).iter().map(of).collect()
        };
        let distance = |one: &Quaternion, other: &Quaternion| {
            let turn = |v: Vector3<f64>| (one.rotate(&v) - other.rotate(&v)).norm();
            turn(Vector3::x()) + turn(Vector3::y())
        };
        let (own, shortest) = (attitudes(&run(Some(initial))), attitudes(&run(None)));
        assert!(distance(&own[0], &initial) < 1e-14);
        let turn = own[0] * shortest[0].conjugate();
        for (own, shortest) in own.iter().zip(&shortest) {
            assert!(distance(own, &(turn * *shortest)) < 1e-13);
            assert!(distance(own, shortest) > 0.1);
        }
        let mut first = None;
        let visit = |_, _, _: &Se3Dual, attitude: Option<&Quaternion>| -> Result<(), RunFailure> {
            first = first.or(attitude.copied());
            Ok(())
        };
        run(Some(initial)).run(visit).unwrap();
        assert!(distance(&axes.attitude_from_principal(&first.unwrap()), &initial) < 1e-14);
    }
}

/// The columns are named, the conserved quantities have the initial values that are told, and the last row is that of the
/// integrator itself.
#[test]
fn rows_have_the_columns_that_are_named() {
    let run = experiment("collective", "gauss-4", pace(0.1, 3.0, 7));
    let columns: usize = run.coordinates().iter().map(|(_, columns)| columns.len()).sum();
    let rows = rows(&run);
    assert_eq!(rows[0].len(), 1 + columns + run.conserved().len());
    assert_eq!(rows[0][1 + columns..], run.initial().unwrap());
    // 0, 7, 14, 21, 28 and 30
    assert_eq!((rows.len() as u64, rows.len()), (run.pace.rows(), 6));
    let integrator = run.method.integrator(&top()).unwrap();
    let end = integrator.after(&AnyState::from_slice(&run.start), 0.1, 30).unwrap().momentum;
    assert_eq!(rows[5][1..7], *end.as_slice());
}

/// A run that continues from a saved moment has the same last row, to the last bit, as one that was not interrupted.
#[test]
fn a_run_goes_on_from_a_saved_moment() {
    let top = experiment("collective", "gauss-8", pace(0.05, 150.0, 1000));
    let body = of_formula(
        ("so(3)", "Pi1^2/4 + Pi2^2/6 + Pi3^2/8 + Pi1"),
        &[0.3, 1.0, -0.2],
        ("collective", "gauss-6"),
        pace(0.05, 150.0, 1000),
    );
    for run in [&*top as &Experiment, &*body] {
        let (mut saved, mut last) = (None, Vec::new());
        let visit = |moment: &lie_poisson_runs::Moment<'_>| -> Result<(), RunFailure> {
            if moment.step == 2048 {
                saved = Some(moment.saved());
            }
            last = moment.row.to_vec();
            Ok(())
        };
        run.follow(None, visit).unwrap();
        let (mut again, mut first) = (Vec::new(), None);
        let visit = |moment: &lie_poisson_runs::Moment<'_>| -> Result<(), RunFailure> {
            first.get_or_insert(moment.step);
            again = moment.row.to_vec();
            Ok(())
        };
        run.follow(saved.as_ref(), visit).unwrap();
        assert_eq!(again, last);
        // Control: the moments before are not made again.
        assert!(first > Some(2048), "{first:?}");
    }
}

/// A body with two rotors, two of whose Casimirs are coordinates.
#[derive(Debug)]
struct Rotors(FormulaSystem);

impl SystemScales for Rotors {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.0.blocks()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.0.differential(mu)
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        self.0.fastest_rate(mu)
    }
}

impl Model for Rotors {
    fn algebra_name(&self) -> String {
        self.0.algebra_name()
    }

    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        self.0.coordinates()
    }

    fn conserved(&self, start: &[f64]) -> Box<dyn Conserved + '_> {
        self.0.conserved(start)
    }

    fn tangent_integrator(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        Model::tangent_integrator(&self.0, method, start)
    }

    fn is_coordinate(&self, conserved: &str) -> bool {
        ["c1", "c2"].contains(&conserved)
    }
}

/// Conserved quantities that are coordinates have no columns of their own, however many there are.
#[test]
fn a_coordinate_is_one_column() {
    let parameters = Parameters::new().vector("I", &[1.0, 2.0, 3.0]).unwrap();
    let parameters = parameters.vector("J", &[0.1, 0.2]).unwrap();
    let body = SystemKind::named("body-with-rotors").unwrap().system(&parameters).unwrap();
    assert_eq!(body.casimirs()[0].to_string() + &body.casimirs()[1].to_string(), "l1l2");
    let method = body.algebra().method("direct".parse().unwrap(), "gauss-4".parse().unwrap(), 0.0);
    let (start, pace) = (vec![0.3, 1.0, 0.2, 0.2, 0.1], pace(0.1, 1.0, 1));
    let (model, method) = (Rotors(body), method.unwrap());
    let run = Experiment { model, start, method, pace, attitude: false };
    assert_eq!(run.conserved(), ["h", "c3"]);
    let (initial, rows) = (run.initial().unwrap(), rows(&run));
    assert!(rows.iter().all(|row| row.len() == 1 + 5 + 2), "{rows:?}");
    assert_eq!(rows[0][6..], initial);
    // c3 = |Π|²
    assert!((initial[1] - 1.13).abs() < 1e-15, "{initial:?}");
}
