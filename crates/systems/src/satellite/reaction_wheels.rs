//! A rigid body that motors turn by reaction wheels: [`ReactionWheels`].

use crate::error::{SystemError, require_finite};
use crate::gyrostat::principal_moments::PrincipalMoments;
use lie_poisson::{
    Covector, Differential, DualNumber, Hamiltonian, InTime, LiePoisson, Pair, Point, Real, So3,
    Time, from_parts, hessian_by_dual_numbers,
};
use nalgebra::Vector3;

/// The space of (Π, t) with Π in so(3)∗.
type Space = InTime<LiePoisson<So3>>;

/// The angular momenta of N wheels about their axes, as functions of the time.
///
/// A motor exerts the torque u = dl/dt on its wheel, and −u on the body.
pub trait WheelMomenta<const N: usize> {
    /// Returns the angular momentum of each wheel about its axis at a time (s), kg m²/s.
    fn momenta<T: Real>(&self, time: T) -> [T; N];
}

/// A torque-free rigid body with N balanced wheels, whose motors give them the angular momenta l(t).
///
/// It is a Hamiltonian on so(3)∗ that depends on time, with the minus bracket, in the frame of the body:
///
/// ```text
/// h(Π, t) = ½ (Π − l)·I⁻¹(Π − l),    l(t) = Σ_k l_k(t) a_k,    dΠ/dt = Π × Ω,    Ω = I⁻¹(Π − l(t))
/// ```
///
/// Π is the angular momentum of the body with its wheels (kg m²/s), I has the moments of both without those of the
/// wheels about their own axes (kg m²), and `a_k` is the unit vector along the axis of a wheel, whose angular momentum
/// about that axis, against the stars, is `l_k`. The motors are inside: |Π| is conserved, whatever they do, and so is
/// the angular momentum seen from the stars. The energy changes by dh/dt = −Ω·u with the torques u = dl/dt on the
/// wheels.
///
/// Source: P. S. Krishnaprasad, *Lie–Poisson structures, dual-spin spacecraft and asymptotic stability*, Nonlinear
/// Anal. 9 (1985); P. C. Hughes, *Spacecraft Attitude Dynamics* (1986), ch. 3.
///
/// # Example
/// A wheel is spun up until it has all of the angular momentum: the body comes to rest.
/// ```
/// use lie_poisson_systems::lie_poisson::{Real, Time, TimeDependent};
/// use lie_poisson_systems::collective_integrators::Driven;
/// use lie_poisson_systems::prelude::*;
/// struct SpinUp;
/// impl WheelMomenta<1> for SpinUp {
///     fn momenta<T: Real>(&self, time: T) -> [T; 1] {
///         [time * 0.1]
///     }
/// }
/// let wheels = ReactionWheels::new(Vector3::new(3.0, 2.0, 1.0), [Vector3::x()], SpinUp)?;
/// let start = Pair(Covector(Vector3::new(2.0, 0.0, 0.0)), Time(0.0));
/// assert_eq!(wheels.angular_velocity(&start).x, 2.0 / 3.0);
/// let gauss = Driven::new(RungeKutta::gauss(2)?, HOPF, TimeDependent(&wheels));
/// let end = gauss.after(&start, 0.1, 200)?.momentum;
/// assert!(wheels.angular_velocity(&end).norm() < 1e-13 && (end.0.0.x - 2.0).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReactionWheels<W, const N: usize> {
    moments: PrincipalMoments,
    axes: [Vector3<f64>; N],
    wheels: W,
}

impl<W: WheelMomenta<N>, const N: usize> ReactionWheels<W, N> {
    /// Creates a body from its principal moments I₁, I₂, I₃ (kg m²), the axes of the wheels in the frame of the body,
    /// of any length but 0, and the angular momenta of the wheels.
    ///
    /// # Errors
    /// Returns [`SystemError`] unless the moments are positive and obey the triangle inequality, their inverses are
    /// finite, and every axis has a finite length that is not 0.
    pub fn new(
        inertia: Vector3<f64>,
        axes: [Vector3<f64>; N],
        wheels: W,
    ) -> Result<Self, SystemError> {
        let moments = PrincipalMoments::new(&inertia)?;
        for value in axes.iter().flatten() {
            require_finite("axis of a wheel", *value)?;
        }
        // A length is measured in the largest component, so that its square is finite.
        let scaled = axes.map(|axis| axis / axis.amax());
        if axes.iter().any(|axis| axis.amax() == 0.0) {
            return Err(SystemError::Zero { name: "axis of a wheel" });
        }
        Ok(Self { moments, axes: scaled.map(|axis| axis.normalize()), wheels })
    }

    /// Returns the angular velocity Ω = I⁻¹(Π − l(t)) of the body at (Π, t), rad/s.
    pub fn angular_velocity<T: Real>(
        &self,
        Pair(Covector(pi), time): &Point<Space, T>,
    ) -> Vector3<T> {
        self.moments.angular_velocity(&(pi - self.momentum(time.0)))
    }

    /// Returns l(t), the sum of the angular momenta of the wheels about their axes, kg m²/s.
    pub fn momentum<T: Real>(&self, time: T) -> Vector3<T> {
        let momenta = self.wheels.momenta(time);
        let parts = self.axes.iter().zip(momenta).map(|(axis, l)| axis.map(|a| l * a));
        parts.fold(Vector3::zeros(), |sum, part| sum + part)
    }
}

impl<W: WheelMomenta<N>, T: Real, const N: usize> Hamiltonian<Space, T> for ReactionWheels<W, N> {
    fn value(&self, Pair(Covector(pi), time): &Point<Space, T>) -> T {
        let relative = pi - self.momentum(time.0);
        relative.dot(&self.moments.angular_velocity(&relative)) * 0.5
    }

    /// Returns (Ω, −Ω·u) with the torques u = dl/dt.
    fn differential(&self, z: &Point<Space, T>) -> Differential<Space, T> {
        let omega = self.angular_velocity(z);
        let torque = self.momentum(DualNumber::variable(z.1.0)).map(|l| l.derivative());
        let change = Covector(Time(-omega.dot(&torque)));
        from_parts::<Covector<Vector3<T>>, Time<T>>(&omega, &change)
    }

    fn hessian(&self, z: &Point<Space, T>, v: &Point<Space, T>) -> Option<Differential<Space, T>> {
        Some(hessian_by_dual_numbers::<Space, T, _>(self, z, v))
    }
}
