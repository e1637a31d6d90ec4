//! The heavy top: [`HeavyTop`], [`Body`].

use crate::error::{
    TopError, require_finite, require_not_negative, require_positive, require_unit,
};
use crate::tops::parallel_axis::require_possible_body;
use lie_poisson::{
    Covector, Hamiltonian, LiePoisson, Pair, Real, Se3, Se3Dual, hessian_by_dual_numbers,
};
use nalgebra::{Matrix3, Vector3};

/// The phase space of the heavy top, se(3)∗ with the minus bracket. Source: Ohsawa 2019, eq. (1.2).
pub type HeavyTopSpace = LiePoisson<Se3>;

/// The parameters of a rigid body with a fixed point in a gravitational field, in SI units.
///
/// The moments are about the *support*, the fixed point, and not about the centre of mass. Data sheets and tables of solids
/// often give moments about the centre of mass; [`point_inertia`](crate::point_inertia) has the difference. A body whose
/// moments form a matrix is described by [`PrincipalAxes`](crate::PrincipalAxes).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Body {
    /// The principal moments I₁, I₂, I₃ about the support, kg m².
    pub inertia: Vector3<f64>,
    /// The mass m, kg.
    pub mass: f64,
    /// The gravitational acceleration g, m/s²; 0 for the free rigid body.
    pub gravity: f64,
    /// The distance l from the point of support to the centre of mass, m.
    pub length: f64,
    /// The unit vector c from the point of support towards the centre of mass, in the body frame.
    pub center_of_mass: Vector3<f64>,
}

impl Body {
    /// Checks that a body can have these moments about the support, with this mass at this distance from it.
    ///
    /// About the centre of mass it has the moments of I − m l² (1 − ccᵀ). They must not be negative, and none may be larger
    /// than the sum of the other two, to within 1e-9 of the largest moment about the support. [`HeavyTop::new`] does not
    /// check this: the motion depends on the moments and on m g l alone, and some tops of the literature fix no more.
    ///
    /// # Errors
    /// Returns [`TopError::ImpossibleBody`] with the moments about the centre of mass if no body has them, and
    /// [`TopError::NotFinite`] if one of them is not finite.
    ///
    /// # Example
    /// ```
    /// use heavytop::Body;
    /// use nalgebra::Vector3;
    /// let gyroscope = Body {
    ///     inertia: Vector3::new(2.0e-4, 2.0e-4, 3.0e-4), // those of a disc about its own centre
    ///     mass: 0.2,
    ///     gravity: 9.81,
    ///     length: 0.03,
    ///     center_of_mass: Vector3::z(),
    /// };
    /// assert!(gyroscope.require_possible().is_err()); // m l² = 1.8e-4 leaves too little across e₃
    /// let inertia = gyroscope.inertia + Vector3::new(1.8e-4, 1.8e-4, 0.0); // about the support
    /// assert!(Body { inertia, ..gyroscope }.require_possible().is_ok());
    /// ```
    pub fn require_possible(&self) -> Result<(), TopError> {
        let position = self.center_of_mass * self.length;
        require_possible_body(&Matrix3::from_diagonal(&self.inertia), self.mass, &position)
    }
}

/// The heavy top: a rigid body with a fixed point under gravity, as a Hamiltonian on se(3)∗.
///
/// ```text
/// h(Π, Γ) = ½ Π·(I⁻¹Π) + m g l Γ·c,    dh = (Ω, γ) = (I⁻¹Π, m g l c)
/// ```
///
/// in the body frame. Π is the angular momentum (kg m²/s) and Γ = R⁻¹e₃ the upward vertical seen from the
/// body. The equations of motion on se(3)∗ with the minus bracket are
///
/// ```text
/// dΠ/dt = Π × Ω + m g l Γ × c,    dΓ/dt = Γ × Ω
/// ```
///
/// Source: Ohsawa 2019, eqs. (1.1) and (1.3).
///
/// # Example
/// ```
/// use heavytop::HeavyTop;
/// use lie_poisson::{Hamiltonian, LiePoisson, PoissonSpace, Se3, Se3Dual};
/// use nalgebra::Vector3;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let (pi, gamma) = (Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// let mu = Se3Dual::new(pi, gamma);
/// let omega = Vector3::new(1.0, 1.5, 4.0);
/// let rate = LiePoisson::minus(Se3::default()).hamiltonian_vector(&mu, &top.differential(&mu));
/// assert_eq!(rate, Se3Dual::new(pi.cross(&omega) + gamma.cross(&Vector3::x()), gamma.cross(&omega)));
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "Parameters", into = "Parameters"))]
pub struct HeavyTop {
    inertia: Vector3<f64>,
    inverse_inertia: Vector3<f64>,
    weight_moment: f64,
    center_of_mass: Vector3<f64>,
}

