//! The command line, signals, standard output, and the end of memory.

mod help;
mod standard_output;
mod beginnings;
mod arguments;
mod signals;
mod suggested_command;
mod confirmation;
mod manual;
mod program;

pub use program::main;
