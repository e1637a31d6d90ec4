//! The nutation of Lagrange's top in closed form.

use crate::closed_forms::elliptic::{JacobiElliptic, elliptic_argument};
use crate::closed_forms::nutation_cubic::NutationCubic;
use crate::error::{TopError, require_finite};
use crate::tops::top::HeavyTop;
use lie_poisson::{Covector, Pair, Se3Dual};

/// The height Γ₃(t) of Lagrange's top in closed form.
///
/// With u = Γ₃, W = m g l, b = Π·Γ, f₁ = |Γ|² and E′ = h − Π₃²/2I₃ it obeys
///
/// ```text
/// (du/dt)² = [2I₁(E′ − Wu)(f₁ − u²) − (b − Π₃u)²]/I₁² = (2W/I₁)(u − u₁)(u − u₂)(u − u₃)
/// Γ₃ = u₁ + (u₂ − u₁) sn²(νt + δ | m),  ν² = W(u₃ − u₁)/2I₁,  1 − m = (u₃ − u₂)/(u₃ − u₁)
/// tan² am δ = (Γ₃(0) − u₁)/(u₂ − Γ₃(0)),  δ du/dt(0) ≥ 0,  |δ| ≤ K
/// ```
///
/// where u₁ ≤ u₂ ≤ u₃ are the roots, the first two in [−√f₁, √f₁]. The height is constant where du/dt and
/// d²u/dt² vanish: in regular precession, and for a top that stands upright or hangs, stable or not.
///
/// The roots are computed as distances from the start and from the upright position, with Γ₁² + Γ₂² instead of f₁ −
/// Γ₃². No digits are lost at turning points, near the vertical, or near the separatrix, where m = 1 and the top
/// approaches the upright position without reaching it. In all units the errors of Γ₃ are a few units of round-off
/// of |Γ|, plus the effect of a relative error of that size in t. A tilt below 1e-150 rad may be treated as zero.
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
    highest: f64,
    /// The range u₂ − u₁ of the height.
    range: f64,
    /// The rate ν of the argument.
    rate: f64,
    /// The argument δ at t = 0.
    phase: f64,
    functions: JacobiElliptic,
}

impl LagrangeNutation {
    /// Creates the nutation of the motion through `start`.
    ///
    /// # Errors
    /// Returns [`TopError::NotLagrange`] if the top is not Lagrange's with m g l > 0, and [`TopError::NotFinite`] if
    /// the start, or the ratio of its kinetic energy to m g l |Γ|, is not finite.
    pub fn new(top: &HeavyTop, start: &Se3Dual) -> Result<Self, TopError> {
        let weight = top.weight_moment() * top.center_of_mass().z;
        if !top.is_lagrange() || weight <= 0.0 {
            return Err(TopError::NotLagrange);
        }
        let Covector(Pair(pi, gamma)) = start;
        for &component in pi.iter().chain(gamma) {
            require_finite("start", component)?;
        }
        let moment = top.inertia().x;
        let height = gamma.z;
        if gamma.amax() == 0.0 {
            let functions = JacobiElliptic::with_complementary_modulus(1.0);
            return Ok(Self {
                lowest: 0.0,
                highest: 0.0,
                range: 0.0,
                rate: 0.0,
                phase: 0.0,
                functions,
            });
        }
        let cubic = NutationCubic::new(moment, weight, start);
        for value in cubic.roots {
            require_finite("turning point", value)?;
        }
        let [first, second, third] = cubic.roots;
        let (range, width) = (second - first, third - first);
        let root = |part: f64| (part / range).sqrt();
        let phase = if range == 0.0 {
            0.0
        } else {
            elliptic_argument(root(-first), root(second), (third / width).sqrt())
        };
        let complement = if width == 0.0 { 0.0 } else { (cubic.gap / width).min(1.0) };
        let solution = Self {
            lowest: height + cubic.length * first,
            highest: height + cubic.length * second,
            range: cubic.length * range,
            rate: (0.5 * width).sqrt() * cubic.length.sqrt() * weight.sqrt() / moment.sqrt(),
            phase: phase.copysign(cubic.rising),
            functions: JacobiElliptic::with_complement(complement)?,
        };
        for (name, value) in [
            ("lowest height", solution.lowest),
            ("highest height", solution.highest),
            ("range of the height", solution.range),
            ("rate", solution.rate),
            ("phase", solution.phase),
        ] {
            require_finite(name, value)?;
        }
        Ok(solution)
    }

    /// Returns the height Γ₃(t), with t in seconds, or NaN if νt is not finite.
    #[must_use]
    pub fn height(&self, time: f64) -> f64 {
        let [sn, cn, ..] = self.functions.at(self.rate.mul_add(time, self.phase));
        // The height is counted from the nearer turning point.
        if sn.abs() < cn.abs() {
            self.lowest + self.range * sn * sn
        } else {
            self.highest - self.range * cn * cn
        }
    }

    /// Returns the period 2K(m)/ν of the nutation, in seconds.
    ///
    /// It is infinite on the separatrix and for an unstable top that stands upright. If the height is constant, it is
    /// the period of infinitesimal nutation about this height.
    #[must_use]
    pub fn period(&self) -> f64 {
        2.0 * self.functions.quarter_period() / self.rate
    }

    /// Returns the least and the largest height u₁ and u₂, between which Γ₃ moves.
    #[must_use]
    pub fn turning_points(&self) -> (f64, f64) {
        (self.lowest, self.highest)
    }
}
