//! The heavy top on a movable base as a Hamiltonian on (se(3) ⋉ R³)∗.

use crate::error::{SystemError, require_finite, require_not_negative, require_positive};
use lie_poisson::{
    Covector, Hamiltonian, Inherited, LiePoisson, Pair, Real, SO3OnR3, SemidirectAlgebra,
    constant_times, hessian_by_dual_numbers,
};
use nalgebra::{Matrix3, Vector3};

/// The Lie algebra se(3) ⋉ R³, in which translations act trivially on the second R³.
pub type MovableBaseAlgebra = SemidirectAlgebra<Inherited<SO3OnR3, SO3OnR3>>;

/// An element ((Ω, Y), γ) of se(3) ⋉ R³.
pub type MovableBaseElement<T = f64> = Pair<Pair<Vector3<T>, Vector3<T>>, Vector3<T>>;

/// A point ((Π, P), Γ) of (se(3) ⋉ R³)∗.
pub type MovableBaseDual<T = f64> = Covector<MovableBaseElement<T>>;

/// A heavy top whose point of support is a base that moves freely.
///
/// The base of mass M moves in space with the velocity Y, and turns with the top at Ω. A thrust (m+M)g along the
/// vertical carries the weight, so that gravity only turns the top. In the body frame, with the minus bracket,
///
/// ```text
/// h = ½ Ω·IΩ + m l Y·(Ω×c) + ½ (m+M)|Y|² + m g l Γ·c
/// Π = IΩ + m l c×Y,    P = (m+M)Y + m l Ω×c
/// dΠ/dt = Π×Ω + P×Y + m g l Γ×c,    dP/dt = P×Ω,    dΓ/dt = Γ×Ω
/// ```
///
/// Π is the angular momentum about the base (kg m²/s), P the momentum (kg m/s), Γ the upward vertical, and c the
/// direction of the centre of mass, at the distance l. The Casimirs are |P|², P·Γ and |Γ|². For M → ∞ it is the heavy
/// top.
///
/// Source: C. Contreras & T. Ohsawa, *Controlled Lagrangians and stabilization of Euler–Poincaré mechanical systems
/// with broken symmetry II: potential shaping*, Math. Control Signals Syst. 34 (2022), and Jayawardana, Morrison &
/// Ohsawa, *Clebsch canonization of Lie–Poisson systems*, J. Geom. Mech. 14 (2022), for the phase space; the energy is
/// that of two rigidly joined masses.
///
/// # Example
/// The base gives way: a top that starts at rest with its axis horizontal begins to rotate about the common centre of
/// mass of top and base.
/// ```
/// use lie_poisson::{Covector, Hamiltonian, LiePoisson, Pair, PoissonSpace};
/// use lie_poisson_systems::{MovableBaseAlgebra, MovableBaseTop};
/// use nalgebra::{Matrix3, Vector3};
/// let top = MovableBaseTop::new(Vector3::new(2.0, 2.0, 1.0), [1.0, 3.0], 9.81, Vector3::z())?;
/// let at_rest = Covector(Pair(Pair(Vector3::zeros(), Vector3::zeros()), Vector3::x()));
/// let space = LiePoisson::minus(MovableBaseAlgebra::default());
/// let Covector(Pair(Pair(torque, force), _)) = space.hamiltonian_vector(&at_rest, &top.differential(&at_rest));
/// assert_eq!((torque, force), (Vector3::x().cross(&Vector3::z()) * 9.81, Vector3::zeros()));
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovableBaseTop {
    /// The inverse of I − β m l (1 − ccᵀ), where β c is the centre of both masses.
    inverse_inertia: Matrix3<f64>,
    /// The vector m l c/(m+M), from the base to the centre of both masses.
    center: Vector3<f64>,
    /// The mass m + M of the top and the base.
    mass: f64,
    /// The vector m g l c.
    weight_moment: Vector3<f64>,
}

