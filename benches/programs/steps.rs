//! Makes steps of one kernel, for `benches/instructions` to count its instructions:
//!
//! ```text
//! cargo run --release -p measurements --bin steps -- KERNEL (avx2 | avx512 | portable) STEPS
//! ```

use collective_integrators::{
    AlternatingSubsteps, BatchIntegrator, Collective, Direct, HamiltonianField, IntegrationError,
    Integrator, Laned, LiftFree, Observed, RungeKutta, Splitting, StagesInLanes, Start,
};
use heavytop::{
    CollectiveGauss, HeavyTop, MidpointBatch, ReducedMidpoint, SpinorRealisation,
    SymmetricTopBatch, SymmetricTopSplitting, TopMidpoint,
};
use lie_poisson::{InstructionSet, LiePoisson, Se3, Se3Dual, Width};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use std::cell::Cell;
use std::error::Error;
use std::hint::black_box;

/// The number of members of an ensemble, which fills registers on all instruction sets.
const COUNT: u32 = 64;

/// Returns the start of the paper.
fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()))
}

/// Makes the steps of one top.
fn one<I>(integrator: &I, step: f64, steps: u64) -> Result<(), Box<dyn Error>>
where
    I: Start + Integrator<Momentum = Se3Dual>,
{
    let (mut state, mut workspace) = (integrator.start(&start())?, integrator.workspace());
    for _ in 0..steps {
        state = integrator.step(&state, step, &mut workspace)?.point;
    }
    black_box(state);
    Ok(())
}

/// Makes the steps of many tops.
fn many<B, P: Copy>(batch: &B, parameters: P, step: f64, steps: u64) -> Result<(), Box<dyn Error>>
where
    B: BatchIntegrator<Member = (P, Se3Dual)>,
{
    let mut members = vec![(parameters, start()); COUNT as usize];
    for (i, (_, mu)) in (0..COUNT).zip(&mut members) {
        mu.0.0.x += 0.01 * f64::from(i);
    }
    let mut failure: Result<(), IntegrationError> = Ok(());
    let mut failed = |_, error| failure = Err(error);
    batch.advance(&mut members, step, 0..steps, &mut batch.workspace(), &mut failed);
    black_box(members);
    Ok(failure?)
}

/// Makes the steps of many tops by an integrator for one.
fn laned<I>(integrator: I, set: InstructionSet, step: f64, steps: u64) -> Result<(), Box<dyn Error>>
where
    I: Start + Integrator<Momentum = Se3Dual>,
    Laned<I>: BatchIntegrator<Member = <I as Integrator>::State>,
{
    let mut members = Vec::new();
    for i in 0..COUNT {
        let mut mu = start();
        mu.0.0.x += 0.01 * f64::from(i);
        members.push(integrator.start(&mu)?);
    }
    let batch = Laned::new(integrator).with_instructions(set)?;
    let mut failure: Result<(), IntegrationError> = Ok(());
    let mut failed = |_, error| failure = Err(error);
    batch.advance(&mut members, step, 0..steps, &mut batch.workspace(), &mut failed);
    black_box(members);
    Ok(failure?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let [kernel, set, steps] = arguments.as_slice() else {
        return Err("three arguments: KERNEL (avx2 | avx512 | portable) STEPS".into());
    };
    let set = match set.as_str() {
        "avx2" => InstructionSet::Avx2,
        "avx512" => InstructionSet::Avx512,
        "portable" => InstructionSet::Portable,
        other => return Err(format!("no instructions called {other}").into()),
    };
    let (top, steps) = (HeavyTop::kovalevskaya(1.0, 1.0)?, steps.parse()?);
    match kernel.as_str() {
        "gauss-8" => one(&CollectiveGauss::new(8, top)?.with_instructions(set)?, 0.25, steps),
        "midpoint" => one(&TopMidpoint::new(top).with_instructions(set)?, 0.01, steps),
        "midpoint-ensemble" => {
            many(&MidpointBatch::new().on(set, Width::TwoRegisters)?, top, 0.01, steps)
        }
        "splitting-ensemble" => {
            let splitting = SymmetricTopBatch::new(AlternatingSubsteps::blanes_moan6());
            let splitting = splitting.on(set, Width::TwoRegisters)?;
            many(&splitting, SymmetricTopSplitting::new(top)?, 0.2, steps)
        }
        "any-gauss-8-ensemble" => {
            let gauss = Collective::new(RungeKutta::gauss(8)?, SpinorRealisation, top);
            laned(gauss, set, 0.25, steps)
        }
        "any-midpoint-ensemble" => {
            let midpoint = RungeKutta::implicit_midpoint();
            laned(LiftFree::new(midpoint, DualQuaternions, top), set, 0.01, steps)
        }
        "any-hamiltonian-ensemble" => laned(ReducedMidpoint::new(top), set, 0.01, steps),
        "rk4-ensemble" => {
            let space = LiePoisson::minus(Se3::default());
            let field = HamiltonianField { space, hamiltonian: top };
            laned(Direct::new(RungeKutta::rk4(), field), set, 0.01, steps)
        }
        // These integrators are for any system, and have no instructions to choose.
        "any-gauss-8" => {
            one(&Collective::new(RungeKutta::gauss(8)?, SpinorRealisation, top), 0.25, steps)
        }
        "any-gauss-8-lanes" => {
            let gauss = Collective::new(RungeKutta::gauss(8)?, SpinorRealisation, top);
            one(&StagesInLanes::widest(gauss).with_instructions(set)?, 0.25, steps)
        }
        // Observers that count: what they cost beside the same without them.
        "observed-gauss-8" | "observed-gauss-8-lanes" => {
            let (made, count) = (Cell::new(0), |made: &Cell<u64>| made.set(made.get() + 1));
            let scheme = Observed::new(RungeKutta::gauss(8)?, || count(&made));
            let gauss = Collective::new(scheme, SpinorRealisation, top);
            match kernel.ends_with("lanes") {
                true => {
                    let lanes = StagesInLanes::widest(gauss).with_instructions(set)?;
                    one(&Observed::new(lanes, || count(&made)), 0.25, steps)
                }
                false => one(&Observed::new(gauss, || count(&made)), 0.25, steps),
            }
        }
        "lift-free-gauss-4" | "lift-free-gauss-4-lanes" => {
            let gauss = LiftFree::new(RungeKutta::gauss(4)?, DualQuaternions, top);
            match kernel.ends_with("lanes") {
                true => one(&StagesInLanes::widest(gauss).with_instructions(set)?, 0.1, steps),
                false => one(&gauss, 0.1, steps),
            }
        }
        "any-midpoint" => {
            let midpoint = RungeKutta::implicit_midpoint();
            one(&LiftFree::new(midpoint, DualQuaternions, top), 0.01, steps)
        }
        "any-hamiltonian" => one(&ReducedMidpoint::new(top), 0.01, steps),
        "rk4" => {
            let field =
                HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
            one(&Direct::new(RungeKutta::rk4(), field), 0.01, steps)
        }
        "observed-rk4" => {
            let made = Cell::new(0);
            let field =
                HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
            let observed = Observed::new(field, || made.set(made.get() + 1));
            one(&Direct::new(RungeKutta::rk4(), observed), 0.01, steps)
        }
        "splitting-4" => {
            let (flows, four) =
                (SymmetricTopSplitting::new(top)?, AlternatingSubsteps::blanes_moan4());
            one(&Splitting::alternating(flows, four), 0.2, steps)
        }
        "strang" => one(&Splitting::strang(SymmetricTopSplitting::new(top)?), 0.02, steps),
        other => Err(format!("no kernel called {other}").into()),
    }
}
