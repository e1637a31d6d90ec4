//! Fluids on the sphere with viscosity, drag, a force, stirring and transport noise.

use crate::arrays::array_systems::{lattice, system};
use crate::support::{last, pace, rows};
use collective_integrators::{AnyState, Integrator, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_runs::{
    Arguments, ArraySystem, Experiment, FluidNoise, FluidTerms, HarmonicShell, LatticeTerms, Model,
    NoisePaths, OpenArrays, PathEnsemble, RunFailure, Schedule, SpinDamping,
};

/// The columns of a row behind the coordinates of a fluid of the size N: h, Z, M3, M1, M2.
const fn column(size: usize, quantity: usize) -> usize {
    1 + size * size + quantity
}

fn fluid(size: usize) -> ArraySystem {
    system("sphere-fluid", &Arguments::new().number("size", size as f64))
}

fn shell(least: usize, most: usize, strength: f64) -> Vec<HarmonicShell> {
    vec![HarmonicShell { degrees: [least, most], strength }]
}

fn transport(strength: f64) -> FluidTerms {
    let noise = FluidNoise { transport: shell(2, 4, strength), ..FluidNoise::default() };
    FluidTerms { noise: Some(noise), ..FluidTerms::default() }
}

fn stirring(strength: f64) -> FluidTerms {
    let noise = FluidNoise { stirring: shell(2, 2, strength), ..FluidNoise::default() };
    FluidTerms { noise: Some(noise), ..FluidTerms::default() }
}

/// Returns terms on another path of their noise.
fn on_path(terms: &FluidTerms, path: u64) -> FluidTerms {
    let mut terms = terms.clone();
    terms.noise.as_mut().unwrap().paths.path = path;
    terms
}

/// Returns the run of a fluid that begins with these rows l, m, re, im.
fn run(
    fluid: ArraySystem,
    terms: FluidTerms,
    rows: &[[f64; 4]],
    (step, end, every): (f64, f64, u64),
) -> Experiment<OpenArrays> {
    let start = Arguments::new().list("coefficients", rows.as_flattened().to_vec());
    let start = fluid.start_of(&start).unwrap();
    let step = Schedule::new(step, end).unwrap().step;
    let model = OpenArrays::new(fluid, terms, step).unwrap();
    let start = model.start(&start).unwrap();
    let method = model.method(None, None, 0.0).unwrap();
    Experiment { model, start, method, pace: pace(step, end, every), attitude: false }
}

const EDDIES: [[f64; 4]; 3] = [[2.0, 1.0, 0.5, 0.1], [3.0, 2.0, -0.4, 0.2], [5.0, 0.0, 0.3, 0.0]];

/// Harmonics of one degree make a steady flow, so that stirring and damping alone change them: each of 2l + 1 has the
/// variance σ²/2λ, at every step size. After a step of 2/λ they are forgotten but for e⁻², and Z but for e⁻⁴.
#[test]
#[ignore = "long"]
fn a_stirred_and_damped_shell_has_its_exact_enstrophy() {
    let (strength, steps) = (0.05, 2000);
    let mean_of = |viscosity| {
        let terms = FluidTerms { viscosity, drag: 0.4, ..stirring(strength) };
        let run = run(fluid(4), terms, &[], (2.0, 2.0 * steps as f64, 1));
        let rows = rows(&run, None);
        // h = Z/2l(l + 1), and nothing else is excited.
        for row in &rows[1..] {
            let (z, energy) = (row[column(4, 1)], row[column(4, 0)]);
            assert!((energy - z / 12.0).abs() < 1e-13 * z && row[column(4, 2)].abs() < 1e-12 * z);
        }
        rows[1..].iter().map(|row| row[column(4, 1)]).sum::<f64>() / steps as f64
    };
    // λ = 0.4 + 0.1·6 = 1
    let exact = 5.0 * strength * strength / 2.0;
    // Z is χ² of 5 degrees of freedom; its correlation e⁻⁴ from step to step adds 2 per cent.
    let error = 1.02 * exact * (2.0_f64 / 5.0 / steps as f64).sqrt();
    let mean = mean_of(0.1);
    assert!((mean - exact).abs() < 4.0 * error, "{mean} {exact} ± {error}");
    let other = mean_of(0.2);
    assert!((other - exact).abs() > 8.0 * error, "control: {other}");
}

/// On one degree dω/dt = F − λω, whatever the step is; on many the error is that of the order 2.
#[test]
fn a_forced_and_damped_fluid_has_its_closed_form_and_its_order() {
    let forced = |force| FluidTerms { viscosity: 0.01, power: 2, drag: 0.3, force, noise: None };
    let row = last(&run(
        fluid(6),
        forced(vec![[2.0, 1.0, 0.2, -0.1]]),
        &[[2.0, 1.0, 0.0, 0.3]],
        (0.5, 3.0, 1),
    ));
    let rate = 0.3 + 0.01 * 36.0;
    let (lost, gained) = ((-rate * 3.0_f64).exp(), -(-rate * 3.0_f64).exp_m1() / rate);
    // Re ω₂₁ is at [2, 1], Im ω₂₁ at [0, 2].
    assert!((row[1 + 6 * 2 + 1] - 0.2 * gained).abs() < 1e-13);
    assert!((row[1 + 2] - (0.3 * lost - 0.1 * gained)).abs() < 1e-13);
    let end =
        |step| last(&run(fluid(8), forced(vec![[4.0, 2.0, 0.5, 0.0]]), &EDDIES, (step, 2.0, 1)));
    let [long, short, exact] = [0.1, 0.05, 0.00625].map(end);
    let error = |row: &[f64]| {
        let changes = row[1..].iter().zip(&exact[1..]).map(|(a, b)| (a - b).abs());
        changes.fold(0.0, f64::max)
    };
    let ratio = error(&long) / error(&short);
    // The reference has 1/64 of the error of the shorter one.
    assert!((ratio - 4.0).abs() < 0.2 && error(&short) > 1e-6, "{ratio}");
}

/// The rate, as users read it, is that of short steps, and the viscosity has a part in it.
#[test]
fn the_rate_is_the_limit_of_steps() {
    let terms =
        FluidTerms { drag: 0.5, force: vec![[3.0, 1.0, 0.2, 0.4]], ..FluidTerms::default() };
    let there = run(fluid(7), terms, &EDDIES, (1e-4, 1e-4, 1));
    let mut given = there.start.clone();
    there.model.present(&mut given);
    let rate = there.model.rate(&given, 0.0).unwrap();
    let integrator = there.model.integrator(&there.method, &there.start).unwrap();
    let after = |step| {
        let end = integrator.after(&AnyState::from_slice(&there.start), step, 1).unwrap();
        let mut end = end.momentum.as_slice().to_vec();
        there.model.present(&mut end);
        end
    };
    let (forth, back) = (after(1e-4), after(-1e-4));
    let ideal = there.model.system().rate(&given).unwrap();
    let mut largest = 0.0_f64;
    for i in 0..rate.len() {
        // Central differences: the third derivative times h²/6, and rounding, 1e-12.
        assert!(((forth[i] - back[i]) / 2e-4 - rate[i]).abs() < 1e-7);
        largest = largest.max((rate[i] - ideal[i]).abs());
    }
    assert!(largest > 0.1, "control: there are forces");
    assert!(there.model.rate(&given[1..], 0.0).is_err());
}

/// Transport noise keeps the enstrophy and no energy; other terms keep neither, and terms that are zero keep both.
#[test]
fn what_is_kept_is_told() {
    let kept = |terms: FluidTerms| {
        let run = run(fluid(6), terms, &EDDIES, (0.05, 2.0, 40));
        let (first, last) = (run.initial().unwrap(), last(&run));
        let changes: Vec<f64> = (0..5).map(|i| (first[i] - last[column(6, i)]).abs()).collect();
        assert_eq!(run.conserved(), ["h", "Z", "M3", "M1", "M2"]);
        (run.kept(), changes)
    };
    let (names, changes) = kept(transport(0.05));
    assert_eq!(names, [false, true, false, false, false]);
    assert!(changes[1] < 1e-13 && changes[0] > 1e-4, "{changes:?}");
    for terms in [
        FluidTerms { viscosity: 0.01, ..FluidTerms::default() },
        FluidTerms { drag: 0.1, ..transport(0.05) },
        FluidTerms { force: vec![[3.0, 0.0, 0.1, 0.0]], ..FluidTerms::default() },
        stirring(0.1),
    ] {
        let (names, changes) = kept(terms);
        assert_eq!(names, [false; 5]);
        assert!(changes[1] > 1e-4, "{changes:?}");
    }
    let still = FluidTerms { force: vec![[3.0, 1.0, 0.0, 0.0]], ..stirring(0.0) };
    let (names, changes) = kept(still);
    assert_eq!(names, [true; 5]);
    assert!(changes[1..].iter().all(|change| *change < 1e-13), "{changes:?}");
}

/// A run continues with the bits of the whole one, and its path is that of its number in an ensemble.
#[test]
#[ignore = "long"]
fn paths_are_functions_of_their_number() {
    let noise = FluidNoise {
        transport: shell(2, 3, 0.05),
        stirring: shell(3, 3, 0.1),
        paths: NoisePaths::default(),
    };
    let terms = FluidTerms { drag: 0.1, noise: Some(noise), ..FluidTerms::default() };
    let there = run(fluid(4), terms.clone(), &EDDIES[..2], (0.05, 102.4, 1024));
    let mut saved = None;
    let keep = |moment: &lie_poisson_runs::Moment<'_>| {
        if moment.step == 1024 {
            saved = Some(moment.saved());
        }
        Ok::<_, RunFailure>(())
    };
    there.follow(None, keep).unwrap();
    let saved = saved.unwrap();
    assert_eq!(saved.state.len(), 16 + 2);
    assert_eq!(rows(&there, Some(&saved)).pop(), Some(last(&there)));
    // Control: on another path the end is another one.
    let mut other = saved.clone();
    other.state[16] = 1.0;
    assert_ne!(rows(&there, Some(&other)).pop(), Some(last(&there)));

    let short = |path| run(fluid(4), on_path(&terms, path), &EDDIES[..2], (0.05, 1.0, 20));
    let ensemble = PathEnsemble { paths: 4, quantiles: Vec::new() };
    let found = ensemble.follow(&short(0), |_| true).unwrap().unwrap().pop().unwrap();
    let mean = (0..4).map(|path| last(&short(path))[column(4, 1)]).sum::<f64>() / 4.0;
    let of_ensemble = &found.quantities[column(4, 1) - 1];
    assert!((of_ensemble.mean - mean).abs() < 1e-13 && of_ensemble.deviation > 1e-3);
}

