//! Solutions in closed form: Euler's top and Lagrange's, by elliptic functions.

pub(crate) mod power_of_two;
pub(crate) mod elliptic;
pub(crate) mod euler_top;
pub(crate) mod nutation_cubic;
pub(crate) mod lagrange_nutation;
