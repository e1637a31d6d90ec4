//! What is known of all orbits together: before they are drawn, and when the section is done.

pub(super) mod survey;
pub(super) mod section_summary;
pub(super) mod system_section_summary;
