//! Viscous friction with principal axes of its own: [`ViscousMatrix`].

use crate::error::StepError;
use crate::open_systems::torqued::TorqueFlow;
use crate::open_systems::torques::torque_error::TorqueError;
use lie_poisson::{Real, State};
use nalgebra::{DMatrix, SMatrix};

/// The torque F = −Cμ of viscous friction, with a symmetric matrix C of eigenvalues c ≥ 0.
///
/// Its flow μ ↦ exp(−hC) μ is exact: along each principal axis of C, found once by eigenvectors, μ is multiplied by exp(−ch).
/// The matrix has as many rows as a momentum has coordinates; for momenta (μ, t) with the time it has a last row and column of
/// zeros. Friction along the axes of the coordinates alone is [`ViscousTorque`](crate::ViscousTorque).
///
/// # Example
/// Friction across the axis n = (3, 0, 4)/5 alone leaves the spin about it, as long as the body does not turn:
/// ```
/// use collective_integrators::{TorqueFlow, ViscousMatrix};
/// use lie_poisson::Covector;
/// use nalgebra::{Matrix3, Vector3};
/// let n = Vector3::new(0.6, 0.0, 0.8);
/// let across = ViscousMatrix::new(&((Matrix3::identity() - n * n.transpose()) * 0.5))?;
/// let mut pi = Covector(n * 2.0 + Vector3::y());
/// across.flow(&mut pi, 4.0)?;
/// assert!((pi.0 - (n * 2.0 + Vector3::y() * (-2.0_f64).exp())).norm() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ViscousMatrix {
    /// The eigenvalues c, which increase.
    rates: Vec<f64>,
    /// The columns are the principal axes, in the same order.
    axes: DMatrix<f64>,
}

impl ViscousMatrix {
    /// Creates friction from a symmetric matrix. Eigenvalues that are negative by their rounding errors alone count as 0.
    ///
    /// # Errors
    /// Returns [`TorqueError::NotFiniteEntry`] if an entry is NaN or infinite, [`TorqueError::NotSymmetric`] if two entries
    /// across the diagonal differ by more than rounding errors of the largest one, and [`TorqueError::Rate`] if an
    /// eigenvalue is negative.
    pub fn new<const N: usize>(matrix: &SMatrix<f64, N, N>) -> Result<Self, TorqueError> {
        let places = || (0..N).flat_map(|row| (0..N).map(move |column| (row, column)));
        if let Some(place) = places().find(|place| !matrix[*place].is_finite()) {
            let (row, column, number) = (place.0 + 1, place.1 + 1, matrix[place]);
            return Err(TorqueError::NotFiniteEntry { row, column, number });
        }
        let largest = places().fold(0.0_f64, |largest, place| largest.max(matrix[place].abs()));
        for (row, column) in places().filter(|(row, column)| column < row) {
            let (entry, across) = (matrix[(row, column)], matrix[(column, row)]);
            if (entry / largest - across / largest).abs() > ROUNDING {
                let (row, column) = (row + 1, column + 1);
                return Err(TorqueError::NotSymmetric { row, column, entry, across });
            }
        }
        if largest == 0.0 {
            return Ok(Self { rates: vec![0.0; N], axes: DMatrix::identity(N, N) });
        }
        // Eigenvectors need squares, which the entries themselves may not have.
        let scaled = DMatrix::from_fn(N, N, |row, column| {
            let [entry, across] = [(row, column), (column, row)].map(|at| matrix[at] / largest);
            0.5 * (entry + across)
        });
        let eigen = scaled.symmetric_eigen();
        let mut order: Vec<_> = (0..N).collect();
        order.sort_by(|i, j| eigen.eigenvalues[*i].total_cmp(&eigen.eigenvalues[*j]));
        let axes = DMatrix::from_fn(N, N, |row, column| eigen.eigenvectors[(row, order[column])]);
        let mut rates = Vec::with_capacity(N);
        for (place, index) in order.iter().enumerate() {
            let rate = eigen.eigenvalues[*index];
            let (negative, unscaled) = (rate < -ROUNDING * N as f64, rate * largest);
            if negative || !unscaled.is_finite() {
                return Err(TorqueError::Rate { coordinate: place + 1, rate: unscaled });
            }
            rates.push(unscaled.max(0.0));
        }
        Ok(Self { rates, axes })
    }

    /// Returns the rates along the principal axes, which increase.
    #[must_use]
    pub fn rates(&self) -> &[f64] {
        &self.rates
    }
}

/// The rounding errors of an entry or an eigenvalue, relative to the largest entry.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl<V: State> TorqueFlow<V> for ViscousMatrix {
    /// Multiplies the part of μ along each principal axis by exp(−ch).
    ///
    /// # Errors
    /// Returns [`StepError::Dimension`] if μ has not as many coordinates as the matrix has rows.
    fn flow(&self, mu: &mut V, step: f64) -> Result<(), StepError> {
        StepError::check_dimension(mu, self.rates.len())?;
        let before = mu.clone();
        for (rate, axis) in self.rates.iter().zip(self.axes.column_iter()) {
            // The parts that are lost, so that friction of the rate 0 changes no digit.
            let lost = V::Scalar::from_f64((-rate * step).exp_m1());
            let mut along = V::Scalar::from_f64(0.0);
            for (i, x) in axis.iter().enumerate() {
                along += before.coordinate(i) * V::Scalar::from_f64(*x);
            }
            for (i, x) in axis.iter().enumerate() {
                mu.set_coordinate(i, mu.coordinate(i) + along * lost * V::Scalar::from_f64(*x));
            }
        }
        Ok(())
    }
}
