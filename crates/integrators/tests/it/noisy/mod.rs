//! Motions with noise: what is kept on each path, what is true in the mean, and that paths are functions of time.

mod affine_flows;
mod brownian_paths;
mod gibbs_means;
mod noisy_casimirs;
mod noisy_orders;
mod noisy_reduced;
mod paths_of_runs;
mod regressed_orders;
mod support;
