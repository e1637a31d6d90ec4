//! The fixed-point iteration for stage equations, and the test of its convergence.

pub(crate) mod block_sizes;
pub(crate) mod convergence;
pub(crate) mod stage_scale;
pub(crate) mod stage_solver;
pub(crate) mod stage_rows;
pub(crate) mod lane_problem;
pub(crate) mod prediction;
