//! The methods of the page, and motions that make their steps.

pub(crate) mod snapshot;
pub(crate) mod motion;
pub(crate) mod direct_with_attitude;
pub(crate) mod friction;
pub(crate) mod damped;
pub(crate) mod page_method;
