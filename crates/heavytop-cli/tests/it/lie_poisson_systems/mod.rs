//! Systems that a configuration describes by an algebra and a formula.

mod array_sweeps;
mod files_of_arrays;
mod kinds_of_systems;
mod systems_of_arrays;
mod drawn_marks;
mod plots;
mod films;
mod system_sections;
mod system_sweeps;
mod systems;
