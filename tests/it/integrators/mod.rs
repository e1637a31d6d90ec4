//! §4–5 of the paper: collective integrators, their orders, and what they conserve.

mod collective_dynamics;
mod conservation;
mod convergence;
mod discrete_poisson;
mod free_rigid_body;
mod integrable_tops;
mod lift_free;
mod partitioned;
mod reduced;
