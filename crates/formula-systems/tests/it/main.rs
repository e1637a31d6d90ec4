//! The promises of the crate: algebras, states, methods and sections, what is refused, and what runs conserve.
#![allow(clippy::unwrap_used, clippy::panic)]

mod algebra_expressions;
mod algebras_of_systems;
mod casimirs;
mod catalogue;
mod collective_by_expression;
mod laws_of_systems;
mod methods;
mod open_systems;
mod realisations;
mod sections_of_systems;
mod support;
