//! Motions on coadjoint orbits whose field depends on time, or loses energy.

mod driven_casimirs;
mod adaptors;
mod damped_spins;
mod driven_orders;
mod inputs;
mod poisson_steps;
