//! States of fixed dimension, and of a dimension that is known only when the program runs: [`State`].

use crate::numbers::blocks::Blocks;
use crate::numbers::mask::Mask;
use crate::numbers::real::Real;
use core::fmt::Debug;

/// A vector that an integrator advances: either small and of fixed dimension, or large and on the heap.
///
/// The operations work in place, so that a large vector needs no storage for intermediate results. A small vector is
/// also a [`Vector`](crate::Vector), which adds operators that compute by value.
///
/// A structure of one or two states is a state by [`state_of_parts!`](crate::state_of_parts), and so are
/// [`Pair`](crate::Pair), [`Power`](crate::Power) and [`Sites`](crate::Sites).
///
/// The arguments of an operation belong to one space ([`same_shape`](Self::same_shape)). Otherwise the result has no
/// meaning, but no operation panics.
///
/// # Temporary vectors
/// A method that needs a temporary vector [takes](Self::take) it from a pool and [gives](Self::give) it back. The
/// pool of a small type is `()`: the vector is a local variable. The pool of a large type is `Vec<Self>`: nothing is
/// allocated after the first step.
///
/// # Example
/// ```
/// use generic_scalars::{Pair, State};
/// use nalgebra::{Vector1, Vector2};
///
/// /// Returns y + 2x.
/// fn moved<V: State<Scalar = f64>>(y: &V, x: &V, pool: &mut V::Pool) -> V {
///     let mut z = V::take(pool, y);
///     z.assign(y);
///     z.add_multiple(2.0, x);
///     z
/// }
/// let (y, x) = (Pair(Vector1::new(1.0), Vector2::new(0.0, 3.0)), Pair(Vector1::new(0.5), Vector2::x()));
/// let z = moved(&y, &x, &mut Default::default());
/// assert_eq!(z, Pair(Vector1::new(2.0), Vector2::new(2.0, 3.0)));
/// ```
/// A state of your own on the heap needs eleven items, and two more to reuse its storage; the other methods have
/// defaults:
/// ```
/// use generic_scalars::State;
/// #[derive(Clone, Debug, PartialEq)]
/// struct Heap(Vec<f64>);
/// impl State for Heap {
///     type Scalar = f64;
///     type Blocks = (f64,);
///     type Shape = usize;
///     type Pool = Vec<Self>;
///     fn dimension(&self) -> usize { self.0.len() }
///     fn shape(&self) -> usize { self.0.len() }
///     fn zeros_of(length: &usize) -> Self { Self(vec![0.0; *length]) }
///     fn take(pool: &mut Vec<Self>, like: &Self) -> Self {
///         pool.pop().filter(|v| v.same_shape(like)).unwrap_or_else(|| like.zeros_like())
///     }
///     fn give(self, pool: &mut Vec<Self>) { pool.push(self) }
///     fn coordinate(&self, i: usize) -> f64 { self.0.get(i).copied().unwrap_or(0.0) }
///     fn set_coordinate(&mut self, i: usize, x: f64) {
///         if let Some(v) = self.0.get_mut(i) { *v = x }
///     }
///     fn scale_in_place(&mut self, s: f64) { self.0.iter_mut().for_each(|v| *v *= s) }
///     fn add_multiple(&mut self, s: f64, x: &Self) {
///         self.0.iter_mut().zip(&x.0).for_each(|(v, x)| *v += s * x)
///     }
/// }
/// let (mut v, x) = (Heap(vec![1.0, 2.0]), Heap(vec![3.0, -1.0]));
/// v.subtract_from(&x);
/// assert_eq!(v, Heap(vec![2.0, -3.0]));
/// assert!(v.is_finite() && x.zeros_like() == Heap(vec![0.0; 2]));
/// ```
pub trait State: Clone + Debug + PartialEq + Send + Sync + 'static {
    /// The type of the real numbers.
    type Scalar: Real;

    /// The type of one number for each block of coordinates.
    ///
    /// It is `(Self::Scalar,)` if all coordinates have the same unit and the same scale, and a pair for the two parts
    /// of a vector such as (q, p), whose units differ. Tests of size, such as the convergence tests of implicit
    /// methods, compare each block with itself, so that no result depends on units.
    type Blocks: Blocks<Self::Scalar>;

    /// The data that distinguish one space of this type from another: `()` for a small type, the number of sites or
    /// the size of a matrix for a large one.
    ///
    /// It does not contain numbers of the type [`Scalar`](Self::Scalar): the same space over dual numbers has the same
    /// shape.
    type Shape: Clone + Debug + PartialEq + Send + Sync;

    /// The storage of temporary vectors: `()` for a small type, `Vec<Self>` for a large one.
    type Pool: Clone + Debug + Default + Send + Sync;

    /// The number of blocks of coordinates.
    const BLOCKS: usize = <Self::Blocks as Blocks<Self::Scalar>>::COUNT;

    /// Returns the dimension over the reals.
    fn dimension(&self) -> usize;

    /// Returns the shape of the vector, which distinguishes its space from the others of this type.
    fn shape(&self) -> Self::Shape;

    /// Returns the zero vector of the space of a shape.
    #[must_use]
    fn zeros_of(shape: &Self::Shape) -> Self;

    /// Returns whether the two vectors belong to one space.
    #[cfg_attr(optimised, inline(always))]
    fn same_shape(&self, other: &Self) -> bool {
        self.shape() == other.shape()
    }

    /// Returns the zero vector of the same space.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn zeros_like(&self) -> Self {
        Self::zeros_of(&self.shape())
    }

    /// Takes a vector of the space of `like` from the pool. Its coordinates are arbitrary. The default is a new vector,
    /// which is right for a small type.
    #[must_use]
    #[cfg_attr(optimised, inline(always))]
    fn take(_pool: &mut Self::Pool, like: &Self) -> Self {
        like.zeros_like()
    }

    /// Gives a vector back to the pool. The default drops it.
    #[cfg_attr(optimised, inline(always))]
    fn give(self, _pool: &mut Self::Pool) {}

    /// Copies another vector into the storage of this one: v ← x.
    #[cfg_attr(optimised, inline(always))]
    fn assign(&mut self, x: &Self) {
        self.clone_from(x);
    }

    /// Takes the value of another vector, whose coordinates are arbitrary afterwards.
    ///
    /// A small vector is copied, and a large one exchanges its storage.
    #[cfg_attr(optimised, inline(always))]
    fn move_from(&mut self, other: &mut Self) {
        core::mem::swap(self, other);
    }

    /// Returns the i-th coordinate, or zero for i ≥ [`dimension`](Self::dimension).
    fn coordinate(&self, i: usize) -> Self::Scalar;

    /// Sets the i-th coordinate; does nothing for i ≥ [`dimension`](Self::dimension).
    fn set_coordinate(&mut self, i: usize, x: Self::Scalar);

    /// Sets every coordinate: vᵢ ← f(i).
    #[cfg_attr(optimised, inline(always))]
    fn set_coordinates(&mut self, f: impl Fn(usize) -> Self::Scalar) {
        for i in 0..self.dimension() {
            self.set_coordinate(i, f(i));
        }
    }

    /// Returns the number of blocks that the vector has: [`BLOCKS`](Self::BLOCKS), or fewer if that is known only when the
    /// program runs. The blocks that it lacks are the last ones.
    #[cfg_attr(optimised, inline(always))]
    fn blocks(&self) -> usize {
        Self::BLOCKS
    }

    /// Returns the block of the i-th coordinate, a number below [`BLOCKS`](Self::BLOCKS). The default is 0.
    ///
    /// ```
    /// use generic_scalars::{Covector, Pair, State};
    /// use nalgebra::Vector3;
    /// type Momentum = Covector<Pair<Vector3<f64>, Vector3<f64>>>; // (Π, Γ)
    /// let momentum = Momentum::new(Vector3::x(), Vector3::y());
    /// assert_eq!(Momentum::BLOCKS, 2);
    /// assert_eq!([0, 2, 3, 5].map(|i| momentum.block(i)), [0, 0, 1, 1]);
    /// ```
    #[cfg_attr(optimised, inline(always))]
    fn block(&self, _i: usize) -> usize {
        0
    }

    /// Sets all coordinates to zero.
    #[cfg_attr(optimised, inline(always))]
    fn set_zero(&mut self) {
        self.set_coordinates(|_| Self::Scalar::from_f64(0.0));
    }

    /// Adds another vector: v ← v + x.
    #[cfg_attr(optimised, inline(always))]
    fn add_in_place(&mut self, x: &Self) {
        self.add_multiple(Self::Scalar::from_f64(1.0), x);
    }

    /// Subtracts another vector: v ← v − x.
    #[cfg_attr(optimised, inline(always))]
    fn subtract_in_place(&mut self, x: &Self) {
        self.add_multiple(Self::Scalar::from_f64(-1.0), x);
    }

    /// Subtracts from another vector: v ← x − v.
    #[cfg_attr(optimised, inline(always))]
    fn subtract_from(&mut self, x: &Self) {
        self.negate_in_place();
        self.add_in_place(x);
    }

    /// Changes the sign: v ← −v.
    #[cfg_attr(optimised, inline(always))]
    fn negate_in_place(&mut self) {
        self.scale_in_place(Self::Scalar::from_f64(-1.0));
    }

    /// Multiplies by a number: v ← s v.
    fn scale_in_place(&mut self, s: Self::Scalar);

    /// Adds a multiple of another vector: v ← v + s x.
    fn add_multiple(&mut self, s: Self::Scalar, x: &Self);

    /// Adds a linear combination of vectors: v ← v + Σ aⱼ kⱼ, in the order of the terms. Surplus coefficients or
    /// vectors are ignored.
    #[cfg_attr(optimised, inline(always))]
    fn add_combination(&mut self, a: &[f64], k: &[Self]) {
        for (&a, k) in a.iter().zip(k) {
            self.add_multiple(Self::Scalar::from_f64(a), k);
        }
    }

    /// Replaces the vector by another one in the SIMD lanes in which the mask is true.
    #[cfg_attr(optimised, inline(always))]
    fn replace_where(&mut self, mask: <Self::Scalar as Real>::Mask, x: &Self) {
        for i in 0..self.dimension() {
            self.set_coordinate(i, Real::select(mask, x.coordinate(i), self.coordinate(i)));
        }
    }

    /// Raises `largest` in each block to the largest |vᵢ| in that block, and adds every |vᵢ| to `sum`.
    ///
    /// The sum is NaN where a coordinate is NaN. The largest number may lose a NaN.
    #[cfg_attr(optimised, inline(always))]
    fn measure(&self, largest: &mut Self::Blocks, sum: &mut Self::Scalar) {
        for i in 0..self.dimension() {
            let (block, size) = (self.block(i), self.coordinate(i).magnitude());
            largest.set(block, size.maximum(largest.at(block)));
            *sum += size;
        }
    }

    /// Measures the difference v − x, as [`measure`](Self::measure) does. So iterations see what still changes; a coordinate
    /// that none of them changes, such as a time, may leave its difference out.
    #[cfg_attr(optimised, inline(always))]
    fn measure_difference(&self, x: &Self, largest: &mut Self::Blocks, sum: &mut Self::Scalar) {
        for i in 0..self.dimension() {
            let (block, size) = (self.block(i), (self.coordinate(i) - x.coordinate(i)).magnitude());
            largest.set(block, size.maximum(largest.at(block)));
            *sum += size;
        }
    }

    /// Returns whether every coordinate is a finite number in every lane.
    #[cfg_attr(optimised, inline(always))]
    fn is_finite(&self) -> bool {
        let zero = Self::Scalar::from_f64(0.0);
        let (mut largest, mut sum) = (Self::Blocks::uniform(zero), zero);
        self.measure(&mut largest, &mut sum);
        // Numbers may be finite although their sum is not. The sum keeps a NaN that the maximum loses.
        let most = Self::Scalar::from_f64(f64::MAX);
        let finite = (0..Self::BLOCKS).fold(
            sum.at_most(sum),
            #[cfg_attr(optimised, inline(always))]
            |finite, block| finite.and(largest.at(block).at_most(most)),
        );
        finite.all()
    }
}
