//! Stage equations: their solver, its convergence tests, and predictions from the steps before.

pub(crate) mod two_sum;
pub(crate) mod block_sizes;
pub(crate) mod convergence;
pub(crate) mod stage_scale;
pub(crate) mod stage_solver;
pub(crate) mod newton;
pub(crate) mod extrapolation;
pub(crate) mod history;
pub(crate) mod stage_memory;
