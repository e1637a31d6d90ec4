//! The principal axes of an inertia matrix: [`PrincipalAxes`].

use crate::error::{TopError, require_finite};
use lie_poisson::{Covector, Pair, Quaternion, Se3Dual};
use nalgebra::{Matrix3, Vector3};

/// The largest difference of two entries of a symmetric matrix that mirror each other, relative to the largest entry.
const ASYMMETRY: f64 = 1e-9;

/// The size below which an eigenvalue is zero up to the rounding of the entries, relative to the largest entry.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The number of sweeps of Jacobi's iteration; five reach round-off.
const SWEEPS: usize = 30;

/// The pairs of coordinates that a sweep turns, each with the third coordinate.
const PLANES: [[usize; 3]; 3] = [[0, 1, 2], [0, 2, 1], [1, 2, 0]];

/// The principal moments of inertia of a body, and its principal axes in the axes in which the body is described.
///
/// ```text
/// I = A diag(I₁, I₂, I₃) Aᵀ,    A ∈ SO(3)
/// ```
///
/// The columns of A are the principal axes. A vector v of the body has the components Aᵀv along them. The equations of
/// a [`HeavyTop`](crate::HeavyTop) hold in principal axes; this type leads there and back. A body frame turned by A has
/// the attitude RA if the frame in which the body is described has the attitude R.
///
/// Where moments are equal the axes are not unique, and any of them serves. A matrix that is diagonal has A = 1.
///
/// Source: C. G. J. Jacobi, J. reine angew. Math. 30 (1846) 51; G. H. Golub & C. F. Van Loan, *Matrix Computations*, §8.5,
/// for the rotations.
///
/// # Example
/// A top that is given by a matrix, and one state of it:
/// ```
/// use heavytop::{Body, HeavyTop, PrincipalAxes};
/// use lie_poisson::Se3Dual;
/// use nalgebra::{Matrix3, Vector3};
/// let inertia = Matrix3::new(2.0, 0.3, 0.0, 0.3, 1.5, 0.1, 0.0, 0.1, 1.0);
/// let axes = PrincipalAxes::of(&inertia)?;
/// let top = HeavyTop::new(&Body {
///     inertia: axes.moments(),
///     mass: 1.0,
///     gravity: 9.81,
///     length: 0.1,
///     center_of_mass: axes.to_principal(&Vector3::new(0.6, 0.0, 0.8)),
/// })?;
/// let given = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::z());
/// let mu = axes.state_to_principal(&given);
/// let omega = axes.from_principal(&top.angular_velocity(&mu.0.0));
/// assert!((inertia * omega - given.0.0).norm() < 1e-14); // IΩ = Π, in the axes of the matrix
/// assert!((axes.state_from_principal(&mu).0.0 - given.0.0).norm() < 1e-14);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    moments: Vector3<f64>,
    axes: Matrix3<f64>,
}

impl PrincipalAxes {
    /// Finds the principal axes of an inertia matrix, kg m².
    ///
    /// Moments that are zero up to the rounding of the entries are zero. Whether the moments are those of a body is for
    /// [`HeavyTop::new`](crate::HeavyTop::new) to say.
    ///
    /// # Errors
    /// Returns [`TopError::NotFinite`] if an entry is not finite, and [`TopError::NotSymmetric`] if two entries that
    /// mirror each other differ by more than 1e-9 of the largest entry.
    pub fn of(inertia: &Matrix3<f64>) -> Result<Self, TopError> {
        let (mut matrix, largest) = (symmetric(inertia)?, inertia.amax());
        let mut axes = Matrix3::identity();
        for _ in 0..SWEEPS {
            let turned = PLANES.map(|plane| turn(&mut matrix, &mut axes, plane));
            if turned == [false; 3] {
                break;
            }
        }
        let clean = |moment: f64| if moment.abs() <= ROUNDING * largest { 0.0 } else { moment };
        Ok(Self { moments: matrix.diagonal().map(clean), axes })
    }

    /// Describes a body in its principal axes already, by its principal moments, kg m²: A = 1.
    #[must_use]
    pub fn aligned(moments: Vector3<f64>) -> Self {
        Self { moments, axes: Matrix3::identity() }
    }

    /// Returns the principal moments I₁, I₂, I₃, kg m².
    #[must_use]
    pub fn moments(&self) -> Vector3<f64> {
        self.moments
    }

    /// Returns the rotation A, whose columns are the principal axes.
    #[must_use]
    pub fn rotation(&self) -> Matrix3<f64> {
        self.axes
    }

    /// Returns whether the body is described in its principal axes: A = 1.
    #[must_use]
    pub fn is_aligned(&self) -> bool {
        self.axes == Matrix3::identity()
    }

