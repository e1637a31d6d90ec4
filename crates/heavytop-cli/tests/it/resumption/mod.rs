//! Interruptions: runs continue to the same bytes, or leave nothing behind.

mod altered_checkpoints;
mod altered_tiles;
pub mod checkpoint;
mod interruptions;
mod locks;
pub mod tiles;
