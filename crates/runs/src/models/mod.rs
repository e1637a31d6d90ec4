//! What runs follow: tops, and other Lie–Poisson systems.

pub(crate) mod conserved;
pub(crate) mod model;
pub(crate) mod top_in_axes;
pub(crate) mod top_quantity;
mod formula_system;
mod open_system;
pub(crate) mod open_top;
pub mod step_angle;
