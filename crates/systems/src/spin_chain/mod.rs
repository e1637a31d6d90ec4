//! Classical spins in a row.

pub(crate) mod heisenberg_chain;
