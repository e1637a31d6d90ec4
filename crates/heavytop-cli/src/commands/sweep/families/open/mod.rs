//! Families of motions that are driven, damped, noisy or under a torque.

mod subject;
pub mod open_family;
