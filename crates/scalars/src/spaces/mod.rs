//! Vector spaces over every scalar: vectors, duals, sums and powers, and derivatives of maps between them.

pub(crate) mod vector;
pub(crate) mod covector;
pub(crate) mod matrices;
pub(crate) mod pair;
pub(crate) mod power;
pub(crate) mod quaternion;
pub(crate) mod space;
pub(crate) mod derivative;
pub(crate) mod norm;
