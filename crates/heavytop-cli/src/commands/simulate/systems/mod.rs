//! `simulate` for a Lie–Poisson system instead of a top.

mod system_summary;
mod simulate_system;

pub use simulate_system::simulate_system;
pub use system_summary::SystemSummary;
