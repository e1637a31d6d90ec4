//! Systems that a configuration describes by an algebra and a formula.

mod fluids_with_forces;
mod kinds_of_systems;
mod system_sections;
mod sweeps_with_forces;
mod system_sweeps;
mod systems;
mod systems_with_forces;
mod lattices_with_noise;
mod tops_with_forces;
mod refused_forces;
