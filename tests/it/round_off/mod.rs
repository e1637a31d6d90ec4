//! Where numbers are limited: round-off over many steps, large steps, small points, and units.

mod compensated;
mod large_steps;
mod recentring;
mod scales;
mod scales_of_measurements;
mod scales_of_systems;
