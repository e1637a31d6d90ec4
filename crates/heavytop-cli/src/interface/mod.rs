//! The command line, and what the process has to do with its system.

mod help;
mod arguments;
mod signals;
mod standard_output;
mod memory_guard;
mod program;

pub use memory_guard::MemoryGuard;
pub use program::main;
