//! One top, its sections and its chaos, and many tops at once.

pub(crate) mod body;
pub(crate) mod top;
pub(crate) mod many;
mod reports;
pub(crate) mod sections;
pub(crate) mod chaos;
