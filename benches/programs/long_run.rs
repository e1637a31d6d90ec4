//! Measures round-off over a long run: how f₁, f₂ and h change, with and without compensated summation.
//!
//! `cargo run --release -p measurements --bin long_run -- [steps] [starts] [method]`
//!
//! For an ensemble of starts of a generic top it prints the root mean square of each deviation at geometrically
//! growing times, its mean, and the slope of ln(rms) against ln(t): ½ for a random walk, 1 for a drift.

use collective_integrators::{
    Collective, Direct, HamiltonianField, LiftFree, RungeKutta, Start, fitted_order,
};
use heavytop::{Body, CollectiveGauss, HeavyTop, SpinorRealisation};
use lie_poisson::nalgebra::Vector3;
use lie_poisson::{Hamiltonian, LiePoisson, Se3, Se3Dual};
use momentum_map::DualQuaternions;
use std::error::Error;

const STEP: f64 = 0.05;

/// Returns the deviations (f₁, f₂, h) of one run at 2⁰, 2¹, 2², … steps from the values of the lifted start.
fn deviations<I>(
    integrator: &I,
    top: &HeavyTop,
    start: &Se3Dual,
    steps: u64,
) -> Result<Vec<[f64; 3]>, Box<dyn Error>>
where
    I: Start<f64, Momentum = Se3Dual>,
{
    let values = |mu: &Se3Dual| [mu.0.1.dot(&mu.0.1), mu.0.0.dot(&mu.0.1), top.value(mu)];
    let mut state = integrator.start(start)?;
    // The rounding error of the lift is no part of the walk.
    let first = values(&integrator.momentum(&state));
    let mut workspace = integrator.workspace();
    let mut rows = Vec::new();
    let mut next = 1;
    for step in 1..=steps {
        state = integrator.step(&state, STEP, &mut workspace)?.point;
        if step == next {
            let now = values(&integrator.momentum(&state));
            rows.push([0, 1, 2].map(|k| now[k] - first[k]));
            next *= 2;
        }
    }
    Ok(rows)
}

/// The options of the program: steps, starts and method.
struct Run<'a> {
    top: &'a HeavyTop,
    starts: &'a [Se3Dual],
    steps: u64,
    /// The only method to run, if one is asked for.
    wanted: Option<&'a str>,
}

impl Run<'_> {
    /// Reports on a method without and with compensation.
    fn compare(
        &self,
        name: &str,
        plain: &impl Start<f64, Momentum = Se3Dual>,
        compensated: &impl Start<f64, Momentum = Se3Dual>,
    ) -> Result<(), Box<dyn Error>> {
        self.one(name, plain)?;
        self.one(&format!("{name}, compensated"), compensated)
    }

    fn one(
        &self,
        name: &str,
        integrator: &impl Start<f64, Momentum = Se3Dual>,
    ) -> Result<(), Box<dyn Error>> {
        if self.wanted.is_none_or(|wanted| wanted == name) {
            report(name, integrator, self.top, self.starts, self.steps)?;
        }
        Ok(())
    }
}

fn report<I>(
    name: &str,
    integrator: &I,
    top: &HeavyTop,
    starts: &[Se3Dual],
    steps: u64,
) -> Result<(), Box<dyn Error>>
where
    I: Start<f64, Momentum = Se3Dual>,
{
    let clock = std::time::Instant::now();
    let runs = starts
        .iter()
        .map(|start| deviations(integrator, top, start, steps))
        .collect::<Result<Vec<_>, _>>()?;
    let count = runs.len() as f64;
    println!("{name}: {} runs of {steps} steps of {STEP}, {:.0?}", runs.len(), clock.elapsed());
    for (k, quantity) in ["f1", "f2", "h"].iter().enumerate() {
        let moment = |row: usize, power: i32| {
            runs.iter().map(|run| run[row][k].powi(power)).sum::<f64>() / count
        };
        let rms: Vec<(f64, f64)> = (0..runs[0].len())
            .map(|row| (STEP * 2_f64.powi(row as i32), moment(row, 2).sqrt()))
            .collect();
        // The first rows show single rounding errors of the quantity itself, which are no walk yet.
        let walk: Vec<(f64, f64)> = rms.iter().copied().skip(rms.len() / 2).collect();
        let slope = fitted_order(&walk, 0.0).map_or("-".to_owned(), |slope| format!("{slope:.2}"));
        let last = rms.len() - 1;
        println!(
            "  {quantity}: rms {:.2e} at t = {:.3e}, mean {:+.2e} ± {:.1e}, slope {slope}",
            rms[last].1,
            rms[last].0,
            moment(last, 1),
            rms[last].1 / count.sqrt()
        );
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut number = |default: u64| arguments.next().map_or(Ok(default), |text| text.parse());
    let (steps, starts) = (number(1 << 16)?, number(16)?);
    let top = HeavyTop::new(&Body {
        inertia: Vector3::new(2.1, 1.7, 1.0),
        mass: 1.0,
        gravity: 1.0,
        length: 0.3,
        center_of_mass: Vector3::new(0.48, -0.64, 0.6),
    })?;
    let start = |n: u64| {
        let turn = 0.7 * n as f64;
        let gamma = Vector3::new(turn.cos(), (1.3 * turn).sin(), 0.4 + turn.sin()).normalize();
        Se3Dual::new(Vector3::new(0.3, -0.4, 2.0 + 0.1 * turn.cos()), gamma)
    };
    let starts: Vec<Se3Dual> = (0..starts).map(start).collect();
    let wanted = std::env::args().nth(3);
    let run = Run { top: &top, starts: &starts, steps, wanted: wanted.as_deref() };
    let gauss = CollectiveGauss::new(6, top)?;
    run.one("CollectiveGauss, 6 stages", &gauss)?;
    let schemes =
        [("midpoint", RungeKutta::implicit_midpoint()), ("gauss-12", RungeKutta::gauss(6)?)];
    for (name, scheme) in schemes {
        let free = LiftFree::new(scheme.clone(), DualQuaternions, top);
        run.compare(name, &free, &free.clone().compensated())?;
        let collective = Collective::new(scheme.clone(), SpinorRealisation, top);
        let lifted = format!("collective {name}");
        run.compare(&lifted, &collective, &collective.clone().compensated())?;
        let space = LiePoisson::minus(Se3::default());
        let direct = Direct::new(scheme, HamiltonianField { space, hamiltonian: top });
        run.compare(&format!("direct {name}"), &direct, &direct.clone().compensated())?;
    }
    Ok(())
}
