//! Lattices of spins in a field that depends on the time: the driven spin of a formula, the balance of energy, and refusals.

use crate::arrays::array_systems::{lattice, system};
use crate::support::{last, pace, rows};
use collective_integrators::diagnostics::{SystemScales, fitted_order};
use lie_poisson::{InputTable, Interpolation};
use lie_poisson_formula_systems::{NamedInputs, OpenNames, OpenSystem, OpenTerms, SystemAlgebra};
use lie_poisson_formulas::Parameters;
use lie_poisson_runs::{
    Arguments, ArraySystem, Experiment, LatticeField, LatticeTerms, Model, OpenArrays, RunFailure,
    SpinDamping,
};

/// A field that turns once in 0.63, and a held table that jumps at 0.37 and 1.3.
const FIELD: [&str; 3] = ["1.5*cos(10*t)", "u*sin(10*t)", "0.5 + u/2"];

fn inputs() -> NamedInputs {
    let (times, values) = (vec![0.0, 0.37, 1.3, 4.0], vec![1.0, -2.0, 0.5, 0.0]);
    let table = InputTable::new(times, values, Interpolation::Constant).unwrap();
    NamedInputs::new(vec![("u".into(), table)])
}

fn driven(damping: Option<SpinDamping>) -> LatticeTerms {
    let field = Some(LatticeField::new(inputs(), &FIELD).unwrap());
    LatticeTerms { field, damping, noise: None }
}

/// Returns one spin without bonds, in a constant field along e₃.
fn one_spin() -> ArraySystem {
    let given = Arguments::new().list("shape", vec![1.0]).list("field", vec![0.0, 0.0, 0.7]);
    system("spin-lattice", &given)
}

fn run(
    lattice: ArraySystem,
    terms: LatticeTerms,
    spins: &[f64],
    (step, end, every): (f64, f64, u64),
) -> Experiment<OpenArrays> {
    let start = lattice.start_of(&Arguments::new().list("S", spins.to_vec())).unwrap();
    let model = OpenArrays::new(lattice, terms, step).unwrap();
    let method = model.method(None, None, 0.0).unwrap();
    Experiment { model, start, method, pace: pace(step, end, every), attitude: false }
}

/// Returns the spin of a formula with the same field and Gilbert's damping, which Gauss's method of order 12 follows.
fn exact(spin: [f64; 3], end: f64) -> Vec<f64> {
    let algebra = SystemAlgebra::named("so(3)").unwrap();
    let names = OpenNames::new(algebra, &inputs(), Parameters::new()).unwrap();
    let [x, y, z] = FIELD;
    let text = format!("-({x})*Pi1 - ({y})*Pi2 - (0.7 + {z})*Pi3");
    let (base, hamiltonian) = names.system(&text).unwrap();
    let terms = OpenTerms {
        inputs: inputs(),
        hamiltonian,
        damping: Some(lie_poisson_formula_systems::Damping::Gilbert(0.3)),
        ..OpenTerms::default()
    };
    let model = OpenSystem::new(base.with_plus_bracket().unwrap(), terms, end / 100.0).unwrap();
    let scheme = "gauss-12".parse().unwrap();
    let method = model.method("collective".parse().unwrap(), scheme, 0.0).unwrap();
    let pace = pace(end / 100.0, end, 100);
    last(&Experiment { model, start: spin.to_vec(), method, pace, attitude: false })
}

/// The step is a sixth to a twenty-fifth of the period of the field, and jumps lie within steps.
#[test]
fn a_lattice_of_one_spin_is_the_driven_spin_of_a_formula() {
    let spin = [0.6, 0.0, 1.6];
    let expected = exact(spin, 2.0);
    let error = |step: f64| {
        let damping = Some(SpinDamping::Gilbert(0.3));
        let row = last(&run(one_spin(), driven(damping), &spin, (step, 2.0, 1)));
        let apart = row[1..4].iter().zip(&expected[1..4]).map(|(a, b)| (a - b).abs());
        (step, apart.fold(0.0, f64::max), (row[4] - expected[4]).abs())
    };
    let errors = [0.1, 0.05, 0.025, 0.0125].map(error);
    let order = fitted_order(&errors.map(|(step, error, _)| (step, error)), 1e-13).unwrap();
    assert!((order - 2.0).abs() < 0.15, "{order} {errors:?}");
    // The column h has the field of its time, as that of the formula.
    assert!(errors[3].1 < 5e-3 && errors[3].2 < 2e-2, "{errors:?}");
    assert!(expected[4].abs() > 0.2, "control: {expected:?}");
}

