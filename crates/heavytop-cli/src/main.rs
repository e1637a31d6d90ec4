//! The program `heavytop`. Everything is in the library, so that tests can reach it.

mod memory;

use std::process::ExitCode;

fn main() -> ExitCode {
    heavytop_cli::main()
}
