//! The errors of the commands, the texts that the program prints for them, and the exit codes.

mod quotation;
mod parts;
mod error;
mod conversions;
mod exit_code;
mod message;
mod report;

pub use error::Error;
pub use parts::checkpoint_error::CheckpointError;
pub use parts::field_file_error::FieldFileError;
pub use parts::input_file_error::InputFileError;
pub use parts::sweep_error::SweepError;
pub use parts::system_table_error::SystemTableError;
pub use quotation::Quotation;
pub use report::{Place, Report};
