//! What time and noise cost: a step of the collective midpoint rule of one top, with a gravity that swings, with
//! friction, at a temperature, and of many tops on SIMD lanes.
//!
//! All names of a group make the same steps of one top. The ratios to compare are those of a line to the first line of its
//! group; the elements that criterion counts are steps.
#![allow(clippy::unwrap_used, missing_docs)]

use collective_integrators::{
    BatchIntegrator, BrownianPaths, Collective, Driven, Laned, Noisy, NoisyReduced, RungeKutta,
    StageSolver, Start,
};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use heavytop::{HeavyTop, HeavyTopSpace, SpinorRealisation};
use lie_poisson::{
    Autonomous, Covector, Differential, DoubleBracket, Hamiltonian, InTime, InnerProduct,
    InstructionSet, IsotropicNoise, LiePoisson, Pair, PathNumber, Point, Real, Se3, Se3Dual, Time,
    TimeDependent, Vector, from_parts,
};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use std::hint::black_box;

const STEP: f64 = 0.05;
const STEPS: u64 = 1000;
const TOPS: u64 = 64;
const FRICTION: f64 = 0.1;
const TEMPERATURE: f64 = 0.5;

/// Kovalevskaya's top with the weight 1 + cos(t)/5.
#[derive(Clone, Copy)]
struct Swinging(HeavyTop);

impl<T: Real> Hamiltonian<InTime<HeavyTopSpace>, T> for Swinging {
    #[inline(always)]
    fn value(&self, Pair(mu, Time(t)): &Point<InTime<HeavyTopSpace>, T>) -> T {
        self.0.value(mu) + mu.0.1.x * t.cos() * 0.2
    }

    #[inline(always)]
    fn differential(
        &self,
        Pair(mu, Time(t)): &Point<InTime<HeavyTopSpace>, T>,
    ) -> Differential<InTime<HeavyTopSpace>, T> {
        let mut element = self.0.differential(mu);
        element.1.x += t.cos() * 0.2;
        let rate = -(mu.0.1.x * t.sin() * 0.2);
        from_parts::<Se3Dual<T>, Time<T>>(&element, &Covector(Time(rate)))
    }
}

fn top() -> HeavyTop {
    HeavyTop::kovalevskaya(1.0, 1.0).unwrap()
}

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 1.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()))
}

fn midpoint() -> RungeKutta {
    RungeKutta::implicit_midpoint()
}

type Damped = DoubleBracket<HeavyTopSpace, Autonomous<HeavyTop>>;

fn damped() -> Damped {
    let (space, inner_product) = (LiePoisson::minus(Se3::default()), InnerProduct::euclidean());
    DoubleBracket::new(space, Autonomous(top()), FRICTION, inner_product).unwrap()
}

fn driven_by_friction() -> Driven<RungeKutta, SpinorRealisation, Damped> {
    Driven::new(midpoint(), SpinorRealisation, damped())
}

fn noise() -> IsotropicNoise {
    IsotropicNoise::thermal(InnerProduct::euclidean(), (FRICTION, TEMPERATURE)).unwrap()
}

fn paths() -> BrownianPaths {
    BrownianPaths::new(1, STEP).unwrap()
}

fn langevin() -> Noisy<RungeKutta, SpinorRealisation, Damped, IsotropicNoise> {
    Noisy::new(midpoint(), SpinorRealisation, damped(), noise(), paths())
}

fn reduced(tolerance: f64) -> NoisyReduced<DualQuaternions, Damped, IsotropicNoise> {
    let solver = StageSolver { tolerance, ..StageSolver::default() };
    NoisyReduced::new(DualQuaternions, damped(), noise(), paths()).with_solver(solver)
}

