//! One-step methods for any vector field.

pub(crate) mod scheme;
pub(crate) mod ladder;
pub(crate) mod refinement;
pub(crate) mod runge_kutta;
pub(crate) mod stage_equations;
pub(crate) mod named_runge_kutta;
pub(crate) mod polarisation;
pub(crate) mod partitioned;
