//! Polynomials: their gradients, and the formulas that they represent.

use super::monomials::Exponents;
use super::numeric::balance::{Scales, shifted};
use super::surd::{Surd, rounding};
use crate::names::coordinates::{Coordinates, Field};
use crate::text::printer::number;
use core::fmt::Write as _;

/// The error of a coefficient that counts as rounding, relative to the largest coefficient.
const ROUNDING: f64 = 1e-12;

/// A homogeneous polynomial: monomials with their coefficients.
#[derive(Clone, Debug)]
pub(crate) struct Polynomial {
    pub(crate) terms: Vec<(Exponents, f64)>,
}

/// Returns a point whose coordinates, between 1 and 2 in size, behave like random ones and are the same in every run. Each
/// sample is another one.
///
/// The numbers x ↦ 1 − 2x² obey no linear recurrence, by which the coordinates of matrices would make matrices of small rank,
/// as sines of i² do: 22 is nearly 7π.
///
/// Source: S. M. Ulam & J. von Neumann, *On combination of stochastic and deterministic processes*, Bull. Amer. Math. Soc. 53
/// (1947).
///
/// # Example
/// ```
/// use lie_poisson_formulas::generic_point;
/// let point = generic_point(100, 0);
/// assert!(point.iter().all(|x| (1.0..=2.0).contains(&x.abs())) && point != generic_point(100, 1));
/// ```
#[must_use]
pub fn generic_point(dimension: usize, sample: usize) -> Vec<f64> {
    let all = core::iter::successors(Some(0.3_f64), |x| Some(1.0 - 2.0 * x * x));
    let own = all.skip(sample.saturating_mul(dimension)).take(dimension);
    own.map(|x| x + 1.0_f64.copysign(x)).collect()
}

impl Polynomial {
    /// Returns the direction of the gradient at a point, in the coordinates x_i/s_i with the scales s: a unit vector.
    pub(crate) fn gradient(&self, point: &[f64], scales: &Scales) -> Vec<f64> {
        let exponent = |monomial: &[u8]| -> i32 {
            monomial.iter().enumerate().map(|(i, &e)| i32::from(e) * scales.exponent(i)).sum()
        };
        let most = self.terms.iter().map(|(monomial, _)| exponent(monomial)).max().unwrap_or(0);
        let terms = self.terms.iter().map(|(monomial, coefficient)| {
            (monomial, shifted(*coefficient, exponent(monomial) - most))
        });
        let mut gradient = vec![0.0; point.len()];
        for (monomial, coefficient) in terms {
            for (i, entry) in gradient.iter_mut().enumerate() {
                *entry += coefficient * derivative(monomial, i, point);
            }
        }
        let largest = gradient.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        if largest > 0.0 {
            gradient.iter_mut().for_each(|x| *x /= largest);
            let length = gradient.iter().map(|x| x * x).sum::<f64>().sqrt();
            gradient.iter_mut().for_each(|x| *x /= length);
        }
        gradient
    }

    /// Returns the polynomial times the constant that makes its largest coefficient 1 and its first one positive.
    ///
    /// The values of a Casimir then change continuously with the structure constants, and can be compared.
    pub(crate) fn normalised(mut self) -> Self {
        let largest = self.terms.iter().fold(0.0_f64, |size, (_, a)| size.max(a.abs()));
        let sign = self.terms.first().map_or(1.0, |(_, first)| first.signum());
        if largest > 0.0 {
            self.terms.iter_mut().for_each(|(_, coefficient)| *coefficient /= sign * largest);
        }
        self
    }

    /// Returns the polynomial as a formula, in which squares and products of vectors are written with the vectors'
    /// names, and coefficients as fractions times square roots if they are such numbers.
    pub(crate) fn text(&self, coordinates: &Coordinates) -> String {
        let terms = self.terms.iter();
        let mut left: Vec<Term> =
            terms.map(|(monomial, a)| (monomial.clone(), Coefficient::new(*a))).collect();
        let mut text = String::new();
        let fields = coordinates.fields();
        for (n, first) in fields.iter().enumerate() {
            for second in fields.iter().skip(n) {
                if let Some(coefficient) = take_product(&mut left, first, second) {
                    let product = if first == second {
                        format!("|{}|^2", first.name)
                    } else {
                        format!("{}·{}", first.name, second.name)
                    };
                    append(&mut text, coefficient, &product);
                }
            }
        }
        let names: Vec<String> = coordinates.names().collect();
        for (monomial, coefficient) in left {
            let factors = names.iter().zip(&monomial).filter(|(_, exponent)| **exponent > 0);
            let factors: Vec<_> = factors
                .map(|(name, &exponent)| match exponent {
                    1 => name.clone(),
                    _ => format!("{name}^{exponent}"),
                })
                .collect();
            append(&mut text, coefficient, &factors.join("*"));
        }
        text
    }
}

/// Returns the partial derivative of a monomial.
fn derivative(monomial: &[u8], i: usize, point: &[f64]) -> f64 {
    let factors = monomial.iter().zip(point).enumerate().map(|(j, (&exponent, &x))| {
        match (j == i, i32::from(exponent)) {
            (false, exponent) => x.powi(exponent),
            (true, 0) => 0.0,
            (true, exponent) => f64::from(exponent) * x.powi(exponent - 1),
        }
    });
    factors.product()
}

