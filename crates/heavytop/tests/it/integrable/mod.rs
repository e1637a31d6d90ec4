//! Euler's and Lagrange's tops in closed form, and the functions that they need.

mod closed_forms;
mod euler_top;
mod jacobi_elliptic;
mod lagrange_nutation;
