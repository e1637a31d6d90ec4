//! The command line, signals, standard output, and the end of memory.

mod help;
mod arguments;
mod signals;
mod standard_output;
mod suggested_command;
mod confirmation;
mod first_configuration;
mod manual;
mod memory_guard;
mod program;

pub use memory_guard::MemoryGuard;
pub use program::main;
