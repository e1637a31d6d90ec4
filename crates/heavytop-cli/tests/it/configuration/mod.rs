//! What a user writes: presets, bodies, angles, initial states, assignments, and the messages about mistakes.

mod angles;
mod assignments;
mod described_bodies;
mod initial;
mod inputs_in_files;
mod presets;
mod quotations;
mod refusals;
