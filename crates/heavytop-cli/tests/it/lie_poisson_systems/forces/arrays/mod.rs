//! Lattices and fluids of any size with inputs, drives, friction, noise and torques.

mod fluids_with_forces;
mod lattices_with_drives;
mod lattices_with_noise;
