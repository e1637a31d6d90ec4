//! Kirchhoff's rigid body in an ideal fluid.

use crate::HeavyTopSpace;
use crate::error::{TopError, require_finite};
use lie_poisson::{Covector, Hamiltonian, Pair, Real, Se3Dual, hessian_by_dual_numbers};
use nalgebra::{Matrix3, Vector3};

/// A rigid body in an ideal fluid at rest at infinity (Kirchhoff): on se(3)∗ with the minus
/// bracket, with the impulsive couple Π (kg m²/s) and the impulse P (kg m/s),
///
/// ```text
/// h(Π, P) = ½ Π·AΠ + Π·BP + ½ P·CP,    dh = (AΠ + BP, BᵀΠ + CP)
/// dΠ/dt = Π × Ω + P × v,    dP/dt = P × Ω,    (Ω, v) = dh
/// ```
///
/// The Casimirs are |P|² and Π·P. A heavy underwater vehicle, a torpedo or a falling card without
/// lift are of this kind.
///
/// Source: G. Kirchhoff, *Vorlesungen über mathematische Physik* (1876), 19th lecture; H. Lamb,
/// *Hydrodynamics*, 6th ed., §124; N. E. Leonard, *Stability of a bottom-heavy underwater
/// vehicle*, Automatica 33 (1997).
///
/// # Example
/// ```
/// use heavytop::Kirchhoff;
/// use lie_poisson::{Hamiltonian, Pair, Se3Dual};
/// use nalgebra::{Matrix3, Vector3};
/// let a = Matrix3::from_diagonal(&Vector3::new(1.0, 0.5, 0.25));
/// let body = Kirchhoff::new(a, Matrix3::zeros(), a)?;
/// let Pair(omega, v) = body.differential(&Se3Dual::new(Vector3::x(), Vector3::y()));
/// assert_eq!((omega, v), (Vector3::x(), Vector3::new(0.0, 0.5, 0.0)));
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kirchhoff {
    a: Matrix3<f64>,
    b: Matrix3<f64>,
    c: Matrix3<f64>,
}

impl Kirchhoff {
    /// From the blocks A, B and C of the inverse of the body-and-fluid inertia.
    ///
    /// # Errors
    /// If an entry is not finite, A or C is not symmetric, or h is not positive definite.
    pub fn new(a: Matrix3<f64>, b: Matrix3<f64>, c: Matrix3<f64>) -> Result<Self, TopError> {
        for (name, matrix) in [("A", &a), ("B", &b), ("C", &c)] {
            for &entry in matrix {
                require_finite(name, entry)?;
            }
        }
        for (name, matrix) in [("A", &a), ("C", &c)] {
            let defect = (matrix - matrix.transpose()).amax();
            if defect > 1e-12 * matrix.amax() {
                return Err(TopError::NotSymmetric { name, defect });
            }
        }
        require_positive_definite(&a, &b, &c)?;
        Ok(Self { a, b, c })
    }
}

/// Gauss elimination of the 6×6 matrix [A B; Bᵀ C]: all pivots must be positive.
fn require_positive_definite(
    a: &Matrix3<f64>,
    b: &Matrix3<f64>,
    c: &Matrix3<f64>,
) -> Result<(), TopError> {
    let mut m = nalgebra::SMatrix::<f64, 6, 6>::from_fn(|i, j| match (i < 3, j < 3) {
        (true, true) => a[(i, j)],
        (true, false) => b[(i, j - 3)],
        (false, true) => b[(j, i - 3)],
        (false, false) => c[(i - 3, j - 3)],
    });
    for k in 0..6 {
        let pivot = m[(k, k)];
        if pivot.is_nan() || pivot <= 0.0 {
            return Err(TopError::NotPositive { name: "pivot of [A B; Bᵀ C]", value: pivot });
        }
        for i in k + 1..6 {
            let factor = m[(i, k)] / pivot;
            for j in k..6 {
                m[(i, j)] -= factor * m[(k, j)];
            }
        }
    }
    Ok(())
}

impl<T: Real> Hamiltonian<HeavyTopSpace, T> for Kirchhoff {
    #[inline]
    fn value(&self, mu: &Se3Dual<T>) -> T {
        let (Covector(Pair(pi, p)), Pair(omega, v)) = (mu, self.differential(mu));
        (pi.dot(&omega) + p.dot(&v)) * 0.5
    }

    #[inline]
    fn differential(&self, mu: &Se3Dual<T>) -> Pair<Vector3<T>, Vector3<T>> {
        let Covector(Pair(pi, p)) = mu;
        let [a, b, c] = [&self.a, &self.b, &self.c].map(|m| m.map(T::from_f64));
        Pair(a * pi + b * p, b.tr_mul(pi) + c * p)
    }

    #[inline]
    fn hessian(&self, mu: &Se3Dual<T>, v: &Se3Dual<T>) -> Option<Pair<Vector3<T>, Vector3<T>>> {
        Some(hessian_by_dual_numbers::<HeavyTopSpace, T, _>(self, mu, v))
    }
}
