//! The promises of the crate: the language, its errors, derivatives, scalars, algebras and Casimirs.
#![allow(clippy::unwrap_used, clippy::panic)]

mod algebras;
mod casimirs;
mod derivatives;
mod errors;
mod expressions;
mod language;
mod random_texts;
mod scalars;
mod support;
mod tables;
