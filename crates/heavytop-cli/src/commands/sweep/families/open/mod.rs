//! Families of motions that are driven, damped, noisy or under a torque.

mod subject;
pub(in crate::commands::sweep) mod open_family;
