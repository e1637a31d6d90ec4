//! A vector whose dimension is known only when the program runs: [`AnyState`].

use crate::stages::flat_state::Four;
use lie_poisson::{Blocks, Real, State};
use smallvec::SmallVec;
use std::collections::BTreeSet;

/// The number of coordinates that need no storage on the heap.
const FEW: usize = 12;

/// The largest number of blocks of coordinates.
const MOST_BLOCKS: usize = 4;

/// A state or a momentum of an [`AnyIntegrator`](crate::AnyIntegrator): its coordinates, in at most four
/// [blocks](State::BLOCKS). Up to 12 coordinates need no storage on the heap.
///
/// # Example
/// ```
/// use collective_integrators::AnyState;
/// use lie_poisson::{Pair, State};
/// use nalgebra::{Vector1, Vector2};
/// let z = AnyState::of(&Pair(Vector1::new(1.0), Vector2::new(2.0, 3.0)));
/// assert_eq!(z.as_slice(), [1.0, 2.0, 3.0]);
/// assert_eq!([0, 1, 2].map(|i| z.block(i)), [0, 1, 1]);
/// ```
#[derive(Debug, PartialEq)]
pub struct AnyState<T = f64> {
    values: SmallVec<[T; FEW]>,
    blocks: BlockEnds,
}

/// The number of coordinates up to the end of each block. It is the dimension for blocks that are not used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockEnds([usize; MOST_BLOCKS]);

impl BlockEnds {
    /// Returns the blocks of the first coordinates of a vector, at most `dimension`. Those after the third count as one.
    pub(super) fn of<V: State>(v: &V, dimension: usize) -> Self {
        let dimension = dimension.min(v.dimension());
        let mut ends = [dimension; MOST_BLOCKS];
        // Vectors whose blocks are known only when the program runs leave out numbers.
        let numbers: BTreeSet<usize> = (0..dimension).map(|i| v.block(i)).collect();
        // The last end stays the dimension.
        let [before_last @ .., _] = &mut ends;
        for i in (0..dimension).rev() {
            let before = numbers.range(..v.block(i)).count().checked_sub(1);
            if let Some(end) = before.and_then(|before| before_last.get_mut(before)) {
                *end = i;
            }
        }
        Self(ends)
    }
}

impl<T: Real> AnyState<T> {
    /// Returns the coordinates of a vector, with its blocks. Blocks after the third count as one.
    #[must_use]
    pub fn of<V: State<Scalar = T>>(v: &V) -> Self {
        Self::with_blocks(v, BlockEnds::of(v, v.dimension()))
    }

    /// Returns the coordinates of a vector in these blocks.
    pub(super) fn with_blocks<V: State<Scalar = T>>(v: &V, blocks: BlockEnds) -> Self {
        let mut all = Self::zeros_of(&blocks);
        all.copy_entries(v);
        all
    }

    /// Sets the coordinates to the first ones of a vector.
    #[inline]
    pub(super) fn copy_entries<V: State<Scalar = T>>(&mut self, v: &V) {
        let copy = |values: &mut [T]| {
            for (i, value) in (0..v.dimension()).zip(values) {
                *value = v.coordinate(i);
            }
        };
        let values = self.as_mut_slice();
        // The compiler knows the number of coordinates in the first case.
        match values.get_mut(..v.dimension()) {
            Some(all) => copy(all),
            None => copy(values),
        }
    }

    /// Returns the vector of one block with these coordinates.
    #[must_use]
    pub fn from_slice(values: &[T]) -> Self {
        let blocks = BlockEnds([values.len(); MOST_BLOCKS]);
        Self { values: SmallVec::from_slice(values), blocks }
    }

    /// Returns the coordinates.
    #[must_use]
    pub fn as_slice(&self) -> &[T] {
        &self.values
    }

    /// Returns the coordinates, to be changed.
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        &mut self.values
    }
}

