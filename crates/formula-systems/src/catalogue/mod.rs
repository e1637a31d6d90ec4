//! Systems by name: each in a file of its own, and in the list `SystemKind::ALL`.

pub(crate) mod parameter;
pub(crate) mod system_kind;
mod bodies;
mod fluids_and_spins;
mod all;
