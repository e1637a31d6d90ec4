//! Ensembles on SIMD lanes (several trajectories in one register): each member as if it were alone.

use collective_integrators::*;
use heavytop::*;
use lie_poisson::*;
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

/// Tops that differ in every parameter, symmetric about e₃.
fn tops() -> Vec<SymmetricTopSplitting> {
    let top = |i: usize| {
        let x = i as f64 / 7.0;
        let body = Body {
            inertia: Vector3::new(1.5 + x, 1.5 + x, 1.0 + 0.5 * x),
            mass: 1.0,
            gravity: 1.0 + x,
            length: 0.6,
            center_of_mass: Vector3::new(0.6, 0.48 - x, 0.64 + x).normalize(),
        };
        SymmetricTopSplitting::new(HeavyTop::new(&body).unwrap()).unwrap()
    };
    (0..7).map(top).collect()
}

/// The number of members: more than two groups of sixteen, and no multiple of any number of lanes.
const COUNT: usize = 37;

fn starts() -> Vec<Se3Dual> {
    let start = |i: usize| {
        let x = i as f64 / COUNT as f64;
        Se3Dual::new(
            Vector3::new(2.0 - x, 0.5 + 2.0 * x, 3.0 * x - 1.0),
            Vector3::new(0.6, -0.8 * x, 0.8 - x),
        )
    };
    (0..COUNT).map(start).collect()
}

fn sets() -> [AlternatingSubsteps; 4] {
    [
        AlternatingSubsteps::blanes_moan4(),
        AlternatingSubsteps::blanes_moan6(),
        AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10()),
        AlternatingSubsteps::new(&[0.5, 0.5], &[0.25, 0.75]).unwrap(), // no neighbours to merge
    ]
}

/// Returns the tops by turns, each with its start.
fn members<B: Copy>(tops: &[B]) -> Vec<(B, Se3Dual)> {
    tops.iter().copied().cycle().zip(starts()).collect()
}

fn no_failure(index: usize, error: IntegrationError) {
    panic!("{index}: {error}");
}

fn difference(a: &Se3Dual, b: &Se3Dual) -> f64 {
    let Covector(Pair(pi, gamma)) = *a - *b;
    larger(pi.amax(), gamma.amax())
}

