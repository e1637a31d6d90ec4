//! Ensembles on threads: each member has the bits of its own trajectory.

use crate::bits::lanes_of_members::{alone, bits, gauss, lifted, momenta, top};
use collective_integrators::{CHECKPOINT, Collective, Ensemble, Laned, MemberError, StepError};
use heavytop::{MidpointBatch, ReducedMidpoint, SpinorRealisation, TopMidpoint};
use lie_poisson::{
    Automatic, Covector, Energy, InstructionSet, LiePoisson, Point, Real, RealSpace, Se3Dual, So3,
    Vector, Width,
};
use momentum_map::{Cotangent, CotangentBundle, Lift, PoissonMap};
use nalgebra::Vector3;
use std::slice;
use std::sync::Mutex;

fn pool(threads: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap()
}

/// Kernels run on threads by the same call, and depend on nothing of a member but its state.
#[test]
fn kernels_are_run_by_the_same_call() {
    let members: Vec<_> = momenta(300).iter().map(|mu| (top(), *mu)).collect();
    let run = |sweep: MidpointBatch, threads| {
        let mut members = members.clone();
        members[71].1.0.0.z = f64::NAN;
        let ensemble = Ensemble::new(sweep);
        let failures = pool(threads).install(|| ensemble.advance(&mut members, 0.01, 0..50));
        assert_eq!(failures.iter().map(|failure| failure.index).collect::<Vec<_>>(), [71]);
        members.iter().map(|(_, mu)| bits(mu)).collect::<Vec<_>>()
    };
    let one = run(MidpointBatch::new(), 1);
    for threads in [2, 3, 8] {
        assert_eq!(one, run(MidpointBatch::new(), threads), "{threads}");
    }
    let integrator = TopMidpoint::new(top());
    let mut singly: Vec<_> = members.iter().map(|(_, mu)| *mu).collect();
    for mu in &mut singly {
        assert!(
            Ensemble::new(integrator.clone()).advance(slice::from_mut(mu), 0.01, 0..50).is_empty()
        );
    }
    assert_eq!(
        singly.iter().map(bits).enumerate().find(|(i, mu)| *i != 71 && mu != &one[*i]),
        None
    );
    // Negative control: without fused multiply-add other bits come out.
    let unfused = MidpointBatch::new().on(InstructionSet::Portable, Width::TwoRegisters).unwrap();
    let fused = InstructionSet::detected() != InstructionSet::Portable;
    assert_eq!(run(unfused, 1) != one, fused);
}

#[test]
#[ignore = "long"]
fn threads_do_not_matter() {
    let members = momenta(5000);
    let ensemble = Ensemble::new(Laned::new(ReducedMidpoint::new(top())));
    let run = |threads: usize| -> (Vec<Se3Dual>, Vec<MemberError>) {
        let mut members = members.clone();
        members[4321].0.0.x = f64::NAN;
        members[17].0.1.y = f64::NAN;
        let failures = pool(threads).install(|| ensemble.advance(&mut members, 0.01, 0..20));
        (members, failures)
    };
    let (one, failures) = run(1);
    let same = |a: &[Se3Dual], b: &[Se3Dual]| a.iter().map(bits).eq(b.iter().map(bits));
    for threads in [2, 3, 8] {
        let (many, same_failures) = run(threads);
        assert!(same(&one, &many) && failures.len() == 2);
        // Failures are compared as text, since the residual of a NaN is a NaN.
        assert_eq!(format!("{failures:?}"), format!("{same_failures:?}"));
    }
    assert_eq!([failures[0].index, failures[1].index], [17, 4321]);
    let start = |n: usize| match failures[n].source.source {
        StepError::NotFiniteStart { coordinate, .. } => Some(coordinate),
        _ => None,
    };
    assert_eq!([start(0), start(1)], [Some(4), Some(0)]);

    // The members are streamed, on two threads.
    let streamed = Mutex::new(vec![Se3Dual::zero(); members.len()]);
    let count = members.len() as u64;
    let start = |index: u64| match index {
        17 | 4321 => Se3Dual::basis(0).scaled(f64::NAN),
        index => members[index as usize],
    };
    pool(2).install(|| {
        ensemble.stream(count, start, 0.01, 20, |chunk| {
            let first = chunk.first as usize;
            let expected: Vec<_> = failures
                .iter()
                .map(|failure| failure.index)
                .filter(|&i| (first..first + chunk.members.len()).contains(&(i as usize)))
                .collect();
            assert!(chunk.failures.iter().map(|failure| failure.index).eq(expected));
            streamed.lock().unwrap()[first..][..chunk.members.len()].copy_from_slice(chunk.members);
        });
    });
    let mut streamed = streamed.into_inner().unwrap();
    // Negative control: a member that failed differs; it never moved.
    assert!(!same(&streamed, &one));
    for failure in &failures {
        streamed[failure.index as usize] = one[failure.index as usize];
    }
    assert!(same(&streamed, &one));
}

/// A run in calls that meet at checkpoints is the run in one call.
#[test]
fn runs_meet_at_checkpoints() {
    let ensemble = Ensemble::new(Laned::new(lifted(gauss(2))));
    let (end, lift) = (CHECKPOINT + 40, |mu: &Se3Dual| SpinorRealisation.lift(mu).unwrap());
    let run = |length: u64| {
        let mut members: Vec<_> = momenta(6).iter().map(lift).collect();
        for start in (0..end).step_by(length as usize) {
            let steps = start..end.min(start + length);
            assert!(ensemble.advance(&mut members, 0.05, steps).is_empty());
        }
        members.iter().map(bits).collect::<Vec<_>>()
    };
    assert_eq!(run(CHECKPOINT), run(end));
    // Negative control: calls that meet elsewhere lose the memory of the steps before.
    assert_ne!(run(3), run(end));
}

/// The angular momentum L = q × p of a particle, which is no top.
#[derive(Clone)]
struct AngularMomentum;
type Phase = CotangentBundle<RealSpace<3>>;

impl PoissonMap for AngularMomentum {
    type Source = Phase;
    type Target = LiePoisson<So3>;
    fn source(&self) -> Phase {
        CotangentBundle(RealSpace)
    }
    fn target(&self) -> LiePoisson<So3> {
        LiePoisson::plus(So3)
    }
    fn apply<T: Real>(&self, z: &Point<Phase, T>) -> Covector<Vector3<T>> {
        Covector(z.q.cross(&z.p.0))
    }
}

#[derive(Clone)]
struct Anisotropic;

impl Energy for Anisotropic {
    type Space = LiePoisson<So3>;
    fn energy<T: Real>(&self, Covector(l): &Covector<Vector3<T>>) -> T {
        l.x * l.x * 0.5 + l.y * l.y * l.z
    }
}

#[test]
#[ignore = "long"]
fn any_collective_system_gets_lanes_and_threads() {
    let particle = Collective::new(gauss(2), AngularMomentum, Automatic(Anisotropic));
    let start = |index: u64| {
        let x = 0.1 * (1 + index % 97) as f64;
        Cotangent::new(Vector3::new(1.0, 0.0, x), Covector(Vector3::new(0.5, 0.1 * x, 1.0)))
    };
    let members: Vec<_> = (0..300).map(start).collect();
    let (ends, ..) = alone(&particle, &members, 0.01, 0..50);
    Ensemble::new(Laned::new(particle)).stream(300, start, 0.01, 50, |chunk| {
        assert!(chunk.failures.is_empty());
        for (index, z) in (chunk.first..).zip(chunk.members) {
            assert_eq!(bits(z), ends[index as usize]);
        }
    });
}
