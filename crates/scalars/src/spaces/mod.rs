//! Vector spaces over every scalar: states, vectors, duals, sums and powers.

mod macros;
pub(crate) mod state;
pub(crate) mod vector;
pub(crate) mod covector;
pub(crate) mod matrices;
pub(crate) mod pair;
pub(crate) mod power;
pub(crate) mod sites;
pub(crate) mod quaternion;
pub(crate) mod space;
