//! Brownian motions that are functions of the time.

mod normal_quantile;
mod philox;
pub(crate) mod brownian_paths;
