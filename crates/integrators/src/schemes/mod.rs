//! One-step methods that know nothing of 𝔤.

pub(crate) mod scheme;
pub(crate) mod refinement;
pub(crate) mod runge_kutta;
pub(crate) mod polarisation;
pub(crate) mod partitioned;
