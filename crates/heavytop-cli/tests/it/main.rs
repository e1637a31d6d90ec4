//! The promises of the program `heavytop`, as a user runs it.
#![allow(clippy::unwrap_used, clippy::panic)]

mod arrays_and_pictures;
mod commands;
mod configuration;
mod conversation;
mod faults;
mod lie_poisson_systems;
mod program;
mod resumption;
mod runs;
mod service;
mod variants_of_errors;
mod writing;
