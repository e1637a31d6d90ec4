//! The command `heavytop animate`, which writes a page that shows a top in motion.

mod animation;
mod page_summary;
mod animate_command;

pub use animate_command::{MOST_FRAMES, animate};
pub use animation::Animation;
pub use page_summary::PageSummary;
