//! What tops and their integrators accept: parameters, names, starts, and momenta of any size.

mod extreme_momenta;
mod names_and_kinds;
mod starts;
mod tops;
