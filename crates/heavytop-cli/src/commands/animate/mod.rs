//! `heavytop animate`: the top in motion, as a page for a browser.

mod animation;
mod page_summary;
mod animate_command;

pub use animate_command::{MOST_FRAMES, animate};
pub use animation::Animation;
pub use page_summary::PageSummary;
