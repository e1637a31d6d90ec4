//! Systems of arrays: their equations, their runs, and lattices of spins at a temperature.

mod array_runs;
mod array_systems;
mod thermal_lattices;
