//! Times the steps of Gauss's methods on duals of Lie algebras by a formula, as the program `heavytop` and Python make them:
//!
//! ```text
//! cargo run --release -p measurements --bin formula_gauss [-- STEPS [SYSTEM [METHOD]]]
//! ```
//!
//! A time is the least of seven runs, and the sweeps are the mean over their steps.

use collective_integrators::{AnyState, Integrator, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::Parameters;
use std::error::Error;
use std::time::Instant;

/// The name, the algebra, the Hamiltonian and the start of a system.
type System = (&'static str, &'static str, &'static str, &'static [f64]);

const TOP: [f64; 6] = [2.0, 3.0, 4.0, 0.5, 0.0, 0.75];

const SYSTEMS: [System; 6] = [
    ("rigid body", "so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2 + Pi1*Pi2/8", &[1.0, 2.0, 0.5]),
    ("Kovalevskaya", "se(3)", "(Pi1^2/2 + Pi2^2/2 + Pi3^2)/2 + Gamma1", &TOP),
    (
        "Kirchhoff",
        "se(3)",
        "(Pi1^2/2 + Pi2^2/3 + Pi3^2)/2 + (Gamma1^2 + Gamma2^2/2 + Gamma3^2/3)/2 + Pi1*Gamma2/10",
        &TOP,
    ),
    (
        "periodic field",
        "se(3)",
        "(Pi1^2/2 + Pi2^2/3 + Pi3^2)/2 + cos(Gamma1) + sin(Gamma2)*Gamma3",
        &TOP,
    ),
    (
        "so(4)",
        "so(4)",
        "(L12^2/2 + L13^2/3 + L14^2/4 + L23^2/5 + L24^2/6 + L34^2/7)/2",
        &[1.0, 0.5, 0.3, 0.2, 0.1, 0.7],
    ),
    (
        "two fields",
        "so(3) ⋉ (R3 + R3)",
        "(Pi1^2/2 + Pi2^2/3 + Pi3^2)/2 + Gamma_1_1 + Gamma_2_2/2 + Gamma_1_3*Gamma_2_1/3",
        &[2.0, 3.0, 4.0, 0.5, 0.0, 0.75, 0.0, 1.0, 0.0],
    ),
];

const METHODS: [(Formulation, SchemeName, f64); 8] = [
    (Formulation::Collective, SchemeName::Gauss(8), 0.25),
    (Formulation::Reduced, SchemeName::Gauss(8), 0.25),
    (Formulation::Direct, SchemeName::Gauss(8), 0.25),
    (Formulation::Direct, SchemeName::Gauss(8), 1.0),
    (Formulation::Collective, SchemeName::Gauss(4), 0.0625),
    (Formulation::Collective, SchemeName::Gauss(2), 0.0625),
    (Formulation::Collective, SchemeName::ImplicitMidpoint, 0.01),
    (Formulation::Reduced, SchemeName::ImplicitMidpoint, 0.01),
];

/// The number of runs of which the fastest counts.
const RUNS: u64 = 7;

fn main() -> Result<(), Box<dyn Error>> {
    let steps = std::env::args().nth(1).map_or(Ok(20_000), |text| text.parse::<u64>())?;
    let [wanted, wanted_method] = [2, 3].map(|at| std::env::args().nth(at));
    for (name, algebra, text, start) in SYSTEMS {
        if wanted.as_ref().is_some_and(|wanted| wanted != name) {
            continue;
        }
        let algebra = SystemAlgebra::named(algebra)?;
        let system = FormulaSystem::new(algebra, text, &Parameters::new())?;
        for (formulation, scheme, h) in METHODS {
            let method = format!("{formulation} {scheme}");
            if wanted_method.as_ref().is_some_and(|wanted| *wanted != method) {
                continue;
            }
            let Ok(method) = system.algebra().method(formulation, scheme, 0.0) else { continue };
            let integrator = system.integrator(&method, start)?;
            let (mut best, mut sweeps) = (f64::INFINITY, 0);
            for _ in 0..RUNS {
                let mut state = integrator.start(&AnyState::from_slice(start))?;
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
