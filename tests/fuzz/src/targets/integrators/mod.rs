//! Integrators of systems that are not tops alone, and what they run on.

mod attitudes;
mod chains;
mod cocycles;
mod doubled_spaces;
mod kinds;
mod schemes;
mod sites;
mod stages_side_by_side;

pub(crate) use kinds::run;
pub use kinds::{kind_of_case, names_of_kinds};
