//! Polynomials between the entries of a table: [`Interpolation`].

use core::fmt;
use core::str::FromStr;
use generic_scalars::Real;
use thiserror::Error;

/// The error returned for a name that no [`Interpolation`] has.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("unknown interpolation `{name}`; there are constant, linear, cubic")]
pub struct UnknownInterpolation {
    /// The name that was given.
    pub name: String,
}

/// The way in which an [`InputTable`](crate::InputTable) continues between its times.
///
/// # Example
/// ```
/// use lie_poisson::Interpolation;
/// assert_eq!("cubic".parse(), Ok(Interpolation::Cubic));
/// assert_eq!(
///     "quintic".parse::<Interpolation>().unwrap_err().to_string(),
///     "unknown interpolation `quintic`; there are constant, linear, cubic"
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// Each value holds from its time until the next one, where the next value begins. The last value is that of the
    /// last time alone.
    Constant,
    /// Straight lines.
    Linear,
    /// The natural cubic spline, which is twice continuously differentiable and has the second derivative 0 at both
    /// ends.
    Cubic,
}

impl Interpolation {
    /// The names of all interpolations.
    pub const NAMES: &[(&str, Self)] =
        &[("constant", Self::Constant), ("linear", Self::Linear), ("cubic", Self::Cubic)];

    /// Returns the name of the interpolation.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Linear => "linear",
            Self::Cubic => "cubic",
        }
    }

    /// Returns the pieces of the interpolation of at least two values at increasing times. The last piece of constants
    /// is a point.
    pub(crate) fn pieces(self, times: &[f64], values: &[f64]) -> Vec<Piece> {
        let curvatures = match self {
            Self::Constant | Self::Linear => vec![0.0; times.len()],
            Self::Cubic => natural_curvatures(times, values),
        };
        let pairs = times.windows(2).zip(values.windows(2)).zip(curvatures.windows(2));
        let mut pieces: Vec<_> = pairs
            .map(|((t, u), k)| {
                let (step, width) = (u[1] - u[0], relative_width(times, t));
                let [first, second] = [k[0], k[1]].map(|k| width * (width * k));
                let coefficients = match self {
                    Self::Constant => [u[0], 0.0, 0.0, 0.0],
                    Self::Linear => [u[0], step, 0.0, 0.0],
                    Self::Cubic => {
                        let slope = step - (2.0 * first + second) / 6.0;
                        [u[0], slope, first / 2.0, (second - first) / 6.0]
                    }
                };
                Piece { begin: t[0], width: t[1] - t[0], coefficients }
            })
            .collect();
        if self == Self::Constant
            && let (Some(&begin), Some(&value), Some(&last)) =
                (times.last(), values.last(), pieces.last())
        {
            pieces.push(Piece { begin, coefficients: [value, 0.0, 0.0, 0.0], ..last });
        }
        pieces
    }
}

impl FromStr for Interpolation {
    type Err = UnknownInterpolation;

    fn from_str(name: &str) -> Result<Self, UnknownInterpolation> {
        let found = Self::NAMES.iter().find(|(known, _)| *known == name);
        found.map(|(_, known)| *known).ok_or_else(|| UnknownInterpolation { name: name.to_owned() })
    }
}

impl fmt::Display for Interpolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The polynomial c₀ + c₁ s + c₂ s² + c₃ s³ of the part s = (t − begin)/width of an interval of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    begin: f64,
    width: f64,
    coefficients: [f64; 4],
}

impl Piece {
    /// Returns whether the polynomial and its derivative are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let slopes = self.coefficients.iter().skip(1).map(|c| 3.0 * c / self.width);
        self.width.is_finite() && slopes.chain(self.coefficients).all(f64::is_finite)
    }

    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn at<T: Real>(&self, t: T) -> T {
        let ([a, b, c, d], s) = (self.coefficients, (t - self.begin) / self.width);
        ((s * d + c) * s + b) * s + a
    }

    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn derivative<T: Real>(&self, t: T) -> T {
        let ([_, b, c, d], s) = (self.coefficients, (t - self.begin) / self.width);
        ((s * (3.0 * d) + 2.0 * c) * s + b) / self.width
    }
}

/// Returns the part of the whole table that an interval takes: second derivatives by it have the unit of the values, so
/// that none of them depends on the unit of time.
fn relative_width(times: &[f64], interval: &[f64]) -> f64 {
    let whole = times[times.len() - 1] - times[0];
    (interval[1] - interval[0]) / whole
}

/// Returns the second derivatives M of the natural cubic spline, by the part of the whole time:
///
/// ```text
/// w₋ M₋ + 2 (w₋ + w) M + w M₊ = 6 (Δu/w − Δu₋/w₋),    with M = 0 at both ends.
/// ```
///
/// The matrix is diagonally dominant, so that elimination without pivots is stable.
fn natural_curvatures(times: &[f64], values: &[f64]) -> Vec<f64> {
    let widths: Vec<_> = times.windows(2).map(|t| relative_width(times, t)).collect();
    let slopes: Vec<_> = values.windows(2).zip(&widths).map(|(u, w)| (u[1] - u[0]) / w).collect();
    // After elimination, M = rest − above · M₊.
    let mut rows = vec![(0.0, 0.0)];
    for (w, slope) in widths.windows(2).zip(slopes.windows(2)) {
        let (above, rest) = rows[rows.len() - 1];
        let pivot = 2.0 * (w[0] + w[1]) - w[0] * above;
        rows.push((w[1] / pivot, (6.0 * (slope[1] - slope[0]) - w[0] * rest) / pivot));
    }
    let mut curvatures = vec![0.0];
    for (above, rest) in rows.iter().skip(1).rev() {
        curvatures.push(rest - above * curvatures[curvatures.len() - 1]);
    }
    curvatures.push(0.0);
    curvatures.reverse();
    curvatures
}
