//! The motions that sections are made of: those of a top, or of another Lie–Poisson system.

pub(super) mod limits;
pub(super) mod section_problem;
pub(super) mod top_problem;
pub(super) mod system_problem;