/// The serialised form of a top. It is checked when it is read, as by [`HeavyTop::new`].
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct Parameters {
    inertia: Vector3<f64>,
    weight_moment: f64,
    center_of_mass: Vector3<f64>,
}

#[cfg(feature = "serde")]
impl TryFrom<Parameters> for HeavyTop {
    type Error = TopError;

    fn try_from(read: Parameters) -> Result<Self, TopError> {
        Self::from_moment(read.inertia, read.weight_moment, read.center_of_mass)
    }
}

#[cfg(feature = "serde")]
impl From<HeavyTop> for Parameters {
    fn from(HeavyTop { inertia, weight_moment, center_of_mass, .. }: HeavyTop) -> Self {
        Self { inertia, weight_moment, center_of_mass }
    }
}

impl HeavyTop {
    /// Creates the top from the parameters of a body. The mass, gravity and length enter through their product alone, the
    /// weight moment m g l (N m).
    ///
    /// One moment may be zero: a *thin rod* along that axis. The triangle inequality makes the other two equal, and the
    /// centre of mass lies on the rod. A rod has no angular momentum about itself ([`require_state`](Self::require_state)),
    /// and its motion is that of any symmetric top with the same moments across and no spin: Ω has no component along the
    /// rod, and the moment about it plays no part.
    ///
    /// # Errors
    /// Returns a [`TopError`] that names the parameter, unless the moments are positive, or those of a thin rod, and obey
    /// the triangle inequality, the mass is positive, gravity and length are not negative, the direction of the centre of
    /// mass is a unit vector, and the reciprocals of the moments are finite.
    pub fn new(body: &Body) -> Result<Self, TopError> {
        require_positive("mass", body.mass)?;
        require_not_negative("gravity", body.gravity)?;
        require_not_negative("length", body.length)?;
        Self::from_moment(body.inertia, body.mass * body.gravity * body.length, body.center_of_mass)
    }

    fn from_moment(
        inertia: Vector3<f64>,
        weight_moment: f64,
        center_of_mass: Vector3<f64>,
    ) -> Result<Self, TopError> {
        let rod = rod(&inertia);
        for (i, name) in ["inertia[0]", "inertia[1]", "inertia[2]"].into_iter().enumerate() {
            if rod != Some(i) {
                require_positive(name, inertia[i])?;
            }
        }
        require_triangle(&inertia)?;
        require_not_negative("mass·gravity·length", weight_moment)?;
        require_unit("center_of_mass", &center_of_mass)?;
        if let (Some(axis), true) = (rod, weight_moment > 0.0) {
            let across = (center_of_mass - Vector3::ith(axis, center_of_mass[axis])).norm();
            if across > ROUNDING {
                return Err(TopError::RodCenter { axis, across });
            }
        }
        let inverse_inertia = kinetic(&inertia).map(|i| 1.0 / i);
        for (name, &inverse) in
            ["1/inertia[0]", "1/inertia[1]", "1/inertia[2]"].iter().zip(&inverse_inertia)
        {
            require_finite(name, inverse)?;
        }
        Ok(Self { inertia, inverse_inertia, weight_moment, center_of_mass })
    }

    /// Creates the free rigid body, which has no gravity.
    ///
    /// # Errors
    /// Returns [`TopError`] unless the moments (kg m²) are positive, have finite reciprocals, and obey the triangle
    /// inequality.
    pub fn free_rigid_body(inertia: Vector3<f64>) -> Result<Self, TopError> {
        Self::from_moment(inertia, 0.0, Vector3::z())
    }

