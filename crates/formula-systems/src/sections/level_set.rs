//! The common level set of several functions, and the projection to it: [`LevelSet`].

use crate::casimirs::casimir::ScalarFunction;
use nalgebra::{DMatrix, DVector};

/// The largest number of Newton steps of a projection.
const MOST_STEPS: usize = 60;

/// The largest last step of a projection, and its largest residual, both relative. Newton's method converges
/// quadratically, and a step of this size is followed by rounding errors alone.
const CONVERGED: f64 = 1e-9;

/// The smallest singular value, relative to the largest one, of a direction in which a projection moves. Functions with
/// a smaller singular value count as dependent.
const INDEPENDENT: f64 = 1e-10;

/// A function with a value on the set.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Level<'a> {
    pub(crate) function: &'a dyn ScalarFunction,
    pub(crate) value: f64,
    /// The period by multiples of which the value may differ, if the function is an angle.
    pub(crate) period: Option<f64>,
}

impl<'a> Level<'a> {
    /// Creates the level of a function that has a value exactly.
    pub(crate) fn new(function: &'a dyn ScalarFunction, value: f64) -> Self {
        Self { function, value, period: None }
    }

    /// Returns the function at a point minus the value, or the difference of least size if there is a period.
    pub(crate) fn difference(&self, point: &[f64]) -> f64 {
        let difference = self.function.value_at(point) - self.value;
        match self.period {
            Some(period) => difference - period * (difference / period).round(),
            None => difference,
        }
    }
}

/// The set on which functions have given values.
#[derive(Clone, Debug)]
pub(crate) struct LevelSet<'a> {
    /// The functions with their values.
    pub(crate) levels: Vec<Level<'a>>,
    /// The sizes of the coordinates, by which they are compared with each other.
    pub(crate) scales: Vec<f64>,
}

impl LevelSet<'_> {
    /// Returns a point of the set near `guess`, or `None` if there is none or it cannot be found.
    ///
    /// The steps are those of Newton's method of least length, in coordinates that are divided by their sizes:
    /// x ← x − S (J S)⁺ f(x) with the pseudo-inverse of the matrix J S of differentials. Source: A. Ben-Israel, *A
    /// Newton–Raphson method for the solution of systems of equations*, J. Math. Anal. Appl. 15 (1966).
    pub(crate) fn project(&self, guess: Vec<f64>) -> Option<Vec<f64>> {
        let mut point = guess;
        for _ in 0..MOST_STEPS {
            let (step, residual) = self.step(&point)?;
            for ((x, dx), scale) in point.iter_mut().zip(&step).zip(&self.scales) {
                *x -= scale * dx;
            }
            let length = step.amax();
            if !length.is_finite() {
                return None;
            }
            if settled(length, residual) {
                // One step more, down to rounding.
                let (last, _) = self.step(&point)?;
                for ((x, dx), scale) in point.iter_mut().zip(&last).zip(&self.scales) {
                    *x -= scale * dx;
                }
                return point.iter().all(|x| x.is_finite()).then_some(point);
            }
        }
        None
    }

    /// Returns the point of the set near one that misses it by rounding errors of this relative size, if it does not miss it by more.
    pub(super) fn without_rounding(&self, near: Vec<f64>, rounding: f64) -> Option<Vec<f64>> {
        let exact = self.project(near.clone())?;
        let sized = |(x, scale): (f64, &f64)| (x / scale).abs();
        let moved = exact.iter().zip(&near).map(|(x, y)| x - y).zip(&self.scales).map(sized);
        let size = near.iter().copied().zip(&self.scales).map(sized).fold(1.0, f64::max);
        (moved.fold(0.0, f64::max) <= rounding * size).then_some(exact)
    }

    /// Returns a Newton step, in sizes of the coordinates, and the largest residual relative to the slopes.
    fn step(&self, point: &[f64]) -> Option<(DVector<f64>, f64)> {
        let constraints = self.levels.iter().map(|level| {
            let slopes = level.function.differential_at(point);
            let slopes = slopes.iter().zip(&self.scales).map(|(x, s)| x * s).collect();
            Constraint { slopes, difference: level.difference(point), value: level.value }
        });
        least_step(&constraints.collect::<Vec<_>>())
    }
}

/// A function that should have another value, with its derivatives in the directions of a step.
#[derive(Clone, Debug)]
pub(crate) struct Constraint {
    pub(crate) slopes: Vec<f64>,
    /// The function minus its value on the set.
    pub(crate) difference: f64,
    /// Its value on the set.
    pub(crate) value: f64,
}

/// Returns whether a projection has converged, by its last step and the largest residual.
pub(crate) fn settled(length: f64, residual: f64) -> bool {
    length <= CONVERGED && residual <= CONVERGED
}

/// Returns the step of least length that removes the linear part of all residuals, with the opposite sign, and the
/// largest residual relative to the slopes.
pub(crate) fn least_step(constraints: &[Constraint]) -> Option<(DVector<f64>, f64)> {
    let columns = constraints.first().map_or(0, |constraint| constraint.slopes.len());
    let mut matrix = DMatrix::zeros(constraints.len(), columns);
    let mut residual = DVector::zeros(constraints.len());
    for (row, Constraint { slopes, difference, value }) in constraints.iter().enumerate() {
        let size = slopes.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        // A function without a slope cannot be corrected.
        let unit = if size > 0.0 { size } else { value.abs().max(f64::MIN_POSITIVE) };
        slopes.iter().enumerate().for_each(|(i, x)| matrix[(row, i)] = x / unit);
        residual[row] = difference / unit;
    }
    if residual.iter().chain(matrix.iter()).any(|x: &f64| !x.is_finite()) {
        return None;
    }
    let largest = residual.amax();
    let decomposition = matrix.svd(true, true);
    let cut = INDEPENDENT * decomposition.singular_values.max();
    Some((decomposition.solve(&residual, cut).ok()?, largest))
}

#[cfg(test)]
mod tests {
    use super::{Level, LevelSet};
    use lie_poisson::So3;
    use lie_poisson_formulas::{Formula, FormulaError, NameError, Parameters, Vocabulary};

    fn formula(text: &str) -> Result<Formula, Option<FormulaError>> {
        let names: Result<_, NameError> = Vocabulary::of(&So3, &Parameters::new());
        Formula::new(text, &names.map_err(|_| None)?).map_err(Some)
    }

    /// |Π|² = 4 with a function without slope: the point exists if the function has its value, and not otherwise.
    #[test]
    fn functions_without_a_slope_hold_or_do_not() -> Result<(), Option<FormulaError>> {
        let (sphere, constant) = (formula("|Pi|^2")?, formula("0*Pi1 + 3")?);
        let project = |value: f64| {
            let levels = vec![Level::new(&sphere, 4.0), Level::new(&constant, value)];
            LevelSet { levels, scales: vec![1.0; 3] }.project(vec![1.0, 2.0, -1.0])
        };
        let point = project(3.0).unwrap_or_default();
        assert_eq!(point.len(), 3);
        assert!((point.iter().map(|x| x * x).sum::<f64>() - 4.0).abs() < 1e-14, "{point:?}");
        assert_eq!(project(2.0), None);
        let logarithm = formula("ln(Pi1)")?;
        let levels = vec![Level::new(&logarithm, 0.0)];
        let set = LevelSet { levels, scales: vec![1.0; 3] };
        assert_eq!(set.project(vec![-1.0, 2.0, -1.0]), None, "no value at the guess");
        assert!(set.project(vec![0.5, 2.0, -1.0]).is_some());
        Ok(())
    }
}
