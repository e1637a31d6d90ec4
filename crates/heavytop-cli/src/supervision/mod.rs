//! The supervision of a command: its forecast, its progress bar, requests to stop, and the finished parts from which it continues.

pub(crate) mod forecast;
mod progress;
mod watch;
pub(crate) mod warnings;
pub(crate) mod tiled_run;
mod tile_folder;

pub use forecast::Forecast;
pub use progress::Progress;
pub(crate) use tile_folder::{Held, Tiles};
pub use tiled_run::TileOptions;
pub use watch::Watch;
