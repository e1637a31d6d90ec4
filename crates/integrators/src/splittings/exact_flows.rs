//! Vector fields whose parts have flows in closed form.

use lie_poisson::{Real, Vector};

/// A vector field X = X_1 + … + X_n whose parts have flows in closed form.
///
/// If the parts are the Hamiltonian vector fields of h = h_1 + … + h_n, their exact flows are
/// Poisson maps, and so is what is composed of them: a splitting method needs no realisation to be
/// a Poisson integrator. It needs luck with h.
///
/// # Example
/// See [`Splitting`](crate::Splitting).
pub trait ExactFlows<T: Real = f64> {
    /// Where the field lives.
    type Point: Vector<Scalar = T>;

    /// n
    const COUNT: usize;

    /// The flow of X_{index+1} for the given time, which may be negative; the identity for `index`
    /// ≥ `COUNT`.
    fn flow(&self, index: usize, time: f64, z: &Self::Point) -> Self::Point;
}
