//! Powers Vᴺ of a small vector space, with N known when the program runs: [`Sites`].

use crate::numbers::real::Real;
use crate::spaces::state::State;
use crate::spaces::vector::Vector;
use core::ops::{Deref, DerefMut};

/// An element (v₁, …, v_N) of the power Vᴺ of a small space, with N known only when the program runs.
///
/// Examples are the states of N spins, of N vortices, or of N particles of a lattice. [`Power`](crate::Power) is the
/// same space for an N that the compiler knows. The vectors are accessed as those of a slice:
///
/// ```
/// use generic_scalars::{Sites, State};
/// use nalgebra::Vector3;
/// let mut spins = Sites::new(vec![Vector3::z(); 1000]);
/// spins[0] = Vector3::x();
/// assert_eq!((spins.len(), spins.dimension()), (1000, 3000));
/// assert_eq!(spins.iter().sum::<Vector3<f64>>(), Vector3::new(1.0, 0.0, 999.0));
/// spins.scale_in_place(2.0);
/// assert_eq!(spins.coordinate(3 * 999 + 2), 2.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sites<V>(Vec<V>);

impl<V> Sites<V> {
    /// Creates the element with the given vectors.
    #[must_use]
    pub const fn new(vectors: Vec<V>) -> Self {
        Self(vectors)
    }

    /// Returns the vectors of all sites.
    #[must_use]
    pub fn into_inner(self) -> Vec<V> {
        self.0
    }
}

/// Collects the vectors of an iterator.
impl<V> FromIterator<V> for Sites<V> {
    fn from_iter<I: IntoIterator<Item = V>>(vectors: I) -> Self {
        Self(vectors.into_iter().collect())
    }
}

impl<V> Deref for Sites<V> {
    type Target = [V];

    #[inline]
    fn deref(&self) -> &[V] {
        &self.0
    }
}

impl<V> DerefMut for Sites<V> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [V] {
        &mut self.0
    }
}

/// The operations of a [`State`] that is a sequence of vectors of one space, one vector after the other.
macro_rules! operations_by_sites {
    ($inline:meta) => {
        #[$inline]
        fn coordinate(&self, i: usize) -> V::Scalar {
            // Vectors of dimension 0 have no coordinates; the width 1 avoids a division by zero.
            let width = V::DIM.max(1);
            self.0.get(i / width).map_or_else(num_traits::zero, |v| v.coordinate(i % width))
        }

        #[$inline]
        fn set_coordinate(&mut self, i: usize, x: V::Scalar) {
            let width = V::DIM.max(1);
            if let Some(v) = self.0.get_mut(i / width) {
                v.set_coordinate(i % width, x);
            }
        }

        /// Returns the block of a coordinate within its vector: all vectors share their blocks.
        #[$inline]
        fn block(&self, i: usize) -> usize {
            if V::BLOCKS == 1 { 0 } else { V::zero().block(i % V::DIM.max(1)) }
        }

        #[$inline]
        fn set_zero(&mut self) {
            self.0.fill(V::zero());
        }

        #[$inline]
        fn add_in_place(&mut self, x: &Self) {
            for (v, x) in self.0.iter_mut().zip(&x.0) {
                v.add_in_place(x);
            }
        }

        #[$inline]
        fn subtract_in_place(&mut self, x: &Self) {
            for (v, x) in self.0.iter_mut().zip(&x.0) {
                v.subtract_in_place(x);
            }
        }

        #[$inline]
        fn subtract_from(&mut self, x: &Self) {
            for (v, x) in self.0.iter_mut().zip(&x.0) {
                v.subtract_from(x);
            }
        }

        #[$inline]
        fn negate_in_place(&mut self) {
            for v in &mut self.0 {
                v.negate_in_place();
            }
        }

        #[$inline]
        fn scale_in_place(&mut self, s: V::Scalar) {
            for v in &mut self.0 {
                v.scale_in_place(s);
            }
        }

        #[$inline]
        fn add_multiple(&mut self, s: V::Scalar, x: &Self) {
            for (v, x) in self.0.iter_mut().zip(&x.0) {
                v.add_multiple(s, x);
            }
        }

        /// Adds all terms at one site before going on to the next site, so that the sum passes through memory once.
        #[$inline]
        fn add_combination(&mut self, a: &[f64], k: &[Self]) {
            for (i, v) in self.0.iter_mut().enumerate() {
                for (&a, k) in a.iter().zip(k) {
                    if let Some(k) = k.0.get(i) {
                        v.add_multiple(V::Scalar::from_f64(a), k);
                    }
                }
            }
        }

        #[$inline]
        fn replace_where(&mut self, mask: <V::Scalar as Real>::Mask, x: &Self) {
            for (v, x) in self.0.iter_mut().zip(&x.0) {
                v.replace_where(mask, x);
            }
        }

        #[$inline]
        fn measure(&self, largest: &mut V::Blocks, sum: &mut V::Scalar) {
            for v in &self.0 {
                v.measure(largest, sum);
            }
        }

        #[$inline]
        fn measure_difference(&self, x: &Self, largest: &mut V::Blocks, sum: &mut V::Scalar) {
            for (v, x) in self.0.iter().zip(&x.0) {
                v.measure_difference(x, largest, sum);
            }
        }
    };
}
pub(crate) use operations_by_sites;

impl<V: Vector> State for Sites<V> {
    type Scalar = V::Scalar;
    type Blocks = V::Blocks;
    /// The number of sites.
    type Shape = usize;
    type Pool = Vec<Self>;

    #[inline]
    fn dimension(&self) -> usize {
        self.len() * V::DIM
    }

    #[inline]
    fn shape(&self) -> usize {
        self.len()
    }

    fn zeros_of(sites: &usize) -> Self {
        Self(vec![V::zero(); *sites])
    }

    /// Takes from the pool the vector that was given back last, or allocates one.
    #[inline]
    fn take(pool: &mut Vec<Self>, like: &Self) -> Self {
        let last = pool.pop().filter(|last| last.same_shape(like));
        last.unwrap_or_else(|| like.zeros_like())
    }

    #[inline]
    fn give(self, pool: &mut Vec<Self>) {
        pool.push(self);
    }

    #[inline]
    fn assign(&mut self, x: &Self) {
        self.0.clone_from(&x.0);
    }

    operations_by_sites!(inline);
}
