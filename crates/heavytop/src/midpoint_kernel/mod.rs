//! The collective midpoint rule for tops in lanes: one top, or as many as there are lanes.
//!
//! The modules in dependency order: vectors in [`components`], [`parameters`] of tops, a [`guess`]
//! of a and what follows from it, one [`step`], the [`extrapolation`] of a,
//! [`one_top`] and [`many_tops`].
//!
//! # Cost
//! A step with one guess takes 299 floating-point operations in each lane, a fused multiply-add
//! counted as two: 60 to extrapolate a, 30 for R_a, 84 for the correction d, 14 to see whether it
//! is at the floor and to apply it, 100 for the end, 11 to see that it is finite. One top is bound
//! by the latency of one step after the other; in two registers of AVX-512 two thirds of the peak
//! of the processor are reached.

mod components;
mod extrapolation;
mod guess;
mod many_tops;
mod one_top;
mod parameters;
mod step;

pub(crate) use many_tops::{ManyTops, Member};
pub(crate) use one_top::Memory;
pub(crate) use parameters::Top;

#[cfg(test)]
mod tests;
