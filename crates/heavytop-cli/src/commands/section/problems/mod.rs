//! The motions that sections are made of: those of a top, of another Lie–Poisson system, or with forces.

pub(super) mod limits;
pub(super) mod section_problem;
pub(super) mod top_problem;
pub(super) mod system_problem;
pub(super) mod open_problem;
