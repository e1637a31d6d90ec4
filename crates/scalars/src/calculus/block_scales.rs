//! Norms of vectors whose blocks have different units: [`BlockScales`].

use crate::calculus::norm::norm_of;
use crate::numbers::blocks::Blocks;
use crate::numbers::mask::Mask;
use crate::numbers::real::Real;
use crate::spaces::state::State;

/// A positive scale s_b for each [block](State::BLOCKS) of coordinates, in the unit of the block, with which vectors are
/// measured:
///
/// ```text
/// ‖v‖ = √( Σ_b |v_b|²/s_b² )
/// ```
///
/// The blocks of a vector such as (Π, Γ) have different units, so that the sum of their squares has no meaning: in other
/// units it is the square of one of them alone. Divided by a typical |Π| and a typical |Γ| they are numbers, and their
/// norm does not depend on units.
///
/// Over SIMD lanes each lane has its own scales. The scales of the sizes of a motion are those [of](Self::of) its start,
/// [enlarged](Self::include) by the other points.
///
/// # Example
/// The error of (Π, Γ) relative to its size, in two units of mass:
/// ```
/// use generic_scalars::{BlockScales, Covector, euclidean_norm};
/// use nalgebra::Vector3;
/// for unit in [1.0, 1e-30] {
///     let mu = Covector::new(Vector3::new(3.0, 0.0, 4.0) * unit, Vector3::y());
///     let error = Covector::new(Vector3::x() * (2e-9 * unit), Vector3::z() * 3e-10);
///     let scales = BlockScales::of(&mu);
///     assert!((scales.norm(&error) / 5e-10 - 1.0).abs() < 1e-15);
///     assert!((scales.largest(&error) / 4e-10 - 1.0).abs() < 1e-15);
///     // The norm of all coordinates is that of Π in the one unit, and that of Γ in the other.
///     assert!((euclidean_norm(&error) / 5e-10 - 1.0).abs() > 0.3);
/// }
/// ```
#[derive(Debug)]
pub struct BlockScales<V: State>(V::Blocks);

impl<V: State> Clone for BlockScales<V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V: State> Copy for BlockScales<V> {}

impl<V: State> PartialEq for BlockScales<V> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<V: State> BlockScales<V> {
    /// Returns the same scale for every block. With 1 the norm is that of all coordinates.
    #[must_use]
    pub fn uniform(scale: V::Scalar) -> Self {
        Self(V::Blocks::uniform(scale))
    }

    /// Returns the sizes of the blocks of a vector: the Euclidean norm of the coordinates of each, which neither
    /// overflows nor underflows.
    #[must_use]
    pub fn of(v: &V) -> Self {
        let mut sizes = Self::uniform(num_traits::zero());
        for block in 0..V::BLOCKS {
            sizes.set(block, block_norm(v, block));
        }
        sizes
    }

    /// Returns the scale of a block.
    #[must_use]
    pub fn at(&self, block: usize) -> V::Scalar {
        self.0.at(block)
    }

    /// Sets the scale of a block.
    pub fn set(&mut self, block: usize, scale: V::Scalar) {
        self.0.set(block, scale);
    }

    /// Raises each scale to the size of the block of a vector, if that is larger. A NaN stays.
    pub fn include(&mut self, v: &V) {
        for block in 0..V::BLOCKS {
            self.set(block, self.at(block).larger(block_norm(v, block)));
        }
    }

    /// Returns the coordinate v_i in units of the scale of its block. It is 0 if v_i is, also in a block of scale 0.
    #[must_use]
    pub fn coordinate(&self, v: &V, i: usize) -> V::Scalar {
        quotient(v.coordinate(i), self.at(v.block(i)))
    }

    /// Returns the norm ‖v‖ = √(Σ_b |v_b|²/s_b²) in each SIMD lane. It is NaN where a coordinate is NaN, and ∞ where a
    /// block of scale 0 is not zero.
    #[must_use]
    pub fn norm(&self, v: &V) -> V::Scalar {
        norm_of(v.dimension(), |i| self.coordinate(v, i))
    }

    /// Returns max_b |v_b|/s_b in each SIMD lane, with the same exceptions as the [`norm`](Self::norm).
    #[must_use]
    pub fn largest(&self, v: &V) -> V::Scalar {
        (0..V::BLOCKS).fold(num_traits::zero(), |largest: V::Scalar, block| {
            largest.larger(quotient(block_norm(v, block), self.at(block)))
        })
    }
}

