//! Dual numbers: their type, their operators and their functions.

mod number;
mod operators;
mod functions;

pub use number::DualNumber;
