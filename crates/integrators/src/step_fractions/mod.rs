//! Fractions of a step: the coefficients of compositions and splittings, and the conditions on them.

pub(crate) mod composition_conditions;
pub(crate) mod substeps;
pub(crate) mod named_substeps;
pub(crate) mod alternating_conditions;
pub(crate) mod alternating_substeps;
