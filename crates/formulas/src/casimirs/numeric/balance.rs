//! The natural sizes of coordinates and of structure constants: [`Scales`].

use lie_poisson::StructureEntry;
use nalgebra::{DMatrix, DVector};

/// The smallest constant, relative to the natural size of its place, that is not a rounding error.
const SMALLEST: f64 = 2e-13;

/// The number of improvements of the weights; the sum of absolute values changes little after this many.
const IMPROVEMENTS: usize = 30;

/// Powers of two s_i such that the constants c_ijk s_k/(s_i s_j) of the coordinates x_i/s_i are as near to a common
/// size as possible. Numbers that are only rounding errors have no influence.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scales {
    exponents: Vec<i32>,
    largest: f64,
}

/// Returns x 2ⁿ.
pub(crate) fn shifted(x: f64, n: i32) -> f64 {
    let (mut x, mut left) = (x, n);
    while left != 0 {
        let step = left.clamp(-1000, 1000);
        x *= 2.0_f64.powi(step);
        left -= step;
    }
    x
}

impl Scales {
    /// Returns the scales of an algebra in which all coordinates have one unit.
    #[cfg(test)]
    pub(crate) fn equal(dimension: usize, constants: &[StructureEntry]) -> Self {
        Self { exponents: vec![0; dimension], largest: 0.0 }.with_largest(constants)
    }

    /// Returns the scales of an algebra whose coordinates have units of their own.
    ///
    /// A small constant is a rounding error if no units make it as large as the others without making more of these small.
    /// [e₀, e₁] = e₂ + ε e₁ has such units for every ε: it is another algebra than [e₀, e₁] = e₂.
    pub(crate) fn of(dimension: usize, constants: &[StructureEntry]) -> Self {
        let mut left: Vec<StructureEntry> = constants.to_vec();
        loop {
            let scales = Self { exponents: balanced(dimension, &left), largest: 0.0 };
            let scales = scales.with_largest(&left);
            let before = left.len();
            left.retain(|constant| !scales.is_rounding(constant));
            if left.len() == before {
                return scales;
            }
        }
    }

    fn with_largest(self, constants: &[StructureEntry]) -> Self {
        let shifted = constants.iter().map(|constant| self.shifted(constant).abs());
        let largest = shifted.fold(0.0, f64::max);
        Self { largest: if largest > 0.0 { largest } else { 1.0 }, ..self }
    }

    /// Returns the exponent of 2 of the scale s_i.
    pub(crate) fn exponent(&self, i: usize) -> i32 {
        self.exponents.get(i).copied().unwrap_or(0)
    }

    /// Returns c_ijk s_k/(s_i s_j).
    fn shifted(&self, &StructureEntry { i, j, k, value }: &StructureEntry) -> f64 {
        shifted(value, self.exponent(k) - self.exponent(i) - self.exponent(j))
    }

    /// Returns a constant in units in which the largest one is ±1.
    pub(crate) fn relative(&self, constant: &StructureEntry) -> f64 {
        self.shifted(constant) / self.largest
    }

    /// Returns the size of a constant at this place that is 1 in units in which the largest one is ±1.
    pub(crate) fn natural(&self, &StructureEntry { i, j, k, .. }: &StructureEntry) -> f64 {
        shifted(self.largest, self.exponent(i) + self.exponent(j) - self.exponent(k))
    }

    /// Returns whether a constant is a rounding error of larger ones.
    pub(crate) fn is_rounding(&self, constant: &StructureEntry) -> bool {
        self.relative(constant).abs() <= SMALLEST
    }
}

/// Returns whole numbers β that minimise Σ |log₂|c_ijk| + β_k − β_i − β_j|, with their middle at 0.
///
/// The sum of absolute values, unlike that of squares, is indifferent to how far a few constants are from the others.
/// Its minimum is that of weighted squares, with weights from the last minimum. Source: E. J. Schlossmacher, *An
/// iterative technique for absolute deviations curve fitting*, J. Amer. Statist. Assoc. 68 (1973).
fn balanced(dimension: usize, constants: &[StructureEntry]) -> Vec<i32> {
    let mut exponents = DVector::zeros(dimension);
    for _ in 0..IMPROVEMENTS {
        let (mut matrix, mut right) =
            (DMatrix::identity(dimension, dimension) * 1e-9, DVector::zeros(dimension));
        for &StructureEntry { i, j, k, value } in constants {
            let mut row = DVector::<f64>::zeros(dimension);
            row[k] += 1.0;
            row[i] -= 1.0;
            row[j] -= 1.0;
            let logarithm = value.abs().log2();
            let weight = 1.0 / (logarithm + row.dot(&exponents)).abs().max(0.5);
            right.axpy(-weight * logarithm, &row, 1.0);
            // The others of the row are zeros.
            let mut places = [i, j, k];
            places.sort_unstable();
            let distinct = |n: usize| n == 0 || places[n] != places[n - 1];
            let places = (0..3).filter(|n| distinct(*n)).map(|n| places[n]);
            for (a, b) in places.clone().flat_map(|a| places.clone().map(move |b| (a, b))) {
                matrix[(a, b)] += weight * row[a] * row[b];
            }
        }
        let Some(factor) = matrix.cholesky() else { break };
        exponents = factor.solve(&right);
    }
    let (lowest, highest) = (exponents.min(), exponents.max());
    let middle = if dimension == 0 { 0.0 } else { (lowest + highest) / 2.0 };
    exponents.iter().map(|exponent| (exponent - middle).round() as i32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// so(3), whose basis vectors have units of their own.
    fn rotations(units: [f64; 3]) -> Vec<StructureEntry> {
        [(0, 1, 2), (1, 2, 0), (2, 0, 1)]
            .map(|(i, j, k)| StructureEntry { i, j, k, value: units[i] * units[j] / units[k] })
            .to_vec()
    }

    #[test]
    fn units_of_coordinates_are_found() {
        for units in [[1.0; 3], [1e9, 1.0, 1.0], [1e-30, 1e20, 3e7]] {
            let constants = rotations(units);
            let scales = Scales::of(3, &constants);
            for constant in &constants {
                // The scales are powers of two.
                let relative = scales.relative(constant);
                assert!((0.2..=1.0).contains(&relative), "{units:?} {relative}");
                assert!((scales.natural(constant) * relative / constant.value - 1.0).abs() < 1e-12);
            }
            // A rounding error at another place does not change them.
            let noise = StructureEntry { i: 0, j: 1, k: 1, value: 1e-16 * units[0] };
            let with: Vec<StructureEntry> = constants.iter().copied().chain([noise]).collect();
            let noisy = Scales::of(3, &with);
            assert!(noisy.is_rounding(&noise), "{units:?} {}", noisy.relative(&noise));
            assert!(constants.iter().all(|constant| !noisy.is_rounding(constant)));
        }
        // [e₀, e₁] = e₂ + ε e₁ is another algebra than [e₀, e₁] = e₂, in units of its own.
        let heisenberg =
            [(2, 1.0), (1, 1e-16)].map(|(k, value)| StructureEntry { i: 0, j: 1, k, value });
        assert!(!Scales::of(3, &heisenberg).is_rounding(&heisenberg[1]));
        // Control: without scales, constants of other units look like rounding errors.
        let constants = rotations([1e9, 1.0, 1.0]);
        assert!(constants.iter().any(|c| Scales::equal(3, &constants).is_rounding(c)));
    }
}
