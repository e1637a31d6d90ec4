//! The errors of the commands, the texts that the program prints for them, and the exit codes.

mod quotation;
mod checkpoint_error;
mod sweep_error;
mod system_table_error;
mod error;
mod conversions;
mod exit_code;
mod message;
mod report;

pub use checkpoint_error::CheckpointError;
pub use error::Error;
pub use quotation::Quotation;
pub use report::{Place, Report};
pub use sweep_error::SweepError;
pub use system_table_error::SystemTableError;