/// Without viscosity a run comes back along its path, drag and noise included; with it there is no way back.
#[test]
fn a_run_backward_retraces_its_path_unless_viscosity_forbids_it() {
    let terms = FluidTerms { drag: 0.2, ..transport(0.05) };
    let there = run(fluid(6), terms, &EDDIES, (0.05, 1.0, 20));
    let integrator = there.model.integrator(&there.method, &there.start).unwrap();
    let start = AnyState::from_slice(&there.start);
    let end = integrator.after(&start, 0.05, 20).unwrap();
    let mut back = integrator.trajectory_from(end.state, -0.05);
    let back = back.nth(20).unwrap().unwrap().momentum;
    let distance = back.as_slice().iter().zip(start.as_slice()).map(|(a, b)| (a - b).abs());
    assert!(distance.fold(0.0, f64::max) < 1e-12);
    let viscous = FluidTerms { viscosity: 0.5, ..FluidTerms::default() };
    let error = OpenArrays::new(fluid(6), viscous, -0.05).unwrap_err();
    assert!(matches!(error, FormulaSystemError::KindValue { name: "viscosity", .. }));
    assert!(error.to_string().contains("0 backward in time, where it feeds small eddies, got 0.5"));
}

/// Half of the root mean square of the vorticity of the noise in a step, or twice that of the stream function over ħ =
/// 2/√(N² − 1).
#[test]
fn strong_transport_noise_has_its_angle_and_a_warning() {
    let model = |size| OpenArrays::new(fluid(size), transport(0.05), 0.01).unwrap();
    let rms = |sum: f64| 0.05 * (sum / (4.0 * core::f64::consts::PI)).sqrt();
    // Σ_l (2l + 1)(l(l + 1))² = 5·36 + 7·144 + 9·400, and Σ_l (2l + 1) = 21
    for (size, angle) in [(5, 0.5 * rms(4788.0)), (8, rms(21.0) * 63.0_f64.sqrt())] {
        let found = model(size).noise_angle(&[], -0.01).unwrap();
        assert!((found - 0.1 * angle).abs() < 1e-14, "{size}: {found}");
    }
    let model = model(8);
    let method = model.method(None, None, 0.0).unwrap();
    let model: &dyn Model = &model;
    let warning = |step| {
        let accuracy = model.accuracy(&method, &[0.0; 64], (step, 10), &|| true).unwrap();
        model.accuracy_warning(&[0.0; 64], &accuracy).unwrap_or_default()
    };
    assert!(
        warning(1.0).contains("the noise turns the state by about 5.1e-1 rad"),
        "{}",
        warning(1.0)
    );
    assert_eq!(warning(0.01), "");
    let viscous = FluidTerms { viscosity: 1.0, ..FluidTerms::default() };
    let viscous = OpenArrays::new(fluid(4), viscous, 0.1).unwrap();
    assert_eq!((viscous.noise_angle(&[0.0; 16], 0.1), viscous.noise()), (None, None));
    assert_eq!((viscous.order(&method), model.order(&method)), (2, 1));
}

