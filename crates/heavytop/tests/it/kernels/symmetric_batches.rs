//! Symmetric tops on SIMD lanes (several trajectories in one register): each as if it were alone.

use crate::kernels::top_ensembles::{COUNT, bits, difference, members, no_failure, starts, tops};
use collective_integrators::*;
use heavytop::*;
use lie_poisson::*;
use nalgebra::Vector3;

fn sets() -> [AlternatingSubsteps; 4] {
    [
        AlternatingSubsteps::blanes_moan4(),
        AlternatingSubsteps::blanes_moan6(),
        AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10()),
        AlternatingSubsteps::new(&[0.5, 0.5], &[0.25, 0.75]).unwrap(), // no neighbours to merge
    ]
}

fn one_by_one(substeps: &AlternatingSubsteps, step: f64, steps: usize) -> Vec<Se3Dual> {
    let tops = tops();
    let end = |(i, z): (usize, Se3Dual)| {
        let integrator = Splitting::alternating(tops[i % tops.len()], substeps.clone());
        (0..steps).fold(z, |z, _| integrator.step(&z, step, &mut Default::default()).unwrap().point)
    };
    starts().into_iter().enumerate().map(end).collect()
}

#[test]
fn symmetric_tops_move_as_one_by_one() {
    for substeps in sets() {
        let (step, steps) = (0.1, 50);
        let expected = one_by_one(&substeps, step, steps);
        for set in InstructionSet::available() {
            let ensemble = SymmetricTopBatch::new(substeps.clone());
            let ensemble = ensemble.on(set, Width::TwoRegisters).unwrap();
            let mut states = members(&tops());
            ensemble.advance(&mut states, step, 0..steps as u64, &mut (), &mut no_failure);
            for ((_, state), expected) in states.iter().zip(&expected) {
                // 50 steps of up to 35 stages have some rounding errors of numbers up to 3 in each, unbiased, and the
                // motion doubles them a few times; 2e-14 was measured.
                assert!(difference(state, expected) < 2e-13, "{set}");
            }
            // Negative control: a neighbouring top ends elsewhere.
            assert!(difference(&states[0].1, &expected[1]) > 1e-3);
        }
    }
}

#[test]
fn bits_depend_on_fusion_alone() {
    let substeps = AlternatingSubsteps::blanes_moan6();
    let ensemble = SymmetricTopBatch::new(substeps.clone());
    let run = |set, width| {
        let mut states = members(&tops());
        let ensemble = ensemble.clone().on(set, width).unwrap();
        ensemble.advance(&mut states, 0.1, 0..20, &mut (), &mut no_failure);
        bits(&states)
    };
    let mut fused = None;
    for set in InstructionSet::available() {
        for width in Width::ALL {
            let found = run(set, width);
            if set == InstructionSet::Portable {
                assert_eq!(found, run(set, Width::Single));
            } else {
                let first = fused.get_or_insert_with(|| found.clone());
                assert_eq!(&found, first, "{set}, {width:?}");
                // Negative control: another rounding gives other bits.
                assert_ne!(found, run(InstructionSet::Portable, width));
            }
        }
    }
}

/// A member that is not a number is reported in each position, and the others are not affected.
#[test]
fn a_top_that_is_not_a_number_harms_no_other() {
    let substeps = AlternatingSubsteps::blanes_moan4();
    let ensemble = SymmetricTopBatch::new(substeps.clone());
    let mut healthy = members(&tops());
    ensemble.advance(&mut healthy, 0.1, 0..10, &mut (), &mut no_failure);
    for position in 0..COUNT {
        let mut states = members(&tops());
        states[position].1.0.0.y = f64::NAN;
        let mut failures = Vec::new();
        ensemble
            .advance(&mut states, 0.1, 0..10, &mut (), &mut |i, error| failures.push((i, error)));
        let [(failed, error)] = failures[..] else { panic!("{failures:?}") };
        assert_eq!((failed, error.step, error.time), (position, 1, 0.0));
        let start = matches!(error.source, StepError::NotFiniteStart { coordinate: 1, .. });
        assert!(start, "{error:?}");
        assert!(states[position].1.0.0.y.is_nan() && states[position].1.0.0.x.is_finite());
        states[position] = healthy[position];
        assert_eq!(bits(&states), bits(&healthy), "{position}");
    }
}

#[test]
fn a_top_that_turns_too_fast_goes_alone() {
    let substeps = AlternatingSubsteps::blanes_moan4();
    let flows = tops()[0];
    let mut states = members(&[flows]);
    states[5].1.0.0 = Vector3::new(3.0, 200.0, 100.0);
    let alone = Splitting::alternating(flows, substeps.clone());
    let expected = (0..10)
        .fold(states[5].1, |z, _| alone.step(&z, 0.1, &mut Default::default()).unwrap().point);
    let ensemble = SymmetricTopBatch::new(substeps);
    ensemble.advance(&mut states, 0.1, 0..10, &mut (), &mut no_failure);
    assert_eq!(bits(&states[5..6]), bits(&[(flows, expected)]));
}

