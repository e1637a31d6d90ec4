//! Collective Gauss methods for many tops on SIMD lanes (several trajectories in one register).

use crate::kernels::top_ensembles::{
    COUNT, any_tops, bits, difference, members, no_failure, starts,
};
use collective_integrators::*;
use heavytop::*;
use lie_poisson::*;
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

fn gauss_moves_as_lift_free<const S: usize>(step: f64) {
    let tops = any_tops();
    let steps = 40;
    let end = |(i, z): (usize, Se3Dual)| {
        let scheme = RungeKutta::gauss(S).unwrap();
        let integrator = LiftFree::new(scheme, DualQuaternions, tops[i % tops.len()]);
        let mut workspace = integrator.workspace();
        (0..steps).fold(z, |z, _| integrator.step(&z, step, &mut workspace).unwrap().point)
    };
    let expected: Vec<Se3Dual> = starts().into_iter().enumerate().map(end).collect();
    for set in InstructionSet::available() {
        let ensemble = GaussBatch::<S>::new().unwrap().on(set, Width::Register).unwrap();
        let mut states = members(&tops);
        ensemble.advance(&mut states, step, 0..steps, &mut (), &mut no_failure);
        for ((_, state), expected) in states.iter().zip(&expected) {
            // 40 steps have some rounding errors of numbers up to 10 on T∗C² in each, 2e-15; the motion multiplies
            // them, to up to 3.6e-13 at t = 12.
            assert!(difference(state, expected) < 1e-12, "{S}: {:e}", difference(state, expected));
        }
        // Negative control: a neighbouring top ends elsewhere.
        assert!(difference(&states[0].1, &expected[1]) > 1e-3);
    }
}

#[test]
fn gauss_batches_move_as_without_a_lift() {
    gauss_moves_as_lift_free::<4>(0.1);
    gauss_moves_as_lift_free::<6>(0.2);
    gauss_moves_as_lift_free::<8>(0.3);
}

#[test]
fn bits_of_gauss_batches_depend_on_fusion_alone() {
    let ensemble = GaussBatch::<4>::new().unwrap();
    let run = |set, width| {
        let mut states = members(&any_tops());
        let ensemble = ensemble.clone().on(set, width).unwrap();
        ensemble.advance(&mut states, 0.2, 0..10, &mut (), &mut no_failure);
        bits(&states)
    };
    for set in InstructionSet::available() {
        let single = run(set, Width::Single);
        for width in Width::ALL {
            assert_eq!(single, run(set, width), "{set}, {width:?}");
        }
        // Negative control: where fused operations differ, so do bits.
        let widest = InstructionSet::detected();
        let alike = (set == InstructionSet::Portable) == (widest == InstructionSet::Portable);
        assert_eq!(single == run(widest, Width::Register), alike, "{set}");
    }
}

/// A member without a result is reported in each position, the general integrator takes over what the lanes cannot
/// compute, and the others are not affected.
#[test]
fn no_top_of_a_gauss_batch_harms_another() {
    let tops = any_tops();
    let ensemble = GaussBatch::<4>::new().unwrap();
    let mut healthy = members(&tops);
    ensemble.advance(&mut healthy, 0.2, 0..5, &mut (), &mut no_failure);
    let count = |start: Se3Dual, position: usize| {
        let mut states = members(&tops);
        states[position].1 = start;
        let mut failures = Vec::new();
        ensemble.advance(&mut states, 0.2, 0..5, &mut (), &mut |i, error| {
            failures.push((i, error.step))
        });
        let end = core::mem::replace(&mut states[position], healthy[position]).1;
        assert_eq!(bits(&states), bits(&healthy), "{position}");
        (failures, end)
    };
    for position in 0..COUNT {
        let mut nan = starts()[position];
        nan.0.0.y = f64::NAN;
        assert_eq!(count(nan, position).0, [(position, 1)]);
        // Without the vertical there is no lift: the general integrator takes over the free rigid body.
        let free = Se3Dual::new(starts()[position].0.0, Vector3::zeros());
        let (failures, end) = count(free, position);
        assert!(failures.is_empty() && end.0.1 == Vector3::zeros() && end != free);
    }
    // A body is too fast for fixed-point sweeps, though not for Newton's iteration.
    let fast = Se3Dual::new(Vector3::new(8.0, 9.0, 10.0), Vector3::z());
    let (failures, end) = count(fast, 3);
    let scheme = RungeKutta::gauss(4).unwrap();
    let alone = LiftFree::new(scheme, DualQuaternions, tops[3]);
    let mut workspace = alone.workspace();
    let expected = (0..5).fold(fast, |z, _| alone.step(&z, 0.2, &mut workspace).unwrap().point);
    assert!(failures.is_empty() && difference(&end, &expected) < 1e-12);
}

#[test]
fn casimirs_of_gauss_batches_hold_to_round_off() {
    let casimirs = |z: &Se3Dual| [z.0.1.norm_squared(), z.0.0.dot(&z.0.1)];
    let ensemble = GaussBatch::<6>::new().unwrap();
    let mut states = members(&any_tops());
    ensemble.advance(&mut states, 0.2, 0..2000, &mut (), &mut no_failure);
    for ((_, end), start) in states.iter().zip(&starts()) {
        for (end, start) in casimirs(end).iter().zip(casimirs(start)) {
            // ‖ψ‖² and Im ψ∗χ are restored at each step: only the last step and M have rounding errors.
            assert!((end - start).abs() < 1e-14, "{:e}", end - start);
        }
    }
}

#[test]
fn orders_of_gauss_batches() {
    fn errors<const S: usize>(counts: &[u64]) -> f64 {
        let top = any_tops()[1];
        let end = |steps: u64, s8: bool| {
            let mut states = [(top, starts()[20])];
            let step = 2.0 / steps as f64;
            if s8 {
                let ensemble = GaussBatch::<8>::new().unwrap();
                ensemble.advance(&mut states, step, 0..steps, &mut (), &mut no_failure);
            } else {
                let ensemble = GaussBatch::<S>::new().unwrap();
                ensemble.advance(&mut states, step, 0..steps, &mut (), &mut no_failure);
            }
            states[0].1
        };
        let exact = end(20, true);
        let point = |&n: &u64| (2.0 / n as f64, difference(&end(n, false), &exact));
        fitted_order(&counts.iter().map(point).collect::<Vec<_>>(), 1e-13).unwrap()
    }
    let (four, eight) = (errors::<2>(&[20, 30, 40, 60]), errors::<4>(&[6, 8, 10, 14]));
    assert!((four - 4.0).abs() < 0.3 && (eight - 8.0).abs() < 0.5, "{four} {eight}");
}
