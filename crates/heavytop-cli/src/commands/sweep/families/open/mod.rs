//! Families of motions that are driven, damped, noisy or under a torque.

mod subject;
mod thermal_axes;
pub mod open_family;
