//! Files that are complete or absent, have one writer, replace no other files, and are read up to a bound.

pub(crate) mod bounded;
pub(crate) mod lock;
pub(crate) mod place;
pub(crate) mod torn_line;
pub(crate) mod safeguards;
mod output;
mod output_set;
pub(crate) mod sealed;

pub use output::Output;
pub(crate) use output_set::OutputSet;
pub use place::Place;
pub(crate) use place::require_csv;
pub(crate) use safeguards::kind::{Kind, contains};
pub use safeguards::safeguard::{Input, Safeguard};
