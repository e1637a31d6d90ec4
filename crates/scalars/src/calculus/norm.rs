//! Euclidean norms that neither overflow nor underflow.

use crate::numbers::mask::Mask;
use crate::numbers::real::Real;
use crate::spaces::state::State;

/// The size up to which a coordinate may underflow when it is squared.
const SMALL: f64 = two_to_the(-500);

/// The size beyond which coordinates may overflow when they are squared and added.
const LARGE: f64 = two_to_the(500);

/// Returns a power of four by which to multiply v before its coordinates are squared, in each SIMD lane.
///
/// After the multiplication no square overflows, and no square that matters underflows. The power is 2⁶⁰⁰ where all
/// vᵢ| ≤ 2⁻⁵⁰⁰, 2⁻⁶⁰⁰ where one |vᵢ| is above 2⁵⁰⁰, and 1 elsewhere. Its square root is a power of two. For dual
/// numbers it depends on the values alone.
///
/// Source: J. L. Blue, *A portable Fortran program to find the Euclidean norm of a vector*, ACM
/// Trans. Math. Softw. 4 (1978).
///
/// # Example
/// ```
/// use generic_scalars::squaring_scale;
/// use nalgebra::Vector2;
/// let v = Vector2::new(3e-200, 4e-200);
/// let s = squaring_scale(&v);
/// assert_eq!((v.norm_squared(), squaring_scale(&Vector2::new(3.0, 4.0))), (0.0, 1.0));
/// assert!(((v * s).norm() / s / 5e-200 - 1.0).abs() < 1e-15);
/// ```
#[inline]
pub fn squaring_scale<V: State>(v: &V) -> V::Scalar {
    squaring_scale_of(v.dimension(), |i| v.coordinate(i))
}

/// Returns the [`squaring_scale`] of the coordinates x(0), …, x(n − 1).
#[inline]
fn squaring_scale_of<T: Real>(n: usize, x: impl Fn(usize) -> T) -> T {
    let within = |bound: f64| {
        let bound = T::from_f64(bound);
        (0..n).fold(T::Mask::from_bool(true), |within, i| {
            let x = x(i);
            within.and(x.at_most(bound)).and((-x).at_most(bound))
        })
    };
    let constant = |exponent: i32| T::from_f64(two_to_the(exponent));
    let moderate = Real::select(within(LARGE), constant(0), constant(-600));
    Real::select(within(SMALL), constant(600), moderate)
}

/// Returns the Euclidean norm √(Σ vᵢ²) of the coordinates in each SIMD lane, without overflow or underflow.
///
/// It is accurate to round-off for every v, whereas the plain squares of very small or very large coordinates
/// underflow or overflow. It is infinite if the norm itself is too large, and NaN where a coordinate is NaN. For
/// coordinates of different units, see [`BlockScales`](crate::BlockScales).
///
/// ```
/// use generic_scalars::euclidean_norm;
/// use nalgebra::Vector3;
/// assert_eq!(euclidean_norm(&Vector3::new(2e300, -1e300, 2e300)), 3e300);
/// assert_eq!(Vector3::new(2e300, -1e300, 2e300).norm(), f64::INFINITY);
/// ```
#[inline]
pub fn euclidean_norm<V: State>(v: &V) -> V::Scalar {
    norm_of(v.dimension(), |i| v.coordinate(i))
}

/// Returns the Euclidean norm of the coordinates x(0), …, x(n − 1).
#[inline]
pub(super) fn norm_of<T: Real>(n: usize, x: impl Fn(usize) -> T) -> T {
    let scale = squaring_scale_of(n, &x);
    let square = (0..n).map(|i| x(i) * scale).fold(T::zero(), |sum, x| sum + x * x);
    square.sqrt() / scale
}

/// Returns 2ⁿ, for n in the exponent range of normal numbers.
const fn two_to_the(n: i32) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{DefaultLanes, Lanes};
    use crate::numbers::dual_number::DualNumber;
    use nalgebra::{Vector2, Vector3};

    #[test]
    fn norms_of_every_size_to_round_off() {
        for size in [1e-300, 1e-160, 1e-150, 1e-3, 1.0, 1e150, 1e160, 1e307] {
            let v = Vector3::new(2.0, -1.0, 2.0) * size;
            assert!((euclidean_norm(&v) / (3.0 * size) - 1.0).abs() < 4e-16, "{size:e}");
            assert_eq!(euclidean_norm(&-v), euclidean_norm(&v), "{size:e}");
            assert_eq!(euclidean_norm(&-v.abs()), euclidean_norm(&v), "{size:e}");
            // One large coordinate among small ones.
            let v = Vector3::new(size, 1e-30 * size, 0.0);
            assert!((euclidean_norm(&v) / size - 1.0).abs() < 4e-16, "{size:e}");
        }
        let least = 5e-324;
        assert_eq!(euclidean_norm(&Vector2::new(3.0 * least, 4.0 * least)), 5.0 * least);
        assert_eq!(euclidean_norm(&Vector2::<f64>::zeros()), 0.0);
        assert_eq!(euclidean_norm(&Vector2::new(f64::MAX, f64::MAX)), f64::INFINITY);
        assert_eq!(euclidean_norm(&Vector2::new(f64::NEG_INFINITY, 1.0)), f64::INFINITY);
        for nan in [Vector2::new(f64::NAN, 1e200), Vector2::new(1e-200, f64::NAN)] {
            assert!(euclidean_norm(&nan).is_nan());
        }
    }

    #[test]
    fn every_lane_has_its_own_scale() {
        let sizes = [1e-200, 1.0, 1e200, 1e-308];
        let v =
            Vector2::new(3.0, 4.0).map(|x| DefaultLanes::from_lanes(|lane| sizes[lane % 4] * x));
        let norm = euclidean_norm(&v);
        for (lane, size) in (0..DefaultLanes::COUNT).zip(sizes) {
            let alone = euclidean_norm(&Vector2::new(3.0 * size, 4.0 * size));
            assert_eq!(norm.lane(lane), alone);
            assert!((alone / (5.0 * size) - 1.0).abs() < 4e-16);
        }
    }

    /// The scale depends on the values alone, even if a derivative has another size than its value.
    #[test]
    fn dual_numbers_are_scaled_by_their_values() {
        for derivative in [1e-250, 1.0, 1e250] {
            let v = Vector2::new(DualNumber::new(3.0, derivative), DualNumber::new(4.0, 0.0));
            let norm = euclidean_norm(&v);
            assert_eq!(norm.value_without_derivative(), 5.0);
            assert!((norm.derivative() / (0.6 * derivative) - 1.0).abs() < 1e-15);
        }
    }
}
