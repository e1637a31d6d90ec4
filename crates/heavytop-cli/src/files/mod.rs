//! Files that are complete or absent, have one writer, and are read up to a bound.

pub(crate) mod bounded;
pub(crate) mod lock;
pub(crate) mod place;
mod output;
pub(crate) mod sealed;

pub use output::Output;
pub use place::Place;