/// dh/dt = ∂h/∂t = −Ḃ·M along the motion, by Simpson's rule, where the field is smooth.
#[test]
fn the_energy_changes_by_the_explicit_dependence_on_the_time() {
    let field = ["0.8*cos(6*t)", "0", "0.3*t"];
    let derivative = |t: f64| [-4.8 * (6.0 * t).sin(), 0.0, 0.3];
    let terms = || LatticeTerms {
        field: Some(LatticeField::new(NamedInputs::default(), &field).unwrap()),
        ..LatticeTerms::default()
    };
    let spins: Vec<f64> = (0..12).map(|i| (f64::from(i) * 1.7).sin()).collect();
    let imbalance = |step: f64| {
        let run = run(lattice(&[4.0], 1.0), terms(), &spins, (step, 2.0, 1));
        assert_eq!(run.kept(), [false, false, false, false, true]);
        let rows = rows(&run, None);
        let rate = |row: &Vec<f64>| -> f64 {
            let own = derivative(row[0]);
            -(0..3).map(|i| own[i] * row[14 + i]).sum::<f64>()
        };
        let worked: f64 = rows
            .windows(3)
            .step_by(2)
            .map(|part| (rate(&part[0]) + 4.0 * rate(&part[1]) + rate(&part[2])) * step / 3.0)
            .sum();
        let (first, end) = (&rows[0], &rows[rows.len() - 1]);
        for row in &rows {
            assert!((row[17] - first[17]).abs() < 1e-12, "C: {}", row[17] - first[17]);
        }
        ((end[13] - first[13] - worked).abs(), (end[13] - first[13]).abs())
    };
    let [(coarse, change), (fine, _)] = [0.05, 0.025].map(imbalance);
    // The method has the order 2.
    assert!(
        change > 0.5 && fine < 2e-3 && (3.0..5.5).contains(&(coarse / fine)),
        "{coarse} {fine}"
    );
}

#[test]
fn rates_sizes_and_the_formula_of_h_have_the_field_of_the_time() {
    let model = OpenArrays::new(one_spin(), driven(None), 0.1).unwrap();
    let spin = [0.6, 0.0, 1.6];
    for (time, u) in [(0.2_f64, 1.0), (0.5, -2.0)] {
        let b = [1.5 * (10.0 * time).cos(), u * (10.0 * time).sin(), 1.2 + u / 2.0];
        let rate = model.rate(&spin, time).unwrap();
        // ds/dt = s × B
        let expected = [-1.6 * b[1], 1.6 * b[0] - 0.6 * b[2], 0.6 * b[1]];
        assert!(rate.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{rate:?}");
    }
    // The largest field is that of t = 0, (1.5, 0, 1), where it is computed: at 0 and at the times of the table.
    let sizes = [0.0, 0.37, 1.3, 4.0_f64].map(|t| {
        let u = [1.0, -2.0, 0.5, 0.0][[0.0, 0.37, 1.3, 4.0].iter().position(|x| *x == t).unwrap()];
        let b: [f64; 3] = [1.5 * (10.0 * t).cos(), u * (10.0 * t).sin(), 0.5 + u / 2.0];
        b.iter().map(|x| x * x).sum::<f64>().sqrt()
    });
    let largest = sizes.into_iter().fold(0.0, f64::max);
    assert!((model.fastest_rate(&spin) - 0.7 - largest).abs() < 1e-14);
    let h = Model::formula(&model, "h").unwrap();
    assert!(h.ends_with("·sum(S[i])") && h.contains("1.5*cos(10*t)"), "{h}");
    assert_eq!(Model::formula(&model, "C"), Model::formula(model.system(), "C"));
    assert!(model.inputs().unwrap().require_until(5.0).is_err());
    assert!(model.inputs().unwrap().require_until(4.0).is_ok());
}

/// A run goes on to the same bits from its middle, in the middle of a turn of the field, and comes back.
#[test]
fn driven_runs_continue_to_the_bit() {
    let spins = [0.6, 0.0, 1.6, 1.0, 0.0, 0.0];
    let run = run(lattice(&[2.0], 0.7), driven(None), &spins, (0.05, 4.0, 40));
    let mut saved = None;
    let keep = |moment: &lie_poisson_runs::Moment<'_>| {
        if moment.step == 40 {
            saved = Some(moment.saved());
        }
        Ok::<_, RunFailure>(())
    };
    run.follow(None, keep).unwrap();
    let saved = saved.unwrap();
    assert_eq!(saved.state[7], 40.0, "the time in steps");
    assert_eq!(rows(&run, Some(&saved)).pop(), Some(last(&run)));
    // Control: at another time the end is another one.
    let mut other = saved;
    other.state[7] = 41.0;
    let failed = run.follow(Some(&other), |_| Ok::<_, RunFailure>(()));
    assert!(failed.is_err(), "the last step is beyond the table");
}

#[test]
fn what_is_no_field_is_refused() {
    for (texts, part) in [
        (&["1", "2"][..], "drive field needs 3 formulas, one for each coordinate, and has 2"),
        (&["1", "2", "3", "4"], "has 4"),
        (&["1", "v", "0"], "drive field2"),
        (&["1", "S1", "0"], "drive field2"),
        (&["", "0", "0"], "drive field1"),
    ] {
        let refused = LatticeField::new(inputs(), texts).unwrap_err().to_string();
        assert!(refused.contains(part), "{refused}");
    }
    let table = InputTable::new(vec![0.0, 1.0], vec![0.0, 1.0], Interpolation::Linear).unwrap();
    for name in ["t", "u v"] {
        let inputs = NamedInputs::new(vec![(name.into(), table.clone())]);
        assert!(LatticeField::new(inputs, &["0", "0", "0"]).is_err(), "{name}");
    }
    let fluid = system("sphere-fluid", &Arguments::new().number("size", 4.0));
    let refused = OpenArrays::new(fluid, driven(None), 0.1).unwrap_err().to_string();
    assert!(refused.contains("drive must be left out") && refused.contains("spin-lattice"));
}
