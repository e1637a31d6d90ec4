//! The promises of the crate: schemes, integrators and indicators of chaos.
#![allow(clippy::unwrap_used, clippy::panic)]

mod advance;
mod collective_sites;
mod compensated_schemes;
mod compositions;
mod extended;
mod faulty_integrators;
mod faulty_schemes;
mod integrator_laws;
mod lift_free_sites;
mod lyapunov;
mod multipliers_of_steps;
mod partitioned_schemes;
mod runge_kutta;
mod spherical_midpoint;
mod splitting_orders;
mod stage_solver;
mod stages_in_lanes;
mod storage_pool;
mod support;
mod trajectory;
