//! A Hamiltonian for every Poisson space.

use core::marker::PhantomData;
use lie_poisson::{Energy, Point, PoissonSpace, Real, State, Vector};

/// The Hamiltonian ½ Σ_i a_i μ_i² + b_i μ_i with a_i between 1 and 2 and small b_i.
///
/// It has no symmetry. Its motions explore 𝔤∗ and stay bounded.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic<P>(PhantomData<P>);

impl<P> Default for Quadratic<P> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

impl<P: PoissonSpace> Energy for Quadratic<P> {
    type Space = P;

    fn energy<T: Real>(&self, mu: &Point<P, T>) -> T {
        let mut sum = T::zero();
        for i in 0..<Point<P, T> as Vector>::DIM {
            let (x, i) = (mu.coordinate(i), i as f64);
            sum += x * x * (0.5 + 0.5 * (i * 0.618).fract()) + x * (0.2 * (i * 0.755).fract());
        }
        sum
    }
}
