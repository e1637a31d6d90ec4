//! Systems by formula that are driven, damped, noisy or forced.

mod driven_formulas;
mod forced_formulas;
mod noisy_formulas;
mod open_refusals;
mod support;