#[test]
fn what_a_fluid_cannot_have_is_refused() {
    let none = FluidTerms::default;
    let shells = |degrees, strength| FluidTerms {
        noise: Some(FluidNoise {
            stirring: vec![HarmonicShell { degrees, strength }],
            ..FluidNoise::default()
        }),
        ..none()
    };
    let paths = |paths| {
        let mut terms = stirring(0.1);
        terms.noise.as_mut().unwrap().paths = paths;
        terms
    };
    let all = NoisePaths::default();
    for (terms, part) in [
        (
            FluidTerms { viscosity: -0.5, ..none() },
            "viscosity must be 0 or a positive number, got -0.5",
        ),
        (
            FluidTerms { viscosity: f64::NAN, ..none() },
            "viscosity must be 0 or a positive number, got NaN",
        ),
        (
            FluidTerms { drag: f64::INFINITY, ..none() },
            "drag must be 0 or a positive number, got inf",
        ),
        (FluidTerms { power: 0, ..none() }, "power must be a whole number from 1 to 32, got 0"),
        (FluidTerms { power: 33, ..none() }, "from 1 to 32, got 33"),
        (
            FluidTerms { viscosity: 1e300, power: 32, ..none() },
            "viscosity of this power must be between",
        ),
        (FluidTerms { force: vec![[4.0, 0.0, 1.0, 0.0]], ..none() }, "degrees l from 1 to 3"),
        (FluidTerms { force: vec![[0.0, 0.0, 1.0, 0.0]], ..none() }, "got l = 0"),
        (
            FluidTerms { force: vec![[2.0, 3.0, 1.0, 0.0]], ..none() },
            "orders m from 0 to l, got l = 2, m = 3",
        ),
        (
            FluidTerms { force: vec![[2.0, 0.0, 1.0, 1.0]], ..none() },
            "torque must be real for m = 0",
        ),
        (
            FluidTerms { force: vec![[2.0, 0.0, f64::NAN, 0.0]], ..none() },
            "torque must be finite, got NaN",
        ),
        (
            shells([0, 2], 1.0),
            "stirring must be of two degrees from 1 to 3, the least first, got [0, 2]",
        ),
        (shells([3, 2], 1.0), "got [3, 2]"),
        (shells([2, 4], 1.0), "got [2, 4]"),
        (shells([1, 2], -1.0), "stirring must be of a strength that is 0 or positive, got -1"),
        (shells([1, 2], f64::NAN), "got NaN"),
        (paths(NoisePaths { path: 1 << 53, ..all }), "below 9007199254740992"),
        (paths(NoisePaths { interval: Some(1e-9), ..all }), "at least 0.00001, it is"),
        (paths(NoisePaths { bound: Some(0.5), ..all }), "or more, it is 0.5"),
    ] {
        let message = OpenArrays::new(fluid(4), terms, 0.1).unwrap_err().to_string();
        assert!(message.contains(part), "{message}: {part}");
    }
    let error = OpenArrays::new(lattice(&[4.0], 1.0), transport(0.1), 0.1).unwrap_err();
    assert_eq!(
        error.to_string(),
        "spin-lattice: damping must be left out: of the systems of arrays sphere-fluid has viscosity, a force and stirring"
    );
    let damping = Some(SpinDamping::LandauLifshitz(1.0));
    assert!(
        OpenArrays::new(fluid(4), LatticeTerms { damping, noise: None, field: None }, 0.1).is_err()
    );
    let model = OpenArrays::new(fluid(4), stirring(0.1), 0.1).unwrap();
    for (formulation, scheme, has) in [
        (Some(Formulation::Direct), None, "it has reduced implicit-midpoint"),
        (None, Some(SchemeName::Gauss(8)), "reduced has implicit-midpoint"),
    ] {
        let error = model.method(formulation, scheme, 0.0).unwrap_err();
        assert!(matches!(&error, FormulaSystemError::NoMethod { has: own, .. } if own == has));
    }
    let method = model.method(None, None, 0.0).unwrap();
    assert!(matches!(
        model.tangent_integrator(&method, &[0.0; 16]),
        Err(RunFailure::NoTangentsOfForces { .. })
    ));
}
