//! Realisations of one's own: quadratic momenta on R²ᵐ, what they obey, and the collective integrator that they make.

mod generic_point;
mod odd_powers;
mod cocycles;
mod clebsch;
pub(crate) mod quadratic_momenta;
pub(crate) mod verdict;
pub(crate) mod lift;
mod recentring;
pub(crate) mod collective;
