//! The promises of the crate: algebras, groups, representations and brackets.
#![allow(clippy::unwrap_used, clippy::panic)]

mod algebra_laws;
mod casimirs;
mod closed_representations;
mod cocycles;
mod faults_of_any_size;
mod faulty_objects;
mod hamiltonian_laws;
mod orbits;
mod sizes;
mod support;
