//! The commands, one folder each. None knows of another.

pub mod simulate;
pub mod reproduce;
pub mod compare;
pub mod section;
pub mod animate;
pub mod bench;
pub mod sweep;
