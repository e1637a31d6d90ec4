//! Rigid bodies that are not tops.

mod generalised_rigid_body;
mod gyrostat;
mod kirchhoff;
mod movable_base;
