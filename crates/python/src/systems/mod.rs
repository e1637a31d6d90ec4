//! Any Lie–Poisson system: its algebra and its Hamiltonian, its runs, and many of them at once.

pub(crate) mod algebra;
pub(crate) mod arrays;
pub(crate) mod system;
pub(crate) mod many;
pub(crate) mod named_inputs;
pub(crate) mod paths;
pub(crate) mod open;
mod open_arguments;