impl<T: Real> Clone for AnyState<T> {
    fn clone(&self) -> Self {
        Self { values: SmallVec::from_slice(&self.values), blocks: self.blocks }
    }

    /// Copies into the storage that is there, if it has the size.
    fn clone_from(&mut self, other: &Self) {
        if self.values.len() == other.values.len() {
            self.values.copy_from_slice(&other.values);
        } else {
            self.values = SmallVec::from_slice(&other.values);
        }
        self.blocks = other.blocks;
    }
}

/// Raises the largest magnitude in each block to those of its numbers, and adds all magnitudes to the sum.
#[cfg_attr(optimised, inline(always))]
fn measure<T: Real>(
    BlockEnds(ends): BlockEnds,
    number: impl Fn(usize) -> T,
    largest: &mut Four<T>,
    sum: &mut T,
) {
    let mut begin = 0;
    for (block, end) in ends.into_iter().enumerate() {
        let mut most = largest.at(block);
        for i in begin..end {
            let size = number(i).magnitude();
            most = size.maximum(most);
            *sum += size;
        }
        largest.set(block, most);
        begin = begin.max(end);
    }
}

impl<T: Real> State for AnyState<T> {
    type Scalar = T;
    type Blocks = Four<T>;
    type Shape = BlockEnds;
    type Pool = Vec<Self>;

    fn dimension(&self) -> usize {
        self.values.len()
    }

    fn shape(&self) -> BlockEnds {
        self.blocks
    }

    fn zeros_of(blocks: &BlockEnds) -> Self {
        let BlockEnds([.., dimension]) = *blocks;
        Self { values: SmallVec::from_elem(T::zero(), dimension), blocks: *blocks }
    }

    fn take(pool: &mut Vec<Self>, like: &Self) -> Self {
        pool.pop().filter(|v| v.same_shape(like)).unwrap_or_else(|| like.zeros_like())
    }

    fn give(self, pool: &mut Vec<Self>) {
        pool.push(self);
    }

    #[cfg_attr(optimised, inline(always))]
    fn coordinate(&self, i: usize) -> T {
        self.values.get(i).copied().unwrap_or_else(T::zero)
    }

    fn set_coordinate(&mut self, i: usize, x: T) {
        if let Some(value) = self.values.get_mut(i) {
            *value = x;
        }
    }

    fn blocks(&self) -> usize {
        self.dimension().checked_sub(1).map_or(1, |last| self.block(last) + 1)
    }

    fn block(&self, i: usize) -> usize {
        let BlockEnds([first, second, third, _]) = self.blocks;
        usize::from(i >= first) + usize::from(i >= second) + usize::from(i >= third)
    }

    #[cfg_attr(optimised, inline(always))]
    fn set_coordinates(&mut self, f: impl Fn(usize) -> T) {
        for (i, value) in self.values.iter_mut().enumerate() {
            *value = f(i);
        }
    }

    #[cfg_attr(optimised, inline(always))]
    fn measure(&self, largest: &mut Four<T>, sum: &mut T) {
        let values = self.values.as_slice();
        measure(
            self.blocks,
            #[cfg_attr(optimised, inline(always))]
            |i| values[i],
            largest,
            sum,
        );
    }

    #[cfg_attr(optimised, inline(always))]
    fn measure_difference(&self, x: &Self, largest: &mut Four<T>, sum: &mut T) {
        let values = self.values.as_slice();
        measure(
            self.blocks,
            #[cfg_attr(optimised, inline(always))]
            |i| values[i] - x.coordinate(i),
            largest,
            sum,
        );
    }

    fn scale_in_place(&mut self, s: T) {
        self.values.iter_mut().for_each(|v| *v *= s);
    }

    fn add_multiple(&mut self, s: T, x: &Self) {
        self.values.iter_mut().zip(&x.values).for_each(|(v, x)| *v += s * *x);
    }
}
