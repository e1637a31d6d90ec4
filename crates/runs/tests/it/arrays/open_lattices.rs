//! Lattices of spins with friction, and at a temperature.

use crate::arrays::array_systems::{lattice, system};
use crate::support::{last, pace, rows};
use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyState, Integrator, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_runs::{
    Arguments, ArraySystem, Experiment, LatticeNoise, LatticeTerms, Model, NoisePaths, OpenArrays,
    PathEnsemble, RunFailure, SpinDamping,
};

const FRICTION: SpinDamping = SpinDamping::LandauLifshitz(1.0);

fn noise(temperature: f64) -> LatticeNoise {
    LatticeNoise { temperature, paths: NoisePaths::default() }
}

fn on(path: u64) -> NoisePaths {
    NoisePaths { path, ..NoisePaths::default() }
}

fn at(temperature: f64) -> LatticeTerms {
    LatticeTerms { noise: Some(noise(temperature)), ..damped(FRICTION) }
}

fn damped(damping: SpinDamping) -> LatticeTerms {
    LatticeTerms { damping: Some(damping), ..LatticeTerms::default() }
}

/// Returns spins with a field of size B along e₃ and without bonds.
fn in_field(count: f64, b: f64) -> ArraySystem {
    let given = Arguments::new().list("shape", vec![count]).list("field", vec![0.0, 0.0, b]);
    system("spin-lattice", &given)
}

/// Returns the run of a lattice whose spins begin along a direction.
fn run(
    lattice: ArraySystem,
    terms: LatticeTerms,
    direction: [f64; 3],
    (step, end, every): (f64, f64, u64),
) -> Experiment<OpenArrays> {
    let start = lattice.start_of(&Arguments::new().list("direction", direction.to_vec())).unwrap();
    let model = OpenArrays::new(lattice, terms, step).unwrap();
    let method = model.method(None, None, 0.0).unwrap();
    Experiment { model, start, method, pace: pace(step, end, every), attitude: false }
}

/// With the friction b and the factor a of the field, ds₃/dt = bB(1 − s₃²), and the spin goes round e₃ by the angle
/// aBt. The error of the midpoint rule is of the order h².
#[test]
fn damped_spins_have_their_closed_forms() {
    let gilbert = 0.5;
    let slower = 1.0 / (1.0 + gilbert * gilbert);
    for (damping, [a, b]) in [
        (SpinDamping::LandauLifshitz(0.3), [1.0, 0.3]),
        (SpinDamping::Gilbert(gilbert), [slower, slower * gilbert]),
    ] {
        let error = |step: f64| {
            let start = [1.0, 0.0, 0.0];
            let row = last(&run(in_field(2.0, 2.0), damped(damping), start, (step, 3.0, 1)));
            let (x, y, z) = (row[1], row[2], row[3]);
            // ds/dt = s × B: clockwise.
            let turned = (y.atan2(x) + 2.0 * a * 3.0).rem_euclid(core::f64::consts::TAU);
            let angle = turned.min(core::f64::consts::TAU - turned);
            (z - (2.0 * b * 3.0).tanh()).abs().max(angle)
        };
        let [long, short] = [0.05, 0.025].map(error);
        assert!(short < 2e-3 && (long / short - 4.0).abs() < 0.1, "{damping:?}: {long} {short}");
    }
}

/// The rate is that of short steps, and the drag turns spins into their fields.
#[test]
fn the_rate_is_the_limit_of_steps() {
    let terms = damped(SpinDamping::Gilbert(0.4));
    let model = OpenArrays::new(lattice(&[2.0, 3.0], 0.7), terms, 1e-4).unwrap();
    let start: Vec<f64> = (0..18).map(|i| (f64::from(i) * 1.7).sin()).collect();
    let method = model.method(None, None, 0.0).unwrap();
    let integrator = model.integrator(&method, &start).unwrap();
    let after = |step| {
        let end = integrator.after(&AnyState::from_slice(&start), step, 1).unwrap().momentum;
        end.as_slice().to_vec()
    };
    let (forth, back, rate) = (after(1e-4), after(-1e-4), model.rate(&start, 0.0).unwrap());
    let undamped = model.system().rate(&start).unwrap();
    let mut largest = 0.0_f64;
    for (i, rate) in rate.iter().enumerate() {
        // Central differences: the third derivative times h²/6, some 1e-8, and rounding, 1e-12.
        assert!(((forth[i] - back[i]) / 2e-4 - rate).abs() < 1e-7);
        largest = largest.max((rate - undamped[i]).abs());
    }
    assert!(largest > 0.1, "control: there is a friction");
    let dh = model.differential(&start);
    let change: f64 = dh.iter().zip(&rate).map(|(dh, rate)| dh * rate).sum();
    assert!(change < -0.1, "{change}");
    assert!(model.rate(&start[1..], 0.0).is_err());
}

