//! The speed of ensembles at a given accuracy: trajectory time units per second, on one thread.
//!
//! A measurement is one call on 1024 of Kovalevskaya's tops near the paper's start, to t = 20. The elements that
//! criterion counts are time units of trajectories.
#![allow(clippy::unwrap_used, missing_docs)]

use collective_integrators::{
    AlternatingSubsteps, BatchIntegrator, Direct, HamiltonianField, Integrator, RungeKutta,
    Substeps,
};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use heavytop::{GaussBatch, HeavyTop, SymmetricTopBatch, SymmetricTopSplitting};
use lie_poisson::{InstructionSet, LiePoisson, Se3, Se3Dual, Width};
use nalgebra::Vector3;
use std::hint::black_box;

const COUNT: u32 = 1024;
const TIME: f64 = 20.0;

fn start(i: u32) -> Se3Dual {
    let x = f64::from(i) / f64::from(COUNT) - 0.5;
    let gamma = Vector3::new(0.5 + 0.1 * x, 0.2 * x, 0.75_f64.sqrt()).normalize();
    Se3Dual::new(Vector3::new(2.0 + 0.2 * x, 3.0 - 0.1 * x, 4.0), gamma)
}

fn steps(step: f64) -> u64 {
    (TIME / step).round() as u64
}

fn ensembles(criterion: &mut Criterion) {
    let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
    let symmetric = SymmetricTopSplitting::new(top).unwrap();
    let mut group = criterion.benchmark_group("ensemble to t = 20");
    group.throughput(Throughput::Elements(u64::from(COUNT) * TIME as u64)).sample_size(10);
    let splittings = [
        (
            "Sofroniou–Spaletta 10",
            AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10()),
            0.125,
        ),
        ("Blanes–Moan 6", AlternatingSubsteps::blanes_moan6(), 0.2),
        ("Blanes–Moan 4", AlternatingSubsteps::blanes_moan4(), 0.1),
    ];
    for set in InstructionSet::available() {
        for (name, substeps, step) in &splittings {
            let ensemble = SymmetricTopBatch::new(substeps.clone());
            let ensemble = ensemble.on(set, Width::TwoRegisters).unwrap();
            group.bench_function(format!("{name}, h = {step}, {set}"), |bencher| {
                bencher.iter(|| {
                    let mut members: Vec<_> = (0..COUNT).map(|i| (symmetric, start(i))).collect();
                    ensemble.advance(&mut members, *step, 0..steps(*step), &mut (), &mut |_, _| ());
                    black_box(members)
                });
            });
        }
        let ensemble = GaussBatch::<8>::new().unwrap().on(set, Width::TwoRegisters).unwrap();
        let step = 1.0 / 3.0;
        group.bench_function(format!("Gauss 16, h = 1/3, {set}"), |bencher| {
            bencher.iter(|| {
                let mut members: Vec<_> = (0..COUNT).map(|i| (top, start(i))).collect();
                ensemble.advance(&mut members, step, 0..steps(step), &mut (), &mut |_, _| ());
                black_box(members)
            });
        });
    }
    let field = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
    let rk4 = Direct::new(RungeKutta::rk4(), field);
    let mut workspace = rk4.workspace();
    group.bench_function("RK4 one by one, h = 0.01", |bencher| {
        bencher.iter(|| {
            let mut end = |z| {
                (0..steps(0.01)).fold(z, |z, _| rk4.step(&z, 0.01, &mut workspace).unwrap().point)
            };
            black_box((0..COUNT).map(|i| end(start(i))).collect::<Vec<_>>())
        });
    });
    group.finish();
}

criterion_group!(benches, ensembles);
criterion_main!(benches);
