//! How steps are made: one by one, many at once, side by side, and with which storage.

mod advance;
mod any_integrator;
mod multipliers_of_steps;
mod observed;
mod stage_solver;
mod stages_in_lanes;
mod storage_pool;
mod trajectory;
