//! Hamiltonians of N copies of a small space, with N known only when the program runs: [`SitesHamiltonian`].

use generic_scalars::{Covector, Sites, Vector};

/// A function h on N copies of the dual 𝔤∗ of one Lie algebra, with N known only when the program runs.
///
/// `V` is the type of the elements of 𝔤 over some scalar. For spaces of a fixed dimension, such as N copies for an N
/// that the compiler knows, use [`Hamiltonian`](crate::Hamiltonian).
///
/// # Example
/// Neighbours on a ring of spins attract each other:
/// ```
/// use lie_poisson::{Covector, Real, Sites, SitesHamiltonian};
/// use nalgebra::Vector3;
/// /// h(s) = −Σ s_i·s_(i+1)
/// struct Ring;
/// impl<T: Real> SitesHamiltonian<Vector3<T>> for Ring {
///     fn value(&self, s: &Covector<Sites<Vector3<T>>>) -> T {
///         let next = s.0.iter().cycle().skip(1);
///         s.0.iter().zip(next).fold(T::zero(), |sum, (s, next)| sum - s.dot(next))
///     }
///     fn differential_into(&self, s: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
///         let n = s.0.len();
///         for (i, dh) in dh.iter_mut().enumerate() {
///             *dh = -s.0[(i + n - 1) % n] - s.0[(i + 1) % n];
///         }
///     }
/// }
/// let spins = Covector(Sites::new(vec![Vector3::x(), Vector3::y(), Vector3::y()]));
/// let mut dh = Sites::new(vec![Vector3::zeros(); 3]);
/// Ring.differential_into(&spins, &mut dh);
/// assert_eq!((Ring.value(&spins), dh[0]), (-1.0, Vector3::new(0.0, -2.0, 0.0)));
/// ```
pub trait SitesHamiltonian<V: Vector> {
    /// Returns the value h(μ). It is NaN if h has a fixed number of sites and μ has another.
    fn value(&self, mu: &Covector<Sites<V>>) -> V::Scalar;

    /// Writes the differential dh(μ), one element of 𝔤 for each site, to `dh`, which has as many sites as μ.
    ///
    /// On entry the coordinates of `dh` are arbitrary. They become NaN if h has a fixed number of sites and μ has
    /// another.
    fn differential_into(&self, mu: &Covector<Sites<V>>, dh: &mut Sites<V>);
}

/// A reference to a Hamiltonian is a Hamiltonian.
impl<V: Vector, H: SitesHamiltonian<V> + ?Sized> SitesHamiltonian<V> for &H {
    fn value(&self, mu: &Covector<Sites<V>>) -> V::Scalar {
        (**self).value(mu)
    }

    fn differential_into(&self, mu: &Covector<Sites<V>>, dh: &mut Sites<V>) {
        (**self).differential_into(mu, dh);
    }
}
