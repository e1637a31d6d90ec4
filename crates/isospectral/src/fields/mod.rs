//! Isospectral equations Ẇ = [B(W), W].

pub(crate) mod isospectral_field;
pub(crate) mod isospectral_noise;
pub(crate) mod driven_isospectral_field;
pub(crate) mod isospectral_double_bracket;
pub(crate) mod isotropic_isospectral_noise;
pub(crate) mod direct_field;
