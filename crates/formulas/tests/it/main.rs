//! The promises of the crate: the language, its errors, derivatives, scalars, algebras and Casimirs.
#![allow(clippy::unwrap_used, clippy::panic)]

mod named_algebras;
mod casimirs_found;
mod casimirs_of_high_degree;
mod calculus;
mod errors;
mod expressions;
mod language;
mod random_texts;
mod sums;
mod support;
mod tables;
