//! The realisation of (so(3) ⋉ (R³ ⊕ R³))∗ on T∗(R³ ⊕ R³).

use crate::actions::derived_actions::Opposite;
use crate::actions::represented_actions::AffineAction;
use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::momentum_map::MomentumMap;
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetPoint};
use crate::phase_spaces::cotangent::Cotangent;
use lie_poisson::{Covector, Diagonal, Mask, Pair, Power, Real, SO3OnR3, Vector, squaring_scale};
use nalgebra::Vector3;

/// The momentum map of the right action (q₁, q₂) ↦ (Rᵀ(q₁ − a₁), Rᵀ(q₂ − a₂)) of SO(3) ⋉ (R³ ⊕ R³), lifted to T∗(R³ ⊕
/// R³):
///
/// ```text
/// M(q, p) = (Π, (Γ₁, Γ₂)),    Π = p₁ × q₁ + p₂ × q₂,    Γₖ = −pₖ
/// ```
///
/// It is for a body that sees two directions, as in two constant fields or on an orbit. The image has every Π, if Γ₁
/// and Γ₂ are not parallel. The fibres are the spaces (q₁ + s₁₁ p₁ + s₁₂ p₂, q₂ + s₁₂ p₁ + s₂₂ p₂), with the momenta
/// ½|p₁|², ½|p₂|² and p₁·p₂, which are the Casimirs.
///
/// Source: T. Ratiu & P. van Moerbeke, *The Lagrange rigid body motion*, Ann. Inst. Fourier 32 (1982), for semidirect
/// products; A. I. Bobenko, A. G. Reyman & M. A. Semenov-Tian-Shansky, Commun. Math. Phys. 122 (1989), for tops in two
/// fields.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, Pair, Power};
/// use momentum_map::{Lift, PoissonMap, TWO_FIELDS};
/// use nalgebra::Vector3;
/// let seen = Power([Vector3::z(), Vector3::new(0.6, 0.8, 0.0)]);
/// let mu = Covector(Pair(Vector3::new(1.0, -2.0, 0.5), seen));
/// let z = TWO_FIELDS.lift::<f64>(&mu)?;
/// let again = TWO_FIELDS.apply::<f64>(&z);
/// assert!((again.0.0 - mu.0.0).norm() < 1e-15 && again.0.1 == seen);
/// // one direction alone does not determine a turn about it
/// let parallel = Power([Vector3::z(), Vector3::z() * -2.0]);
/// assert!(TWO_FIELDS.lift::<f64>(&Covector(Pair(Vector3::x(), parallel))).is_err());
/// # Ok::<(), momentum_map::LiftError>(())
/// ```
pub type TwoFieldRealisation = MomentumMap<Opposite<AffineAction<Diagonal<SO3OnR3, 2>>>>;

/// The realisation T∗(R³ ⊕ R³) → (so(3) ⋉ (R³ ⊕ R³))∗, with the minus bracket.
pub const TWO_FIELDS: TwoFieldRealisation = MomentumMap(Opposite(AffineAction(Diagonal(SO3OnR3))));

/// The least angle between Γ₁ and ±Γ₂, in radians, below which Π would lose twelve digits.
const LEAST_ANGLE: f64 = 1e-12;

/// Returns v/|v|, and |v| as a number and a scale that divides it, for vectors whose squares underflow or overflow,
/// too.
fn unit<T: Real>(v: &Vector3<T>) -> (Vector3<T>, [T; 2]) {
    let scale = squaring_scale(v);
    let scaled = v * scale;
    let length = scaled.dot(&scaled).sqrt();
    (scaled / length, [length, scale])
}

impl Lift for TwoFieldRealisation {
    /// Returns the point of the fibre with the least |Γ₁|²|q₁|² + |Γ₂|²|q₂|²: qₖ = (x × uₖ)/|Γₖ| and pₖ = −Γₖ, with uₖ
    /// = −Γₖ/|Γₖ| and
    ///
    /// ```text
    /// x = ½ (Π + s (s·Π)/|d|² + d (d·Π)/|s|²),    s = u₁ + u₂,  d = u₁ − u₂
    /// ```
    ///
    /// # Errors
    /// Returns [`LiftError`] unless Γ₁ and Γ₂ differ from 0 and are not parallel to within 10⁻¹², all are finite, and
    /// neither Π nor qₖ overflows.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError> {
        let Covector(Pair(pi, seen)) =
            LiftError::unless_finite(*mu, "μ", mu.max_abs(), "Π, Γ₁ and Γ₂ must be finite")?;
        let p = -seen;
        let [first, second] = p.0.map(|p| unit(&p));
        let (s, d) = (first.0 + second.0, first.0 - second.0);
        let squares = [d.dot(&d), s.dot(&s)];
        let least = T::from_f64(LEAST_ANGLE * LEAST_ANGLE);
        // Not a number where a vector is zero.
        if !squares.iter().all(|square| least.at_most(*square).all()) {
            let reason = "Γ₁ and Γ₂ must be different from 0 and not parallel";
            let value = (squares[0] * squares[1]).max_abs().sqrt() / 2.0;
            return Err(LiftError { quantity: "sin(Γ₁, Γ₂)", value, reason });
        }
        let pi_scale = squaring_scale(&pi);
        let half = pi * (pi_scale * 0.5);
        let x = half + s * (s.dot(&half) / squares[0]) + d * (d.dot(&half) / squares[1]);
        let q = Power(
            [first, second].map(|(u, [length, scale])| x.cross(&u) / length * (scale / pi_scale)),
        );
        let z = Cotangent::new(q, Covector(p));
        let range = Pair(z, self.apply::<T>(&z));
        let reason = "|Π|, |Π|/|Γ₁| and |Π|/|Γ₂| must be below 1.7e308";
        Ok(LiftError::unless_finite(range, "Π", pi.max_abs(), reason)?.0)
    }
}

impl FibreSymmetry for TwoFieldRealisation {
    const COUNT: usize = 3;

    /// Returns the point with q₁ + s p₁, with q₂ + s p₂, or with q₁ + s p₂ and q₂ + s p₁.
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        let (mut moved, Covector(p)) = (*z, z.p);
        let [q1, q2] = &mut moved.q.0;
        match index {
            0 => *q1 += p.0[0] * s,
            1 => *q2 += p.0[1] * s,
            2 => {
                *q1 += p.0[1] * s;
                *q2 += p.0[0] * s;
            }
            _ => {}
        }
        moved
    }

    /// Returns the momentum ½|p₁|², ½|p₂|² or p₁·p₂.
    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<Self, T>) -> T {
        let [p1, p2] = &z.p.0.0;
        match index {
            0 => p1.dot(p1) * 0.5,
            1 => p2.dot(p2) * 0.5,
            2 => p1.dot(p2),
            _ => T::zero(),
        }
    }
}
