//! The realisation of sl(2, R)∗ ≅ so(2, 1)∗ on R⁴.

use crate::actions::action::Side;
use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetPoint};
use crate::maps::quadratic_momentum_map::QuadraticMomentumMap;
use crate::maps::symplectic_representation::{Reversed, SymplecticRepresentation};
use lie_poisson::{Pair, Real, SL2OnR2, Sl2, State, Sum, Vector, map_coordinates, squaring_scale};
use nalgebra::Vector2;

/// A representation of SL(2, R) on R² with the symplectic form ±(dq ∧ dp).
pub trait PlaneForm: SymplecticRepresentation<Algebra = Sl2> {
    /// The sign of the symplectic form.
    const SIGN: f64;
}

impl PlaneForm for SL2OnR2 {
    const SIGN: f64 = 1.0;
}

impl PlaneForm for Reversed<SL2OnR2> {
    const SIGN: f64 = -1.0;
}

/// The momentum map of SL(2, R) on two copies of R², with the forms s₁Ω and s₂Ω:
///
/// ```text
/// J(z₁, z₂) = ± Σ_a s_a (q_a p_a, ½p_a², −½q_a²),    z_a = (q_a, p_a)
/// ```
///
/// The upper sign belongs to the left action. In terms of the symmetric matrix S = ±[−2J₃ J₁; J₁ 2J₂] the map is S =
/// s₁ z₁z₁ᵀ + s₂ z₂z₂ᵀ, and −det S/4 is the Casimir. Equal forms (`Sum<SL2OnR2, SL2OnR2>`, or both [`Reversed`]) each
/// reach one sheet of the elliptic orbits. Opposite forms (`Sum<SL2OnR2, Reversed<SL2OnR2>>`) reach the hyperbolic
/// orbits. The fibres are the orbits of O(2) and of O(1, 1); the flow stays in one component.
///
/// Source: the dual pairs (Sp(2, R), O(2)) and (Sp(2, R), O(1, 1)), R. Howe, *Remarks on classical
/// invariant theory*, Trans. AMS 313 (1989).
///
/// # Example
/// ```
/// use lie_poisson::{Casimirs, Covector, SL2OnR2, Sl2, Sum};
/// use momentum_map::{Lift, PoissonMap, QuadraticMomentumMap, Reversed, Side};
/// use nalgebra::Vector3;
/// let hyperbolic = Covector(Vector3::new(1.0, 2.0, 3.0));
/// assert!(Sl2.casimir(0, &hyperbolic) > 0.0);
/// let map = QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Right);
/// assert!((map.apply(&map.lift(&hyperbolic)?) - hyperbolic).0.norm() < 1e-14);
/// // the map with equal forms does not reach it
/// let map = QuadraticMomentumMap::new(Sum(SL2OnR2, SL2OnR2), Side::Right);
/// assert!(map.lift(&hyperbolic).is_err());
/// # Ok::<(), momentum_map::LiftError>(())
/// ```
pub type Sl2Realisation<R, S> = QuadraticMomentumMap<Sum<R, S>>;

