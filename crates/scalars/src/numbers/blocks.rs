//! One number per block of coordinates: [`Blocks`].

use core::fmt::Debug;

/// One value for each [block](crate::State::BLOCKS) of coordinates of a vector, such as the size of q and the size of
/// p for a vector (q, p).
///
/// The type is `(T,)` for a vector of one block, and a pair `(A, B)` for the blocks of two vectors.
///
/// ```
/// use generic_scalars::{Blocks, Covector, Pair, State};
/// use nalgebra::Vector3;
/// type Momentum = Covector<Pair<Vector3<f64>, Vector3<f64>>>; // (Π, Γ)
/// let mut sizes = <Momentum as State>::Blocks::uniform(0.0);
/// sizes.set(1, 9.81);
/// assert_eq!((sizes.at(0), sizes.at(1)), (0.0, 9.81));
/// ```
pub trait Blocks<T>: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// The number of blocks.
    const COUNT: usize;

    /// Returns the same value for every block.
    #[must_use]
    fn uniform(value: T) -> Self;

    /// Returns the value of a block. For an index beyond the last block it is the value of the last block.
    #[must_use]
    fn at(&self, block: usize) -> T;

    /// Sets the value of a block. For an index beyond the last block it sets the value of the last block.
    fn set(&mut self, block: usize, value: T);
}

impl<T: Copy + Debug + PartialEq + Send + Sync + 'static> Blocks<T> for (T,) {
    const COUNT: usize = 1;

    #[cfg_attr(optimised, inline(always))]
    fn uniform(value: T) -> Self {
        (value,)
    }

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, _: usize) -> T {
        self.0
    }

    #[cfg_attr(optimised, inline(always))]
    fn set(&mut self, _: usize, value: T) {
        self.0 = value;
    }
}

impl<T: Copy, A: Blocks<T>, B: Blocks<T>> Blocks<T> for (A, B) {
    const COUNT: usize = A::COUNT + B::COUNT;

    #[cfg_attr(optimised, inline(always))]
    fn uniform(value: T) -> Self {
        (A::uniform(value), B::uniform(value))
    }

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, block: usize) -> T {
        if block < A::COUNT { self.0.at(block) } else { self.1.at(block - A::COUNT) }
    }

    #[cfg_attr(optimised, inline(always))]
    fn set(&mut self, block: usize, value: T) {
        if block < A::COUNT {
            self.0.set(block, value);
        } else {
            self.1.set(block - A::COUNT, value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Blocks;

    #[test]
    fn blocks_of_nested_pairs_are_numbered_from_the_left() {
        type Nested = (((i32,), (i32,)), (i32,));
        assert_eq!(Nested::COUNT, 3);
        let mut values = Nested::uniform(0);
        (0..3).for_each(|block| values.set(block, block as i32 + 1));
        assert_eq!(values, (((1,), (2,)), (3,)));
        assert_eq!([0, 1, 2, 9].map(|block| values.at(block)), [1, 2, 3, 3]);
        type Second = (((i32,), (i32,)), ((i32,), ((i32,), (i32,))));
        let mut values = Second::uniform(0);
        (0..5).for_each(|block| values.set(block, block as i32 + 1));
        assert_eq!(values, (((1,), (2,)), ((3,), ((4,), (5,)))));
        assert_eq!([0, 1, 2, 3, 4].map(|block| values.at(block)), [1, 2, 3, 4, 5]);
    }
}