/// Returns |v_b|, the Euclidean norm of the coordinates of a block.
fn block_norm<V: State>(v: &V, block: usize) -> V::Scalar {
    norm_of(
        v.dimension(),
        |i| if v.block(i) == block { v.coordinate(i) } else { num_traits::zero() },
    )
}

/// Returns x/s, and 0 for x = s = 0.
fn quotient<T: Real>(x: T, s: T) -> T {
    let zero = T::zero();
    let is_zero = |x: T| x.at_most(zero).and((-x).at_most(zero));
    // Where x is 0 and s is not, x/s is 0 with the derivative of x.
    T::select(is_zero(x).and(is_zero(s)), zero, x / s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{DefaultLanes, Lanes};
    use crate::numbers::dual_number::DualNumber;
    use crate::spaces::pair::Pair;
    use nalgebra::{Vector1, Vector2};

    type Two<T = f64> = Pair<Vector1<T>, Vector2<T>>;

    fn two(x: f64, y: [f64; 2]) -> Two {
        Pair(Vector1::new(x), Vector2::from(y))
    }

    #[test]
    fn a_norm_is_the_same_in_all_units() {
        for (s, t) in [(1.0, 1.0), (1e-200, 1e200), (1e155, 1e-300), (1e-30, 1.0)] {
            let mut scales = BlockScales::of(&two(-2.0 * s, [3.0 * t, -4.0 * t]));
            assert!((scales.at(1) / (5.0 * t) - 1.0).abs() < 1e-15);
            scales.include(&two(4.0 * s, [0.0, t]));
            let v = two(12.0 * s, [0.0, 20.0 * t]);
            assert!((scales.norm(&v) - 5.0).abs() < 1e-14, "{s:e} {t:e}");
            assert!((scales.largest(&v) - 4.0).abs() < 1e-14, "{s:e} {t:e}");
        }
    }

    #[test]
    fn what_has_no_scale_is_infinite_unless_it_is_zero() {
        let scales = BlockScales::of(&two(0.0, [1.0, 0.0]));
        let v = two(0.0, [0.5, 0.0]);
        assert_eq!((scales.norm(&v), scales.largest(&v)), (0.5, 0.5));
        let v = two(1e-9, [0.5, 0.0]);
        assert_eq!((scales.norm(&v), scales.largest(&v)), (f64::INFINITY, f64::INFINITY));
        for v in [two(f64::NAN, [0.5, 0.0]), two(0.0, [0.5, f64::NAN])] {
            assert!(scales.norm(&v).is_nan() && scales.largest(&v).is_nan());
            let mut larger = scales;
            larger.include(&v);
            assert!(larger.at(0).is_nan() || larger.at(1).is_nan());
        }
    }

    #[test]
    fn a_coordinate_that_is_zero_keeps_its_derivative() {
        let number = DualNumber::new;
        let v: Two<DualNumber> =
            Pair(Vector1::new(number(0.0, 1.0)), Vector2::new(number(0.0, 3.0), number(5.0, 0.0)));
        let constant = DualNumber::constant;
        let sizes = Pair(Vector1::new(constant(0.0)), Vector2::new(constant(4.0), constant(0.0)));
        let scales = BlockScales::<Two<DualNumber>>::of(&sizes);
        let entry = scales.coordinate(&v, 1);
        assert_eq!((entry.value_without_derivative(), entry.derivative()), (0.0, 0.75));
        // Control: a coordinate without a scale has none.
        let entry = scales.coordinate(&v, 0);
        assert_eq!((entry.value_without_derivative(), entry.derivative()), (0.0, 0.0));
    }

    #[test]
    fn every_lane_has_its_own_scales() {
        let lanes = |f: &dyn Fn(usize) -> f64| DefaultLanes::from_lanes(f);
        let size = |lane: usize| 10.0_f64.powi(60 * lane as i32 - 100);
        let mu: Two<DefaultLanes> =
            Pair(Vector1::new(lanes(&size)), Vector2::repeat(lanes(&|_| 1.0)));
        let v =
            Pair(Vector1::new(lanes(&|lane| 0.5 * size(lane))), Vector2::repeat(lanes(&|_| 0.0)));
        let norm = BlockScales::of(&mu).norm(&v);
        assert!((0..DefaultLanes::COUNT).all(|lane| (norm.lane(lane) - 0.5).abs() < 1e-15));
    }
}
