//! Polarisations, which divide coordinates into positions and momenta: [`Polarisation`].

use core::fmt::Debug;
use lie_poisson::State;

/// A splitting of the coordinates of a symplectic vector space into positions q and momenta p, with dq ∧ dp.
///
/// Partitioned methods need a polarisation; equivariant ones do not. If a type of points orders its coordinates neither
/// as [`FirstHalf`] nor as [`Alternating`], implement a polarisation for it.
///
/// # Example
/// ```
/// use collective_integrators::{Alternating, FirstHalf, Polarisation};
/// use nalgebra::Vector4;
/// let (u, v) = (Vector4::new(1.0, 2.0, 3.0, 4.0), Vector4::new(5.0, 6.0, 7.0, 8.0));
/// assert_eq!(FirstHalf::splice(&u, &v), Vector4::new(1.0, 2.0, 7.0, 8.0));
/// assert_eq!(Alternating::splice(&u, &v), Vector4::new(1.0, 6.0, 3.0, 8.0));
/// ```
pub trait Polarisation: Copy + Debug + Default + PartialEq + Send + Sync + 'static {
    /// Returns whether the i-th of `dim` coordinates is a position.
    fn is_position(i: usize, dim: usize) -> bool;

    /// Returns the index of the coordinate that is conjugate to the i-th of `dim`.
    fn conjugate(i: usize, dim: usize) -> usize;

    /// Returns the point with the positions q of u and the momenta p of v.
    #[cfg_attr(optimised, inline(always))]
    fn splice<V: State>(u: &V, v: &V) -> V {
        let mut z = v.clone();
        Self::splice_into(u, v, &mut z);
        z
    }

    /// Writes to z the point with the positions q of u and the momenta p of v.
    #[cfg_attr(optimised, inline(always))]
    fn splice_into<V: State>(u: &V, v: &V, z: &mut V) {
        let dimension = z.dimension();
        z.set_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| if Self::is_position(i, dimension) { u.coordinate(i) } else { v.coordinate(i) },
        );
    }
}

/// The coordinate order (q₁, …, q_n, p₁, …, p_n), as in points [`Cotangent`](momentum_map::Cotangent) of T∗Q.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FirstHalf;

impl Polarisation for FirstHalf {
    #[cfg_attr(optimised, inline(always))]
    fn is_position(i: usize, dim: usize) -> bool {
        i < dim / 2
    }

    #[cfg_attr(optimised, inline(always))]
    fn conjugate(i: usize, dim: usize) -> usize {
        if i < dim / 2 { i + dim / 2 } else { i - dim / 2 }
    }
}

/// The coordinate order (q₁, p₁, q₂, p₂, …), as in complex vectors z = q + ip and powers of their space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Alternating;

impl Polarisation for Alternating {
    #[cfg_attr(optimised, inline(always))]
    fn is_position(i: usize, _: usize) -> bool {
        i.is_multiple_of(2)
    }

    #[cfg_attr(optimised, inline(always))]
    fn conjugate(i: usize, _: usize) -> usize {
        i ^ 1
    }
}