impl<R: PlaneForm, S: PlaneForm> Lift for Sl2Realisation<R, S> {
    /// Returns z₁ and z₂ along the eigenvectors of S.
    ///
    /// # Errors
    /// Returns [`LiftError`] if the eigenvalues of S do not have the signs s₁ and s₂, if μ is not finite,
    /// or if it is so large that the eigenvalues overflow.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError> {
        let sign = T::from_f64(match self.side() {
            Side::Left => 1.0,
            Side::Right => -1.0,
        });
        let mu = LiftError::unless_finite(*mu, "μ", mu.max_abs(), "μ must be finite")?;
        let scale = squaring_scale(&mu);
        let j = mu.0 * (sign * scale);
        let (mean, half_difference) = (j.y - j.z, -(j.y + j.z));
        let radius = (half_difference * half_difference + j.x * j.x).sqrt();
        let axis = half_angle(half_difference, j.x, radius);
        // The smaller eigenvalue comes from the determinant, since the difference would cancel near the
        // cone.
        let size = mean.select_nonnegative(mean + radius, mean - radius);
        let determinant = -(j.y * j.z * 4.0 + j.x * j.x);
        let other = determinant / size;
        let large = mean.select_nonnegative(size, other);
        let small = mean.select_nonnegative(other, size);
        let first = round_off_to_zero(large * R::SIGN, radius).sqrt();
        let second = round_off_to_zero(small * S::SIGN, radius).sqrt();
        let back = T::one() / scale.sqrt();
        let z: Pair<Vector2<T>, Vector2<T>> =
            Pair(axis * (first * back), Vector2::new(-axis.y, axis.x) * (second * back));
        let reason = "the orbit is not of the kind of this realisation";
        let z = LiftError::unless_finite(z, "μ", mu.max_abs(), reason)?;
        let z: SourcePoint<Self, T> =
            Pair(map_coordinates(&z.0, |x| x), map_coordinates(&z.1, |x| x));
        let range = Pair(z, self.apply::<T>(&z));
        let reason =
            "the coordinates of μ must be below 4e307, so that the eigenvalues are numbers";
        Ok(LiftError::unless_finite(range, "μ", mu.max_abs(), reason)?.0)
    }
}

/// Returns x, or 0 if x is negative by no more than the round-off of numbers of the given size.
fn round_off_to_zero<T: Real>(x: T, size: T) -> T {
    let negative = (x + size * (8.0 * f64::EPSILON)).select_nonnegative(T::zero(), x);
    x.select_nonnegative(x, negative)
}

/// Returns (cos φ, sin φ) for an angle with (cos 2φ, sin 2φ) = (x, y)/r, with φ = 0 for r = 0.
fn half_angle<T: Real>(x: T, y: T, r: T) -> Vector2<T> {
    let size = x.select_nonnegative(x, -x);
    let large = ((r + size) / (r + r)).sqrt();
    let small = y / ((r + r) * large);
    let (cosine, sine) = (x.select_nonnegative(large, small), x.select_nonnegative(small, large));
    // Since r ≥ 0, the condition −r ≥ 0 means r = 0.
    Vector2::new(
        (-r).select_nonnegative(T::one(), cosine),
        (-r).select_nonnegative(T::zero(), sine),
    )
}

impl<R: PlaneForm, S: PlaneForm> FibreSymmetry for Sl2Realisation<R, S> {
    const COUNT: usize = 1;

    /// Returns (c₀ z₁ + s c₁ z₂, c₀ z₂ − s₁s₂ s c₁ z₁), with Stumpff functions of s₁s₂s².
    ///
    /// They are circular functions for equal forms and hyperbolic functions for opposite ones.
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        if index > 0 {
            return *z;
        }
        let signs = R::SIGN * S::SIGN;
        let x = s * s * signs;
        let (cosine, sine) = (x.stumpff(0), s * x.stumpff(1));
        let (first, second): (Vector2<T>, Vector2<T>) =
            (map_coordinates(&z.0, |x| x), map_coordinates(&z.1, |x| x));
        let turned = (first * cosine + second * sine, second * cosine - first * (sine * signs));
        Pair(map_coordinates(&turned.0, |x| x), map_coordinates(&turned.1, |x| x))
    }

    /// Returns s₁ Ω(z₂, z₁), the area that the two vectors span.
    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<Self, T>) -> T {
        let area = z.1.coordinate(0) * z.0.coordinate(1) - z.1.coordinate(1) * z.0.coordinate(0);
        if index > 0 { T::zero() } else { area * R::SIGN }
    }
}

#[cfg(test)]
mod tests {
    use super::round_off_to_zero;

    #[test]
    fn only_negative_round_off_becomes_zero() {
        for (x, size, expected) in [
            (-1e-16, 1.0, 0.0),
            (-1e-14, 1.0, -1e-14),
            (-1e-14, 1e3, 0.0),
            (1e-16, 1.0, 1e-16),
            (-1e-300, 0.0, -1e-300),
        ] {
            assert_eq!(round_off_to_zero(x, size), expected, "{x:e} {size:e}");
        }
    }
}
