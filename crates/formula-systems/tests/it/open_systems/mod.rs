//! Systems by formula that are driven, damped, noisy or forced.

mod driven_formulas;
mod forced_formulas;
mod laws_of_open_systems;
mod noisy_formulas;
mod gilbert_spins;
mod open_refusals;
mod paths_without_a_lift;
pub mod support;
mod tangents_of_open_systems;
