//! Isospectral equations with the time, inputs, controls, damping and noise in them.

mod casimirs_of_su3;
mod driven_isospectral;
mod isotropic_noise;
mod noisy_isospectral;
mod support;
mod temperatures;
