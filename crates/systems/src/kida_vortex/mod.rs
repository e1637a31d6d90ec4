//! An elliptical vortex in a strain.

pub(crate) mod elliptical_patch;
pub(crate) mod lorentz_algebra;
