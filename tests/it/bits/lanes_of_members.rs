//! Many members in SIMD lanes: each has the bits of its own trajectory, up to the step at which it fails.

use collective_integrators::{
    Alternating, BatchIntegrator, CHECKPOINT, Collective, Compensated, Composition, Direct,
    HamiltonianField, IntegrationError, Integrator, LaneKernel, LaneResults, Laned, LiftFree,
    PartitionedRungeKutta, Registers, RungeKutta, StageSolver, Start, Substeps, VectorField,
};
use core::ops::Range;
use heavytop::{HeavyTop, HeavyTopSpace, ReducedMidpoint, SpinorRealisation};
use lie_poisson::{
    Automatic, Covector, Energy, InstructionSet, Lanes, LiePoisson, Pair, Real, Se3, Se3Dual,
    State, Vector, Width,
};
use momentum_map::DualQuaternions;
use nalgebra::Vector1;
use std::collections::BTreeSet;
use workspace_tests::tops;

/// Returns tops from fast to slow, near rest and far from it, so that their iterations differ.
pub fn momenta(count: usize) -> Vec<Se3Dual> {
    let x = [1.2, -0.7, 2.3, 0.4, 0.8, -0.5];
    let speed = |n: usize| [0.01, 0.3, 1.0, 2.0, 0.1][n % 5] * (1.0 + 1e-3 * n as f64);
    let momentum = |n: usize| {
        Se3Dual::from_coordinates(|i| x[(i + n) % 6] * if i < 3 { speed(n) } else { 1.0 })
    };
    (0..count).map(momentum).collect()
}

pub fn bits<V: Vector<Scalar = f64>>(v: &V) -> Vec<u64> {
    (0..V::DIM).map(|i| v.coordinate(i).to_bits()).collect()
}

pub type StateOf<I> = <I as Integrator<f64>>::State;
pub type Failures = Vec<(usize, u64)>;

/// The bits of all members, and which of them failed at which step.
type Ends = (Vec<Vec<u64>>, Failures);

/// Makes the steps of all members, on an instruction set.
type Advance<'a, M> = dyn Fn(InstructionSet, &[M]) -> Ends + 'a;

/// Makes some steps of a group of members in the SIMD lanes of T, and returns which of them have a result.
fn together<I, T>(integrator: &I, group: &mut [StateOf<I>], h: f64, n: u64) -> LaneResults
where
    I: Integrator<f64, State: Vector> + Integrator<T, State: Vector>,
    T: Lanes,
{
    let last = group.len() - 1;
    let mut state = <I as Integrator<T>>::State::from_coordinates(|i| {
        T::from_lanes(|lane| group[lane.min(last)].coordinate(i))
    });
    let mut workspace = Integrator::<T>::workspace(integrator);
    if Integrator::<T>::advance(integrator, &mut state, h, 0..n, &mut workspace).is_err() {
        return LaneResults::default();
    }
    for (lane, member) in group.iter_mut().enumerate() {
        *member = Vector::from_coordinates(|i| state.coordinate(i).lane(lane));
    }
    std::array::from_fn(|lane| lane <= last)
}

/// Returns the bits of all members after some steps in the registers of an instruction set, and which member failed at
/// which step.
fn in_registers<I>(
    integrator: I,
    set: InstructionSet,
    members: &[StateOf<I>],
    h: f64,
    steps: Range<u64>,
) -> Ends
where
    I: Integrator<f64, State: Vector>,
    Laned<I>: BatchIntegrator<Member = StateOf<I>>,
{
    let batch = Laned::new(integrator).with_instructions(set).unwrap();
    ends(members, |members, failed| {
        batch.advance(members, h, steps, &mut batch.workspace(), failed)
    })
}

fn ends<V: Vector<Scalar = f64>>(
    members: &[V],
    advance: impl FnOnce(&mut [V], &mut dyn FnMut(usize, IntegrationError)),
) -> Ends {
    let (mut members, mut failures) = (members.to_vec(), Vec::new());
    let mut failed = |i, error: IntegrationError| {
        failures.push((i, error.step));
    };
    advance(&mut members, &mut failed);
    failures.sort_unstable();
    (members.iter().map(bits).collect(), failures)
}