    /// Creates Lagrange's top: I₁ = I₂, c = e₃. Π₃ is conserved.
    ///
    /// `transverse` is I₁ = I₂ and `axial` is I₃, in kg m²; `weight_moment` is m g l in N m.
    ///
    /// Source: J. L. Lagrange, *Mécanique analytique* (1788).
    ///
    /// # Errors
    /// Returns [`TopError`] in the cases of [`HeavyTop::new`].
    pub fn lagrange(transverse: f64, axial: f64, weight_moment: f64) -> Result<Self, TopError> {
        let inertia = Vector3::new(transverse, transverse, axial);
        Self::from_moment(inertia, weight_moment, Vector3::z())
    }

    /// Creates Kovalevskaya's top: I₁ = I₂ = 2I₃, c = e₁. The paper's experiment has I₃ = m g l = 1.
    ///
    /// `axial` is I₃ in kg m²; `weight_moment` is m g l in N m.
    ///
    /// Source: Ohsawa 2019, §5.2.
    ///
    /// # Errors
    /// Returns [`TopError`] in the cases of [`HeavyTop::new`].
    pub fn kovalevskaya(axial: f64, weight_moment: f64) -> Result<Self, TopError> {
        let inertia = Vector3::new(2.0 * axial, 2.0 * axial, axial);
        Self::from_moment(inertia, weight_moment, Vector3::x())
    }

    /// Creates Goryachev and Chaplygin's top: I₁ = I₂ = 4I₃, c = e₁. It is integrable on Π·Γ = 0.
    ///
    /// `axial` is I₃ in kg m²; `weight_moment` is m g l in N m.
    ///
    /// Source: D. N. Goryachev (1900); S. A. Chaplygin (1901).
    ///
    /// # Errors
    /// Returns [`TopError`] in the cases of [`HeavyTop::new`].
    pub fn goryachev_chaplygin(axial: f64, weight_moment: f64) -> Result<Self, TopError> {
        let inertia = Vector3::new(4.0 * axial, 4.0 * axial, axial);
        Self::from_moment(inertia, weight_moment, Vector3::x())
    }

    /// Returns the principal moments I₁, I₂, I₃, kg m².
    #[must_use]
    pub fn inertia(&self) -> Vector3<f64> {
        self.inertia
    }

    /// Returns the axis 0, 1 or 2 of a thin rod: the one whose moment is zero.
    #[must_use]
    pub fn rod_axis(&self) -> Option<usize> {
        rod(&self.inertia)
    }

    /// Checks that the top can be in a state (Π, Γ). Only a thin rod has states in which it cannot be: those with an angular
    /// momentum about itself, by more than 1e-12 of |Π|.
    ///
    /// # Errors
    /// Returns [`TopError::RodSpin`] in such a state.
    ///
    /// # Example
    /// A pendulum that is a rod of 1 kg and 0.6 m, held at its end:
    /// ```
    /// use heavytop::{Body, HeavyTop, TopError};
    /// use lie_poisson::Se3Dual;
    /// use nalgebra::Vector3;
    /// let pendulum = HeavyTop::new(&Body {
    ///     inertia: Vector3::new(0.12, 0.12, 0.0), // m L²/3 across
    ///     mass: 1.0,
    ///     gravity: 9.81,
    ///     length: 0.3,
    ///     center_of_mass: Vector3::z(),
    /// })?;
    /// let gamma = Vector3::new(0.6, 0.0, -0.8);
    /// pendulum.require_state(&Se3Dual::new(Vector3::new(0.1, 0.2, 0.0), gamma))?;
    /// let refused = pendulum.require_state(&Se3Dual::new(Vector3::new(0.1, 0.2, 0.3), gamma));
    /// assert_eq!(refused, Err(TopError::RodSpin { axis: 2, momentum: 0.3 }));
    /// # Ok::<(), TopError>(())
    /// ```
    pub fn require_state(&self, Covector(Pair(pi, _)): &Se3Dual) -> Result<(), TopError> {
        match self.rod_axis() {
            Some(axis) if pi[axis].abs() > ROUNDING * pi.amax() => {
                Err(TopError::RodSpin { axis, momentum: pi[axis] })
            }
            _ => Ok(()),
        }
    }

    /// Returns the weight moment m g l, N m.
    #[must_use]
    pub fn weight_moment(&self) -> f64 {
        self.weight_moment
    }

    /// Returns the direction c of the centre of mass, a unit vector of the body frame.
    #[must_use]
    pub fn center_of_mass(&self) -> Vector3<f64> {
        self.center_of_mass
    }