/// Squares of Π beyond the numbers, with and without fused multiply-add: the top goes alone, with the same end or error, and
/// harms no other.
#[test]
fn a_top_whose_square_overflows_goes_alone() {
    let substeps = AlternatingSubsteps::blanes_moan4();
    let sphere = HeavyTop::lagrange(1.0, 1.0, 1.0).unwrap();
    for top in [HeavyTop::kovalevskaya(1.0, 1.0).unwrap(), sphere] {
        let flows = SymmetricTopSplitting::new(top).unwrap();
        let alone = Splitting::alternating(flows, substeps.clone());
        for momentum in [1e150, 1e160, 1e300] {
            let start = Se3Dual::new(Vector3::z() * momentum, Vector3::x());
            let mut expected = Ok(start);
            for _ in 0..3 {
                expected = expected
                    .and_then(|z| alone.step(&z, 0.1, &mut Default::default()))
                    .map(|step| step.point);
            }
            for set in InstructionSet::available() {
                let batch = SymmetricTopBatch::new(substeps.clone());
                let batch = batch.on(set, Width::TwoRegisters).unwrap();
                let mut states = members(&[flows]);
                let mut others = states.clone();
                states[3].1 = start;
                let mut failed = Vec::new();
                batch.advance(&mut states, 0.1, 0..3, &mut (), &mut |i, _| failed.push(i));
                batch.advance(&mut others, 0.1, 0..3, &mut (), &mut no_failure);
                match &expected {
                    Ok(end) => assert_eq!(bits(&states[3..4]), bits(&[(flows, *end)]), "{set}"),
                    Err(_) => assert_eq!(failed, [3], "{set} {momentum:e}"),
                }
                states.remove(3);
                others.remove(3);
                assert_eq!(bits(&states), bits(&others), "{set} {momentum:e}");
            }
        }
    }
}

#[test]
fn casimirs_of_symmetric_tops_hold_to_round_off() {
    let casimirs = |z: &Se3Dual| [z.0.1.norm_squared(), z.0.0.dot(&z.0.1)];
    let ensemble = SymmetricTopBatch::new(AlternatingSubsteps::blanes_moan6());
    let mut states = members(&tops());
    ensemble.advance(&mut states, 0.1, 0..2000, &mut (), &mut no_failure);
    for ((_, end), start) in states.iter().zip(&starts()) {
        for (end, start) in casimirs(end).iter().zip(casimirs(start)) {
            // 2000 steps of 14 stages have unbiased rounding errors of some 1e-16 each: 5e-14 in sum.
            assert!((end - start).abs() < 2e-13, "{:e}", end - start);
        }
    }
}

/// Over many tops rounding errors are unbiased: the flows of a step turn, and do not stretch.
///
/// Long steps of Yoshida's method show it best: the angles of its three flows differ most.
#[test]
#[ignore = "long"]
fn casimirs_of_symmetric_tops_walk_and_do_not_drift() {
    let yoshida = AlternatingSubsteps::composed(&Substeps::yoshida4());
    // Lagrange's top turns about its axis by the same angle in all steps, with the same rounding errors of its sine.
    let lagrange = HeavyTop::lagrange(2.0, 1.3, 1.0).unwrap();
    let slower = HeavyTop::lagrange(2.0, 3.0, 2.0).unwrap();
    let kovalevskaya = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let every: Vec<_> = InstructionSet::available().collect();
    let widest = &every[every.len() - 1..];
    for (top, substeps, step, stages, sets) in [
        (kovalevskaya, AlternatingSubsteps::blanes_moan6(), 0.25, 14.0, widest),
        (lagrange, AlternatingSubsteps::blanes_moan6(), 0.25, 14.0, &every[..]),
        (slower, yoshida, 0.2, 3.0, widest),
    ] {
        let flows = SymmetricTopSplitting::new(top).unwrap();
        let start = |i: u32| {
            let x = f64::from(i) / 64.0;
            let gamma = Vector3::new((7.0 * x).cos(), x - 0.5, (7.0 * x).sin()).normalize();
            (flows, Se3Dual::new(Vector3::new(2.0 + x, 3.5 - x, 3.5 + x * x), gamma))
        };
        let starts: Vec<_> = (0..64).map(start).collect();
        for &set in sets {
            casimirs_walk(&substeps, set, &starts, (step, stages));
        }
    }
}