fn one_by_one(substeps: &AlternatingSubsteps, step: f64, steps: usize) -> Vec<Se3Dual> {
    let tops = tops();
    let end = |(i, z): (usize, Se3Dual)| {
        let integrator = Splitting::alternating(tops[i % tops.len()], substeps.clone());
        (0..steps).fold(z, |z, _| integrator.step(&z, step, &mut ()).unwrap().point)
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

fn bits<B>(members: &[(B, Se3Dual)]) -> Vec<[u64; 6]> {
    let coordinates = |z: &Se3Dual| [z.0.0.x, z.0.0.y, z.0.0.z, z.0.1.x, z.0.1.y, z.0.1.z];
    members.iter().map(|(_, z)| coordinates(z).map(f64::to_bits)).collect()
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
    let expected = (0..10).fold(states[5].1, |z, _| alone.step(&z, 0.1, &mut ()).unwrap().point);
    let ensemble = SymmetricTopBatch::new(substeps);
    ensemble.advance(&mut states, 0.1, 0..10, &mut (), &mut no_failure);
    assert_eq!(bits(&states[5..6]), bits(&[(flows, expected)]));
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
#[test]
fn casimirs_of_symmetric_tops_walk_and_do_not_drift() {
    let flows = SymmetricTopSplitting::new(HeavyTop::kovalevskaya(1.0, 1.0).unwrap()).unwrap();
    let start = |i: u32| {
        let x = f64::from(i) / 64.0;
        let gamma = Vector3::new((7.0 * x).cos(), x - 0.5, (7.0 * x).sin()).normalize();
        (flows, Se3Dual::new(Vector3::new(2.0 + x, 3.5 - x, 3.5 + x * x), gamma))
    };
    let starts: Vec<_> = (0..64).map(start).collect();
    for set in InstructionSet::available() {
        casimirs_walk(&starts, set);
    }
}

fn casimirs_walk(starts: &[(SymmetricTopSplitting, Se3Dual)], set: InstructionSet) {
    let mut states = starts.to_vec();
    let ensemble = SymmetricTopBatch::new(AlternatingSubsteps::blanes_moan6());
    let ensemble = ensemble.on(set, Width::TwoRegisters).unwrap();
    ensemble.advance(&mut states, 0.25, 0..65_536, &mut (), &mut no_failure);
    let change = |casimir: fn(&Se3Dual) -> f64| -> Vec<f64> {
        let pairs = states.iter().zip(starts);
        pairs.map(|((_, end), (_, start))| casimir(end) - casimir(start)).collect()
    };
    let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
    let length = change(|z| z.0.1.norm_squared());
    // A random walk of 9·10⁵ stages is 1.3e-13 long, so that the mean of 64 walks is 1.6e-14. With the coefficients
    // of the cosine rounded to nearest the mean was 6e-13.
    assert!(mean(&length).abs() < 8e-14, "{set}: {:e}", mean(&length));
    assert!(length.iter().any(|x| x.abs() > 2e-14)); // something was measured
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

/// Returns tops without symmetry that differ in every parameter.
fn any_tops() -> Vec<HeavyTop> {
    let top = |i: usize| {
        let x = i as f64 / 10.0;
        let body = Body {
            inertia: Vector3::new(1.5 + x, 1.2 - x, 1.0 + 0.5 * x),
            mass: 1.0,
            gravity: 1.0 + x,
            length: 0.6,
            center_of_mass: Vector3::new(0.6, 0.48 - x, 0.64 + x).normalize(),
        };
        HeavyTop::new(&body).unwrap()
    };
    (0..5).map(top).collect()
}

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

/// A run in two calls equals the run in one, with a member that fails on the way.
#[test]
fn calls_that_meet_at_checkpoints_are_one_run() {
    let ensemble = GaussBatch::<2>::new().unwrap();
    let mut whole = members(&any_tops());
    let mut failures = Vec::new();
    // This member turns too far in one step for any iteration, and is not tried again.
    whole[7].1.0.0 *= 1e150;
    let start = whole[7].1;
    let mut parts = whole.clone();
    let end = CHECKPOINT + 5;
    ensemble
        .advance(&mut whole, 0.1, 0..end, &mut (), &mut |i, error| failures.push((i, error.step)));
    assert_eq!((failures.as_slice(), whole[7].1), (&[(7, 1)][..], start));
    for steps in [0..CHECKPOINT, CHECKPOINT..end] {
        ensemble.advance(&mut parts, 0.1, steps, &mut (), &mut |_, _| ());
    }
    assert_eq!(bits(&whole), bits(&parts));
    // Negative control: calls that meet elsewhere give other bits.
    let mut parts = members(&any_tops());
    for steps in [0..10, 10..end] {
        ensemble.advance(&mut parts, 0.1, steps, &mut (), &mut no_failure);
    }
    assert_ne!(bits(&whole[..7]), bits(&parts[..7]));
}

/// Two of three members have no result, and each is reported once; the run crosses a checkpoint, where all of the
/// others restart.
fn of_many_failures_each_is_reported_once<K, B>(ensemble: &K, tops: &[B])
where
    K: BatchIntegrator<Member = (B, Se3Dual)>,
    B: Copy,
{
    let cycle = || tops.iter().copied().cycle().zip(starts().into_iter().cycle());
    let run = |spoilt: &dyn Fn(usize) -> bool| {
        let mut states: Vec<(B, Se3Dual)> = cycle().take(600).collect();
        for (_, (_, start)) in states.iter_mut().enumerate().filter(|&(i, _)| spoilt(i)) {
            start.0.0.y = f64::NAN;
        }
        let mut failures = Vec::new();
        let steps = CHECKPOINT - 2..CHECKPOINT + 2;
        let mut workspace = ensemble.workspace();
        ensemble.advance(&mut states, 0.1, steps, &mut workspace, &mut |i, error| {
            failures.push((i, error.step))
        });
        failures.sort_unstable();
        (failures, bits(&states))
    };
    let spoilt = |i: usize| !i.is_multiple_of(3);
    let (failures, ends) = run(&spoilt);
    let expected: Vec<_> = (0..600).filter(|&i| spoilt(i)).map(|i| (i, CHECKPOINT - 1)).collect();
    assert_eq!(failures, expected);
    let (none, healthy) = run(&|_| false);
    assert_eq!(none, []);
    for (i, (end, healthy)) in ends.iter().zip(&healthy).enumerate() {
        // Negative control: a failed member did not move, and has other bits than a healthy one.
        assert_eq!(end != healthy, spoilt(i), "{i}");
    }
}

#[test]
fn many_failures_are_reported_once() {
    let gauss = GaussBatch::<2>::new().unwrap();
    of_many_failures_each_is_reported_once(&gauss, &any_tops());
    let splitting = SymmetricTopBatch::new(AlternatingSubsteps::blanes_moan4());
    of_many_failures_each_is_reported_once(&splitting, &tops());
}
