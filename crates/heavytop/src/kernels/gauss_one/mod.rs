//! Collective Gauss methods of one heavy top, with the stages in the SIMD lanes of a register.

mod row;
mod compensated_point;
mod stage_history;
mod gauss_coefficients;
mod stage_equations;
pub(crate) mod collective_gauss;
