//! Realisations: quadratic momenta on R²ᵐ, what they obey, and the collective integrator that they make.

pub(crate) mod generic_point;
mod odd_powers;
pub(crate) mod quadratic_momenta;
pub(crate) mod verdict;
mod points;
mod maps;
pub(crate) mod collective;
