//! The command `heavytop section`, which computes and draws Poincaré sections on an energy level.

mod problems;
mod settings;
mod plane_range;
mod orbits;
mod survey;
mod section_summary;
mod picture;
mod point_table;
mod section_forecast;
mod section_command;

pub use section_command::section;
pub use section_forecast::{dry_run, forecast};
pub use section_summary::SectionSummary;
