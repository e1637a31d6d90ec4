//! Collective Gauss methods of one heavy top, with the stages in the SIMD lanes of a register.

mod row;
mod point;
mod memory;
mod coefficients;
mod kernel;
pub(crate) mod collective_gauss;
