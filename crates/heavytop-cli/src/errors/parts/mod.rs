//! The errors of parts of the program.

pub(super) mod checkpoint_error;
pub(super) mod field_file_error;
pub(super) mod input_file_error;
mod open_keys;
pub(super) mod sweep_error;
pub(super) mod system_table_error;
