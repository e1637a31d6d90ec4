//! Solutions in closed form, by elliptic functions: Euler's top and Lagrange's.

pub(crate) mod power_of_two;
pub(crate) mod elliptic;
pub(crate) mod euler_top;
pub(crate) mod nutation_cubic;
pub(crate) mod lagrange_nutation;
