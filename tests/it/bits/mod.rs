//! The same bits in lanes, on threads, from memory and from files, and no allocations in a step.

mod allocations;
mod ensembles;
pub mod lanes_of_members;
mod memory;
mod scalars;
mod serialisation;
