//! What goes on beside the numbers of a command: who sees how far it is, who may stop it, and what it
//! keeps to go on from.

mod progress;
mod watch;
pub(crate) mod tiled_run;
mod tile_folder;

pub use progress::Progress;
pub(crate) use tile_folder::{Held, Tiles};
pub use tiled_run::TileOptions;
pub use watch::Watch;