fn casimirs_walk(
    substeps: &AlternatingSubsteps,
    set: InstructionSet,
    starts: &[(SymmetricTopSplitting, Se3Dual)],
    (step, stages): (f64, f64),
) {
    let batch = SymmetricTopBatch::new(substeps.clone()).on(set, Width::TwoRegisters).unwrap();
    let mut states = starts.to_vec();
    batch.advance(&mut states, step, 0..65_536, &mut (), &mut no_failure);
    let change = |casimir: fn(&Se3Dual) -> f64| -> Vec<f64> {
        let pairs = states.iter().zip(starts);
        pairs.map(|((_, end), (_, start))| casimir(end) - casimir(start)).collect()
    };
    let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
    let length = change(|z| z.0.1.norm_squared());
    // The length of a random walk of one rounding error per stage; the mean of 64 walks is an eighth of it.
    let walk = f64::EPSILON / 2.0 * (65_536.0 * stages).sqrt();
    // With the coefficients of the versine rounded one by one, the mean was 6 walks for Blanes–Moan 6. With errors that
    // balanced each other within a step it was 20 walks for Yoshida's method.
    assert!(mean(&length).abs() < 0.75 * walk, "{set}: {:e}", mean(&length));
    assert!(length.iter().any(|x| x.abs() > 0.2 * walk)); // something was measured
    // No top drifts by itself. With a matrix of the cosine and the sine a top of Lagrange's did by up to 200 walks, and
    // with the same rounding error of w₃² in all steps by up to 90.
    let largest = length.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    assert!(largest < 8.0 * walk, "{set}: {largest:e}");
    // Γ·Π is restored within each of the 64 segments of 1024 steps, and walks only from one segment to the next:
    // 3e-14. Without that it was 4e-13.
    let vertical = change(|z| z.0.0.dot(&z.0.1));
    let largest = vertical.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    assert!(largest < 2e-13 && mean(&vertical).abs() < 2e-14, "{set}: {:e}", mean(&vertical));
}

/// Slow tops, fast ones, and some too fast for the lanes do not affect each other.
#[test]
fn tops_of_different_speed_do_not_notice_each_other() {
    let ensemble = SymmetricTopBatch::new(AlternatingSubsteps::blanes_moan6());
    let advance = |members: &mut [(SymmetricTopSplitting, Se3Dual)]| {
        ensemble.advance(members, 0.25, 0..20, &mut (), &mut no_failure);
    };
    let mut members = members(&tops());
    for (i, (_, z)) in members.iter_mut().enumerate() {
        z.0.0 *= [0.1, 1.0, 4.0, 12.0, 30.0][i % 5];
    }
    let mut together = members.clone();
    advance(&mut together);
    for (i, member) in members.iter().enumerate() {
        let mut alone = [*member];
        advance(&mut alone);
        assert_eq!(bits(&alone), bits(&together[i..=i]), "{i}");
        // Negative control: the top did move.
        assert_ne!(bits(&alone), bits(&members[i..=i]));
    }
}

#[test]
fn orders_of_the_symmetric_batch() {
    let flows = tops();
    let (time, count) = (2.0, 5);
    let error = |substeps: &AlternatingSubsteps, steps: u32| {
        let mut worst = 0.0;
        let ensemble = SymmetricTopBatch::new(substeps.clone());
        let mut states = members(&flows)[..count].to_vec();
        let step = time / f64::from(steps);
        ensemble.advance(&mut states, step, 0..u64::from(steps), &mut (), &mut no_failure);
        for (i, ((_, state), start)) in states.iter().zip(starts()).enumerate() {
            let field = HamiltonianField {
                space: LiePoisson::minus(Se3::default()),
                hamiltonian: *flows[i].top(),
            };
            let exact = Direct::new(RungeKutta::gauss(8).unwrap(), field);
            let mut workspace = exact.workspace();
            let advance = |z, _| exact.step(&z, 0.1, &mut workspace).unwrap().point;
            worst = larger(worst, difference(state, &(0..20).fold(start, advance)));
        }
        (step, worst)
    };
    let fit = |substeps: &AlternatingSubsteps, counts: &[u32]| {
        let errors: Vec<(f64, f64)> = counts.iter().map(|&n| error(substeps, n)).collect();
        fitted_order(&errors, 1e-13).unwrap()
    };
    let [four, six, ten, _] = sets();
    for (substeps, order, counts) in
        [(&four, 4.0, [20, 30, 40, 60]), (&six, 6.0, [6, 8, 12, 16]), (&ten, 10.0, [5, 6, 7, 8])]
    {
        let found = fit(substeps, &counts);
        // Long steps show an order of 10.6 for order 10; the errors of shorter steps are hidden by round-off.
        assert!((-0.4..0.8).contains(&(found - order)), "{found} instead of {order}");
    }
    // Negative control: one coefficient is moved by 1e-3, and another so that the sum holds.
    let mut wrong = six.first().to_vec();
    wrong[1] += 1e-3;
    wrong[2] -= 1e-3;
    let wrong = AlternatingSubsteps::new(&wrong, six.second()).unwrap();
    assert!(fit(&wrong, &[6, 8, 12, 16]) < 3.0);
}
