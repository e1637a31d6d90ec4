//! Times the steps of Gauss's methods on se(3)∗ by a formula, as the program `heavytop` and Python make them:
//!
//! ```text
//! cargo run --release -p measurements --bin formula_gauss [-- STEPS]
//! ```
//!
//! A time is the least of seven runs, and the sweeps are the mean over their steps.

use collective_integrators::{AnyState, Integrator, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::Parameters;
use std::error::Error;
use std::time::Instant;

const SYSTEMS: [(&str, &str); 3] = [
    ("Kovalevskaya", "(Pi1^2/2 + Pi2^2/2 + Pi3^2)/2 + Gamma1"),
    (
        "Kirchhoff",
        "(Pi1^2/2 + Pi2^2/3 + Pi3^2)/2 + (Gamma1^2 + Gamma2^2/2 + Gamma3^2/3)/2 + Pi1*Gamma2/10",
    ),
    ("periodic field", "(Pi1^2/2 + Pi2^2/3 + Pi3^2)/2 + cos(Gamma1) + sin(Gamma2)*Gamma3"),
];

const METHODS: [(Formulation, SchemeName, f64); 7] = [
    (Formulation::Collective, SchemeName::Gauss(8), 0.25),
    (Formulation::Reduced, SchemeName::Gauss(8), 0.25),
    (Formulation::Direct, SchemeName::Gauss(8), 0.25),
    (Formulation::Collective, SchemeName::Gauss(4), 0.0625),
    (Formulation::Collective, SchemeName::Gauss(2), 0.0625),
    (Formulation::Collective, SchemeName::ImplicitMidpoint, 0.01),
    (Formulation::Reduced, SchemeName::ImplicitMidpoint, 0.01),
];

/// The number of runs of which the fastest counts.
const RUNS: u64 = 7;

fn main() -> Result<(), Box<dyn Error>> {
    let steps = std::env::args().nth(1).map_or(Ok(20_000), |text| text.parse::<u64>())?;
    for (name, text) in SYSTEMS {
        let algebra = SystemAlgebra::named("se(3)")?;
        let system = FormulaSystem::new(algebra, text, &Parameters::new())?;
        for (formulation, scheme, h) in METHODS {
            let method = system.algebra().method(formulation, scheme, 0.0)?;
            let start = [2.0, 3.0, 4.0, 0.5, 0.0, 0.75_f64.sqrt()];
            let integrator = system.integrator(&method, &start)?;
            let (mut best, mut sweeps) = (f64::INFINITY, 0);
            for _ in 0..RUNS {
                let mut state = integrator.start(&AnyState::from_slice(&start))?;
                let mut workspace = integrator.workspace();
                let clock = Instant::now();
                for _ in 0..steps {
                    sweeps += integrator.step_in_place(&mut state, h, &mut workspace)?;
                }
                best = best.min(clock.elapsed().as_secs_f64() * 1e9 / steps as f64);
            }
            let mean = sweeps as f64 / (RUNS * steps) as f64;
            println!(
                "{name:15} {formulation:10} {scheme:18} h = {h:6}: {best:6.0} ns, {mean:5.2} sweeps"
            );
        }
    }
    Ok(())
}
