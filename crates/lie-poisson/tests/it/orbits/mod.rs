//! Fields whose motions stay on coadjoint orbits: inputs, controls and damping.

mod controls;
mod input_tables;
mod orbit_fields;
mod faulty_fields;
mod spin_damping;
mod laws_of_noise;
