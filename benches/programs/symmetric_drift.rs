//! Measures the drift of |Γ|² in ensembles of symmetric tops, at fine steps and at steps too coarse for the order of the
//! method.
//!
//! `cargo run --release -p measurements --bin symmetric_drift -- [steps] [tops]`
//!
//! For each top, method and step it prints the change of |Γ|² in a step: the mean over the ensemble with its standard error,
//! and the root mean square. Random walks make that mean square proportional to 1/steps; what is left in long runs are
//! drifts of single tops.

use collective_integrators::{AlternatingSubsteps, BatchIntegrator, Ensemble, Substeps};
use heavytop::{HeavyTop, MidpointBatch, SymmetricTopBatch, SymmetricTopSplitting};
use lie_poisson::Se3Dual;
use lie_poisson::nalgebra::Vector3;
use std::error::Error;

/// Returns the i-th start, with |Π| up to 4 and |Γ| = 1.
fn start(i: u32) -> Se3Dual {
    let turn = 0.7 * f64::from(i);
    let gamma = Vector3::new(turn.cos(), (1.3 * turn).sin(), 0.4 + turn.sin()).normalize();
    let pi = Vector3::new(
        2.0 * (0.3 * turn).cos(),
        3.0 * (0.11 * turn).sin(),
        0.5 + (0.77 * turn).cos(),
    );
    Se3Dual::new(pi, gamma)
}

/// Advances an ensemble, and prints what it changed per step after the `title`.
fn measure<T: Copy + Send + Sync>(
    title: &str,
    integrator: impl BatchIntegrator<Member = (T, Se3Dual)>,
    top: T,
    (step, steps, count): (f64, u32, u32),
) -> Result<(), Box<dyn Error>> {
    let square = |(_, mu): &(T, Se3Dual)| mu.0.1.dot(&mu.0.1);
    let mut members: Vec<_> = (0..count).map(|i| (top, start(i))).collect();
    let first: Vec<f64> = members.iter().map(square).collect();
    let ensemble = Ensemble::new(integrator);
    if let Some(failure) = ensemble.advance(&mut members, step, 0..u64::from(steps)).pop() {
        return Err(failure.into());
    }
    let changes = members.iter().zip(&first).map(|(end, first)| square(end) - first);
    let changes: Vec<f64> = changes.map(|change| change / f64::from(steps)).collect();
    let moment =
        |power| changes.iter().map(|change| change.powi(power)).sum::<f64>() / f64::from(count);
    let error = (moment(2) / f64::from(count)).sqrt();
    println!("| {title} | {step} | {:+.1e} ± {error:.1e} | {:.1e} |", moment(1), moment(2).sqrt());
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut number = |default: u32| arguments.next().map_or(Ok(default), |text| text.parse());
    let (steps, count) = (number(20_000)?, number(8_000)?);
    let tops = [
        ("Kovalevskaya", HeavyTop::kovalevskaya(1.0, 1.0)?),
        ("Lagrange", HeavyTop::lagrange(1.0, 1.5, 1.0)?),
    ];
    let (yoshida, suzuki) = (Substeps::yoshida4(), Substeps::suzuki4());
    let methods = [
        ("Strang", AlternatingSubsteps::composed(&Substeps::new(&[1.0])?), 0.2),
        ("Blanes–Moan 4", AlternatingSubsteps::blanes_moan4(), 0.2),
        ("Blanes–Moan 6", AlternatingSubsteps::blanes_moan6(), 0.25),
        ("Suzuki 4", AlternatingSubsteps::composed(&suzuki), 0.2),
        ("Yoshida 4", AlternatingSubsteps::composed(&yoshida), 0.2),
        ("Yoshida 4", AlternatingSubsteps::composed(&yoshida), 0.1),
        ("Yoshida 4", AlternatingSubsteps::composed(&yoshida), 0.02),
    ];
    for (name, top) in tops {
        let splitting = SymmetricTopSplitting::new(top)?;
        for (method, substeps, step) in &methods {
            let batch = SymmetricTopBatch::new(substeps.clone());
            measure(&format!("{name} | {method}"), batch, splitting, (*step, steps, count))?;
        }
        for step in [0.2, 0.05, 0.02] {
            let title = format!("{name} | midpoint rule");
            measure(&title, MidpointBatch::new(), top, (step, steps, count))?;
        }
    }
    Ok(())
}
