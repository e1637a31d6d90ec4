//! The checks that need two crates: the statements of the paper, and the promises of the documentation.
#![allow(clippy::unwrap_used, clippy::panic)]

mod actions;
mod algebras;
mod allocations;
mod architecture;
mod audit;
mod bodies;
mod brackets;
mod clebsch_algebras;
mod clebsch_steps;
mod collective_dynamics;
mod compensated;
mod conservation;
mod convergence;
mod diagnostics;
mod discrete_poisson;
mod ensembles;
mod error_chains;
mod error_variants;
mod exact;
mod formulas;
mod free_rigid_body;
mod guide;
mod integrable_tops;
mod involution;
mod large_states;
mod large_steps;
mod lanes_of_members;
mod ledger;
mod lift_free;
mod lifts;
mod lyapunov_exponents;
mod memory;
mod momentum_map_l;
mod partitioned;
mod poisson_maps;
mod recentring;
mod reduced;
mod rendered;
mod scalars;
mod scales;
mod sections;
mod semidirect_group;
mod serialisation;
mod spinor_realisation;
mod spinsys_oracle;
mod symmetries;
mod tangent_vectors;
mod varpi;

/// The tutorial `docs/write_your_own.rs`, which runs as a test.
#[path = "../../docs/write_your_own.rs"]
mod write_your_own;