impl MovableBaseTop {
    /// Creates a top from its principal moments about the point of support (kg m²), the masses \[m, M\] of the top and
    /// of the base (kg), the acceleration g of gravity (m/s²) and the vector l c from the support to its centre of mass
    /// (m).
    ///
    /// # Errors
    /// Returns [`SystemError`] unless the moments and m are positive, M and g are not negative, every number is finite,
    /// and the moments are large enough for m and l c, so that the kinetic energy is positive.
    pub fn new(
        inertia: Vector3<f64>,
        [top, base]: [f64; 2],
        gravity: f64,
        center_of_mass: Vector3<f64>,
    ) -> Result<Self, SystemError> {
        for (name, &value) in ["inertia[0]", "inertia[1]", "inertia[2]"].iter().zip(&inertia) {
            require_positive(name, value)?;
        }
        require_positive("mass of the top", top)?;
        require_not_negative("mass of the base", base)?;
        require_not_negative("gravity", gravity)?;
        for &value in &center_of_mass {
            require_finite("center_of_mass", value)?;
        }
        let mass = top + base;
        require_finite("mass of top and base", mass)?;
        let center = center_of_mass * (top / mass);
        let moved =
            Matrix3::identity() * center.dot(&center_of_mass) - center * center_of_mass.transpose();
        let about_center = Matrix3::from_diagonal(&inertia) - moved * top;
        for &value in &about_center {
            require_finite("matrix of the moments about the centre of both masses", value)?;
        }
        let inverse_inertia = about_center.cholesky().map(|cholesky| cholesky.inverse());
        let Some(inverse_inertia) = inverse_inertia else {
            let name = "smallest moment about the centre of both masses";
            return Err(SystemError::NotPositive {
                name,
                value: about_center.symmetric_eigenvalues().min(),
            });
        };
        let weight_moment = center_of_mass * (top * gravity);
        for &value in inverse_inertia.iter().chain(&center).chain(&weight_moment) {
            require_finite("inverse inertia or weight moment", value)?;
        }
        Ok(Self { inverse_inertia, center, mass, weight_moment })
    }

    /// Returns the angular velocity Ω (rad/s) and the velocity Y of the base (m/s), in the body frame.
    pub fn velocities<T: Real>(&self, mu: &MovableBaseDual<T>) -> (Vector3<T>, Vector3<T>) {
        let Covector(Pair(Pair(pi, p), _)) = mu;
        let center = self.center.map(T::from_f64);
        let omega = constant_times(&self.inverse_inertia, &(pi - center.cross(p)));
        (omega, p / T::from_f64(self.mass) - omega.cross(&center))
    }

    /// Returns the Casimirs |P|², in kg² m²/s², P·Γ, in kg m/s, and |Γ|², dimensionless.
    ///
    /// They are those of the semidirect product se(3) ⋉ R³, whatever the Hamiltonian.
    pub fn casimirs<T: Real>(mu: &MovableBaseDual<T>) -> [T; 3] {
        let Covector(Pair(Pair(_, p), gamma)) = mu;
        [p.dot(p), p.dot(gamma), gamma.dot(gamma)]
    }
}

impl<T: Real> Hamiltonian<LiePoisson<MovableBaseAlgebra>, T> for MovableBaseTop {
    #[inline]
    fn value(&self, mu: &MovableBaseDual<T>) -> T {
        let (omega, velocity) = self.velocities(mu);
        let Covector(Pair(Pair(pi, p), gamma)) = mu;
        let kinetic = (pi.dot(&omega) + p.dot(&velocity)) * 0.5;
        kinetic + gamma.dot(&self.weight_moment.map(T::from_f64))
    }

    #[inline]
    fn differential(&self, mu: &MovableBaseDual<T>) -> MovableBaseElement<T> {
        let (omega, velocity) = self.velocities(mu);
        Pair(Pair(omega, velocity), self.weight_moment.map(T::from_f64))
    }

    #[inline]
    fn hessian(
        &self,
        mu: &MovableBaseDual<T>,
        v: &MovableBaseDual<T>,
    ) -> Option<MovableBaseElement<T>> {
        Some(hessian_by_dual_numbers::<LiePoisson<MovableBaseAlgebra>, T, _>(self, mu, v))
    }
}
