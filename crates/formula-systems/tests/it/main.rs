//! The promises of the crate: algebras, states, methods and sections, what is refused, and what runs conserve.
#![allow(clippy::unwrap_used, clippy::panic)]

mod algebras;
mod methods;
mod schemes;
mod sections;
mod support;
