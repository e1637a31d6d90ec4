//! Many vortices on SIMD lanes and threads, against one evaluation for each pair over another scalar.

use lie_poisson_systems::collective_integrators::{Integrator, SphericalMidpoint, VectorField};
use lie_poisson_systems::lie_poisson::generic_scalars::map_coordinates;
use lie_poisson_systems::lie_poisson::{
    Covector, DualNumber, InstructionSet, MissingInstructions, Sites,
};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{ManyVortices, SystemError};
use std::f64::consts::PI;

type Points<T = f64> = Covector<Sites<Vector3<T>>>;

/// Returns vortices of both signs on a spiral of equal areas, with strengths of the given size.
fn spiral(count: usize, size: f64) -> (ManyVortices, Points) {
    let strength = |i: usize| size * if i.is_multiple_of(3) { -0.5 } else { 1.0 + 0.01 * i as f64 };
    let vortices = ManyVortices::new((0..count).map(strength).collect()).unwrap();
    let position = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (2.399963 * i as f64).sin_cos();
        Vector3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z)
    };
    let m = vortices.momentum((0..count).map(position)).unwrap();
    (vortices, m)
}

/// Returns the rates by dual numbers, which have no path on lanes.
fn by_pairs(vortices: &ManyVortices, m: &Points) -> Vec<Vector3<f64>> {
    let dual: Points<DualNumber> =
        Covector(m.0.iter().map(|m| map_coordinates(m, DualNumber::constant)).collect());
    vortices
        .at(&dual)
        .0
        .iter()
        .map(|rate| map_coordinates(rate, |x: DualNumber| x.value_without_derivative()))
        .collect()
}

/// Returns the round-off that a rate may have: a few units of each distance, and one for each partial sum.
fn round_off(vortices: &ManyVortices, m: &Points, i: usize) -> f64 {
    let x: Vec<_> = vortices.positions(m).collect();
    let others = (0..x.len()).filter(|j| *j != i);
    let term = |j: usize| {
        let distance = 1.0 - x[i].dot(&x[j]);
        m.0[j].norm() / distance * (12.0 / distance + 2.0 * x.len() as f64)
    };
    m.0[i].norm() * f64::EPSILON * others.map(term).sum::<f64>() / (4.0 * PI)
}

#[test]
fn lanes_compute_what_pairs_compute() {
    for count in [0, 1, 2, 3, 31, 32, 33, 47, 48, 49, 100] {
        let (vortices, m) = spiral(count, 1.0);
        let expected = by_pairs(&vortices, &m);
        let rates = vortices.at(&m);
        for (i, (rate, expected)) in rates.0.iter().zip(&expected).enumerate() {
            let bound = round_off(&vortices, &m, i);
            assert!((rate - expected).norm() <= bound, "{count} {i}");
            // Control: the bound does not hide a change of one strength by 1e-8.
            let mut other = vortices.strengths().to_vec();
            other[(i + 1) % count] *= 1.0 + 1e-8;
            let other = ManyVortices::new(other).unwrap();
            let changed = other.momentum(vortices.positions(&m)).unwrap();
            let apart = (by_pairs(&other, &changed)[i] - expected).norm();
            assert!(count == 1 || apart > bound, "{count} {i} {apart:e} {bound:e}");
        }
        // Few vortices keep the bits of the evaluation by pairs.
        assert!(count > 31 || rates.0[..] == expected[..], "{count}");
    }
}

/// The portable instructions round products, and the others do not.
#[test]
fn instruction_sets_differ_by_roundings() {
    let (vortices, m) = spiral(100, 1.0);
    let rates = |set| vortices.clone().with_instructions(set).unwrap().at(&m).0;
    let found: Vec<_> = InstructionSet::available().map(rates).collect();
    for rates in &found {
        for (i, (rate, portable)) in rates.iter().zip(found[0].iter()).enumerate() {
            assert!((rate - portable).norm() <= 2.0 * round_off(&vortices, &m, i), "{i}");
        }
    }
    // Those that fuse products and sums have the same bits, and not those of the portable instructions.
    assert!(found.iter().skip(2).all(|rates| *rates == found[1]));
    assert!(found.len() == 1 || found[0] != found[1]);
    let missing = InstructionSet::ALL.into_iter().find(|set| !set.is_available());
    if let Some(set) = missing {
        let refused = vortices.with_instructions(set);
        assert_eq!(refused.err(), Some(MissingInstructions { set }));
    }
}

#[test]
fn numbers_of_threads_do_not_change_bits() {
    // several tasks, the last of them incomplete
    let (vortices, start) = spiral(1003, 1.0);
    let midpoint = SphericalMidpoint::new(vortices);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let (mut m, mut space) = (start.clone(), Integrator::<f64>::workspace(&midpoint));
        pool.install(|| midpoint.step_in_place(&mut m, 1e-3, &mut space)).unwrap();
        m
    };
    let one = run(1);
    assert!(run(2) == one && run(5) == one && one != start);
}

/// Powers of two change no digit of a rate, far beyond the range of a product of three of them.
#[test]
fn units_do_not_matter() {
    let (vortices, m) = spiral(45, 1.0);
    let rates = vortices.at(&m);
    for size in [2.0_f64.powi(200), 2.0_f64.powi(-200)] {
        let (scaled, m) = spiral(45, size);
        for (a, b) in scaled.at(&m).0.iter().zip(rates.0.iter()) {
            assert_eq!(*a, b * size * size);
        }
    }
    assert!(rates.0.iter().all(|rate| rate.norm() > 0.0));
}

#[test]
fn what_is_no_number_stays_visible() {
    let (vortices, m) = spiral(40, 1.0);
    assert!(vortices.at(&m).0.iter().all(|rate| rate.norm().is_finite()));
    let mut bad = m.clone();
    bad.0[37].y = f64::NAN;
    assert!(vortices.at(&bad).0.iter().all(|rate| rate.norm().is_nan()));
    // Two vortices at one place have no rate, the others have.
    let mut positions: Vec<_> = vortices.positions(&m).collect();
    (positions[3], positions[21]) = (Vector3::x(), Vector3::x());
    let rates = vortices.at(&vortices.momentum(positions).unwrap());
    for (i, rate) in rates.0.iter().enumerate() {
        assert_eq!(rate.norm().is_finite(), i != 3 && i != 21, "{i}");
    }
    // Other numbers of vortices are refused, on both paths.
    for count in [39, 41] {
        assert!(vortices.at(&spiral(count, 1.0).1).0.iter().all(|rate| rate.norm().is_nan()));
    }
    assert!(matches!(ManyVortices::new(vec![0.0; 40]), Err(SystemError::Zero { .. })));
}

#[test]
fn storage_is_no_part_of_the_value() {
    let (vortices, m) = spiral(64, 1.0);
    let fresh = vortices.clone();
    let rates = vortices.at(&m);
    assert!(vortices == fresh && vortices.clone().at(&m) == rates);
    assert_ne!(vortices, spiral(64, 2.0).0);
}
