//! Systems by formula that are driven, damped, noisy or forced.

mod driven_formulas;
mod forced_formulas;
mod laws_of_open_systems;
mod motors_of_wheels;
mod noisy_formulas;
mod gilbert_spins;
mod satellites_on_ellipses;
mod open_refusals;
mod support;
mod tangents_of_open_systems;
