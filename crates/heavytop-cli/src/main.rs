//! The entry point of the program `heavytop`. All its code is in the library, where tests can reach it.

use heavytop_cli::MemoryGuard;
use std::process::ExitCode;

#[global_allocator]
static MEMORY: MemoryGuard = MemoryGuard;

fn main() -> ExitCode {
    heavytop_cli::main()
}
