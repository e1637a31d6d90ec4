//! Which coordinates are positions, and which momenta.

use core::fmt::Debug;
use lie_poisson::Vector;

/// A splitting of the coordinates of a symplectic vector space into q and p, with dq ∧ dp.
///
/// It is what a partitioned method needs to know of its phase space, and what an equivariant one
/// has no use for. A type of points whose coordinates are ordered otherwise than in [`FirstHalf`]
/// and [`Alternating`] gets a polarisation of its own in a few lines.
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
    /// Whether the i-th of `dim` coordinates is a position.
    fn is_position(i: usize, dim: usize) -> bool;

    /// The index of the coordinate that is conjugate to the i-th of `dim`.
    fn conjugate(i: usize, dim: usize) -> usize;

    /// (q of u, p of v)
    #[inline]
    fn splice<V: Vector>(u: &V, v: &V) -> V {
        V::from_coordinates(|i| {
            if Self::is_position(i, V::DIM) { u.coordinate(i) } else { v.coordinate(i) }
        })
    }
}

/// (q₁, …, q_n, p₁, …, p_n): points of T∗Q as [`Cotangent`](momentum_map::Cotangent).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FirstHalf;

impl Polarisation for FirstHalf {
    #[inline]
    fn is_position(i: usize, dim: usize) -> bool {
        i < dim / 2
    }

    #[inline]
    fn conjugate(i: usize, dim: usize) -> usize {
        if i < dim / 2 { i + dim / 2 } else { i - dim / 2 }
    }
}

/// (q₁, p₁, q₂, p₂, …): complex vectors z = q + ip, and powers of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Alternating;

impl Polarisation for Alternating {
    #[inline]
    fn is_position(i: usize, _: usize) -> bool {
        i.is_multiple_of(2)
    }

    #[inline]
    fn conjugate(i: usize, _: usize) -> usize {
        i ^ 1
    }
}
