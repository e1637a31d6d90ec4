//! Casimirs that are computed from matrices, where a formula would be too long.

pub(crate) mod matrix_of_momenta;
pub(crate) mod pfaffian_of_numbers;
pub(crate) mod power_trace;
pub(crate) mod wedge_square;
pub(crate) mod cyclic_vector;
pub(crate) mod computed_casimir;
