//! The formulas of the collective midpoint rule for tops, with bit-identical results for one top in registers and for
//! many in SIMD lanes.
//!
//! The module [`register_vector`] holds the vectors of R³ in which the formulas are written, and [`components`] and
//! [`in_register`] hold its two forms. [`midpoint_parameters`] holds the parameters of tops, [`guess`] half a step from
//! a guess of a, [`step`] one step, and [`extrapolation`] the next guess. [`one_top`] and [`many_tops`] use them.
//!
//! # Cost
//! A step with one guess takes 310 floating-point operations in each lane, a fused multiply-add counted as
//! two: 57 for the extrapolation of a, 22 for R_a, 86 for the correction d, 16 to test it against the floor
//! and to apply it, 123 for the end, and 6 to test that the end is finite. With two registers of AVX-512 it
//! reaches three quarters of the peak of the processor.
//!
//! One top takes 73 products and sums of registers and 31 exchanges of lanes. Its speed is bound by the
//! latency of one step after the other, on two paths of more than 80 cycles. One leads from a − d through
//! memory, |a|², the division, R_a and the residual to the next d. The other leads from Γ₁ through memory,
//! the kick, R_a, the residual, d and W Γ + 2d×G to the next Γ₁.

mod components;
mod extrapolation;
mod guess;
mod in_register;
mod many_tops;
mod midpoint_parameters;
mod one_top;
mod register_vector;
mod step;

pub(crate) use many_tops::{Member, together};
pub(crate) use one_top::GuessHistory;

#[cfg(test)]
mod tests;
