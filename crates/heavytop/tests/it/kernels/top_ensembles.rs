//! Ensembles on SIMD lanes (several trajectories in one register): each member as if it were alone.

use collective_integrators::*;
use heavytop::*;
use lie_poisson::*;
use nalgebra::Vector3;

/// The number of members: more than two groups of sixteen, and no multiple of any number of lanes.
pub(crate) const COUNT: usize = 37;

pub(crate) fn starts() -> Vec<Se3Dual> {
    let start = |i: usize| {
        let x = i as f64 / COUNT as f64;
        Se3Dual::new(
            Vector3::new(2.0 - x, 0.5 + 2.0 * x, 3.0 * x - 1.0),
            Vector3::new(0.6, -0.8 * x, 0.8 - x),
        )
    };
    (0..COUNT).map(start).collect()
}

/// Returns the tops by turns, each with its start.
pub(crate) fn members<B: Copy>(tops: &[B]) -> Vec<(B, Se3Dual)> {
    tops.iter().copied().cycle().zip(starts()).collect()
}

pub(crate) fn no_failure(index: usize, error: IntegrationError) {
    panic!("{index}: {error}");
}

pub(crate) fn difference(a: &Se3Dual, b: &Se3Dual) -> f64 {
    let Covector(Pair(pi, gamma)) = *a - *b;
    larger(pi.amax(), gamma.amax())
}

pub(crate) fn bits<B>(members: &[(B, Se3Dual)]) -> Vec<[u64; 6]> {
    let coordinates = |z: &Se3Dual| [z.0.0.x, z.0.0.y, z.0.0.z, z.0.1.x, z.0.1.y, z.0.1.z];
    members.iter().map(|(_, z)| coordinates(z).map(f64::to_bits)).collect()
}

/// Tops that differ in every parameter, symmetric about e₃.
pub(crate) fn tops() -> Vec<SymmetricTopSplitting> {
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

/// Returns tops without symmetry that differ in every parameter.
pub(crate) fn any_tops() -> Vec<HeavyTop> {
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
