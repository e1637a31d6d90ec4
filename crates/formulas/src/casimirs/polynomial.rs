//! Polynomials modulo a prime: their gradients, and the formulas that they represent.

use super::monomials::Exponents;
use super::residue::Residue;
use super::surd::Surd;
use crate::names::coordinates::{Coordinates, Field};
use crate::text::printer::number;
use core::fmt::Write as _;

/// A homogeneous polynomial: monomials with their coefficients.
#[derive(Clone, Debug)]
pub(crate) struct Polynomial {
    pub(crate) terms: Vec<(Exponents, Residue)>,
}

impl Polynomial {
    /// Returns the coordinates of the gradient at a point.
    pub(crate) fn gradient(&self, point: &[Residue]) -> Vec<(usize, Residue)> {
        (0..point.len()).map(|i| (i, self.derivative(i, point))).collect()
    }

    fn derivative(&self, i: usize, point: &[Residue]) -> Residue {
        let slopes = self.terms.iter().map(|(monomial, coefficient)| {
            let factors =
                monomial.iter().zip(point).enumerate().map(|(j, (&exponent, &x))| {
                    match (j == i, u64::from(exponent)) {
                        (false, exponent) => x.power(exponent),
                        (true, 0) => Residue::ZERO,
                        (true, exponent) => Residue::new(exponent as i64) * x.power(exponent - 1),
                    }
                });
            factors.fold(*coefficient, |product, factor| product * factor)
        });
        slopes.fold(Residue::ZERO, |sum, slope| sum + slope)
    }

    /// Returns the coefficients as whole numbers times square roots, without a common divisor and with the first one
    /// positive.
    ///
    /// To this end the polynomial is multiplied by a constant. Returns `None` if no constant gives such coefficients.
    pub(crate) fn whole_coefficients(&self) -> Option<Vec<(i64, u32)>> {
        let surds: Option<Vec<Surd>> =
            self.terms.iter().map(|(_, coefficient)| Surd::of_residue(*coefficient)).collect();
        let surds = surds?;
        let multiple = surds.iter().try_fold(1_i64, |multiple, surd| {
            (multiple / common(multiple, surd.below)).checked_mul(surd.below)
        })?;
        let whole: Option<Vec<i64>> =
            surds.iter().map(|surd| surd.above.checked_mul(multiple / surd.below)).collect();
        let whole = whole?;
        let divisor = whole.iter().fold(0, |divisor, &n| common(divisor, n)).max(1);
        let sign = whole.first().map_or(1, |first| first.signum());
        let coefficients = whole.iter().zip(&surds);
        Some(coefficients.map(|(n, surd)| (sign * (n / divisor), surd.radicand)).collect())
    }

    /// Returns the polynomial as a formula, in which squares and products of vectors are written with the vectors'
    /// names.
    pub(crate) fn text(&self, coordinates: &Coordinates) -> Option<String> {
        let coefficients = self.whole_coefficients()?;
        let monomials = self.terms.iter().map(|(monomial, _)| monomial.clone());
        let mut left: Vec<_> = monomials.zip(coefficients).collect();
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
        Some(text)
    }
}

/// Returns the greatest common divisor.
fn common(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { common(b, a.wrapping_rem(b)) }
}

/// A monomial with its coefficient, a whole number times a square root.
type Term = (Exponents, (i64, u32));

/// Removes the terms of a product of two vectors, if all of them are present with the same coefficient, and returns
/// this coefficient.
fn take_product(terms: &mut Vec<Term>, first: &Field, second: &Field) -> Option<(i64, u32)> {
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
fn append(text: &mut String, (coefficient, radicand): (i64, u32), product: &str) {
    let sign = match (text.is_empty(), coefficient < 0) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    };
    text.push_str(sign);
    if coefficient.unsigned_abs() != 1 {
        text.push_str(&number(coefficient.unsigned_abs() as f64));
        text.push('*');
    }
    if radicand != 1 {
        // Writing to a text does not fail.
        let _ = write!(text, "sqrt({radicand})*");
    }
    text.push_str(product);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gradient_is_that_of_powers() {
        // 5 x²y³ − x, at (7, 2)
        let terms = vec![(vec![2, 3], Residue::new(5)), (vec![1, 0], Residue::new(-1))];
        let gradient = Polynomial { terms }.gradient(&[7, 2].map(Residue::new));
        assert_eq!(gradient, [(0, Residue::new(10 * 7 * 8 - 1)), (1, Residue::new(15 * 49 * 4))]);
    }
}
