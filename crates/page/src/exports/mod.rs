//! The functions that JavaScript calls: functions of numbers, for one top per instance of the module.
//!
//! Numbers come back in a table in memory, whose address [`numbers::show`] returns, and texts as UTF-8 at
//! [`texts::text`]. A function that can fail returns 1 if it did, and then the text is the message. An address holds
//! until the next call.

pub(crate) mod desk;
pub mod actions;
pub mod numbers;
pub mod texts;
