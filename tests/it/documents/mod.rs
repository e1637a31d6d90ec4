//! The documents and messages: they say what the code does, and name what exists.

mod architecture;
mod audit;
mod error_chains;
mod error_variants;
mod guide;
mod ledger;
mod rendered;
