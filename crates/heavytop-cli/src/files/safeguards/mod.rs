//! What outputs may replace: no file that the command reads, and no file that the program has not written.

pub(crate) mod kind;
pub(crate) mod safeguard;
