//! The law suites of the crate: its Hamiltonians, maps, integrators and batches.
//!
//! Every suite also runs on a [`Faulty`](lie_poisson::laws::Faulty) variant, which it must refuse. The module
//! [`every_public_type`] compares the suites with the sources.

mod every_public_type;
mod laws_of_batches;
mod laws_of_hamiltonians_and_maps;
mod laws_of_kernels;
mod laws_of_splittings;
mod suites;
