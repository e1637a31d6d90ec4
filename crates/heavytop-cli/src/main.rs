//! The program `heavytop`. Everything is in the library, so that tests can reach it.

use heavytop_cli::MemoryGuard;
use std::process::ExitCode;

#[global_allocator]
static MEMORY: MemoryGuard = MemoryGuard;

fn main() -> ExitCode {
    heavytop_cli::main()
}
