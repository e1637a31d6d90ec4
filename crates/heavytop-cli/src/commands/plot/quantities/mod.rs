//! The columns of a run that pictures show, with their symbols and units.

mod top_words;
pub(super) mod run_column;
pub(super) mod selection;
