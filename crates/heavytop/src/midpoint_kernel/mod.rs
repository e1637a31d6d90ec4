//! The collective midpoint rule for tops in lanes: one top, or as many as there are lanes.
//!
//! The modules in dependency order: vectors in [`components`], [`parameters`] of tops, a [`guess`]
//! of a and what follows from it, one [`step`], the [`extrapolation`] of a,
//! [`one_top`] and [`many_tops`].

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
