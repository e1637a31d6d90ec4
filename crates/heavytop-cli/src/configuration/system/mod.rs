//! The table `[system]`: any Lie–Poisson system, by its algebra and a formula.

mod numbers;
mod table_file;
mod system_config;
mod system_in_time;
mod arrays_of_system;

pub use numbers::Numbers;
pub use system_config::{Bracket, SystemConfig};
