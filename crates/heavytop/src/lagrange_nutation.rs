//! The nutation of Lagrange's top in closed form.

use crate::elliptic::incomplete_elliptic;
use crate::{HeavyTop, Invariant, TopError, jacobi_elliptic};
use lie_poisson::{Covector, Pair, Se3Dual};
use nalgebra::Vector3;

/// The height Γ₃(t) of Lagrange's top through (Π, Γ)(0). With u = Γ₃, W = m g l, b = Π·Γ,
/// f₁ = |Γ|² and E′ = h − Π₃²/2I₃ it obeys
///
/// ```text
/// (du/dt)² = [2I₁(E′ − Wu)(f₁ − u²) − (b − Π₃u)²]/I₁² = (2W/I₁)(u − u₁)(u − u₂)(u − u₃)
/// Γ₃ = u₁ + (u₂ − u₁) sn²(νt + δ | m),  ν² = W(u₃ − u₁)/2I₁,  m = (u₂ − u₁)/(u₃ − u₁)
/// ```
///
/// with the roots u₁ ≤ u₂ ≤ u₃, the first two in [−√f₁, √f₁].
///
/// Source: E. T. Whittaker, *A Treatise on the Analytical Dynamics of Particles and Rigid Bodies*,
/// 4th ed., §71.
///
/// # Example
/// ```
/// use heavytop::{HeavyTop, LagrangeNutation};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = HeavyTop::lagrange(2.0, 1.0, 1.0)?;
/// let start = Se3Dual::new(Vector3::new(0.5, 0.2, 3.0), Vector3::new(0.6, 0.0, 0.8));
/// let nutation = LagrangeNutation::new(&top, &start)?;
/// assert!((nutation.height(0.0) - 0.8).abs() < 1e-14);
/// assert!((nutation.height(nutation.period()) - 0.8).abs() < 1e-13);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LagrangeNutation {
    lowest: f64,
    range: f64,
    rate: f64,
    phase: f64,
    parameter: f64,
}

impl LagrangeNutation {
    /// The nutation of the motion through `start`.
    ///
    /// # Errors
    /// If the top is not Lagrange's with m g l > 0, or the start is not finite.
    pub fn new(top: &HeavyTop, start: &Se3Dual) -> Result<Self, TopError> {
        let weight = top.weight_moment() * top.center_of_mass().z;
        if !top.is_lagrange() || weight <= 0.0 {
            return Err(TopError::NotLagrange);
        }
        let Covector(Pair(pi, gamma)) = start;
        let i1 = top.inertia().x;
        let roots = turning_points(top, start, weight)?;
        if is_equilibrium(roots, gamma.z) {
            let rest = Self { lowest: gamma.z, range: 0.0, rate: 1.0, phase: 0.0, parameter: 0.0 };
            return Ok(rest);
        }
        let [lowest, highest, outside] = roots;
        let range = highest - lowest;
        let parameter = (range / (outside - lowest)).clamp(0.0, 1.0);
        // u̇ = (Γ × Ω)₃
        let rising = gamma.x * pi.y - gamma.y * pi.x >= 0.0;
        let sine = ((gamma.z - lowest) / range).clamp(0.0, 1.0).sqrt();
        let quarter = incomplete_elliptic(sine.asin(), parameter);
        let phase = if rising { quarter } else { -quarter };
        let rate = (weight * (outside - lowest) / (2.0 * i1)).sqrt();
        // A range of zero is regular precession, of which the phase has no meaning.
        Ok(Self { lowest, range, rate, phase: if range > 0.0 { phase } else { 0.0 }, parameter })
    }

    /// Γ₃(t), t in seconds.
    #[must_use]
    pub fn height(&self, time: f64) -> f64 {
        let [sn, ..] = jacobi_elliptic(self.rate * time + self.phase, self.parameter);
        self.lowest + self.range * sn * sn
    }

    /// The period of the nutation, 2K(m)/ν, in seconds. It grows without bound towards the separatrix,
    /// as far as m next to 1 can tell; where the height is constant it has no meaning.
    #[must_use]
    pub fn period(&self) -> f64 {
        2.0 * incomplete_elliptic(core::f64::consts::FRAC_PI_2, self.parameter) / self.rate
    }

    /// u₁ and u₂, between which Γ₃ moves.
    #[must_use]
    pub fn turning_points(&self) -> (f64, f64) {
        (self.lowest, self.lowest + self.range)
    }
}

/// Whether Γ₃ is a double root of the cubic, where u̇ = ü = 0: regular precession, and the top that
/// spins upright, stable or not. A double root is known to the square root of round-off.
fn is_equilibrium(roots: [f64; 3], height: f64) -> bool {
    let near = roots.iter().filter(|root| (*root - height).abs() <= 4.0 * f64::EPSILON.sqrt());
    near.count() >= 2
}

/// The roots u₁ ≤ u₂ ≤ u₃ of the cubic.
fn turning_points(top: &HeavyTop, start: &Se3Dual, weight: f64) -> Result<[f64; 3], TopError> {
    let Covector(Pair(pi, gamma)) = start;
    let inertia: Vector3<f64> = top.inertia();
    let (i1, spin) = (inertia.x, pi.z);
    let energy = Invariant::Energy.value(top, start) - spin * spin / (2.0 * inertia.z);
    let (level, square) = (pi.dot(gamma), gamma.norm_squared());
    // u³ + a u² + b u + c, the cubic divided by 2 I₁ W
    let scale = 1.0 / (2.0 * i1 * weight);
    let a = -(energy / weight) - spin * spin * scale;
    let b = -square + 2.0 * level * spin * scale;
    let c = square * energy / weight - level * level * scale;
    let cubic = |u: f64| ((u + a) * u + b) * u + c;
    let slope = |u: f64| (3.0 * u + 2.0 * a) * u + b;
    // Three real roots by Viète's formula, each polished by a Newton step or two.
    let (p, q) = (a * a / 9.0 - b / 3.0, a * a * a / 27.0 - a * b / 6.0 + c / 2.0);
    let radius = p.max(0.0).sqrt();
    let angle = (q / (radius * radius * radius)).clamp(-1.0, 1.0).acos();
    let mut roots = [0.0, 1.0, 2.0].map(|k| {
        let turn = (angle + 2.0 * core::f64::consts::PI * k) / 3.0;
        let mut root = -2.0 * radius * turn.cos() - a / 3.0;
        for _ in 0..3 {
            let better = root - cubic(root) / slope(root);
            if cubic(better).abs() < cubic(root).abs() {
                root = better;
            }
        }
        root
    });
    roots.sort_by(f64::total_cmp);
    match roots.iter().find(|root| !root.is_finite()) {
        Some(&value) => Err(TopError::NotFinite { name: "start", value }),
        None => Ok(roots),
    }
}
