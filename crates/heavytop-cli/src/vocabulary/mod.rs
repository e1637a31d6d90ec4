//! The names in configurations and messages: formulations, schemes and other items.

pub(crate) mod brief;
pub(crate) mod suggestion;
pub(crate) mod named;
mod scheme;
mod formulation;

pub use formulation::Formulation;
pub use scheme::{Pair, Raise, Scheme};