/// Times the steps of an integrator.
fn time<I: Start<f64, State: Vector>>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    integrator: &I,
    start: &I::Momentum,
) {
    let start = integrator.start(start).unwrap();
    let mut workspace = integrator.workspace();
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            let mut state = black_box(start);
            integrator.forget(&mut workspace);
            for _ in 0..STEPS {
                state = integrator.step(&state, STEP, &mut workspace).unwrap().point;
            }
            state
        });
    });
}

fn one_top(criterion: &mut Criterion) {
    let in_time = Pair(start(), Time(0.0));
    let on_path = Pair(start(), Pair(PathNumber(0.0), Time(0.0)));
    let driven = |field| Driven::new(midpoint(), SpinorRealisation, field);

    let mut group = criterion.benchmark_group("time");
    group.throughput(Throughput::Elements(STEPS)).sample_size(30);
    let still = Collective::new(midpoint(), SpinorRealisation, top());
    time(&mut group, "top", &still, &start());
    time(&mut group, "the same with a clock", &driven(Autonomous(top())), &in_time);
    let swinging = Driven::new(midpoint(), SpinorRealisation, TimeDependent(Swinging(top())));
    time(&mut group, "gravity that swings", &swinging, &in_time);
    group.finish();

    let mut group = criterion.benchmark_group("noise");
    group.throughput(Throughput::Elements(STEPS)).sample_size(30);
    time(&mut group, "friction", &driven_by_friction(), &in_time);
    time(&mut group, "friction and noise", &langevin(), &on_path);
    time(&mut group, "friction and noise, without a lift", &reduced(0.0), &on_path);
    time(&mut group, "friction and noise, without a lift, to 1e-6", &reduced(1e-6), &on_path);
    let conservative = driven(Autonomous(top()));
    time(&mut group, "neither", &conservative, &in_time);
    let noisy = Noisy::new(midpoint(), SpinorRealisation, Autonomous(top()), noise(), paths());
    time(&mut group, "noise", &noisy, &on_path);
    group.bench_function("its random numbers alone", |bencher| {
        bencher.iter(|| {
            let mut sum = 0.0;
            for n in 0..STEPS {
                let mut increments = [0.0; 6];
                paths().write_increments(0, n as f64, n as f64 + 1.0, &mut increments);
                sum += increments[0] + increments[5];
            }
            sum
        });
    });
    group.finish();
}

/// Times the steps of many members, for each set of instructions.
fn time_batch<I>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    laned: impl Fn() -> Laned<I>,
    first: impl Fn(u64) -> <Laned<I> as BatchIntegrator>::Member,
) where
    Laned<I>: BatchIntegrator<Member: Copy>,
{
    for set in InstructionSet::available() {
        let laned = laned().with_instructions(set).unwrap();
        let mut workspace = laned.workspace();
        let members: Vec<_> = (0..TOPS).map(&first).collect();
        group.bench_function(format!("{name}, {set}"), |bencher| {
            bencher.iter(|| {
                let mut members = members.clone();
                laned.advance(&mut members, STEP, 0..STEPS, &mut workspace, &mut |_, _| ());
                members
            });
        });
    }
}

fn many_tops(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("many tops, per top and step");
    group.throughput(Throughput::Elements(STEPS * TOPS)).sample_size(10);
    let in_time = |_: u64| driven_by_friction().start(&Pair(start(), Time(0.0))).unwrap();
    time_batch(&mut group, "friction", || Laned::new(driven_by_friction()), in_time);
    let on_path = |path: u64| {
        let clock = Pair(PathNumber(path as f64), Time(0.0));
        langevin().start(&Pair(start(), clock)).unwrap()
    };
    time_batch(&mut group, "friction and noise", || Laned::new(langevin()), on_path);
    let moving = |path: u64| Pair(start(), Pair(PathNumber(path as f64), Time(0.0)));
    let name = "friction and noise, without a lift, to 1e-6";
    time_batch(&mut group, name, || Laned::new(reduced(1e-6)), moving);
    group.finish();
}

criterion_group!(benches, one_top, many_tops);
criterion_main!(benches);
