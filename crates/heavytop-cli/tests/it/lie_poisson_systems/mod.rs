//! Systems that a configuration describes by an algebra and a formula.

mod bodies_with_wheels;
mod kinds_of_systems;
mod system_sections;
mod system_sweeps;
mod satellites_in_orbit;
mod systems;
mod forces;
