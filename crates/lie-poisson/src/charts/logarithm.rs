//! Logarithms in closed form: [`Logarithm`].

use crate::{
    AlgebraElement, LieGroup, Pair, Power, PowerGroup, ProductGroup, Quaternion, Real, RealSpace,
    SE2, SE3, SL2, SO2, SO3, SP1, SU2, Sl2, So3, Su2, Vector,
};
use nalgebra::{Matrix2, Matrix3, SVector, Vector1, Vector2, Vector3};
use num_complex::Complex;
use thiserror::Error;

/// The error returned for a group element outside of the domain of log, or not finite.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("no logarithm: the element is outside the domain of log, or not finite")]
pub struct LogarithmError;

/// Groups with a logarithm in closed form: log(exp ξ) = ξ for ξ near 0, and exp(log g) = g.
///
/// The argument of `log` must be an element of the group, up to rounding. This precondition is not checked. For any
/// other matrix the result is meaningless.
///
/// # Example
/// ```
/// use lie_poisson::{LieGroup, Logarithm, SO3};
/// use nalgebra::Vector3;
/// let xi = Vector3::new(0.3, -1.1, 0.4);
/// assert!((SO3.log(&SO3.exp(&xi))? - xi).norm() < 1e-15);
/// # Ok::<(), lie_poisson::LogarithmError>(())
/// ```
pub trait Logarithm: LieGroup {
    /// Returns the principal logarithm of g.
    ///
    /// # Errors
    /// Returns [`LogarithmError`] if there is none: for −I in SU(2) and SL(2, R), for −1 in Sp(1), for
    /// elements of SL(2, R) of trace ≤ −2, and for elements that are not finite. Rotations by π in SO(3)
    /// have a logarithm, whose sign is chosen arbitrarily.
    fn log<T: Real>(&self, g: &Self::Element<T>)
    -> Result<AlgebraElement<Self, T>, LogarithmError>;
}

/// Returns θ / sin θ from sin²θ and cos θ, for 0 ≤ θ < π.
///
/// If sin²θ is negative, it stands for −sinh²θ, and the result is θ / sinh θ from −sinh²θ and cosh θ. The
/// function is analytic at θ = 0, so that dual numbers get the right derivatives.
fn angle_over_sine<T: Real>(sine_squared: T, cosine: T) -> T {
    let tangent_squared = sine_squared / (cosine * cosine);
    // The series is Σ (−t)ᵏ/(2k+1), and 0.04¹³/27 is below round-off.
    let series = (0..13).rev().fold(T::zero(), |tail, k| {
        T::from_f64(1.0 / f64::from(2 * k + 1)) - tangent_squared * tail
    }) / cosine;
    let (sine, sinh) = (sine_squared.sqrt(), (-sine_squared).sqrt());
    let circular = sine.atan2(cosine) / sine;
    // There is no real logarithm for a negative cosine. The sum cosine + sinh should be negative, but may
    // round to a small positive number, so that ln alone would not detect it.
    let none = T::from_f64(f64::NAN);
    let hyperbolic = cosine.select_nonnegative((cosine + sinh).ln() / sinh, none);
    let closed = sine_squared.select_nonnegative(circular, hyperbolic);
    let size = tangent_squared.select_nonnegative(tangent_squared, -tangent_squared);
    let near = (-size + 0.04).select_nonnegative(series, closed);
    cosine.select_nonnegative(near, closed)
}

fn finite<V: Vector>(xi: V) -> Result<V, LogarithmError> {
    if xi.is_finite() { Ok(xi) } else { Err(LogarithmError) }
}

impl<const N: usize> Logarithm for RealSpace<N> {
    fn log<T: Real>(&self, g: &SVector<T, N>) -> Result<SVector<T, N>, LogarithmError> {
        finite(*g)
    }
}

impl Logarithm for SO2 {
    fn log<T: Real>(&self, g: &Matrix2<T>) -> Result<Vector1<T>, LogarithmError> {
        finite(Vector1::new(g.m21.atan2(g.m11)))
    }
}

impl Logarithm for SU2 {
    fn log<T: Real>(&self, g: &Matrix2<Complex<T>>) -> Result<Vector3<T>, LogarithmError> {
        // U = cos(θ/2) I + (sin(θ/2)/(θ/2)) ξ, |ξ| = θ.
        let sine = Su2.coordinates(g);
        let cosine = (g.m11.re + g.m22.re) * 0.5;
        finite(sine * angle_over_sine(sine.dot(&sine) * 0.25, cosine))
    }
}

impl Logarithm for SP1 {
    fn log<T: Real>(&self, g: &Quaternion<T>) -> Result<Vector3<T>, LogarithmError> {
        // q = cos(θ/2) + (sin(θ/2)/(θ/2)) ½ξ, |ξ| = θ.
        let sine = g.vector + g.vector;
        finite(sine * angle_over_sine(g.vector.dot(&g.vector), g.scalar))
    }
}

