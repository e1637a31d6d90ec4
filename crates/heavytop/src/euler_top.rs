//! The free rigid body in closed form.

use crate::elliptic::incomplete_elliptic;
use crate::{RigidBody, jacobi_elliptic};
use nalgebra::Vector3;

/// The solution Π(t) of Euler's equations Π̇ = Π × I⁻¹Π through Π(0), in Jacobi's elliptic
/// functions. With moments I₁ ≤ I₂ ≤ I₃, L² = |Π|², 2E = Π·I⁻¹Π and L² ≥ 2EI₂,
///
/// ```text
/// Π = (a₁ cn u, ±a₂ sn u, ±a₃ dn u),    u = λt + u₀
/// a₁² = I₁(2EI₃ − L²)/(I₃ − I₁),  a₂² = I₂(2EI₃ − L²)/(I₃ − I₂),  a₃² = I₃(L² − 2EI₁)/(I₃ − I₁)
/// λ² = (I₃ − I₂)(L² − 2EI₁)/(I₁I₂I₃),  m = (I₂ − I₁)(2EI₃ − L²)/((I₃ − I₂)(L² − 2EI₁))
/// ```
///
/// the sign being that of Π₃; for L² < 2EI₂ the indices 1 and 3 change places.
///
/// Source: L. D. Landau & E. M. Lifshitz, *Mechanics*, 3rd ed., §37.
///
/// # Example
/// ```
/// use heavytop::{EulerSolution, RigidBody};
/// use nalgebra::Vector3;
/// let body = RigidBody::new(Vector3::new(1.0, 2.0, 2.5))?;
/// let start = Vector3::new(0.3, -0.4, 1.2);
/// let solution = EulerSolution::new(&body, start);
/// assert!((solution.at(0.0) - start).norm() < 1e-15);
/// assert!((solution.at(7.0).norm() - start.norm()).abs() < 1e-15);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerSolution {
    /// The axes that carry cn, sn and dn.
    axes: [usize; 3],
    amplitudes: Vector3<f64>,
    rate: f64,
    phase: f64,
    parameter: f64,
}

impl EulerSolution {
    /// The solution through `start`, kg m²/s; a start that is not finite stays as it is.
    #[must_use]
    pub fn new(body: &RigidBody, start: Vector3<f64>) -> Self {
        let inertia = body.inertia();
        let mut axes = [0, 1, 2];
        axes.sort_by(|&a, &b| inertia[a].total_cmp(&inertia[b]));
        let energy = start.component_div(&inertia).dot(&start);
        let square = start.norm_squared();
        // About the axis of the largest moment, or about that of the smallest.
        let middle = inertia[axes[1]];
        if square < energy * middle || inertia[axes[2]] == middle {
            axes.swap(0, 2);
        }
        let [i1, i2, i3] = axes.map(|axis| inertia[axis]);
        if i3 == i1 || start == Vector3::zeros() || !square.is_finite() {
            return Self::at_rest(start);
        }
        // Products of Π² with differences of moments, which do not cancel.
        let pi = axes.map(|axis| start[axis]);
        let small = pi[0] * pi[0] * (i3 - i1) / i1 + pi[1] * pi[1] * (i3 - i2) / i2;
        let large = pi[2] * pi[2] * (i3 - i1) / i3 + pi[1] * pi[1] * (i2 - i1) / i2;
        let amplitudes = Vector3::new(
            (i1 * small / (i3 - i1)).sqrt(),
            (i2 * small / (i3 - i2)).sqrt(),
            (i3 * large / (i3 - i1)).sqrt(),
        );
        let side = 1.0_f64.copysign(pi[2]);
        let parameter = ((i2 - i1) * small / ((i3 - i2) * large)).min(1.0);
        let angle = (side * pi[1] / amplitudes.y).atan2(pi[0] / amplitudes.x);
        // An odd order of the axes is a reflection, which turns time round; so does I₁ > I₃.
        let odd = (axes[1] + 3 - axes[0]) % 3 != 1;
        let rate = ((i3 - i2) * large / (i1 * i2 * i3)).sqrt();
        if rate == 0.0 {
            return Self::at_rest(start);
        }
        Self {
            axes,
            amplitudes: Vector3::new(amplitudes.x, side * amplitudes.y, side * amplitudes.z),
            rate: if odd == (i3 > i1) { -rate } else { rate },
            phase: if angle.is_nan() { 0.0 } else { incomplete_elliptic(angle, parameter) },
            parameter,
        }
    }

    /// Π = const; `at` returns the amplitudes for rate 0.
    fn at_rest(start: Vector3<f64>) -> Self {
        Self { axes: [0, 1, 2], amplitudes: start, rate: 0.0, phase: 0.0, parameter: f64::NAN }
    }

    /// Π(t), t in seconds.
    #[must_use]
    pub fn at(&self, time: f64) -> Vector3<f64> {
        if self.rate == 0.0 {
            return self.amplitudes;
        }
        let [sn, cn, dn, _] = jacobi_elliptic(self.rate * time + self.phase, self.parameter);
        let mut pi = Vector3::zeros();
        for (axis, value) in self.axes.into_iter().zip([cn, sn, dn]) {
            pi[axis] = value;
        }
        for (axis, amplitude) in self.axes.into_iter().zip(&self.amplitudes) {
            pi[axis] *= amplitude;
        }
        pi
    }
}
