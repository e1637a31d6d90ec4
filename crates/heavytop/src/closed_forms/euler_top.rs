//! The motion of the free rigid body in closed form.

use crate::closed_forms::elliptic::{JacobiElliptic, elliptic_argument};
use crate::closed_forms::power_of_two::power_of_two;
use crate::error::{TopError, require_finite};
use crate::tops::rigid_body::RigidBody;
use crate::tops::top::kinetic;
use nalgebra::Vector3;
use twofloat::TwoFloat;

/// The solution Π(t) of Euler's equations dΠ/dt = Π × I⁻¹Π for a free rigid body, in Jacobi's elliptic
/// functions.
///
/// With moments I₁ ≤ I₂ ≤ I₃, L² = |Π|², 2E = Π·I⁻¹Π and L² ≥ 2EI₂ it is
///
/// ```text
/// Π = (±a₁ cn u, ±a₂ sn u, ±a₃ dn u),    u = λt + u₀
/// a₁² = I₁(2EI₃ − L²)/(I₃ − I₁),  a₂² = I₂(2EI₃ − L²)/(I₃ − I₂),  a₃² = I₃(L² − 2EI₁)/(I₃ − I₁)
/// λ² = (I₃ − I₂)(L² − 2EI₁)/(I₁I₂I₃),   1 − m = (I₃ − I₁)(L² − 2EI₂)/((I₃ − I₂)(L² − 2EI₁))
/// L² − 2EI₂ = Π₃²(I₃ − I₂)/I₃ − Π₁²(I₂ − I₁)/I₁
/// ```
///
/// The signs of the first and the third component are those of Π₁(0) and Π₃(0). The remaining sign is chosen such that
/// λ > 0, and |u₀| ≤ K. For L² < 2EI₂ the indices 1 and 3 are exchanged. L² = 2EI₂ is the separatrix, where m = 1.
///
/// L² − 2EI₂ is computed with twice the digits of an `f64`, so that a start near the separatrix keeps its distance from
/// it and stays on the same side. In all units the errors of Π(t) are a few units of round-off of |Π|, plus the effect
/// of a relative error of that size in t.
///
/// Source: L. D. Landau & E. M. Lifshitz, *Mechanics*, 3rd ed., §37.
///
/// # Example
/// ```
/// use heavytop::{EulerSolution, RigidBody};
/// use nalgebra::Vector3;
/// // On the separatrix the body leaves an unstable rotation and ends in the opposite one.
/// let body = RigidBody::new(Vector3::new(3.0, 4.0, 6.0))?;
/// let start = Vector3::new(-1.0, 0.5, 1.0);
/// let solution = EulerSolution::new(&body, start)?;
/// assert!((solution.at(0.0) - start).norm() < 1e-15);
/// assert!((solution.at(500.0) + Vector3::y() * 1.5).norm() < 1e-15);
/// assert!((solution.at(-500.0) - Vector3::y() * 1.5).norm() < 1e-15);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerSolution {
    start: Vector3<f64>,
    /// The elliptic orbit; `None` for a rotation about a principal axis, where Π is constant.
    orbit: Option<Orbit>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Orbit {
    /// The axes that carry cn, sn and dn.
    axes: [usize; 3],
    amplitudes: [f64; 3],
    /// The rate λ of the argument.
    rate: f64,
    /// The argument u₀ at t = 0.
    phase: f64,
    functions: JacobiElliptic,
}

impl EulerSolution {
    /// Creates the solution through `start`, kg m²/s.
    ///
    /// # Errors
    /// Returns [`TopError::NotFinite`] if the start, |Π| or λ is not finite.
    pub fn new(body: &RigidBody, start: Vector3<f64>) -> Result<Self, TopError> {
        for &component in &start {
            require_finite("start", component)?;
        }
        let inertia = kinetic(&body.inertia());
        if is_equilibrium(&inertia, &start) {
            return Ok(Self { start, orbit: None });
        }
        Ok(Self { start, orbit: Some(Orbit::through(&inertia, &start)?) })
    }

    /// Returns the period 4K(m)/λ of Π, in seconds: infinite on the separatrix, and `None` if Π is constant.
    ///
    /// ```
    /// use heavytop::{EulerSolution, RigidBody};
    /// use nalgebra::Vector3;
    /// let body = RigidBody::new(Vector3::new(1.0, 2.0, 3.0))?;
    /// let start = Vector3::new(0.1, 2.0, 0.2);
    /// let solution = EulerSolution::new(&body, start)?;
    /// let period = solution.period().ok_or("no motion")?;
    /// assert!((solution.at(period) - start).norm() < 1e-13);
    /// assert!((solution.at(period / 2.0) - start).norm() > 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.orbit.map(|orbit| 4.0 * orbit.functions.quarter_period() / orbit.rate)
    }

    /// Returns Π(t), with t in seconds, or NaN if λt is not finite.
    #[must_use]
    pub fn at(&self, time: f64) -> Vector3<f64> {
        self.orbit.map_or(self.start, |orbit| orbit.at(time))
    }
}

