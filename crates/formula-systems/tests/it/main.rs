//! The promises of the crate: algebras, states, methods and sections, what is refused, and what runs conserve.
#![allow(clippy::unwrap_used, clippy::panic)]

mod algebra_expressions;
mod algebras_of_systems;
mod casimirs;
mod collective_by_expression;
mod fastest_integrators;
mod laws_of_systems;
mod methods_by_name;
mod open_systems;
mod realisations;
mod schemes;
mod sections_of_systems;
mod support;