    /// Returns the components Aᵀv of a vector along the principal axes.
    #[must_use]
    pub fn to_principal(&self, v: &Vector3<f64>) -> Vector3<f64> {
        // A product with 1 would change the sign of zeros.
        if self.is_aligned() { *v } else { self.axes.tr_mul(v) }
    }

    /// Returns the vector Av whose components along the principal axes are given.
    #[must_use]
    pub fn from_principal(&self, v: &Vector3<f64>) -> Vector3<f64> {
        if self.is_aligned() { *v } else { self.axes * v }
    }

    /// Returns the state (AᵀΠ, AᵀΓ) in principal axes.
    #[must_use]
    pub fn state_to_principal(&self, Covector(Pair(pi, gamma)): &Se3Dual) -> Se3Dual {
        Se3Dual::new(self.to_principal(pi), self.to_principal(gamma))
    }

    /// Returns the state (AΠ, AΓ) whose components along the principal axes are given.
    #[must_use]
    pub fn state_from_principal(&self, Covector(Pair(pi, gamma)): &Se3Dual) -> Se3Dual {
        Se3Dual::new(self.from_principal(pi), self.from_principal(gamma))
    }

    /// Returns the attitude of the principal axes from that of the frame in which the body is described: RA.
    #[must_use]
    pub fn attitude_to_principal(&self, attitude: &Quaternion) -> Quaternion {
        if self.is_aligned() { *attitude } else { *attitude * self.quaternion() }
    }

    /// Returns the attitude of the frame in which the body is described from that of the principal axes: RAᵀ.
    #[must_use]
    pub fn attitude_from_principal(&self, attitude: &Quaternion) -> Quaternion {
        if self.is_aligned() { *attitude } else { *attitude * self.quaternion().conjugate() }
    }

    /// Returns the unit quaternion of the rotation A.
    fn quaternion(&self) -> Quaternion {
        let rotation = nalgebra::Rotation3::from_matrix_unchecked(self.axes);
        let q = nalgebra::UnitQuaternion::from_rotation_matrix(&rotation);
        Quaternion { scalar: q.w, vector: Vector3::new(q.i, q.j, q.k) }
    }
}

/// Returns the symmetric part of an inertia matrix whose entries that mirror each other are equal up to rounding.
///
/// # Errors
/// Those of [`PrincipalAxes::of`].
pub(crate) fn symmetric(inertia: &Matrix3<f64>) -> Result<Matrix3<f64>, TopError> {
    for value in inertia {
        require_finite("inertia", *value)?;
    }
    for [row, column, _] in PLANES {
        let (value, mirrored) = (inertia[(row, column)], inertia[(column, row)]);
        // Halves, so that no difference overflows.
        if (0.5 * value - 0.5 * mirrored).abs() > 0.5 * ASYMMETRY * inertia.amax() {
            return Err(TopError::NotSymmetric { row, column, value, mirrored });
        }
    }
    Ok(inertia * 0.5 + inertia.transpose() * 0.5)
}

/// Turns the matrix and the axes so that an entry of the matrix vanishes, unless it does up to rounding already; returns
/// whether it did not.
///
/// The entry is compared with the diagonal entries of its row and its column, so that no unit plays a part.
fn turn(matrix: &mut Matrix3<f64>, axes: &mut Matrix3<f64>, [p, q, r]: [usize; 3]) -> bool {
    let (entry, first, second) = (matrix[(p, q)], matrix[(p, p)], matrix[(q, q)]);
    let scale = first.abs().sqrt() * second.abs().sqrt();
    if entry.abs() <= 0.5 * f64::EPSILON * scale {
        (matrix[(p, q)], matrix[(q, p)]) = (0.0, 0.0);
        return false;
    }
    // The tangent of the smaller of the two angles.
    let cotangent = (0.5 * second - 0.5 * first) / entry;
    let tangent = 1.0_f64.copysign(cotangent) / (cotangent.abs() + cotangent.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let (sine, half) = (tangent * cosine, tangent * cosine / (1.0 + cosine));
    matrix[(p, p)] = first - tangent * entry;
    matrix[(q, q)] = second + tangent * entry;
    (matrix[(p, q)], matrix[(q, p)]) = (0.0, 0.0);
    let (a, b) = (matrix[(r, p)], matrix[(r, q)]);
    let (a, b) = (a - sine * (b + half * a), b + sine * (a - half * b));
    (matrix[(r, p)], matrix[(p, r)], matrix[(r, q)], matrix[(q, r)]) = (a, a, b, b);
    for row in 0..3 {
        let (a, b) = (axes[(row, p)], axes[(row, q)]);
        (axes[(row, p)], axes[(row, q)]) = (a - sine * (b + half * a), b + sine * (a - half * b));
    }
    true
}
