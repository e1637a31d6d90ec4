//! The kernels for tops, alone and many at once, against the general integrators.

mod collective_gauss;
mod gauss_batches;
mod instruction_sets;
mod midpoint_kernel;
mod symmetric_batches;
pub mod top_ensembles;
