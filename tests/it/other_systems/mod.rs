//! Collective integrators beyond the paper: other bodies, other algebras, large states, and formulas.

mod bodies;
mod clebsch_algebras;
mod clebsch_runs;
mod clebsch_steps;
mod formulas;
mod large_states;
mod rounded_algebras;
mod spinsys_oracle;
mod systems_by_kind;
