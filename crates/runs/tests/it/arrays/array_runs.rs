//! Runs of systems of arrays: starts, resumption, threads, units, and what is refused.

use crate::arrays::array_systems::{after, lattice, system};
use crate::support::{pace, rows};
use collective_integrators::diagnostics::SystemScales;
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_runs::{Arguments, ArrayKind, ArraySystem, Experiment, Model, Pace, RunFailure};
use nalgebra::Vector3;
use std::f64::consts::PI;

const SPHERICAL: (Option<Formulation>, SchemeName) =
    (Some(Formulation::Reduced), SchemeName::SphericalMidpoint);

fn experiment(
    model: ArraySystem,
    given: &Arguments,
    (formulation, scheme): (Option<Formulation>, SchemeName),
    pace: Pace,
) -> Experiment<ArraySystem> {
    let start = Model::start(&model, &model.start_of(given).unwrap()).unwrap();
    let method = model.method(formulation, scheme, 0.0).unwrap();
    Experiment { model, start, method, pace, attitude: false }
}

/// A run of a large system can be resumed after fewer steps than that of a small one, with the same bits.
#[test]
#[ignore = "long"]
fn large_systems_are_resumed_to_the_same_bits() {
    // 300 × 250 spins are 225000 coordinates; 2²⁴ over that, as a power of two, is 64.
    let model = || lattice(&[300.0, 250.0], 1.0);
    assert_eq!(model().resumable_after(), 64);
    assert_eq!(lattice(&[4.0], 1.0).resumable_after(), 1024);
    let given = Arguments::new().number("tilt", 0.3);
    let run = experiment(model(), &given, SPHERICAL, pace(0.05, 3.4, 64));
    let (mut saved, mut steps, mut all) = (None, Vec::new(), Vec::new());
    run.follow(None, |moment| -> Result<(), RunFailure> {
        steps.push(moment.step);
        if run.pace.keeps(moment.step) {
            all.push(moment.row.to_vec());
        }
        if moment.step == 64 {
            saved = Some(moment.saved());
        }
        Ok(())
    })
    .unwrap();
    let saved = saved.unwrap();
    assert_eq!((saved.step, steps.last()), (64, Some(&68)), "{steps:?}");
    let rest = rows(&run, Some(&saved));
    assert_eq!((all.len(), rest.len()), (3, 1));
    assert_eq!(all[2..], rest[..]);
}

/// Control: an integrator that knows its earlier steps does not give the same bits when it is resumed where it does not
/// forget them.
#[test]
fn small_systems_remember_earlier_steps() {
    let given = Arguments::new().number("tilt", 0.3);
    let scheme = (None, SchemeName::Gauss(4));
    let run = experiment(lattice(&[6.0], 1.0), &given, scheme, pace(0.3, 90.0, 100));
    let mut saved = None;
    run.follow(None, |moment| -> Result<(), RunFailure> {
        if moment.step == 100 {
            saved = Some(moment.saved());
        }
        Ok(())
    })
    .unwrap();
    assert_ne!(rows(&run, None)[2..], rows(&run, saved.as_ref())[..]);
}

#[test]
#[ignore = "long"]
fn states_have_the_same_bits_on_any_number_of_threads() {
    let spins = || {
        let model = lattice(&[24.0, 24.0, 24.0], 1.0);
        let start = model.start_of(&Arguments::new().number("tilt", PI)).unwrap();
        [SPHERICAL, (None, SchemeName::Gauss(2))]
            .map(|method| after(&model, &start, method, (0.05, 3)))
    };
    let vortices = || {
        let strengths: Vec<f64> = (0..400).map(|i| 0.01 * f64::from(i % 7 - 3) + 0.005).collect();
        let model = system("vortices", &Arguments::new().list("strengths", strengths));
        let start = model.start_of(&Arguments::new().number("seed", 1.0)).unwrap();
        after(&model, &start, (None, SchemeName::Gauss(2)), (0.01, 3))
    };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| (spins(), vortices()))
    };
    assert!(on(1) == on(3));
}

