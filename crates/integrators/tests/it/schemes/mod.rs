//! Schemes: order, symplecticity, symmetry, and what they conserve.

mod compensated_schemes;
mod compositions;
mod extended;
mod partitioned_schemes;
mod runge_kutta;
mod splitting_orders;
