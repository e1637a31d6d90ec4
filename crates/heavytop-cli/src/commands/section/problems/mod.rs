//! What a section is of: a top, or another Lie–Poisson system.

pub(super) mod limits;
pub(super) mod section_problem;
pub(super) mod top_problem;
pub(super) mod system_problem;
pub(super) mod any_problem;