impl Logarithm for SO3 {
    fn log<T: Real>(&self, g: &Matrix3<T>) -> Result<Vector3<T>, LogarithmError> {
        let q = rotation_quaternion(g);
        let sine = q.vector + q.vector;
        finite(sine * angle_over_sine(q.vector.dot(&q.vector), q.scalar))
    }
}

/// Returns a unit quaternion with non-negative real part that rotates as R does.
///
/// There are four formulas, each of which divides by one component; the one with the largest component is
/// used.
/// Source: S. W. Shepperd, *Quaternion from rotation matrix*, J. Guidance Control 1 (1978).
fn rotation_quaternion<T: Real>(r: &Matrix3<T>) -> Quaternion<T> {
    let one = T::one();
    let (a, b, c) = (r.m11, r.m22, r.m33);
    let skew = Vector3::new(r.m32 - r.m23, r.m13 - r.m31, r.m21 - r.m12);
    let (d, e, f) = (r.m12 + r.m21, r.m13 + r.m31, r.m23 + r.m32);
    // Each candidate is four times one component squared, with four times that component times the
    // quaternion.
    let candidates = [
        (one + a + b + c, [one + a + b + c, skew.x, skew.y, skew.z]),
        (one + a - b - c, [skew.x, one + a - b - c, d, e]),
        (one - a + b - c, [skew.y, d, one - a + b - c, f]),
        (one - a - b + c, [skew.z, e, f, one - a - b + c]),
    ];
    let (mut size, mut rows) = candidates[0];
    for (other, others) in &candidates[1..] {
        let better = *other - size;
        for (row, other) in rows.iter_mut().zip(others) {
            *row = better.select_nonnegative(*other, *row);
        }
        size = better.select_nonnegative(*other, size);
    }
    let scale = with_sign(size.sqrt() * 2.0, rows[0]);
    Quaternion::from_coordinates(|i| rows[i] / scale)
}

/// Returns `size` with the sign of another number.
fn with_sign<T: Real>(size: T, sign: T) -> T {
    sign.select_nonnegative(size, -size)
}

impl Logarithm for SL2 {
    fn log<T: Real>(&self, g: &Matrix2<T>) -> Result<Vector3<T>, LogarithmError> {
        let sine = Sl2.coordinates(g);
        let cosine = (g.m11 + g.m22) * 0.5;
        let factor = angle_over_sine(Sl2.determinant(&sine), cosine);
        // The trace is ≤ −2, whatever sign rounding gives to the determinant.
        let none = T::from_f64(f64::NAN);
        finite(sine * (-cosine - 1.0).select_nonnegative(none, factor))
    }
}

impl Logarithm for SE3 {
    /// Returns (ξ, V⁻¹a) with ξ = log R and V⁻¹ = I − ½X + ((c₃ − 2c₄)/(2c₂)) X².
    ///
    /// Here X = hat(ξ), and the Stumpff functions have the argument |ξ|².
    fn log<T: Real>(
        &self,
        g: &Pair<Matrix3<T>, Vector3<T>>,
    ) -> Result<Pair<Vector3<T>, Vector3<T>>, LogarithmError> {
        let xi = SO3.log(&g.0)?;
        let (x, hat) = (xi.dot(&xi), So3.hat(&xi));
        let factor = (x.stumpff(3) - x.stumpff(4) * 2.0) / (x.stumpff(2) * 2.0);
        let turned = hat * g.1;
        finite(Pair(xi, g.1 - turned * T::from_f64(0.5) + hat * turned * factor))
    }
}

impl Logarithm for SE2 {
    /// Returns (ω, V⁻¹a) with the complex number V = c₁ + ωc₂ J and Stumpff functions of ω².
    fn log<T: Real>(
        &self,
        g: &Pair<Matrix2<T>, Vector2<T>>,
    ) -> Result<Pair<Vector1<T>, Vector2<T>>, LogarithmError> {
        let omega = SO2.log(&g.0)?;
        let x = omega.x * omega.x;
        let (re, im) = (x.stumpff(1), omega.x * x.stumpff(2));
        let back = Vector2::new(g.1.x * re + g.1.y * im, g.1.y * re - g.1.x * im);
        finite(Pair(omega, back / (re * re + im * im)))
    }
}

impl<G: Logarithm, H: Logarithm> Logarithm for ProductGroup<G, H> {
    /// Returns (log g, log h), factor by factor.
    fn log<T: Real>(
        &self,
        g: &Self::Element<T>,
    ) -> Result<AlgebraElement<Self, T>, LogarithmError> {
        Ok(Pair(self.0.log::<T>(&g.0)?, self.1.log::<T>(&g.1)?))
    }
}

