//! The command `heavytop reproduce`, which repeats the paper's experiment (Ohsawa 2019, §5.2).

mod record;
mod figures;
mod plot;
mod deviations;
mod reproduce_command;

pub use deviations::{Deviations, Reproduction};
pub use reproduce_command::reproduce;
