//! The time of a step of the collective midpoint rule, for one top and for many.
//!
//! The formulas for tops and the iteration for any system are compared with RK4 in plain Rust.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use collective_integrators::{BatchIntegrator, Integrator};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use heavytop::{HeavyTop, ReducedMidpoint, TopMidpoint};
use lie_poisson::{InstructionSet, Se3Dual};
use nalgebra::Vector3;
use std::hint::black_box;

const STEP: f64 = 0.01;
const STEPS: u64 = 1000;
const TOPS: u64 = 160;

fn top() -> HeavyTop {
    HeavyTop::kovalevskaya(1.0, 1.0).unwrap()
}

fn start(i: u64) -> Se3Dual {
    let spin = 4.0 - 0.01 * i as f64;
    Se3Dual::new(Vector3::new(2.0, 3.0, spin), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()))
}

fn run<I: Integrator<State = Se3Dual>>(midpoint: &I) -> Se3Dual {
    let (mut mu, mut space) = (black_box(start(0)), midpoint.workspace());
    for _ in 0..STEPS {
        mu = midpoint.step(&mu, STEP, &mut space).unwrap().point;
    }
    mu
}

type State = [f64; 6];

/// Returns the rate of change by the equations of the Kovalevskaya top.
fn rate([p, q, r, x, y, z]: State) -> State {
    let (u, v, w) = (0.5 * p, 0.5 * q, r);
    [
        q * w - r * v,
        r * u - p * w + z,
        p * v - q * u - y,
        y * w - z * v,
        z * u - x * w,
        x * v - y * u,
    ]
}

fn runge_kutta(mut z: State) -> State {
    let ahead =
        |z: &State, s: f64, k: &State| -> State { std::array::from_fn(|i| z[i] + s * k[i]) };
    for _ in 0..STEPS {
        let first = rate(z);
        let second = rate(ahead(&z, 0.5 * STEP, &first));
        let third = rate(ahead(&z, 0.5 * STEP, &second));
        let fourth = rate(ahead(&z, STEP, &third));
        for i in 0..6 {
            z[i] += STEP / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]);
        }
    }
    z
}

fn one_top(c: &mut Criterion) {
    let mut group = c.benchmark_group("midpoint, one top, per step");
    group.throughput(Throughput::Elements(STEPS));
    for set in InstructionSet::available() {
        let midpoint = TopMidpoint::new(top()).with_instructions(set).unwrap();
        group.bench_function(set.to_string(), |b| b.iter(|| run(&midpoint)));
    }
    let general = ReducedMidpoint::new(top());
    group.bench_function("any system", |b| b.iter(|| run(&general)));
    let z = [2.0, 3.0, 4.0, 0.5, 0.0, 0.75_f64.sqrt()];
    group.bench_function("RK4 in plain Rust", |b| b.iter(|| runge_kutta(black_box(z))));
    group.finish();
}

fn many_tops(c: &mut Criterion) {
    let mut group = c.benchmark_group("midpoint, many tops, per top and step");
    group.throughput(Throughput::Elements(STEPS * TOPS));
    for set in InstructionSet::available() {
        let midpoint = TopMidpoint::new(top()).with_instructions(set).unwrap();
        group.bench_function(set.to_string(), |b| {
            b.iter(|| {
                let mut states: Vec<_> = (0..TOPS).map(start).collect();
                let failed = &mut |i, e| panic!("{i}: {e}");
                BatchIntegrator::advance(&midpoint, &mut states, STEP, 0..STEPS, &mut (), failed);
                states
            });
        });
    }
    group.finish();
}

criterion_group!(benches, one_top, many_tops);
criterion_main!(benches);
