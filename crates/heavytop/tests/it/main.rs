//! The promises of the crate: tops, kernels, splittings and closed forms.
#![allow(clippy::unwrap_used, clippy::panic)]

mod attitude;
mod closed_forms;
mod collective_gauss;
mod descent;
mod euler_top;
mod extreme_momenta;
mod gauss_batches;
mod instruction_sets;
mod jacobi_elliptic;
mod lagrange_nutation;
mod laws;
mod midpoint_kernel;
mod names_and_kinds;
mod poincare;
mod splittings;
mod starts;
mod symmetric_batches;
mod top_ensembles;
mod tops;