/// Returns whether Π × I⁻¹Π = 0. It compares the factors, since the products may underflow.
fn is_equilibrium(inertia: &Vector3<f64>, pi: &Vector3<f64>) -> bool {
    let vanishes = |i: usize, j: usize| pi[i] == 0.0 || pi[j] == 0.0 || inertia[i] == inertia[j];
    vanishes(0, 1) && vanishes(1, 2) && vanishes(2, 0)
}

impl Orbit {
    fn through(inertia: &Vector3<f64>, start: &Vector3<f64>) -> Result<Self, TopError> {
        // Everything is homogeneous in Π and in I.
        let (size, unit) = (power_of_two(start.amax()), power_of_two(inertia.max()));
        let mut axes = [0, 1, 2];
        axes.sort_by(|&a, &b| inertia[a].total_cmp(&inertia[b]));
        let scaled = |axes: [usize; 3]| {
            (axes.map(|axis| inertia[axis] / unit), axes.map(|axis| start[axis] / size))
        };
        let (moments, pi) = scaled(axes);
        let distance = separatrix_distance(moments, pi);
        // The rotation is about the axis of the largest moment or of the smallest, always the latter if I₂ =
        // I₃.
        if distance < 0.0 {
            axes.swap(0, 2);
        }
        let ([i1, i2, i3], [p1, p2, p3]) = scaled(axes);
        let (wide, narrow, rest) = ((i3 - i1).abs(), (i3 - i2).abs(), (i2 - i1).abs());
        // |2EI₃ − L²|^½ and |L² − 2EI₁|^½, sums of squares.
        let small = (p1 * (wide / i1).sqrt()).hypot(p2 * (narrow / i2).sqrt());
        let large = (p3 * (wide / i3).sqrt()).hypot(p2 * (rest / i2).sqrt());
        let a1 = small * (i1 / wide).sqrt();
        let a2 = small * (i2 / narrow).sqrt();
        let a3 = large * (i3 / wide).sqrt();
        let modulus = distance.abs() * (wide / (i1 * i3 * narrow)).sqrt() / large;
        // An odd order of the axes is a reflection, which reverses time; so does I₁ > I₃.
        let even = (axes[1] + 3 - axes[0]) % 3 == 1;
        let (s1, s3) = (1.0_f64.copysign(p1), 1.0_f64.copysign(p3));
        let s2 = if even == (i3 > i1) { s1 * s3 } else { -s1 * s3 };
        let amplitudes = [s1 * a1 * size, s2 * a2 * size, s3 * a3 * size];
        let rate = large * (narrow / i2).sqrt() / (i1 * i3).sqrt() * size / unit;
        let phase = elliptic_argument(s2 * p2 / a2, p1.abs() / a1, p3.abs() / a3);
        for value in amplitudes {
            require_finite("amplitude", value)?;
        }
        for (name, value) in [("rate", rate), ("phase", phase), ("modulus", modulus)] {
            require_finite(name, value)?;
        }
        let functions = JacobiElliptic::with_complementary_modulus(modulus);
        Ok(Self { axes, amplitudes, rate, phase, functions })
    }

    fn at(&self, time: f64) -> Vector3<f64> {
        let [sn, cn, dn, _] = self.functions.at(self.rate.mul_add(time, self.phase));
        let ([i, j, k], [a1, a2, a3]) = (self.axes, self.amplitudes);
        let mut pi = Vector3::zeros();
        (pi[i], pi[j], pi[k]) = (a1 * cn, a2 * sn, a3 * dn);
        pi
    }
}

/// Returns ±|I₁I₃(L² − 2EI₂)|^½ with the sign of L² − 2EI₂, for I₁ ≤ I₂ ≤ I₃.
fn separatrix_distance([i1, i2, i3]: [f64; 3], [p1, _, p3]: [f64; 3]) -> f64 {
    let [low, high] = [TwoFloat::new_sub(i2, i1) * i3, TwoFloat::new_sub(i3, i2) * i1];
    // The larger term is scaled near 1, so that it does not underflow.
    let size = power_of_two((p1 * low.hi().sqrt()).abs().max((p3 * high.hi().sqrt()).abs()));
    let term = |p: f64, weight: TwoFloat| weight * (p / size) * (p / size);
    let difference = f64::from(term(p3, high) - term(p1, low));
    size * difference.abs().sqrt().copysign(difference)
}
