//! Methods made from others: compositions, and splittings into exact flows.

pub(crate) mod composition;
pub(crate) mod exact_flows;
pub(crate) mod flow_sequence;
pub(crate) mod splitting;
pub(crate) mod tao;
