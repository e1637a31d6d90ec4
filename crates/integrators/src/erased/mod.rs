//! Integrators whose type is known only when the program runs: one type for all of them, and the state of any dimension.

mod any_state;
mod any_steps;
mod any_integrator;
mod by_pointer;

pub use any_integrator::AnyIntegrator;
pub use any_state::AnyState;
pub use any_steps::{AnyStart, AnySteps, AnyTangents, AnyWorkspace};
pub use by_pointer::ByPointer;
