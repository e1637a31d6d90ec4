//! The collective midpoint rule in closed form: for any Hamiltonian, for one top in registers, and for many
//! tops in SIMD lanes.

mod closed_form;
pub(crate) mod formulas;
pub(crate) mod reduced_midpoint;
pub(crate) mod top_midpoint;
pub(crate) mod midpoint_batch;
