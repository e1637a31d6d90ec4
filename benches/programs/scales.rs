//! Measures how well structure is conserved in any units: the table of `docs/audit.md`.
//!
//! `cargo run --release -p measurements --bin scales` prints, for a generic top and 1000 steps of 1/50, the
//! largest deviations of f₁, f₂ and h, each in its own unit, in units of 1 and at the worst of twelve others. With
//! the argument `all`, rows for compensated summation and for difference quotients follow.

use std::error::Error;
use workspace_tests::scales::{methods, scaled};

const EXPONENTS: [i32; 7] = [-30, -15, -8, 0, 8, 15, 30];

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| method | f₁ | f₂ | h | f₁, worst | f₂, worst | h, worst |\n|---|---|---|---|---|---|---|"
    );
    let all = std::env::args().any(|argument| argument == "all");
    let more = |name: &str| name.ends_with("compensated") || name.ends_with("derivatives");
    for method in methods(false)?.into_iter().filter(|method| all || !more(&method.name)) {
        let deviations = |s: i32, lambda: i32| -> Result<[f64; 3], Box<dyn Error>> {
            let (top, mu) = scaled(false, 10.0_f64.powi(s), 10.0_f64.powi(lambda))?;
            let outcome = (method.run)(&top, &mu, 0.02, 1000).ok_or("a step failed")?;
            Ok(outcome.deviations)
        };
        let here = deviations(0, 0)?;
        let mut worst = [0.0_f64; 3];
        for (s, lambda) in EXPONENTS.into_iter().flat_map(|n| [(n, 0), (0, n)]) {
            let there = deviations(s, lambda)?;
            worst = [0, 1, 2].map(|i| lie_poisson::larger(worst[i], there[i]));
        }
        let cells = here.iter().chain(&worst).map(|x| format!("{x:.1e}"));
        println!("| {} | {} |", method.name, cells.collect::<Vec<_>>().join(" | "));
    }
    Ok(())
}
