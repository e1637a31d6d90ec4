//! A rigid body in an ideal fluid.

pub(crate) mod inverse_inertia;
pub(crate) mod kirchhoff;
