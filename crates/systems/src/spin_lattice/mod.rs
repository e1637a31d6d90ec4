//! Classical spins on lattices: at rest, and on atoms in motion.

pub(crate) mod heisenberg_lattice;
pub(crate) mod lattice_midpoint;
pub(crate) mod row_kernels;
pub(crate) mod rows;
pub(crate) mod slab_sweep;
pub(crate) mod stencil;
pub(crate) mod vibrating_lattice;
