//! The collective midpoint rule for tops: one top in registers, or many in lanes, by the same
//! formulas and with the same bits.
//!
//! The modules in dependency order: the [`vector`]s of R³ that the formulas are written in, as
//! [`components`] in lanes or [`in_register`]; [`parameters`] of tops, a [`guess`] of a and what
//! follows from it, one [`step`], the [`extrapolation`] of a, [`one_top`] and [`many_tops`].
//!
//! # Cost
//! A step with one guess takes 307 floating-point operations in each lane, a fused multiply-add
//! counted as two: 60 to extrapolate a, 34 for R_a, 86 for the correction d, 17 to see whether it
//! is at the floor and to apply it, 99 for the end, 11 to see that it is finite. In two registers of
//! AVX-512 three quarters of the peak of the processor are reached.
//!
//! One top takes 70 products and sums of registers and 29 exchanges of lanes. It is bound by the
//! latency of one step after the other, on two ways of some 80 cycles each: from a − d through
//! memory, |a|², the division, R_a and the residual to the next d; from Γ₁ through memory, the
//! kick, R_a, the residual, d and Γ + 4d×Γ to the next.

mod components;
mod extrapolation;
mod guess;
mod in_register;
mod many_tops;
mod one_top;
mod parameters;
mod step;
mod vector;

pub(crate) use many_tops::{Member, together};
pub(crate) use one_top::Memory;

#[cfg(test)]
mod tests;
