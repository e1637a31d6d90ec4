//! The speed of integrators for one of Kovalevskaya's tops from the paper's start: per step, and to t = 10 at a given
//! accuracy.
//!
//! The elements that criterion counts are steps in the first case, and time units in the second. Errors are 2-norms
//! of the error of (Π, Γ) at t = 10, from `docs/performance.md`.
#![allow(clippy::unwrap_used, missing_docs)]

use collective_integrators::{
    AlternatingSubsteps, Collective, Direct, HamiltonianField, LiftFree, RungeKutta, Splitting,
    Start,
};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use heavytop::{CollectiveGauss, HeavyTop, SpinorRealisation, SymmetricTopSplitting};
use lie_poisson::{InstructionSet, LiePoisson, Se3, Se3Dual, Vector};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use std::hint::black_box;

const STEPS: u64 = 1000;
const TIME: f64 = 10.0;

fn top() -> HeavyTop {
    HeavyTop::kovalevskaya(1.0, 1.0).unwrap()
}

fn gauss(stages: usize) -> RungeKutta {
    RungeKutta::gauss(stages).unwrap()
}

fn lifted(stages: usize) -> Collective<RungeKutta, SpinorRealisation, HeavyTop> {
    Collective::new(gauss(stages), SpinorRealisation, top())
}

fn direct(scheme: RungeKutta) -> Direct<RungeKutta, HamiltonianField<LiePoisson<Se3>, HeavyTop>> {
    let space = LiePoisson::minus(Se3::default());
    Direct::new(scheme, HamiltonianField { space, hamiltonian: top() })
}

/// Times so many steps of an integrator.
fn time<I: Start<f64, State: Vector, Momentum = Se3Dual>>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    integrator: &I,
    (step, steps): (f64, u64),
) {
    let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
    let start = integrator.start(&start).unwrap();
    let mut workspace = integrator.workspace();
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            let mut state = black_box(start);
            integrator.forget(&mut workspace);
            for _ in 0..steps {
                state = integrator.step(&state, step, &mut workspace).unwrap().point;
            }
            state
        });
    });
}

fn per_step(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("one top, per step");
    group.throughput(Throughput::Elements(STEPS)).sample_size(20);
    for set in InstructionSet::available() {
        for (stages, step) in [(4, 0.0625), (6, 0.125), (8, 0.25)] {
            let kernel = CollectiveGauss::new(stages, top()).unwrap();
            let kernel = kernel.with_instructions(set).unwrap();
            let name = format!("Gauss {}, {set}", 2 * stages);
            time(&mut group, &name, &kernel, (step, STEPS));
        }
    }
    time(&mut group, "any system, Gauss 16", &lifted(8), (0.25, STEPS));
    let free = |scheme| LiftFree::new(scheme, DualQuaternions, top());
    time(&mut group, "any system, lift-free Gauss 16", &free(gauss(8)), (0.25, STEPS));
    time(&mut group, "any system, lift-free midpoint", &free(gauss(1)), (0.01, STEPS));
    group.finish();
}

fn per_accuracy(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("one top to t = 10");
    group.throughput(Throughput::Elements(TIME as u64)).sample_size(20);
    let steps = |step: f64| (step, (TIME / step).round() as u64);
    let kernel = |stages| CollectiveGauss::new(stages, top()).unwrap();
    time(&mut group, "6e-15: Gauss 16", &kernel(8), steps(2.0 / 7.0));
    time(&mut group, "2e-15: any system, Gauss 16", &lifted(8), steps(0.25));
    time(&mut group, "1e-13: DOP853, direct", &direct(RungeKutta::dop853()), steps(0.025));
    time(&mut group, "1e-11: Gauss 8", &kernel(4), steps(0.0625));
    let flows = SymmetricTopSplitting::new(top()).unwrap();
    let splitting = Splitting::alternating(flows, AlternatingSubsteps::blanes_moan6());
    time(&mut group, "1e-9: splitting of order 6", &splitting, steps(0.25));
    time(&mut group, "1e-6: RK4, direct", &direct(RungeKutta::rk4()), steps(0.01));
    group.finish();
}

criterion_group!(benches, per_step, per_accuracy);
criterion_main!(benches);