/// Returns the number with the fewest digits that differs from the given one by rounding.
fn shortest(value: f64) -> f64 {
    let decimal = |digits: usize| format!("{value:.digits$e}").parse::<f64>().ok();
    let mut decimals = (0..17).filter_map(decimal);
    decimals.find(|decimal| (decimal - value).abs() <= rounding(value)).unwrap_or(value)
}

/// A coefficient, of size 1 at most.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Coefficient {
    Surd(Surd),
    Decimal(f64),
}

impl Coefficient {
    fn new(value: f64) -> Self {
        // A small coefficient may have fewer roundings than the largest.
        let surd = Surd::recognise(value, rounding(value));
        let surd = surd.or_else(|| Surd::recognise(value, ROUNDING));
        let surd = surd.filter(|surd| surd.above != 0);
        surd.map_or_else(|| Self::Decimal(shortest(value)), Self::Surd)
    }

    fn is_negative(self) -> bool {
        match self {
            Self::Surd(surd) => surd.above < 0,
            Self::Decimal(value) => value < 0.0,
        }
    }
}

/// A monomial with its coefficient.
type Term = (Exponents, Coefficient);

/// Removes the terms of a product of two vectors, if all of them are present with the same coefficient, and returns
/// this coefficient.
fn take_product(terms: &mut Vec<Term>, first: &Field, second: &Field) -> Option<Coefficient> {
    let dimension = first.dimension.filter(|_| first.dimension == second.dimension)?;
    let is_part = |monomial: &Exponents, i: usize| {
        let at = |place: usize| monomial.get(place).copied().unwrap_or(0);
        let (a, b) = (first.start + i, second.start + i);
        let expected = if a == b { 2 } else { 1 };
        monomial.iter().sum::<u8>() == 2 && at(a) == expected && at(b) == expected
    };
    let parts: Option<Vec<usize>> = (0..dimension)
        .map(|i| terms.iter().position(|(monomial, _)| is_part(monomial, i)))
        .collect();
    let parts = parts?;
    let coefficient = terms.get(*parts.first()?)?.1;
    if parts.iter().any(|&part| terms.get(part).is_none_or(|term| term.1 != coefficient)) {
        return None;
    }
    let mut place = 0;
    terms.retain(|_| {
        place += 1;
        !parts.contains(&(place - 1))
    });
    Some(coefficient)
}

/// Appends a term with its sign.
fn append(text: &mut String, coefficient: Coefficient, product: &str) {
    let sign = match (text.is_empty(), coefficient.is_negative()) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    };
    // Writing to a text does not fail.
    let _ = match coefficient {
        Coefficient::Decimal(value) => write!(text, "{sign}{}*{product}", number(value.abs())),
        Coefficient::Surd(Surd { above, below, radicand }) => {
            let above = match above.unsigned_abs() {
                1 => String::new(),
                above => format!("{above}*"),
            };
            let root = if radicand == 1 { String::new() } else { format!("sqrt({radicand})*") };
            let below = if below == 1 { String::new() } else { format!("/{below}") };
            write!(text, "{sign}{above}{root}{product}{below}")
        }
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    /// Square matrices of the coordinates are far from singular; that of sines of i² with 11 rows is not.
    #[test]
    fn matrices_of_generic_coordinates_have_full_rank() {
        let condition = |of: &dyn Fn(usize) -> Vec<f64>, n: usize| {
            let values = DMatrix::from_vec(n, n, of(n * n)).singular_values();
            values.min() / values.max()
        };
        for sample in 0..4 {
            let generic = |count| generic_point(count, sample);
            assert!((2..17).all(|n| condition(&generic, n) > 1e-4), "{sample}");
        }
        let sines = |count: usize| (1..=count).map(|i| ((i * i) as f64).sin()).collect();
        assert!(condition(&sines, 11) < 1e-4);
    }

    #[test]
    fn the_gradient_is_that_of_powers() {
        // 5 x²y³ − x, at (7, 2)
        let terms = vec![(vec![2, 3], 5.0), (vec![1, 0], -1.0)];
        let scales = Scales::equal(2, &[]);
        let gradient = Polynomial { terms }.gradient(&[7.0, 2.0], &scales);
        let expected = [10.0 * 7.0 * 8.0 - 1.0, 15.0 * 49.0 * 4.0];
        assert!((gradient[0] * expected[1] / (gradient[1] * expected[0]) - 1.0).abs() < 1e-14);
        assert!((gradient[0].hypot(gradient[1]) - 1.0).abs() < 1e-15);
    }

    /// The largest coefficient is 1, the first one positive, and fractions are written as such.
    #[test]
    fn coefficients_are_fractions_or_decimals() -> Result<(), crate::NameError> {
        let names = Coordinates::scalars(["x", "y"])?;
        for (coefficients, expected) in [
            ([12.0, 3.0], "x + y/4"),
            ([-1.0, 3.0], "x/3 - y"),
            ([2.0, 3.0_f64.sqrt()], "x + sqrt(3)*y/2"),
            ([1.0 / 3.0 - 1e-14, -1.0], "x/3 - y"),
            ([1.0, 0.123_456_789_123], "x + 0.123456789123*y"),
            ([1.0, 1e-13], "x + 1e-13*y"),
            ([1.0, 1.234_567_891e-13], "x + 1.234567891e-13*y"),
        ] {
            let [a, b] = coefficients;
            let polynomial = Polynomial { terms: vec![(vec![1, 0], a), (vec![0, 1], b)] };
            assert_eq!(polynomial.normalised().text(&names), expected);
        }
        Ok(())
    }
}
