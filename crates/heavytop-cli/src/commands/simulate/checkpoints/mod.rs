//! What an interrupted run leaves: its rows, and the state after them.

mod state_text;
pub(super) mod growing_file;
pub(super) mod checkpoint;
