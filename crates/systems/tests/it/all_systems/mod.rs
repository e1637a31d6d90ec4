//! What all systems share: second derivatives, states on the heap, sizes, and drifts.

mod beyond_switches;
pub mod drifts;
mod heap_states;
mod hessians;