    /// Returns the angular velocity Ω = I⁻¹Π in the body frame, rad/s.
    #[cfg_attr(optimised, inline(always))]
    pub fn angular_velocity<T: Real>(&self, pi: &Vector3<T>) -> Vector3<T> {
        let inverse = &self.inverse_inertia;
        Vector3::new(pi.x * inverse.x, pi.y * inverse.y, pi.z * inverse.z)
    }

    /// Returns the kinetic energy T = ½ Π·I⁻¹Π, J.
    ///
    /// ```
    /// use heavytop::HeavyTop;
    /// use lie_poisson::{Hamiltonian, Se3Dual};
    /// use nalgebra::Vector3;
    /// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    /// let mu = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
    /// let (kinetic, potential) = (top.kinetic_energy(&mu.0.0), top.potential_energy(&mu.0.1));
    /// assert_eq!([kinetic, potential, kinetic + potential], [11.25, 0.6, top.value(&mu)]);
    /// # Ok::<(), heavytop::TopError>(())
    /// ```
    #[cfg_attr(optimised, inline(always))]
    pub fn kinetic_energy<T: Real>(&self, pi: &Vector3<T>) -> T {
        pi.dot(&self.angular_velocity(pi)) * 0.5
    }

    /// Returns the potential energy V = m g l c·Γ, J: zero where the centre of mass is level with the support.
    #[cfg_attr(optimised, inline(always))]
    pub fn potential_energy<T: Real>(&self, gamma: &Vector3<T>) -> T {
        gamma.dot(&self.center_of_mass.map(T::from_f64)) * self.weight_moment
    }

    /// Returns the diagonal of I⁻¹.
    #[inline]
    pub(crate) fn inverse_inertia(&self) -> Vector3<f64> {
        self.inverse_inertia
    }

    /// Returns the constant part γ = m g l c of dh.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn force<T: Real>(&self) -> Vector3<T> {
        let force = self.center_of_mass * self.weight_moment;
        Vector3::new(T::from_f64(force.x), T::from_f64(force.y), T::from_f64(force.z))
    }
}

/// The differential dh, an element of se(3).
type Velocity<T> = Pair<Vector3<T>, Vector3<T>>;

impl<T: Real> Hamiltonian<HeavyTopSpace, T> for HeavyTop {
    #[cfg_attr(optimised, inline(always))]
    fn value(&self, mu: &Se3Dual<T>) -> T {
        let Covector(Pair(pi, gamma)) = mu;
        self.kinetic_energy(pi) + self.potential_energy(gamma)
    }

    #[cfg_attr(optimised, inline(always))]
    fn differential(&self, mu: &Se3Dual<T>) -> Velocity<T> {
        Pair(self.angular_velocity(&mu.0.0), self.force())
    }

    #[inline]
    fn hessian(&self, mu: &Se3Dual<T>, v: &Se3Dual<T>) -> Option<Velocity<T>> {
        Some(hessian_by_dual_numbers::<HeavyTopSpace, T, _>(self, mu, v))
    }
}

/// The relative size up to which a number is zero up to the rounding of parameters with 12 digits.
const ROUNDING: f64 = 1e-12;

/// Returns the axis about which the moment is zero, if the other two moments are those of a thin rod or of no body at all.
fn rod(inertia: &Vector3<f64>) -> Option<usize> {
    let axis = (0..3).find(|axis| inertia[*axis] == 0.0)?;
    (0..3).all(|i| i == axis || inertia[i] > 0.0).then_some(axis)
}

/// Returns the moments of the kinetic energy: for a thin rod, which never turns about itself, those of a sphere.
pub(crate) fn kinetic(inertia: &Vector3<f64>) -> Vector3<f64> {
    match rod(inertia) {
        Some(axis) => Vector3::repeat(inertia[(axis + 1) % 3]),
        None => *inertia,
    }
}

fn require_triangle(inertia: &Vector3<f64>) -> Result<(), TopError> {
    // A flat body has I₁ + I₂ = I₃, which rounding may break by a few units.
    const SLACK: f64 = 1.0 + 1e-12;
    for i in 0..3 {
        let (largest, first, second) = (inertia[i], inertia[(i + 1) % 3], inertia[(i + 2) % 3]);
        if largest > (first + second) * SLACK {
            return Err(TopError::Triangle { largest, first, second });
        }
    }
    Ok(())
}
