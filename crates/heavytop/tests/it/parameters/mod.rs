//! What tops and their integrators accept: parameters, matrices, thin rods, names, starts, and momenta of any size.

mod extreme_momenta;
mod names_and_kinds;
mod principal_axes;
mod starts;
mod thin_rods;
mod tops;
