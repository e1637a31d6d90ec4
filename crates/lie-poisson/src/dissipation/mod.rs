//! Dissipation and noise whose motions stay on coadjoint orbits: double brackets, the damping of spins, temperature.

pub(crate) mod dissipation_error;
pub(crate) mod double_bracket;
pub(crate) mod gilbert_damping;
pub(crate) mod noise;