/// Returns the same by trajectories, and all numbers of iterations that occurred.
pub fn alone<I>(
    integrator: &I,
    members: &[StateOf<I>],
    h: f64,
    steps: Range<u64>,
) -> (Vec<Vec<u64>>, Failures, BTreeSet<usize>)
where
    I: Integrator<f64, State: Vector>,
{
    let (mut ends, mut failures, mut iterations) = (Vec::new(), Vec::new(), BTreeSet::new());
    for (i, member) in members.iter().enumerate() {
        let mut end = *member;
        let run = integrator.trajectory_resumed(*member, steps.start, h);
        for sample in run.take((steps.end - steps.start) as usize + 1) {
            match sample {
                Ok(sample) => {
                    end = sample.state;
                    if sample.step > steps.start {
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

/// Tests that an integrator of tops returns the bits of its trajectories in the registers of every instruction set, and in
/// each of the `others` ways. `differing` says whether members must differ in their iterations, the negative control.
fn same_bits<I>(
    integrator: &I,
    (h, steps, differing): (f64, Range<u64>, bool),
    others: &[&Advance<'_, StateOf<I>>],
) where
    I: Start<f64, State: Vector, Momentum = Se3Dual> + Clone,
    Laned<I>: BatchIntegrator<Member = StateOf<I>>,
{
    let start = |mu: &Se3Dual| integrator.start(mu).unwrap();
    let members: Vec<_> = momenta(21).iter().map(start).collect();
    let (ends, failures, iterations) = alone(integrator, &members, h, steps.clone());
    assert_eq!(iterations.len() > 1, differing, "{iterations:?}");
    // Some members do not fail.
    assert!(failures.len() < members.len() / 2, "{failures:?}");
    for set in InstructionSet::available() {
        let registers = in_registers(integrator.clone(), set, &members, h, steps.clone());
        let others = others.iter().map(|other| other(set, &members));
        for (which, (lanes, reported)) in [registers].into_iter().chain(others).enumerate() {
            assert_eq!(reported, failures, "{set} {which}");
            for (i, (lane, alone)) in lanes.iter().zip(&ends).enumerate() {
                assert_eq!(lane, alone, "{set} {which} member {i}");
            }
        }
    }
}

/// Makes tests of [`same_bits`] in registers of the width that suits each instruction set.
macro_rules! same_bits_in_registers {
    ($($name:ident: $type:ty = $integrator:expr, $h:expr, $steps:expr, $differing:expr;)*) => {$(
        #[test]
        fn $name() {
            let integrator: $type = $integrator;
            same_bits(&integrator, ($h, $steps, $differing), &[]);
        }
    )*};
}

/// Makes tests of [`same_bits`] in all lanes of all widths that this processor has.
macro_rules! same_bits_at_every_width {
    ($($name:ident: $type:ty = $integrator:expr, $h:expr, $steps:expr, $differing:expr;)*) => {$(
        #[test]
        fn $name() {
            struct Kernel($type);
            impl LaneKernel for Kernel {
                type Member = StateOf<$type>;
                fn together<T: Lanes>(&self, group: &mut [Self::Member], h: f64, n: u64) -> LaneResults {
                    together::<$type, T>(&self.0, group, h, n)
                }
                fn alone(
                    &self,
                    member: &mut Self::Member,
                    h: f64,
                    steps: Range<u64>,
                ) -> Result<(), IntegrationError> {
                    let mut workspace = Integrator::<f64>::workspace(&self.0);
                    Integrator::<f64>::advance(&self.0, member, h, steps, &mut workspace).map(drop)
                }
            }
            let kernel = Kernel($integrator);
            let of_width = |width: Width| {
                let kernel = &kernel;
                move |set: InstructionSet, members: &[StateOf<$type>]| {
                    let registers = Registers::new(set, width).unwrap();
                    ends(members, |members, failed| {
                        registers.advance(kernel, members, $h, $steps, failed);
                    })
                }
            };
            let widths = Width::ALL.map(of_width);
            let others = widths.each_ref().map(|other| {
                let other: &Advance<'_, StateOf<$type>> = other;
                other
            });
            same_bits(&kernel.0, ($h, $steps, $differing), &others);
        }
    )*};
}

pub type Lifted<S> = Collective<S, SpinorRealisation, HeavyTop>;
type Free<S> = LiftFree<S, DualQuaternions, HeavyTop>;
type Equations = HamiltonianField<LiePoisson<Se3>, HeavyTop>;

pub fn top() -> HeavyTop {
    tops::generic().unwrap()
}

pub fn gauss(stages: usize) -> RungeKutta {
    RungeKutta::gauss(stages).unwrap()
}

pub fn lifted<S: collective_integrators::Equivariant>(scheme: S) -> Lifted<S> {
    Collective::new(scheme, SpinorRealisation, top())
}

fn free<S: collective_integrators::Equivariant>(scheme: S) -> Free<S> {
    LiftFree::new(scheme, DualQuaternions, top())
}

fn equations() -> Equations {
    HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top() }
}

/// Steps of a run that goes on, before a checkpoint and after it.
const BEYOND_A_CHECKPOINT: Range<u64> = CHECKPOINT - 50..CHECKPOINT + 30;

// Of the lanes of a width only the scalars differ, whose bits have tests of their own.
same_bits_at_every_width! {
    explicit_steps: Direct<RungeKutta, Equations> =
        Direct::new(RungeKutta::rk4(), equations()), 0.02, 0..100, false;
    midpoint_steps_beyond_a_checkpoint: Lifted<RungeKutta> =
        lifted(RungeKutta::implicit_midpoint()), 0.05, BEYOND_A_CHECKPOINT, true;
    gauss_steps: Lifted<RungeKutta> = lifted(gauss(4)), 0.2, 0..40, true;
    // Newton's iteration takes over in some lanes, with exact derivatives and with quotients.
    large_direct_steps: Direct<RungeKutta, Equations> =
        Direct::new(gauss(2), equations()), 0.6, 0..20, true;
}

same_bits_in_registers! {
    lift_free_steps: Free<RungeKutta> = free(gauss(2)), 0.05, 0..100, true;
    lift_free_steps_beyond_a_checkpoint: Free<RungeKutta> =
        free(gauss(1)), 0.05, BEYOND_A_CHECKPOINT, true;
    compensated_steps: Compensated<Free<RungeKutta>> = free(gauss(3)).compensated(), 0.05, 0..40, true;
    compensated_lifted_steps: Compensated<Lifted<RungeKutta>> =
        lifted(gauss(2)).compensated(), 0.05, BEYOND_A_CHECKPOINT, true;
    compositions: Free<Composition<RungeKutta>> =
        free(Composition::new(gauss(1), Substeps::suzuki(4).unwrap())), 0.1, 0..40, true;
    partitioned_steps: Lifted<PartitionedRungeKutta<Alternating>> =
        Collective::that_does_not_descend(
            PartitionedRungeKutta::lobatto_iiia_iiib(3).unwrap(), SpinorRealisation, top(),
        ), 0.02, 0..100, true;
    reduced_steps: ReducedMidpoint<Automatic<Body>> =
        ReducedMidpoint::new(Automatic(Body)), 0.05, BEYOND_A_CHECKPOINT, true;
}

/// Runs that go on beyond a checkpoint, and longer ones with large steps.
#[test]
#[ignore = "long"]
fn longer_runs() {
    let run = (0.05, CHECKPOINT - 100..CHECKPOINT + 30, true);
    same_bits(&lifted(RungeKutta::implicit_midpoint()), run.clone(), &[]);
    same_bits(&lifted(gauss(4)), run.clone(), &[]);
    same_bits(&free(gauss(1)), run.clone(), &[]);
    same_bits(&free(gauss(2)), run.clone(), &[]);
    same_bits(&lifted(gauss(2)).compensated(), run.clone(), &[]);
    same_bits(&ReducedMidpoint::new(Automatic(Body)), run, &[]);
    // With large steps more members need Newton's iteration, or fail.
    same_bits(&free(gauss(2)), (2.0, 0..20, true), &[]);
    same_bits(&lifted(gauss(2)).compensated(), (1.0, 0..20, true), &[]);
    same_bits(&ReducedMidpoint::new(Automatic(Body)), (1.5, 0..20, true), &[]);
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

/// The widths above are those of this machine; others may have fewer.
#[test]
fn every_machine_has_three_widths() {
    let sets: Vec<_> = InstructionSet::available().map(|set| set.to_string()).collect();
    println!("tested on: {}", sets.join("; "));
    assert!(sets.len() <= 3 && sets[0] == InstructionSet::Portable.to_string());
}

/// Without a step nothing changes, but a start that is not finite is refused all the same.
#[test]
fn no_steps_refuse_what_is_no_number() {
    let integrator = LiftFree::new(RungeKutta::rk4(), DualQuaternions, top());
    let mut members = momenta(5);
    members[3].0.0.y = f64::NAN;
    let before: Vec<_> = members.iter().map(bits).collect();
    for first in [0, 7, CHECKPOINT] {
        let batch = Laned::new(integrator.clone());
        let (mut refused, mut workspace) = (Vec::new(), batch.workspace());
        let mut failed = |i: usize, error: IntegrationError| refused.push((i, error.step));
        batch.advance(&mut members, 0.1, first..first, &mut workspace, &mut failed);
        // The number is that of the step that would have been next.
        assert_eq!(refused, [(3, first + 1)]);
        assert_eq!(members.iter().map(bits).collect::<Vec<_>>(), before);
    }
}

/// A member that is NaN or infinite, in every lane of two groups, is reported, and the others keep their bits.
#[test]
#[ignore = "long"]
fn a_member_that_is_no_number_harms_no_other() {
    let integrator = free(gauss(2));
    let members = momenta(8);
    for set in InstructionSet::available() {
        // Groups are made anew at a checkpoint.
        let steps = CHECKPOINT - 40..CHECKPOINT + 40;
        let run = |members: &[Se3Dual]| {
            in_registers(integrator.clone(), set, members, 0.05, steps.clone())
        };
        let (clean, failures) = run(&members);
        assert!(failures.is_empty());
        for poison in [f64::NAN, f64::INFINITY] {
            for position in 0..members.len() {
                let mut poisoned = members.clone();
                poisoned[position] = poisoned[position].scaled(poison);
                let (ends, failures) = run(&poisoned);
                assert_eq!(failures, [(position, CHECKPOINT - 39)]);
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
        let (ends, failures, _) = alone(&integrator, &members, 0.01, 0..500);
        let steps: BTreeSet<_> = failures.iter().map(|failure| failure.1).collect();
        assert!(steps.len() > 5 && failures.len() < members.len(), "{failures:?}");
        for set in InstructionSet::available() {
            let (lanes, reported) = in_registers(integrator.clone(), set, &members, 0.01, 0..500);
            assert_eq!((&lanes, &reported), (&ends, &failures), "{set}");
        }
    }
}
