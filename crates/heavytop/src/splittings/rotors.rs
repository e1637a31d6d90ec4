//! The splitting of a top into four exactly solvable parts.

use crate::attitude::step_rotation::TurningFlows;
use crate::splittings::principal_turn::PrincipalTurn;
use crate::tops::rigid_body::RigidBody;
use crate::tops::top::HeavyTop;
use collective_integrators::ExactFlows;
use lie_poisson::{Covector, LieGroup, Pair, Quaternion, Real, SP1, Se3Dual, Vector};
use nalgebra::Vector3;

/// The splitting of a top into three rotors, one for each principal axis, and the weight.
///
/// Their Hamiltonians and flows are
///
/// ```text
/// h = Π₁²/2I₁ + Π₂²/2I₂ + Π₃²/2I₃ + m g l Γ·c
/// φ_i^t: Π and Γ turn about e_i by the angle −tΠ_i/I_i,    i = 1, 2, 3
/// φ_4^t: Π ← Π + t m g l Γ×c
/// ```
///
/// Each flow is exact, since dΠ/dt = Π×Ω and dΓ/dt = Γ×Ω with the constant Ω = (Π_i/I_i) e_i. A
/// [`Splitting`](collective_integrators::Splitting) of these flows is an explicit Lie–Poisson integrator on
/// se(3)∗, or on so(3)∗ for the [free body](RigidBody), which has no weight. It conserves |Γ| and Π·Γ to
/// round-off.
///
/// Source: McLachlan, *Explicit Lie–Poisson integration and the Euler equations*, Phys. Rev. Lett.
/// 71 (1993); Reich, *Momentum conserving symplectic integrators*, Physica D 76 (1994); Hairer,
/// Lubich & Wanner, *Geometric Numerical Integration*, §VII.5.
///
/// # Example
/// ```
/// use collective_integrators::{Splitting, Start};
/// use heavytop::{HeavyTop, Invariant, RotorSplitting};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// for sample in Splitting::strang(RotorSplitting(top)).trajectory(&start, 0.02)?.take(500) {
///     let mu = sample?.momentum;
///     let deviation = |i: Invariant| (i.value(&top, &mu) - i.value(&top, &start)).abs();
///     assert!(deviation(Invariant::VerticalMomentum) < 1e-13);
///     assert!(deviation(Invariant::Energy) < 1e-2);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotorSplitting<B>(pub B);

impl RotorSplitting<HeavyTop> {
    /// Returns the angle −tΠ_i/I_i of rotor i.
    #[inline]
    fn angle<T: Real>(&self, index: usize, time: f64, pi: &Vector3<T>) -> T {
        pi[index] * rate(-time, &self.0.inertia(), index)
    }
}

/// Returns t/I_i. A thin rod, which does not turn about itself, has the moments of a sphere.
#[inline]
fn rate(time: f64, inertia: &Vector3<f64>, index: usize) -> f64 {
    let moment = inertia[index];
    if moment == 0.0 { time / inertia[(index + 1) % 3] } else { time / moment }
}

impl<T: Real> ExactFlows<T> for RotorSplitting<HeavyTop> {
    type Point = Se3Dual<T>;
    const COUNT: usize = 4;

    #[inline]
    fn flow(&self, index: usize, time: f64, mu: &Se3Dual<T>) -> Se3Dual<T> {
        let Covector(Pair(pi, gamma)) = mu;
        if index < 3 {
            let turn = PrincipalTurn::new(index, self.angle(index, time, pi));
            Se3Dual::new(turn.apply(pi), turn.apply(gamma))
        } else if index == 3 {
            kick(&self.0, time, mu)
        } else {
            *mu
        }
    }
}

impl<T: Real> TurningFlows<T> for RotorSplitting<HeavyTop> {
    #[inline]
    fn flow_turn(&self, index: usize, time: f64, mu: &Se3Dual<T>) -> Quaternion<T> {
        if index < 3 {
            axial_turn(index, self.angle(index, time, &mu.0.0))
        } else {
            Quaternion::one()
        }
    }
}

impl<T: Real> ExactFlows<T> for RotorSplitting<RigidBody> {
    type Point = Covector<Vector3<T>>;
    const COUNT: usize = 3;

    #[inline]
    fn flow(&self, index: usize, time: f64, mu: &Covector<Vector3<T>>) -> Covector<Vector3<T>> {
        if index >= 3 {
            return *mu;
        }
        let angle = mu.0[index] * rate(-time, &self.0.inertia(), index);
        Covector(PrincipalTurn::new(index, angle).apply(&mu.0))
    }
}

/// Rotates v by a rotation vector ω: v + c₁ ω×v + c₂ ω×(ω×v), with Stumpff functions of |ω|².
#[inline]
pub(crate) fn rotated<T: Real>(omega: &Vector3<T>, v: &Vector3<T>) -> Vector3<T> {
    let (x, turned) = (omega.dot(omega), omega.cross(v));
    v + (turned * x.stumpff(1) + omega.cross(&turned) * x.stumpff(2))
}

/// Returns the unit quaternion of the rotation about e_axis by the angle.
#[inline]
pub(crate) fn axial_turn<T: Real>(axis: usize, angle: T) -> Quaternion<T> {
    SP1.exp(&Vector3::basis(axis).scaled(angle))
}

/// Advances μ by the flow of m g l Γ·c.
#[inline]
pub(crate) fn kick<T: Real>(top: &HeavyTop, time: f64, mu: &Se3Dual<T>) -> Se3Dual<T> {
    let Covector(Pair(pi, gamma)) = mu;
    let force = top.center_of_mass().map(|c| T::from_f64(time * top.weight_moment() * c));
    Se3Dual::new(pi + gamma.cross(&force), *gamma)
}
