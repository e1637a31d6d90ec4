//! Many members at once: each has the bits of its own trajectory.

use collective_integrators::{
    Alternating, BatchIntegrator, CHECKPOINT, Collective, Compensated, Composition, Direct,
    Ensemble, HamiltonianField, Integrator, Laned, LanedOver, LiftFree, MemberError,
    PartitionedRungeKutta, RungeKutta, StageSolver, Start, StepError, Substeps, VectorField,
};
use heavytop::{
    HeavyTop, HeavyTopSpace, MidpointBatch, ReducedMidpoint, SpinorRealisation, TopMidpoint,
};
use lie_poisson::{
    Automatic, Covector, Energy, InstructionSet, LaneTask, Lanes, LiePoisson, Pair, Point, Real,
    RealSpace, Se3, Se3Dual, So3, Vector, Width, dispatch,
};
use momentum_map::{Cotangent, CotangentBundle, DualQuaternions, Lift, PoissonMap};
use nalgebra::{Vector1, Vector3};
use std::collections::BTreeSet;
use std::slice;
use std::sync::Mutex;
use workspace_tests::tops;

/// Returns tops from fast to slow, near rest and far from it, so that their iterations differ.
fn momenta(count: usize) -> Vec<Se3Dual> {
    let x = [1.2, -0.7, 2.3, 0.4, 0.8, -0.5];
    let speed = |n: usize| [0.01, 0.3, 1.0, 2.0, 0.1][n % 5] * (1.0 + 1e-3 * n as f64);
    let momentum = |n: usize| {
        Se3Dual::from_coordinates(|i| x[(i + n) % 6] * if i < 3 { speed(n) } else { 1.0 })
    };
    (0..count).map(momentum).collect()
}

fn bits<V: Vector<Scalar = f64>>(v: &V) -> Vec<u64> {
    (0..V::DIM).map(|i| v.coordinate(i).to_bits()).collect()
}

type State<I> = <I as Integrator<f64>>::State;
type Failures = Vec<(usize, u64)>;

/// Returns the bits of all members after some steps over the SIMD lanes T, and which member failed at which step.
fn advanced<I, T>(integrator: I, members: &[State<I>], h: f64, n: u64) -> (Vec<Vec<u64>>, Failures)
where
    I: Integrator<f64, State: Vector> + Integrator<T, State: Vector> + Sync,
    T: Lanes,
{
    ends(&LanedOver::<I, T>::new(integrator), members, h, n)
}

/// Returns the same in the registers of an instruction set.
fn in_registers<I>(
    integrator: I,
    set: InstructionSet,
    members: &[State<I>],
    h: f64,
    n: u64,
) -> (Vec<Vec<u64>>, Failures)
where
    I: Integrator<f64, State: Vector>,
    Laned<I>: BatchIntegrator<Member = State<I>>,
{
    ends(&Laned::new(integrator).with_instructions(set).unwrap(), members, h, n)
}

fn ends<B>(batch: &B, members: &[B::Member], h: f64, n: u64) -> (Vec<Vec<u64>>, Failures)
where
    B: BatchIntegrator<Member: Vector<Scalar = f64>>,
{
    let (mut members, mut failures) = (members.to_vec(), Vec::new());
    let mut failed = |i, error: collective_integrators::IntegrationError| {
        failures.push((i, error.step));
    };
    batch.advance(&mut members, h, 0..n, &mut batch.workspace(), &mut failed);
    failures.sort_unstable();
    (members.iter().map(bits).collect(), failures)
}

/// Returns the same by trajectories, and all numbers of iterations that occurred.
fn alone<I>(
    integrator: &I,
    members: &[State<I>],
    h: f64,
    n: u64,
) -> (Vec<Vec<u64>>, Failures, BTreeSet<usize>)
where
    I: Integrator<f64, State: Vector>,
{
    let (mut ends, mut failures, mut iterations) = (Vec::new(), Vec::new(), BTreeSet::new());
    for (i, member) in members.iter().enumerate() {
        let mut end = *member;
        for sample in integrator.trajectory_from(*member, h).take(n as usize + 1) {
            match sample {
                Ok(sample) => {
                    end = sample.state;
                    if sample.step > 0 {
                        iterations.insert(sample.iterations);
                    }
                }
                Err(error) => {
                    failures.push((i, error.step));
                    break;
                }
            }
        }
        ends.push(bits(&end));
    }
    (ends, failures, iterations)
}

