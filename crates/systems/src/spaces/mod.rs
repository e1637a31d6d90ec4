//! Phase spaces that several systems share.

pub(crate) mod spin_space;
