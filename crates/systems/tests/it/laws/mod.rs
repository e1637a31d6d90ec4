//! The law suites of the gallery: each system obeys those of its space, its Hamiltonian, its map and its integrator.
//!
//! Every suite also runs on a [`Faulty`](lie_poisson_systems::lie_poisson::laws::Faulty) variant of the system, which it
//! must refuse. The module [`every_system`] compares the suites with the sources and with the table of `docs/testing.md`.

mod body_laws;
mod every_system;
mod field_laws;
mod gallery_sources;
mod matrix_laws;
mod satellite_laws;
mod spin_laws;
mod suites_with_controls;
mod vortex_laws;