impl<G: Logarithm, const N: usize> Logarithm for PowerGroup<G, N> {
    /// Returns (log g₁, …, log g_N), factor by factor.
    fn log<T: Real>(
        &self,
        g: &Self::Element<T>,
    ) -> Result<AlgebraElement<Self, T>, LogarithmError> {
        let mut logs = [Vector::zero(); N];
        for (log, g) in logs.iter_mut().zip(&g.0) {
            *log = self.0.log::<T>(g)?;
        }
        Ok(Power(logs))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{DefaultLanes, DualNumber, Lanes, map_coordinates};
    use core::f64::consts::PI;

    #[test]
    fn rotations_by_pi_and_near_it_have_a_logarithm() {
        let axes = [Vector3::x(), Vector3::y(), -Vector3::z(), Vector3::new(0.36, 0.48, -0.8)];
        for axis in axes {
            for angle in [PI, PI - 1e-9, PI - 1e-3, 3.0, 1e-3, 1e-9] {
                let g = SO3.exp(&(axis * angle));
                let log = SO3.log(&g);
                let error =
                    log.map(|log| (SO3.exp(&log) - g).amax().max((log.norm() - angle).abs()));
                // A matrix determines its angle only to the rounding errors of its entries.
                assert!(error.is_ok_and(|error| error < 2e-15), "{axis} {angle}");
            }
        }
    }

    /// Two components of the quaternion are the largest and agree to 10⁻¹², and a third one is 10⁻⁶. No formula may
    /// divide by the third.
    #[test]
    fn logarithms_of_quarter_turns_and_of_half_turns_between_axes() {
        let (axes, tilt) = ([Vector3::x(), Vector3::y(), Vector3::z()], 1e-6);
        for (i, j) in (0..9).map(|n| (n / 3, n % 3)) {
            for other in [axes[j] * tilt, -axes[j] * tilt] {
                let quarter = (axes[i] + other).normalize() * (0.5 * (PI + tilt * tilt));
                let between = axes[i] + axes[(i + 1) % 3] * other.sum().signum();
                let half = (between + other).normalize() * PI;
                let nearly_half = between.normalize() * (PI - 2.0 * tilt);
                for xi in [quarter, half, nearly_half].into_iter().flat_map(|xi| [xi, -xi]) {
                    let g = SO3.exp(&xi);
                    let error = SO3.log(&g).map(|log| (SO3.exp(&log) - g).amax());
                    assert!(error.is_ok_and(|error| error < 2e-15), "{xi} {error:?}");
                }
            }
        }
    }

    #[test]
    fn elements_without_logarithm_are_errors() {
        assert_eq!(SU2.log(&(-SU2.identity::<f64>())), Err(LogarithmError));
        assert_eq!(SL2.log(&(-SL2.identity::<f64>())), Err(LogarithmError));
        assert_eq!(SL2.log(&Matrix2::new(-2.0, 0.0, 0.0, -0.5)), Err(LogarithmError));
        assert_eq!(SO3.log(&Matrix3::from_element(f64::NAN)), Err(LogarithmError));
    }

    #[test]
    fn minus_a_hyperbolic_element_has_no_logarithm_however_large() {
        for n in 0..400 {
            let t = f64::from(n);
            let xi = Vector3::new((t * 0.7).sin(), (t * 1.3).cos(), 1.0 + t.sin()) * (0.05 * t);
            let g = -SL2.exp(&xi);
            if g.trace() <= -2.0 {
                assert_eq!(SL2.log(&g), Err(LogarithmError), "{xi}");
            }
        }
    }

    #[test]
    fn derivatives_at_the_identity_are_exact() {
        // d/ds log exp(sξ) = ξ, through the series at θ = 0.
        let xi = Vector3::new(0.3, -1.1, 0.4);
        let along: Vector3<DualNumber> = map_coordinates(&xi, |x| DualNumber::new(0.0, x));
        let logs =
            [SO3.log(&SO3.exp(&along)), SU2.log(&SU2.exp(&along)), SL2.log(&SL2.exp(&along))];
        for log in logs {
            let slope = log.map(|log| log.map(|x| x.derivative()));
            assert!(slope.is_ok_and(|slope| (slope - xi).norm() < 1e-15));
        }
    }

    #[test]
    fn lanes_take_their_own_branches() {
        let angles = DefaultLanes::load(&[1e-9, 0.1, 2.0, PI]);
        let axis = Vector3::new(0.36, 0.48, -0.8).map(DefaultLanes::from_f64);
        let log = SO3.log(&SO3.exp(&(axis * angles)));
        let error = log.map(|log| log.dot(&axis) - angles);
        // The logarithm of exp of π may be −π about the same axis.
        assert!(error.is_ok_and(|error| (0..4).all(|i| error.lane(i).abs() % (2.0 * PI) < 2e-15)));
    }
}
