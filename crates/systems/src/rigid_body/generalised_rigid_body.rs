//! The free rigid body in N dimensions: [`GeneralisedRigidBody`].

use crate::error::{SystemError, require_finite, require_positive};
use isospectral_flows::num_complex::Complex;
use isospectral_flows::{IsospectralField, LargeSkewHermitian};

/// The free rigid body in N dimensions, on so(N)∗, with N known when the program runs.
///
/// ```text
/// dM/dt = [M, Ω],    M_jk = (J_j + J_k) Ω_jk,    h(M) = ½ Σ_(j<k) M_jk²/(J_j + J_k)
/// ```
///
/// M is the real skew-symmetric matrix of the angular momentum in the frame of the body, Ω is the matrix of the angular
/// velocity, and J_j = ∫x_j² dm are the second moments of the mass. For N = 3 the equations are those of Euler, with
/// the moments of inertia I₁ = J₂ + J₃ and so on, M₃₂ = Π₁, M₁₃ = Π₂ and M₂₁ = Π₃.
///
/// The system is integrable. Besides the spectrum of M, it conserves the spectrum of M + λJ² for every λ, from which
/// the integrals of Manakov follow.
///
/// The matrices are points of u(N)∗ whose imaginary part is zero. Every integrator for [`IsospectralField`]s keeps it
/// zero. J is in kg m², and M in kg m²/s.
///
/// Source: Manakov, *Note on the integration of Euler's equations of the dynamics of an n-dimensional rigid body*,
/// Funct. Anal. Appl. 10 (1976); Ratiu, *The motion of the free n-dimensional rigid body*, Indiana Univ. Math. J. 29
/// (1980).
///
/// # Example
/// ```
/// use collective_integrators::{Integrator, RungeKutta};
/// use lie_poisson_systems::GeneralisedRigidBody;
/// use lie_poisson_systems::isospectral_flows::IsospectralRungeKutta;
/// let body = GeneralisedRigidBody::new(vec![1.0, 1.5, 2.0, 2.5, 3.0])?;
/// let mut m = body.momentum(|j, k| ((j + 3 * k) as f64).sin());
/// let (energy, second) = (body.energy(&m), body.manakov_integral(&m));
/// let gauss = IsospectralRungeKutta::new(RungeKutta::gauss(3)?, body.clone());
/// let mut workspace = gauss.workspace();
/// for _ in 0..100 {
///     gauss.step_in_place(&mut m, 0.1, &mut workspace)?;
/// }
/// assert!((body.energy(&m) - energy).abs() < 1e-9);
/// assert!((body.manakov_integral(&m) - second).abs() < 1e-8);
/// assert!(m.matrix().imaginary().iter().all(|x| *x == 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GeneralisedRigidBody {
    moments: Vec<f64>,
    /// The reciprocals 1/(J_j + J_k), column by column.
    inverses: Vec<f64>,
}

impl GeneralisedRigidBody {
    /// Creates the body with the second moments J_j of its mass; their number is N.
    ///
    /// # Errors
    /// Returns [`SystemError`] if a moment is not a positive number, or is so small that its reciprocal is not finite.
    pub fn new(moments: Vec<f64>) -> Result<Self, SystemError> {
        for &moment in &moments {
            require_positive("second moment of the mass", moment)?;
        }
        // Half of the sum does not overflow.
        let inverse = |k: &f64, j: &f64| 0.5 / (0.5 * j + 0.5 * k);
        let inverses: Vec<f64> =
            moments.iter().flat_map(|k| moments.iter().map(move |j| inverse(k, j))).collect();
        for &inverse in &inverses {
            require_finite("reciprocal of the sum of two second moments", inverse)?;
        }
        Ok(Self { moments, inverses })
    }

    /// Returns the second moments J_j, in kg m².
    #[must_use]
    pub fn moments(&self) -> &[f64] {
        &self.moments
    }

    /// Returns the angular momentum with the entries M_jk = f(j, k) for j < k.
    #[must_use]
    pub fn momentum(&self, f: impl Fn(usize, usize) -> f64) -> LargeSkewHermitian {
        LargeSkewHermitian::from_upper(self.moments.len(), |j, k| {
            Complex::from(if j < k { f(j, k) } else { 0.0 })
        })
    }

    /// Returns the energy h(M) = ½ Σ_(j<k) M_jk²/(J_j + J_k), in J, or NaN if M has another size.
    #[must_use]
    pub fn energy(&self, m: &LargeSkewHermitian) -> f64 {
        // Each entry with j < k occurs twice.
        0.25 * self.sum(m, |i| self.inverses[i])
    }

    /// Returns Manakov's integral tr(M²J²)/2 = −½ Σ_jk M_jk² J_j², or NaN if the size of M is not N.
    #[must_use]
    pub fn manakov_integral(&self, m: &LargeSkewHermitian) -> f64 {
        -0.5 * self.sum(m, |i| self.moments[i % self.moments.len()].powi(2))
    }

    /// Returns Σ_jk M_jk² f(j + N k).
    fn sum(&self, m: &LargeSkewHermitian, f: impl Fn(usize) -> f64) -> f64 {
        if m.size() != self.moments.len() {
            return f64::NAN;
        }
        m.matrix().real().iter().enumerate().map(|(i, entry)| entry * entry * f(i)).sum()
    }
}

impl IsospectralField for GeneralisedRigidBody {
    fn size(&self) -> usize {
        self.moments.len()
    }

    /// Writes −Ω, so that dM/dt = [−Ω, M]. It is NaN if M has another size.
    fn generator_into(&self, m: &LargeSkewHermitian, generator: &mut LargeSkewHermitian) {
        generator.change_upper(|re, im| {
            im.fill(0.0);
            if m.size() != self.moments.len() {
                return re.fill(f64::NAN);
            }
            for ((b, m), inverse) in re.iter_mut().zip(m.matrix().real()).zip(&self.inverses) {
                *b = -m * inverse;
            }
        });
    }
}