/// Spins have no unit: with c S, J/c and B the motion is the same, for c of any size.
#[test]
fn motions_do_not_depend_on_units() {
    let state = |c: f64| {
        let given = Arguments::new().list("shape", vec![4.0, 3.0]).number("exchange", 1.0 / c);
        let model = system("spin-lattice", &given.list("field", vec![0.1, 0.0, 0.2]));
        let start = model.start_of(&Arguments::new().number("tilt", 1.0)).unwrap();
        let start: Vec<f64> = start.iter().map(|x| c * x).collect();
        [SPHERICAL, (None, SchemeName::Gauss(4)), (Some(Formulation::Direct), SchemeName::Rk4)]
            .map(|method| after(&model, &start, method, (0.1, 20)))
    };
    let expected = state(1.0);
    for c in [1e-30, 1e30] {
        for (one, other) in state(c).iter().zip(&expected) {
            let equal = |(x, y): (&f64, &f64)| (x / c - y).abs() < 1e-12;
            assert!(one.iter().zip(other).all(equal), "{c:e}");
        }
    }
}

/// Directions are uniformly distributed on the cap: the mean of the cosine is half of the range, and a seed gives one start.
#[test]
fn random_starts_are_uniform_and_determined_by_their_seed() {
    let model = lattice(&[40.0, 50.0], 1.0);
    let start = |tilt: f64, seed: f64| {
        model.start_of(&Arguments::new().number("tilt", tilt).number("seed", seed)).unwrap()
    };
    for tilt in [1e-9_f64, 0.1, 1.0, PI] {
        let spins = start(tilt, 1.0);
        let spins: Vec<_> = spins.as_chunks::<3>().0.iter().map(|s| Vector3::from(*s)).collect();
        assert!(spins.iter().all(|s| (s.norm() - 1.0).abs() < 1e-14));
        let angle = |s: &Vector3<f64>| s.xy().norm().atan2(s.z);
        assert!(spins.iter().all(|s| angle(s) <= tilt * (1.0 + 1e-12)));
        // sin²(θ/2) is uniform between 0 and its value at the tilt. The mean of 2000 has a deviation of 1/155.
        let part = |s: &Vector3<f64>| ((0.5 * angle(s)).sin() / (0.5 * tilt).sin()).powi(2);
        let mean = spins.iter().map(part).sum::<f64>() / spins.len() as f64;
        assert!((mean - 0.5).abs() < 4.0 / 155.0, "{tilt} {mean}");
        let sum: Vector3<f64> = spins.iter().sum();
        assert!(sum.xy().norm() < 4.0 * tilt.min(1.0) * (spins.len() as f64).sqrt());
    }
    assert_eq!(start(1.0, 2.0), start(1.0, 2.0));
    assert_ne!(start(1.0, 2.0), start(1.0, 3.0));
    // Vortices keep apart.
    let vortices = system("vortices", &Arguments::new().list("strengths", vec![1.0; 300]));
    let m = vortices.start_of(&Arguments::new().number("seed", 0.0)).unwrap();
    let m: Vec<_> = m.as_chunks::<3>().0.iter().map(|x| Vector3::from(*x)).collect();
    let nearest = (0..m.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let nearest = nearest.map(|(i, j)| (m[i] - m[j]).norm_squared()).fold(f64::INFINITY, f64::min);
    assert!(nearest >= 2.0 / 300.0);
}

/// Which quantities are conserved depends on the symmetry: those that are named stay, and the others do not.
#[test]
fn the_names_of_invariants_follow_the_symmetry() {
    let of = |given: &Arguments| {
        let model = system(
            "spin-lattice",
            &given.clone().list("shape", vec![4.0, 3.0]).number("exchange", 1.0),
        );
        let start = model.start_of(&Arguments::new().number("tilt", 2.0)).unwrap();
        let end = after(&model, &start, (None, SchemeName::Gauss(4)), (0.05, 100));
        let conserved = model.conserved(&start);
        let [before, later] = [&start, &end].map(|state| conserved.values(0.0, state).unwrap());
        assert!(
            before.iter().zip(&later).all(|(a, b)| (a - b).abs() < 1e-9),
            "{before:?} {later:?}"
        );
        let total = |state: &[f64]| {
            state.as_chunks::<3>().0.iter().map(|s| Vector3::from(*s)).sum::<Vector3<f64>>()
        };
        (conserved.names().join(" "), (total(&start) - total(&end)).norm())
    };
    let none = Arguments::new();
    let along = none.clone().list("field", vec![0.3, 0.4, 0.0]);
    assert_eq!(of(&none).0, "h M1 M2 M3 C");
    let (names, moved) = of(&along);
    assert!(names == "h M C" && moved > 0.1);
    let axis = none.number("anisotropy", 0.5).list("axis", vec![0.0, 0.0, 2.0]);
    assert_eq!(of(&axis).0, "h M C");
    let both = axis.clone().list("field", vec![0.0, 0.0, -1.0]);
    assert_eq!(of(&both).0, "h M C");
    let (names, moved) = of(&axis.list("field", vec![0.1, 0.0, 1.0]));
    assert!(names == "h C" && moved > 0.1);
}

#[test]
fn what_does_not_fit_is_refused_with_what_is_needed() {
    let spins = Arguments::new().list("shape", vec![3.0, 2.0]).number("exchange", 1.0);
    let strengths = Arguments::new().list("strengths", vec![1.0, 2.0]);
    let chain = Arguments::new().number("atoms", 4.0).number("exchange", 1.0);
    let fluid = Arguments::new().number("size", 4.0);
    let none = Arguments::new;
    let parameters = [
        ("spin-lattice", spins.clone().number("exchagne", 1.0), "did you mean exchange?"),
        ("spin-lattice", none().list("shape", vec![3.0]), "without them nothing moves"),
        ("spin-lattice", spins.clone().list("periodic", vec![1.0, 0.5]), "0 or 1, got 0.5"),
        ("spin-lattice", spins.clone().list("periodic", vec![1.0; 3]), "each of 2 axes, got 3"),
        ("spin-lattice", none(), "shape is missing. It takes shape of any"),
        ("spin-lattice", spins.clone().number("J", 1.0), "there is no J. It takes"),
        (
            "spin-lattice",
            spins.clone().number("field", 1.0),
            "field must be a list of 3, got one number",
        ),
        ("spin-lattice", spins.clone().list("shape", vec![2.5]), "got [2.5]"),
        ("spin-lattice", spins.clone().list("shape", vec![1e5; 3]), "at most 268435456 spins"),
        (
            "spin-lattice",
            spins.clone().list("exchange", vec![1.0; 3]),
            "one for each of 2 axes, got 3",
        ),
        ("spin-lattice", spins.clone().list("bonds", vec![1.0; 3]), "rows of four numbers"),
        (
            "spin-lattice",
            spins.clone().list("bonds", vec![0.5, 0.0, 0.0, 1.0]),
            "whole numbers of cells",
        ),
        // A bond of each spin to itself, one along an axis that there is not, and one beyond the open ends.
        ("spin-lattice", spins.clone().list("bonds", vec![3.0, 0.0, 0.0, 1.0]), "got [3, 0, 0]"),
        ("spin-lattice", spins.clone().list("bonds", vec![1.0, 0.0, 1.0, 1.0]), "got [1, 0, 1]"),
        (
            "spin-lattice",
            spins.clone().number("periodic", 0.0).list("bonds", vec![1.0, 2.0, 0.0, 1.0]),
            "offsets to other spins of the lattice",
        ),
        ("spin-lattice", spins.clone().list("axis", vec![0.0; 3]), "axis must be different from 0"),
        ("spin-lattice", spins.clone().number("anisotropy", f64::NAN), "finite, got NaN"),
        ("vortices", strengths.clone().list("strengths", vec![1.0, 0.0]), "number 2 is 0"),
        ("vortices", none().list("strengths", vec![]), "at least one number, got none"),
        ("vibrating-lattice", chain.clone().number("atoms", 2.0), "from 3 to 16777216, got 2"),
        ("vibrating-lattice", chain.clone().number("mass", 0.0), "positive, got 0"),
        ("vibrating-lattice", chain.clone().number("stiffness", -1.0), "0 or positive, got -1"),
        ("sphere-fluid", none().number("size", 1.0), "from 2 to 2048, got 1"),
    ];
    for (kind, given, said) in parameters {
        let error = ArrayKind::named(kind).unwrap().system(&given).unwrap_err().to_string();
        assert!(error.contains(said) && error.contains(kind), "{error}");
    }
    let starts = [
        (
            "spin-lattice",
            &spins,
            none().list("S", vec![1.0; 17]),
            "array of shape [3, 2, 3], got 17",
        ),
        ("spin-lattice", &spins, none().list("S", vec![0.0; 18]), "number 1 is 0"),
        ("spin-lattice", &spins, none().list("direction", vec![0.0; 3]), "different from 0"),
        ("spin-lattice", &spins, none().list("waves", vec![1.0]), "each of 2 axes, got 1"),
        ("spin-lattice", &spins, none().number("tilt", 4.0), "from 0 to pi, got 4"),
        (
            "spin-lattice",
            &spins,
            none().number("tilt", 1.0).number("seed", 0.5),
            "a whole number from 0 to",
        ),
        (
            "vortices",
            &strengths,
            none().list("positions", vec![1.0; 3]),
            "each of 2 vortices, got 3",
        ),
        ("vortices", &strengths, none().list("positions", vec![1.0; 6]), "number 1 is 1.7"),
        (
            "vortices",
            &strengths,
            none().list("m", vec![1.0, 0.0, 0.0, 1.0, 0.0, 0.0]),
            "number 2 is 0.5",
        ),
        (
            "vibrating-lattice",
            &chain,
            none().number("tilt", 1.0).list("q", vec![1.0; 3]),
            "each of 4 atoms, got 3",
        ),
        ("spin-lattice", &spins, none(), "S must be given, or direction"),
        ("spin-lattice", &spins, none().list("waves", vec![1.0, 0.5]), "got 0.5"),
        (
            "spin-lattice",
            &spins,
            none().list("waves", vec![1.0, 0.0]),
            "cone must be larger than 0",
        ),
        (
            "spin-lattice",
            &spins,
            none().number("tillt", 0.1),
            "there is no tillt; did you mean tilt?",
        ),
        ("vortices", &strengths, none(), "positions must be given, or m"),
        ("sphere-fluid", &fluid, none(), "coefficients must be given, or vorticity"),
        ("sphere-fluid", &fluid, none().list("coefficients", vec![1.0; 3]), "rows of four numbers"),
        (
            "sphere-fluid",
            &fluid,
            none().list("coefficients", vec![0.0, 0.0, 1.0, 0.0]),
            "got l = 0",
        ),
        (
            "sphere-fluid",
            &fluid,
            none().list("coefficients", vec![2.0, 0.0, 1.0, 7.0]),
            "got im = 7",
        ),
        (
            "sphere-fluid",
            &fluid,
            none().list("degrees", vec![1.0, 2.0]).number("rms", -1.0),
            "rms must be positive, got -1",
        ),
        ("sphere-fluid", &fluid, none().list("omega", vec![1.0; 15]), "shape [4, 4], got 15"),
        (
            "sphere-fluid",
            &fluid,
            none().list("degrees", vec![1.0, 4.0]),
            "from 1 to 3, the least first, got [1.0, 4.0]",
        ),
        (
            "sphere-fluid",
            &fluid,
            none().list("coefficients", vec![1.0, 2.0, 1.0, 0.0]),
            "m from 0 to l, got l = 1, m = 2",
        ),
    ];
    for (kind, parameters, given, said) in starts {
        let error = system(kind, parameters).start_of(&given).unwrap_err().to_string();
        assert!(error.contains(said) && error.contains(kind), "{error}");
    }
    let twice = [
        ("spin-lattice", &spins, none().list("S", vec![1.0; 18]).number("tilt", 1.0), "tilt"),
        (
            "vortices",
            &strengths,
            none().list("positions", vec![1.0; 6]).number("seed", 1.0),
            "seed",
        ),
        ("sphere-fluid", &fluid, none().list("omega", vec![1.0; 16]).number("rms", 1.0), "rms"),
    ];
    for (kind, parameters, given, name) in twice {
        let error = system(kind, parameters).start_of(&given).unwrap_err().to_string();
        assert!(error.contains(&format!("{kind}: {name} must be left out beside")), "{error}");
    }
    let together = none().list("positions", vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let error = system("vortices", &strengths).start_of(&together).unwrap_err().to_string();
    assert!(error.contains("two vortices are at one place"), "{error}");
    let backward = none().list("degrees", vec![3.0, 1.0]);
    let error = system("sphere-fluid", &fluid).start_of(&backward).unwrap_err().to_string();
    assert!(error.contains("the least first, got [3.0, 1.0]"), "{error}");
    let short = none().list("waves", vec![1e300, 0.0]).number("cone", 0.1);
    let error = system("spin-lattice", &spins).start_of(&short).unwrap_err().to_string();
    assert!(error.contains("at most 1e6, got 1e300"), "{error}");
    // A field in tiny units has a direction.
    let weak = system("spin-lattice", &spins.clone().list("field", vec![0.0, 0.0, 1e-200]));
    let state = weak.start_of(&none().number("tilt", 1.0)).unwrap();
    assert!(weak.conserved(&state).values(0.0, &state).is_ok());
    let error =
        lattice(&[3.0], 1.0).method(Some(Formulation::Splitting), SchemeName::Gauss(4), 0.0);
    assert!(error.unwrap_err().to_string().ends_with("it has collective, reduced, direct"));
    assert!(Model::start(&lattice(&[3.0], 1.0), &[0.0; 8]).is_err());
}

/// States of another dimension have no value, and nothing panics.
#[test]
fn states_of_another_dimension_are_nan() {
    let systems = [
        lattice(&[3.0], 1.0),
        system("vortices", &Arguments::new().list("strengths", vec![1.0, 2.0])),
        system("vibrating-lattice", &Arguments::new().number("atoms", 3.0).number("exchange", 1.0)),
        system("sphere-fluid", &Arguments::new().number("size", 3.0)),
    ];
    for model in systems {
        for count in [0, 1, model.dimension() - 1, model.dimension() + 1] {
            let mut state = vec![0.5; count];
            assert!(model.differential(&state).iter().all(|x| x.is_nan()));
            assert!(model.fastest_rate(&state).is_nan() && model.rate(&state).is_err());
            assert!(model.conserved(&state).values(0.0, &state).is_err());
            assert!(model.on_circle(&state, 1.0, 4).is_none());
            model.present(&mut state);
            assert_eq!(state, vec![0.5; count]);
        }
    }
}

/// Vortices with strengths c k, and fluids with vorticities c ω, move as those with k and ω in 1/c of the time.
#[test]
fn vortices_and_fluids_have_no_units() {
    let vortices = |c: f64| {
        let strengths = [1.0, -0.7, 1.5].map(|k| c * k).to_vec();
        let model = system("vortices", &Arguments::new().list("strengths", strengths));
        let start = model.start_of(&Arguments::new().number("seed", 2.0)).unwrap();
        let gauss = after(&model, &start, (None, SchemeName::Gauss(4)), (0.05 / c, 20));
        let spherical = after(&model, &start, SPHERICAL, (0.05 / c, 20));
        [gauss, spherical].concat()
    };
    let fluid = |c: f64| {
        let model = system("sphere-fluid", &Arguments::new().number("size", 6.0));
        let given = Arguments::new().list("degrees", vec![1.0, 4.0]).number("rms", c);
        let start = model.start_of(&given).unwrap();
        after(&model, &start, (None, SchemeName::Gauss(2)), (0.05 / c, 20))
    };
    let atoms = |c: f64| {
        // S, q and J without units; p, m and κ by c, c and 1/c of the time.
        let given =
            Arguments::new().number("atoms", 4.0).number("mass", 1.0 / c).number("stiffness", c);
        let given = given.number("exchange", c).number("coupling", 0.5 * c);
        let model = system("vibrating-lattice", &given);
        let start = model.start_of(&Arguments::new().number("tilt", 1.0)).unwrap();
        let end = after(&model, &start, (None, SchemeName::Gauss(4)), (0.05 / c, 20));
        end[..16].iter().map(|x| c * x).collect()
    };
    let all: [&dyn Fn(f64) -> Vec<f64>; 3] = [&vortices, &fluid, &atoms];
    for motion in all {
        let expected = motion(1.0);
        for c in [1e-30, 1e30] {
            let equal = |(x, y): (&f64, &f64)| (x / c - y).abs() < 1e-12;
            assert!(motion(c).iter().zip(&expected).all(equal), "{c:e}");
        }
    }
}
