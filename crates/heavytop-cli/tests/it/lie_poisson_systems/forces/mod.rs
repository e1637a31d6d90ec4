//! Systems, tops, lattices and fluids with inputs, drives, friction, noise and torques.

mod systems_with_forces;
mod tops_with_forces;
mod arrays;
mod forms_of_damping;
mod sweeps_with_forces;
mod refused_forces;
mod begun_with_forces;
mod sections_with_forces;
