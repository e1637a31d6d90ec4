//! The maps of Ohsawa 2019: the action on spinors, ϖ, and the realisation M.

pub(crate) mod spinor_motions;
pub(crate) mod varpi;
pub(crate) mod spinor_realisation;
