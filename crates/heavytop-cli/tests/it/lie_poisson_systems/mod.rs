//! Systems that a configuration describes by an algebra and a formula.

mod system_sections;
mod system_sweeps;
mod systems;
