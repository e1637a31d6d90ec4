//! Files that are there whole or not at all, have one writer, and may have no end.

pub(crate) mod bounded;
pub(crate) mod lock;
pub(crate) mod place;
mod output;
pub(crate) mod sealed;

pub use output::Output;
pub use place::Place;
