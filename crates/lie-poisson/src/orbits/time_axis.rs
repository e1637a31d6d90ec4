//! The axis of time as a Poisson space: [`TimeAxis`].

use crate::brackets::poisson::PoissonSpace;
use crate::brackets::product_space::ProductSpace;
use generic_scalars::{Differential, Point, Real, Vector, VectorSpace};
use nalgebra::Vector1;

/// The axis of time R, whose bracket is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TimeAxis;

/// The product P × R of a Poisson space with the axis of time, whose points are (μ, t). Functions of t are Casimirs of
/// it, so that the bracket is that of P at each time.
pub type InTime<P> = ProductSpace<P, TimeAxis>;

impl VectorSpace for TimeAxis {
    type Point<T: Real> = Vector1<T>;
}

impl PoissonSpace for TimeAxis {
    #[cfg_attr(optimised, inline(always))]
    fn hamiltonian_vector<T: Real>(
        &self,
        _: &Point<Self, T>,
        _: &Differential<Self, T>,
    ) -> Point<Self, T> {
        Vector::zero()
    }
}
