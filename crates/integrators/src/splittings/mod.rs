//! Methods made from others: compositions, and splittings into exact flows.

pub(crate) mod composition;
pub(crate) mod splitting;
pub(crate) mod alternating_splitting;
pub(crate) mod tao;
