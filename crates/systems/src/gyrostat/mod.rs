//! A heavy body with a spinning rotor inside.

pub(crate) mod heavy_gyrostat;
pub(crate) mod principal_moments;
