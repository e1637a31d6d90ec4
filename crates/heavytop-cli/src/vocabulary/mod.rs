//! The words of configurations and messages: formulations, schemes and other items by name.

pub(crate) mod brief;
pub(crate) mod suggestion;
pub(crate) mod named;
mod scheme;
mod formulation;

pub use formulation::Formulation;
pub use scheme::{Pair, Raise, Scheme};
