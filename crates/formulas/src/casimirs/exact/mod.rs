//! Exact linear algebra modulo a prime, for structure constants that are fractions times square roots.

pub(crate) mod residue;
pub(crate) mod roots;
pub(crate) mod null_space;
pub(crate) mod recognition;
pub(crate) mod exact_brackets;