/// The energy per bond of a long ring is −J (coth K − 1/K), K = J/kT, by the transfer operator: (coth K − 1/K)ᴺ is left
/// out. It is the mean over the last three quarters of 16 paths, with the standard error from their differences.
#[test]
#[ignore = "long"]
fn the_energy_of_a_ring_is_that_of_its_temperature() {
    let sites = 48.0;
    let run = run(lattice(&[sites], 1.0), at(0.5), [0.0, 0.0, 1.0], (0.025, 12.5, 10));
    let mut means = Vec::new();
    for path in 0..16 {
        let mut run = run.clone();
        let terms =
            LatticeTerms { noise: Some(LatticeNoise { paths: on(path), ..noise(0.5) }), ..at(0.5) };
        run.model = OpenArrays::new(run.model.system().clone(), terms, 0.025).unwrap();
        let rows = rows(&run, None);
        let some = &rows[rows.len() / 4..];
        let h = 3 * sites as usize + 1;
        means.push(some.iter().map(|row| row[h]).sum::<f64>() / some.len() as f64 / sites);
        let row = &rows[rows.len() - 1];
        assert!((row[h + 4] - sites).abs() < 1e-11, "{:?}", &row[h..]);
        for spin in row[1..h].as_chunks::<3>().0 {
            assert!((spin.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }
    let mean = means.iter().sum::<f64>() / 16.0;
    let error = (means.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (15.0 * 16.0)).sqrt();
    let exact = |k: f64| k.recip() - k.tanh().recip();
    // The step lowers the energy by 0.0019, less than half the standard error: 2000 paths of 200 spins show 0.0019(7), and 0.0038(7)
    // with twice the step.
    assert!((mean - exact(2.0)).abs() < 4.0 * error, "{mean} ± {error}");
    assert!((mean - exact(2.5)).abs() > 8.0 * error, "control: {mean} ± {error}");
}

/// Statistics are those of the paths one by one, and do not depend on the start of their numbers.
#[test]
fn an_ensemble_follows_the_paths_of_a_lattice() {
    let run = run(lattice(&[3.0], 1.0), at(1.0), [0.0, 0.0, 1.0], (0.05, 2.0, 40));
    let paths = PathEnsemble { paths: 5, quantiles: Vec::new() };
    let row = paths.follow(&run, |_| true).unwrap().unwrap().pop().unwrap();
    let h = |path| {
        let mut run = run.clone();
        let terms =
            LatticeTerms { noise: Some(LatticeNoise { paths: on(path), ..noise(1.0) }), ..at(1.0) };
        run.model = OpenArrays::new(run.model.system().clone(), terms, 0.05).unwrap();
        last(&run)[10]
    };
    let mean = (0..5).map(h).sum::<f64>() / 5.0;
    assert!((row.quantities[9].mean - mean).abs() < 1e-14 && row.quantities[9].deviation > 0.1);
    assert!((row.quantities[13].mean - 3.0).abs() < 1e-13, "C");
}

/// Runs are the same from their middle on, and come back along their path.
#[test]
fn runs_continue_and_come_back() {
    let run = run(lattice(&[2.0, 2.0], 1.0), at(1.0), [0.0, 1.0, 1.0], (0.05, 102.4, 1024));
    let mut saved = None;
    let keep = |moment: &lie_poisson_runs::Moment<'_>| {
        if moment.step == 1024 {
            saved = Some(moment.saved());
        }
        Ok::<_, RunFailure>(())
    };
    run.follow(None, keep).unwrap();
    let saved = saved.unwrap();
    assert_eq!(saved.state.len(), 12 + 2);
    assert_eq!(rows(&run, Some(&saved)).pop(), Some(last(&run)));
    // Control: on another path the end is another one.
    let mut other = saved.clone();
    other.state[12] = 1.0;
    assert_ne!(rows(&run, Some(&other)).pop(), Some(last(&run)));
    let integrator = run.model.integrator(&run.method, &run.start).unwrap();
    let start = AnyState::from_slice(&run.start);
    let there = integrator.after(&start, 0.05, 40).unwrap();
    let mut back = integrator.trajectory_from(there.state, -0.05);
    let back = back.nth(40).unwrap().unwrap().momentum;
    // Each of 80 steps is solved to round-off, and the motion spreads it by some e⁴.
    let distance = back.as_slice().iter().zip(start.as_slice()).map(|(a, b)| (a - b).abs());
    assert!(distance.fold(0.0, f64::max) < 1e-11);
}

/// √(2bkTh), the largest of all spins.
#[test]
fn strong_noise_has_its_angle_and_a_warning() {
    let given = Arguments::new().list("S", vec![0.0, 0.0, 2.0, 0.0, 0.5, 0.0]);
    for (damping, friction) in [(FRICTION, 1.0), (SpinDamping::Gilbert(1.0), 0.5 / 0.5)] {
        let terms = LatticeTerms { noise: Some(noise(4.0)), ..damped(damping) };
        let lattice = lattice(&[2.0], 1.0);
        let start = lattice.start_of(&given).unwrap();
        let model = OpenArrays::new(lattice, terms, 0.02).unwrap();
        let angle = model.noise_angle(&start, -0.02).unwrap();
        assert!((angle - (2.0 * friction * 4.0 * 0.02_f64).sqrt()).abs() < 1e-15);
        let method = model.method(None, None, 0.0).unwrap();
        let model: &dyn Model = &model;
        let warning = |step| {
            let accuracy = model.accuracy(&method, &start, (step, 10), &|| true).unwrap();
            model.accuracy_warning(&start, &accuracy).unwrap_or_default()
        };
        assert!(warning(0.02).contains("the noise turns the state by about 4.0e-1 rad"));
        assert_eq!(warning(0.01), "");
    }
    let still = OpenArrays::new(lattice(&[2.0], 1.0), damped(FRICTION), 0.1).unwrap();
    assert_eq!((still.noise_angle(&[0.0; 6], 0.1), still.noise()), (None, None));
}

#[test]
fn what_a_lattice_cannot_have_is_refused() {
    let refused =
        |terms, step| OpenArrays::new(lattice(&[4.0], 1.0), terms, step).unwrap_err().to_string();
    let noisy = |paths| LatticeTerms {
        noise: Some(LatticeNoise { paths, ..noise(1.0) }),
        ..damped(FRICTION)
    };
    for (terms, part) in [
        (damped(SpinDamping::Gilbert(-0.5)), "0 or a positive number, it is -0.5"),
        (damped(SpinDamping::LandauLifshitz(f64::NAN)), "it is NaN"),
        (at(-1.0), "the temperature must be 0 or a positive number, it is -1"),
        (at(f64::INFINITY), "it is inf"),
        (LatticeTerms { damping: None, ..at(1.0) }, "a temperature needs a friction"),
        (noisy(NoisePaths { path: 1 << 53, ..on(0) }), "below 9007199254740992"),
        (noisy(NoisePaths { interval: Some(1e-9), ..on(0) }), "at least 0.00001, it is"),
        (noisy(NoisePaths { interval: Some(f64::NAN), ..on(0) }), "it is NaN"),
        (noisy(NoisePaths { bound: Some(0.5), ..on(0) }), "or more, it is 0.5"),
    ] {
        let message = refused(terms, 0.1);
        assert!(message.contains(part), "{message}: {part}");
    }
    assert!(refused(at(1.0), 0.0).contains("it is 0"));
    let message = refused(at(1.0), -0.1);
    assert!(message.contains("no way back in time") && message.contains("the step is -0.1"));
    for terms in [at(0.0), damped(FRICTION)] {
        assert!(OpenArrays::new(lattice(&[4.0], 1.0), terms, -0.1).is_ok());
    }
    let fluid = system("sphere-fluid", &Arguments::new().number("size", 4.0));
    let error = OpenArrays::new(fluid, damped(FRICTION), 0.1).unwrap_err();
    assert_eq!(
        error.to_string(),
        "sphere-fluid: damping must be left out: of the systems of arrays spin-lattice has friction, a temperature and a field in \
         time"
    );
    let model = OpenArrays::new(lattice(&[4.0], 1.0), at(1.0), 0.1).unwrap();
    for (formulation, scheme, has) in [
        (Some(Formulation::Collective), None, "it has direct implicit-midpoint"),
        (None, Some(SchemeName::Gauss(8)), "direct has implicit-midpoint"),
    ] {
        let error = model.method(formulation, scheme, 0.0).unwrap_err();
        assert!(matches!(&error, FormulaSystemError::NoMethod { has: own, .. } if own == has));
    }
    assert!(model.method(None, None, -1.0).is_err());
    let collective = lattice(&[4.0], 1.0).method(None, SchemeName::Gauss(4), 0.0).unwrap();
    assert!(model.integrator(&collective, &[0.0; 12]).is_err());
}