/// Tests that an integrator of tops returns the bits of its trajectories in all lanes of all widths
/// that this processor has; `$differing` says whether members must differ in their iterations, the
/// negative control.
macro_rules! same_bits_at_every_width {
    ($($name:ident: $type:ty = $integrator:expr, $h:expr, $steps:expr, $differing:expr;)*) => {$(
        #[test]
        fn $name() {
            struct Task<'a>(&'a $type, &'a [State<$type>]);
            impl LaneTask for Task<'_> {
                type Output = (Vec<Vec<u64>>, Failures);
                fn run<T: Lanes>(self) -> Self::Output {
                    advanced::<$type, T>(self.0.clone(), self.1, $h, $steps)
                }
            }
            let integrator: $type = $integrator;
            let start = |mu: &Se3Dual| Start::<f64>::start(&integrator, mu).unwrap();
            let members: Vec<_> = momenta(21).iter().map(start).collect();
            let (ends, failures, iterations) = alone(&integrator, &members, $h, $steps);
            assert_eq!(iterations.len() > 1, $differing, "{iterations:?}");
            // Some members do not fail.
            assert!(failures.len() < members.len() / 2, "{failures:?}");
            for set in InstructionSet::available() {
                for width in Width::ALL {
                    let task = Task(&integrator, &members);
                    let (lanes, reported) = dispatch(task, set, width).unwrap();
                    assert_eq!(reported, failures);
                    for (i, (lane, alone)) in lanes.iter().zip(&ends).enumerate() {
                        assert_eq!(lane, alone, "{set} {width:?} member {i}");
                    }
                }
                let (lanes, reported) =
                    in_registers(integrator.clone(), set, &members, $h, $steps);
                assert_eq!(reported, failures, "{set}");
                for (i, (lane, alone)) in lanes.iter().zip(&ends).enumerate() {
                    assert_eq!(lane, alone, "{set} member {i}");
                }
            }
        }
    )*};
}

type Lifted<S> = Collective<S, SpinorRealisation, HeavyTop>;
type Free<S> = LiftFree<S, DualQuaternions, HeavyTop>;
type Equations = HamiltonianField<LiePoisson<Se3>, HeavyTop>;

fn top() -> HeavyTop {
    tops::generic().unwrap()
}

fn gauss(stages: usize) -> RungeKutta {
    RungeKutta::gauss(stages).unwrap()
}

fn lifted<S: collective_integrators::Equivariant>(scheme: S) -> Lifted<S> {
    Collective::new(scheme, SpinorRealisation, top())
}

fn free<S: collective_integrators::Equivariant>(scheme: S) -> Free<S> {
    LiftFree::new(scheme, DualQuaternions, top())
}

fn equations() -> Equations {
    HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top() }
}

same_bits_at_every_width! {
    explicit_steps: Direct<RungeKutta, Equations> =
        Direct::new(RungeKutta::rk4(), equations()), 0.02, 100, false;
    midpoint_steps_beyond_a_checkpoint: Lifted<RungeKutta> =
        lifted(RungeKutta::implicit_midpoint()), 0.05, CHECKPOINT + 30, true;
    gauss_steps: Lifted<RungeKutta> = lifted(gauss(4)), 0.2, 300, true;
    lift_free_steps: Free<RungeKutta> = free(gauss(2)), 0.05, 300, true;
    lift_free_steps_beyond_a_checkpoint: Free<RungeKutta> =
        free(gauss(1)), 0.05, CHECKPOINT + 30, true;
    compensated_steps: Compensated<Free<RungeKutta>> = free(gauss(3)).compensated(), 0.05, 100, true;
    compensated_lifted_steps: Compensated<Lifted<RungeKutta>> =
        lifted(gauss(2)).compensated(), 0.05, CHECKPOINT + 30, true;
    large_compensated_steps: Compensated<Lifted<RungeKutta>> =
        lifted(gauss(2)).compensated(), 1.0, 20, true;
    // Newton's iteration takes over in some lanes, with exact derivatives and with quotients.
    large_lift_free_steps: Free<RungeKutta> = free(gauss(2)), 2.0, 20, true;
    large_direct_steps: Direct<RungeKutta, Equations> =
        Direct::new(gauss(2), equations()), 0.6, 20, true;
    compositions: Free<Composition<RungeKutta>> =
        free(Composition::new(gauss(1), Substeps::suzuki(4).unwrap())), 0.1, 100, true;
    partitioned_steps: Lifted<PartitionedRungeKutta<Alternating>> =
        Collective::that_does_not_descend(
            PartitionedRungeKutta::lobatto_iiia_iiib(3).unwrap(), SpinorRealisation, top(),
        ), 0.02, 100, true;
    reduced_steps: ReducedMidpoint<Automatic<Body>> =
        ReducedMidpoint::new(Automatic(Body)), 0.05, CHECKPOINT + 30, true;
    large_reduced_steps: ReducedMidpoint<Automatic<Body>> =
        ReducedMidpoint::new(Automatic(Body)), 1.5, 20, true;
}

