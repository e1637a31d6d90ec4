//! What a user writes: presets, initial states, assignments, and the messages about mistakes.

mod assignments;
mod initial;
mod presets;
mod quotations;
mod refusals;
