//! Zeitlin's model on the coordinates of its matrices: [`ZeitlinCoordinates`].

use crate::matrix_hydrodynamics::zeitlin::Zeitlin;
use collective_integrators::{AnyState, VectorField};
use lie_poisson::{Real, State};

/// The equation dW/dt = [P, W]/ħ of [`Zeitlin`] on the N² coordinates of W, over every scalar, such as dual numbers: for
/// tangent vectors, and with them Lyapunov exponents.
///
/// The coordinates are those of `LargeSkewHermitian`: column by column the real parts below the diagonal and the imaginary
/// parts on and above it; they are vorticities, in inverse units of time. Products are plain sums, and each evaluation allocates
/// its matrices, so that for large N the field of matrices is much faster.
///
/// Source: that of [`Zeitlin`].
///
/// # Example
/// The rate is that of the matrices:
/// ```
/// use collective_integrators::{AnyState, VectorField};
/// use lie_poisson::State;
/// use lie_poisson_systems::isospectral_flows::{CommutatorField, LargeSkewHermitian};
/// use lie_poisson_systems::num_complex::Complex;
/// use lie_poisson_systems::{Zeitlin, ZeitlinCoordinates};
/// let fluid = Zeitlin::new(4)?;
/// let w = LargeSkewHermitian::from_upper(4, |j, k| Complex::new(j as f64, k as f64 - 1.5));
/// let state: Vec<f64> = (0..16).map(|i| w.coordinate(i)).collect();
/// let rate = ZeitlinCoordinates(fluid.clone()).at(&AnyState::from_slice(&state));
/// let expected = CommutatorField::new(fluid).at(&w);
/// assert!((0..16).all(|i| (rate.coordinate(i) - expected.coordinate(i)).abs() < 1e-13));
/// # Ok::<(), lie_poisson_systems::SystemError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ZeitlinCoordinates(pub Zeitlin);

/// The real and the imaginary parts of a matrix, column by column.
struct Parts<T> {
    re: Vec<T>,
    im: Vec<T>,
}

impl<T: Real> Parts<T> {
    fn zeros(n: usize) -> Self {
        Self { re: vec![T::zero(); n * n], im: vec![T::zero(); n * n] }
    }

    /// Makes the entries below the diagonal those of a skew-Hermitian matrix.
    fn mirror(&mut self, n: usize) {
        for (k, j) in (0..n).flat_map(|k| (0..=k).map(move |j| (k, j))) {
            let re = if j == k { T::zero() } else { self.re[j + n * k] };
            (self.re[j + n * k], self.re[k + n * j]) = (re, -re);
            self.im[k + n * j] = self.im[j + n * k];
        }
    }

    /// Returns the matrix of coordinates.
    fn of_coordinates(n: usize, x: &[T]) -> Self {
        let mut parts = Self::zeros(n);
        for (k, j) in (0..n).flat_map(|k| (0..=k).map(move |j| (k, j))) {
            // The real part above the diagonal is the negative of that below, which is a coordinate.
            parts.re[j + n * k] = -x[k + n * j];
            parts.im[j + n * k] = x[j + n * k];
        }
        parts.mirror(n);
        parts
    }

    /// Returns the entry in row j and column k of the product with another matrix.
    fn product(&self, other: &Self, n: usize, (j, k): (usize, usize)) -> (T, T) {
        let (mut re, mut im) = (T::zero(), T::zero());
        for l in 0..n {
            let (a, b) = (
                (self.re[j + n * l], self.im[j + n * l]),
                (other.re[l + n * k], other.im[l + n * k]),
            );
            re += a.0 * b.0 - a.1 * b.1;
            im += a.0 * b.1 + a.1 * b.0;
        }
        (re, im)
    }
}

impl ZeitlinCoordinates {
    /// Returns P/ħ.
    fn generator<T: Real>(&self, w: &Parts<T>) -> Parts<T> {
        let (laplacian, scale) = (self.0.laplacian(), 1.0 / self.0.planck_constant());
        let n = laplacian.size();
        let mean_of = |im: &[T]| {
            let sum = (0..n).fold(T::zero(), |sum, j| sum + im[j + n * j]);
            sum * (1.0 / n as f64)
        };
        let mut p = Parts::zeros(n);
        laplacian.solve_upper(-scale, &w.re, T::zero(), &mut p.re);
        laplacian.solve_upper(-scale, &w.im, mean_of(&w.im), &mut p.im);
        let (mean, turning) =
            (mean_of(&p.im), scale * self.0.planck_constant() * self.0.rotation());
        for j in 0..n {
            let height = 0.5 * (n as f64 - 1.0) - j as f64;
            p.im[j + n * j] = p.im[j + n * j] - mean + T::from_f64(turning * height);
        }
        p.mirror(n);
        p
    }
}

impl<T: Real> VectorField<T> for ZeitlinCoordinates {
    type Point = AnyState<T>;

    fn at(&self, w: &AnyState<T>) -> AnyState<T> {
        let mut rate = w.zeros_like();
        self.at_into(w, &mut rate);
        rate
    }

    /// Writes the rate. It is NaN if there are not N² coordinates.
    fn at_into(&self, w: &AnyState<T>, rate: &mut AnyState<T>) {
        let n = self.0.laplacian().size();
        if [w.dimension(), rate.dimension()] != [n * n; 2] {
            return rate.set_coordinates(|_| T::from_f64(f64::NAN));
        }
        let w = Parts::of_coordinates(n, w.as_slice());
        let p = self.generator(&w);
        // [P, W] = Z − Z* with Z = PW, since both are skew-Hermitian.
        for (k, j) in (0..n).flat_map(|k| (0..=k).map(move |j| (k, j))) {
            let (above, below) = (p.product(&w, n, (j, k)), p.product(&w, n, (k, j)));
            let rate = rate.as_mut_slice();
            rate[j + n * k] = above.1 + below.1;
            if j != k {
                rate[k + n * j] = below.0 - above.0;
            }
        }
    }
}
