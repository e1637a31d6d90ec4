//! Sizes of vectors, block by block: [`BlockSizes`].

use lie_poisson::{Blocks, Mask, Real, State};

/// The mask type for the SIMD lanes of the scalar of a vector.
pub(crate) type MaskOf<V> = <<V as State>::Scalar as Real>::Mask;

/// The largest magnitude in each [block](State::BLOCKS) of coordinates of one or several vectors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BlockSizes<V: State> {
    most: V::Blocks,
    /// The sum of all magnitudes, which keeps a NaN that the maxima lose.
    sum: V::Scalar,
}

impl<V: State> BlockSizes<V> {
    /// Returns the sizes of no vector: zero.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn zero() -> Self {
        Self::uniform(V::Scalar::from_f64(0.0))
    }

    /// Returns sizes that exceed all numbers.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn infinite() -> Self {
        Self::uniform(V::Scalar::from_f64(f64::INFINITY))
    }

    #[cfg_attr(optimised, inline(always))]
    fn uniform(size: V::Scalar) -> Self {
        Self { most: V::Blocks::uniform(size), sum: size }
    }

    /// Returns the sizes f(block) of vectors whose magnitudes have the given sum.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn from_parts(f: impl Fn(usize) -> V::Scalar, sum: V::Scalar) -> Self {
        let mut sizes = Self { sum, ..Self::zero() };
        for block in 0..V::BLOCKS {
            sizes.most.set(block, f(block));
        }
        sizes
    }

    /// Returns the sum of all magnitudes.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn sum(&self) -> V::Scalar {
        self.sum
    }

    /// Returns the sizes of several vectors.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn of(vectors: &[V]) -> Self {
        let mut sizes = Self::zero();
        for v in vectors {
            sizes.include(v);
        }
        sizes
    }

    /// Enlarges the sizes to hold one more vector.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn include(&mut self, v: &V) {
        v.measure(&mut self.most, &mut self.sum);
    }

    /// Enlarges the sizes to hold the difference of two vectors.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn include_difference(&mut self, v: &V, w: &V) {
        v.measure_difference(w, &mut self.most, &mut self.sum);
    }

    /// Enlarges the sizes to hold those of `other` that are above the bound that f gives for their block.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn include_above(&mut self, other: &Self, f: impl Fn(usize) -> V::Scalar) {
        for block in 0..V::BLOCKS {
            let below = other.at(block).at_most(f(block));
            let size = Real::select(below, V::Scalar::from_f64(0.0), other.at(block));
            self.most.set(block, size.maximum(self.at(block)));
        }
        self.sum += other.sum;
    }

    /// Selects the first sizes in lanes where the mask is true, and the second elsewhere.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn select(mask: MaskOf<V>, yes: &Self, no: &Self) -> Self {
        let mut sizes = Self { sum: Real::select(mask, yes.sum, no.sum), most: yes.most };
        for block in 0..V::BLOCKS {
            sizes.most.set(block, Real::select(mask, yes.at(block), no.at(block)));
        }
        sizes
    }

    /// Adds other sizes, multiplied by a factor.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn add_multiple(&mut self, factor: V::Scalar, other: &Self) {
        for block in 0..V::BLOCKS {
            self.most.set(block, self.at(block) + factor * other.at(block));
        }
        self.sum += factor * other.sum;
    }

    /// Returns the size of a block.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn at(&self, block: usize) -> V::Scalar {
        self.most.at(block)
    }

    /// Returns the largest f(block), or NaN or ∞ if a coordinate of one of the vectors was.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn largest_of(&self, other: &Self, f: impl Fn(usize) -> V::Scalar) -> V::Scalar {
        let sum = self.sum + other.sum;
        let finite = sum.at_most(V::Scalar::from_f64(f64::MAX));
        Real::select(finite, self.largest_unchecked(f), sum)
    }

    /// Returns the largest f(block), without a check for NaN.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn largest_unchecked(&self, f: impl Fn(usize) -> V::Scalar) -> V::Scalar {
        let mut largest = f(0);
        for block in 1..V::BLOCKS {
            largest = f(block).maximum(largest);
        }
        largest
    }

    /// Returns the largest size, or NaN if a coordinate was NaN.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn largest(&self) -> V::Scalar {
        let largest = self.largest_unchecked(
            #[cfg_attr(optimised, inline(always))]
            |block| self.at(block),
        );
        Real::select(self.sum.at_most(self.sum), largest, self.sum)
    }

    /// Returns the reciprocal of each size, or 0 for a size below the normal numbers, whose reciprocal may overflow.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn inverse(&self) -> Self {
        let (zero, one) = (V::Scalar::from_f64(0.0), V::Scalar::from_f64(1.0));
        let least = V::Scalar::from_f64(f64::MIN_POSITIVE);
        let mut inverse = self.clone();
        for block in 0..V::BLOCKS {
            let size = self.at(block);
            inverse.most.set(block, Real::select(size.at_most(least), zero, one / size));
        }
        inverse
    }

    /// Returns the lanes in which each size is at most the bound that f gives for its block. It is false for a NaN.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn at_most(&self, f: impl Fn(usize) -> V::Scalar) -> MaskOf<V> {
        let mut all = self.sum.at_most(self.sum);
        for block in 0..V::BLOCKS {
            all = all.and(self.at(block).at_most(f(block)));
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::BlockSizes;
    use lie_poisson::{Pair, Vector};
    use nalgebra::{Vector1, Vector2};

    fn largest(vectors: &[Vector2<f64>]) -> f64 {
        BlockSizes::of(vectors).largest()
    }

    #[test]
    fn a_nan_is_never_lost() {
        let (small, large) = (Vector2::new(1.0, -2.0), Vector2::new(-7.0, 0.0));
        let nan = Vector2::new(f64::NAN, 1.0);
        assert_eq!(largest(&[small, large]), 7.0);
        assert!([[nan, small], [small, nan]].iter().all(|vectors| largest(vectors).is_nan()));
        assert_eq!(largest(&[Vector2::repeat(f64::MAX), Vector2::repeat(-f64::MAX)]), f64::MAX);
        let in_second = Pair(Vector1::new(1.0), nan);
        assert!(BlockSizes::of(&[in_second]).largest().is_nan());
        assert!(!BlockSizes::of(&[in_second]).at_most(|_| f64::INFINITY));
    }

    #[test]
    fn each_block_has_its_own_size() {
        type Two = Pair<Vector1<f64>, Vector2<f64>>;
        let vectors: [Two; 2] = [
            Pair(Vector1::new(1e-30), Vector2::new(3.0, -4.0)),
            Pair(Vector1::new(-2e-30), Vector2::new(1.0, 0.0)),
        ];
        let sizes = BlockSizes::of(&vectors);
        assert_eq!((sizes.at(0), sizes.at(1)), (2e-30, 4.0));
        assert!(sizes.at_most(|block| [2e-30, 4.0][block]));
        assert!(!sizes.at_most(|block| [1e-30, 1e3][block]), "a small block is not hidden");
        type Three = Pair<Two, Vector1<f64>>;
        let three = BlockSizes::of(&[Three::from_coordinates(|i| i as f64)]);
        assert_eq!([three.at(0), three.at(1), three.at(2)], [0.0, 2.0, 3.0]);
    }

    #[test]
    fn sizes_below_their_bounds_are_left_out() {
        type Two = Pair<Vector1<f64>, Vector2<f64>>;
        let sizes = |x, y| BlockSizes::of(&[Pair(Vector1::new(x), Vector2::new(y, 0.0)) as Two]);
        let mut largest = sizes(1.0, 1.0);
        largest.include_above(&sizes(5.0, 7.0), |block| [6.0, 2.0][block]);
        assert_eq!((largest.at(0), largest.at(1)), (1.0, 7.0));
        largest.include_above(&sizes(5.0, f64::NAN), |_| 1e3);
        assert!(largest.at(0) == 1.0 && largest.largest().is_nan());
    }

    #[test]
    fn large_sizes_are_numbers() {
        let (large, none) = (Vector2::new(1e200, 0.0), Vector2::new(1e200, f64::INFINITY));
        let sizes = |v: Vector2<f64>| BlockSizes::of(&[v]);
        assert_eq!(sizes(large).largest_of(&sizes(large), |_| 3.0), 3.0);
        assert_eq!(sizes(large).largest_of(&sizes(none), |_| 3.0), f64::INFINITY);
    }

    #[test]
    fn scaled_sizes_are_added_block_by_block() {
        type Two = Pair<Vector1<f64>, Vector2<f64>>;
        let sizes = |x, y, z| BlockSizes::of(&[Pair(Vector1::new(x), Vector2::new(y, z)) as Two]);
        let mut sum = sizes(-1.0, 3.0, -4.0);
        sum.add_multiple(0.5, &sizes(8.0, 2.0, -1.0));
        assert_eq!((sum.at(0), sum.at(1), sum.sum()), (5.0, 5.0, 13.5));
        sum.add_multiple(1.0, &sizes(0.0, f64::NAN, 0.0));
        assert!(sum.sum().is_nan() && sum.largest().is_nan());
    }
}
