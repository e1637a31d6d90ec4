//! The command `heavytop reproduce`, which repeats the paper's experiment (Ohsawa 2019, §5.2).

mod record;
mod figures;
mod plot;
mod drifts;
mod reproduce_command;

pub use drifts::{Drift, Reproduction};
pub use reproduce_command::reproduce;
