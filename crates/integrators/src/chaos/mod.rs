//! Tangent vectors along a trajectory, and indicators of chaos.

pub(crate) mod generic_tangents;
pub(crate) mod tangent_integrator;
pub(crate) mod tangents;
pub(crate) mod lyapunov;
pub(crate) mod megno;
pub(crate) mod smaller_alignment;