/// A top given by its formula.
#[derive(Clone)]
struct Body;

impl Energy for Body {
    type Space = HeavyTopSpace;
    fn energy<T: Real>(&self, Covector(Pair(pi, gamma)): &Se3Dual<T>) -> T {
        pi.x * pi.x * 0.5 + pi.y * pi.y * 0.4 + pi.z * pi.z * 0.3 + gamma.x * 0.2 - gamma.z
    }
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
    let unfused = MidpointBatch::with_instructions(InstructionSet::Portable).unwrap();
    let fused = InstructionSet::detected() != InstructionSet::Portable;
    assert_eq!(run(unfused, 1) != one, fused);
}

/// The widths above are those of this machine; others may have fewer.
#[test]
fn every_machine_has_three_widths() {
    let sets: Vec<_> = InstructionSet::available().map(|set| set.to_string()).collect();
    println!("tested on: {}", sets.join("; "));
    assert!(sets.len() <= 3 && sets[0] == InstructionSet::Portable.to_string());
}

/// A member that is NaN or infinite, in every lane of two groups, is reported, and the others keep their bits.
#[test]
fn a_member_that_is_no_number_harms_no_other() {
    let integrator = free(gauss(2));
    let members = momenta(8);
    for set in InstructionSet::available() {
        let run = |members: &[Se3Dual]| in_registers(integrator.clone(), set, members, 0.05, 1100);
        let (clean, failures) = run(&members);
        assert!(failures.is_empty());
        for poison in [f64::NAN, f64::INFINITY] {
            for position in 0..members.len() {
                let mut poisoned = members.clone();
                poisoned[position] = poisoned[position].scaled(poison);
                let (ends, failures) = run(&poisoned);
                assert_eq!(failures, [(position, 1)]);
                for (i, (end, clean)) in ends.iter().zip(&clean).enumerate() {
                    assert_eq!(end == clean, i != position, "{set} {i} of {position}");
                }
                assert_eq!(ends[position], bits(&poisoned[position]));
            }
        }
        // Negative control: without a report at its first step, the group would be lost.
        let all = vec![members[0].scaled(f64::NAN); 5];
        assert_eq!(run(&all).1.len(), 5);
    }
}

/// The vector field ẋ = x², whose solution is infinite at t = 1/x(0).
#[derive(Clone)]
struct BlowUp;

impl<T: Real> VectorField<T> for BlowUp {
    type Point = Vector1<T>;
    fn at(&self, z: &Vector1<T>) -> Vector1<T> {
        z.map(|x| x * x)
    }
}

/// Members that fail late, each at its own time, by an infinity and by no convergence.
#[test]
fn members_fail_at_the_step_and_state_of_their_trajectories() {
    let members: Vec<_> = (1..=11).map(|n| Vector1::new(1.0 / (0.7 * f64::from(n)))).collect();
    let implicit = gauss(2).with_solver(StageSolver { newton: false, ..StageSolver::default() });
    for scheme in [RungeKutta::rk4(), implicit] {
        let integrator = Direct::new(scheme, BlowUp);
        let (ends, failures, _) = alone(&integrator, &members, 0.01, 500);
        let steps: BTreeSet<_> = failures.iter().map(|failure| failure.1).collect();
        assert!(steps.len() > 5 && failures.len() < members.len(), "{failures:?}");
        for set in InstructionSet::available() {
            let (lanes, reported) = in_registers(integrator.clone(), set, &members, 0.01, 500);
            assert_eq!((&lanes, &reported), (&ends, &failures), "{set}");
        }
    }
}

fn pool(threads: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap()
}

#[test]
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
fn any_collective_system_gets_lanes_and_threads() {
    let particle = Collective::new(gauss(2), AngularMomentum, Automatic(Anisotropic));
    let start = |index: u64| {
        let x = 0.1 * (1 + index % 97) as f64;
        Cotangent::new(Vector3::new(1.0, 0.0, x), Covector(Vector3::new(0.5, 0.1 * x, 1.0)))
    };
    let members: Vec<_> = (0..300).map(start).collect();
    let (ends, ..) = alone(&particle, &members, 0.01, 50);
    Ensemble::new(Laned::new(particle)).stream(300, start, 0.01, 50, |chunk| {
        assert!(chunk.failures.is_empty());
        for (index, z) in (chunk.first..).zip(chunk.members) {
            assert_eq!(bits(z), ends[index as usize]);
        }
    });
}
