//! The formats of outputs: CSV, NumPy's npz, Parquet.

pub(crate) mod run_table;
mod extent;
mod metadata;
mod rows;
mod npz;
pub(crate) mod parquet;
pub(crate) mod recognition;
mod format;

pub(crate) use extent::Extent;
pub use format::Format;
pub use metadata::Metadata;
pub use run_table::RunTable;
