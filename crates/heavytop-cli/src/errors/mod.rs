//! What can go wrong in a command, what the program prints of it, and the exit codes.

mod checkpoint_error;
mod sweep_error;
mod error;
mod message;

pub use checkpoint_error::CheckpointError;
pub use error::Error;
pub use sweep_error::SweepError;
