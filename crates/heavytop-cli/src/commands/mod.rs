//! The commands of the program, one folder each; no command imports another.

pub mod simulate;
pub mod reproduce;
pub mod compare;
pub mod report;
pub mod events;
pub mod ensemble;
pub mod section;
pub mod animate;
pub mod bench;
pub mod sweep;
pub mod export;
pub mod plot;
