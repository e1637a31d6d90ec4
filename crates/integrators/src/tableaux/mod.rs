//! Runge–Kutta coefficients, their families and their order conditions.

pub(crate) mod order_conditions;
pub(crate) mod tableau;
pub(crate) mod gauss;
pub(crate) mod lobatto;
pub(crate) mod dirk;
pub(crate) mod dop853;
pub(crate) mod semiexplicit;
