//! The command `heavytop report`, which tells the rates and turning points of a top beside the formulas of textbooks.

mod report_table;
mod report_command;

pub use report_command::report;
pub use report_table::ReportTable;
