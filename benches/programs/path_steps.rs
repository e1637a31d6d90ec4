//! Times the steps of the midpoint rule along paths of a noise by a formula, as the program `heavytop` and Python make them, and
//! writes a table of them:
//!
//! ```text
//! cargo run --release -p measurements --bin path_steps [-- STEPS]
//! ```
//!
//! A time is the least of seven runs, which the methods take in turns.

use collective_integrators::{AnyIntegrator, AnyState, Integrator, NoiseRule, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::InnerProduct;
use lie_poisson_formula_systems::{
    Damping, FormulaSystem, NoiseFields, NoiseTerms, OpenSystem, OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::Parameters;
use std::error::Error;
use std::time::Instant;

const STEP: f64 = 0.05;

const FRICTION: f64 = 0.1;

const TEMPERATURE: f64 = 0.2;

/// The number of runs of which the fastest counts.
const RUNS: usize = 7;

/// The name, the algebra, the Hamiltonian and the start of a system.
type System = (&'static str, &'static str, &'static str, &'static [f64]);

const SYSTEMS: [System; 2] = [
    ("free rigid body", "so(3)", "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", &[1.0, 2.0, 0.5]),
    (
        "heavy top",
        "se(3)",
        "(Pi1^2/2 + Pi2^2/2 + Pi3^2)/2 + Gamma1",
        &[2.0, 3.0, 4.0, 0.5, 0.0, 0.75],
    ),
];

/// What a step is, whether there is noise, the formulation, and the tolerance of the stages.
const METHODS: [(&str, bool, Formulation, f64); 5] = [
    ("friction, `collective`", false, Formulation::Collective, 0.0),
    ("friction and noise, `collective`", true, Formulation::Collective, 0.0),
    ("the same, `tolerance` 1e-6, which changes the Casimirs", true, Formulation::Collective, 1e-6),
    ("friction and noise, `reduced`", true, Formulation::Reduced, 0.0),
    ("the same, `tolerance` 1e-6", true, Formulation::Reduced, 1e-6),
];

/// Returns the integrator of a system with friction, and with the noise of a temperature if there is one.
fn integrator(
    (_, algebra, hamiltonian, start): System,
    (_, has_noise, formulation, tolerance): (&str, bool, Formulation, f64),
) -> Result<AnyIntegrator, Box<dyn Error>> {
    let algebra = SystemAlgebra::named(algebra)?;
    let base = FormulaSystem::new(algebra, hamiltonian, &Parameters::new())?;
    let damping =
        Damping::DoubleBracket { friction: FRICTION, inner_product: InnerProduct::euclidean() };
    let noise = match has_noise {
        true => Some(NoiseTerms {
            fields: NoiseFields::thermal(Some(&damping), TEMPERATURE)?,
            seed: 1,
            path: 0,
            rule: NoiseRule::Together,
            interval: None,
            bound: None,
        }),
        false => None,
    };
    let terms = OpenTerms { damping: Some(damping), noise, ..OpenTerms::default() };
    let open = OpenSystem::new(base, terms, STEP)?;
    let method = open.method(formulation, SchemeName::ImplicitMidpoint, tolerance)?;
    Ok(open.tangent_integrator(&method, start)?.without_tangents())
}

/// Returns the time of a step of each method, ns.
fn times(system: System, steps: u64) -> Result<[f64; METHODS.len()], Box<dyn Error>> {
    let mut best = [f64::INFINITY; METHODS.len()];
    for _ in 0..RUNS {
        for (best, method) in best.iter_mut().zip(METHODS) {
            let integrator = integrator(system, method)?;
            let mut state = integrator.start(&AnyState::from_slice(system.3))?;
            let mut workspace = integrator.workspace();
            let clock = Instant::now();
            integrator.advance(&mut state, STEP, 0..steps, &mut workspace)?;
            *best = best.min(clock.elapsed().as_secs_f64() * 1e9 / steps as f64);
        }
    }
    Ok(best)
}

fn main() -> Result<(), Box<dyn Error>> {
    let steps = std::env::args().nth(1).map_or(Ok(20_000), |text| text.parse())?;
    let [body, top] = SYSTEMS.map(|system| times(system, steps));
    let (body, top) = (body?, top?);
    let [of_body, of_top] = SYSTEMS.map(|system| system.0);
    println!("| a step by formula | {of_body}, ns | ratio | {of_top}, ns | ratio |");
    println!("|---|--:|--:|--:|--:|");
    for (i, (what, ..)) in METHODS.into_iter().enumerate() {
        let cell = |times: &[f64; METHODS.len()]| match i {
            0 => format!("{:.0} |", times[0]),
            _ => format!("{:.0} | {:.2}", times[i], times[i] / times[0]),
        };
        println!("| {what} | {} | {} |", cell(&body), cell(&top));
    }
    Ok(())
}
