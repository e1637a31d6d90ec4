//! Systems of arrays: their equations, their runs, and those with friction, forces and noise.

mod array_runs;
mod array_systems;
mod lattices_in_time;
mod open_fluids;
mod open_lattices;
