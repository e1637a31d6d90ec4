//! What can be said of all members of a sweep before they are followed.

pub(super) mod worst_accuracy;
pub(super) mod impossible_members;
