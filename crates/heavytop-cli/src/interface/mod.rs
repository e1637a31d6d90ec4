//! The command line, signals, standard output, and the end of memory.

mod help;
mod arguments;
mod signals;
mod standard_output;
mod suggested_command;
mod confirmation;
mod first_configuration;
mod first_system;
mod manual;
mod program;

pub use program::main;
