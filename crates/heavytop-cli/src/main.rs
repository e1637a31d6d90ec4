//! The entry point of the program `heavytop`. All its code is in the library, where tests can reach it.

use std::process::ExitCode;

fn main() -> ExitCode {
    heavytop_cli::main()
}
