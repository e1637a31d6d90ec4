//! What algebras, groups, representations and brackets promise.
#![allow(clippy::unwrap_used, clippy::panic)]

mod algebra_laws;
mod casimirs;
mod support;
