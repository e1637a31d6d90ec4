//! The law suites of the crate: its types obey them, and faults of any size are found.

mod map_faults_of_any_size;
mod map_laws;
mod multipliers;
mod phase_space_laws;
mod units_of_multipliers;
