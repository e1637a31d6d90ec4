//! Prints a row for every scheme and formulation: what is claimed, and what is measured.
//!
//! `cargo run --release -p measurements --bin audit -- [steps]` prints that table of `docs/audit.md`. It takes
//! about a minute for 10⁶ steps. The columns are explained at [`workspace_tests::audit::Row`].

use workspace_tests::audit::{Failure, HEADER, LONG, methods};

fn main() -> Result<(), Failure> {
    let steps = std::env::args().nth(1).map_or(Ok(LONG), |text| text.parse())?;
    println!("{HEADER}\n|{}", "---|".repeat(10));
    for method in methods()? {
        println!("{}", method.row(steps)?);
    }
    Ok(())
}
