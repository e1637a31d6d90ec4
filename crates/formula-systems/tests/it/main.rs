//! The promises of the crate: algebras, states and methods, what is refused, and what runs conserve.
#![allow(clippy::unwrap_used, clippy::panic)]

mod algebras;
mod methods;
mod support;
