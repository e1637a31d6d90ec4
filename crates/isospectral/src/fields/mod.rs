//! Isospectral equations Ẇ = [B(W), W].

pub(crate) mod isospectral_field;
pub(crate) mod isospectral_noise;
pub(crate) mod direct_field;
