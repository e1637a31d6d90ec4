//! Euler's equations on the sphere as equations for a matrix: Zeitlin's model.

pub(crate) mod quantised_laplacian;
pub(crate) mod spherical_harmonic;
pub(crate) mod vorticity_coefficients;
pub(crate) mod zeitlin;
pub(crate) mod zeitlin_coordinates;
