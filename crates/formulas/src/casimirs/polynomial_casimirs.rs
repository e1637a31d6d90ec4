//! The polynomial Casimirs of an algebra: [`find_casimirs`].

use super::bracket_table::{BracketTable, generic};
use super::casimir_error::CasimirError;
use super::monomials::{count, equations, monomials};
use super::null_space::{null_space, rank};
use super::polynomial::Polynomial;
use crate::hamiltonians::formula::Formula;
use crate::names::coordinates::Coordinates;
use crate::names::parameters::Parameters;
use crate::names::vocabulary::Vocabulary;
use lie_poisson::{LieAlgebra, Momentum, Vector};

/// The largest degree of the Casimirs that are looked for.
const HIGHEST_DEGREE: u8 = 4;

/// The largest number of monomials of a degree that is searched.
const MOST_MONOMIALS: usize = 4096;

/// The relative size of the bracket of a Casimir with the coordinates that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// The Casimirs that [`find_casimirs`] found, and how many there are.
#[derive(Clone, Debug, PartialEq)]
pub struct PolynomialCasimirs {
    formulas: Vec<Formula>,
    independent: usize,
    degree: u8,
}

impl PolynomialCasimirs {
    /// Returns the Casimirs, those of low degree first. None is a function of the others.
    #[must_use]
    pub fn formulas(&self) -> &[Formula] {
        &self.formulas
    }

    /// Returns the number of independent Casimirs near a generic point: the dimension of the algebra minus that of the
    /// largest orbits.
    #[must_use]
    pub const fn independent(&self) -> usize {
        self.independent
    }

    /// Returns how many independent Casimirs were not found, because they are not polynomials or have higher degrees.
    #[must_use]
    pub const fn missing(&self) -> usize {
        self.independent.saturating_sub(self.formulas.len())
    }

    /// Returns the highest degree that was searched: 4, or less if all Casimirs were found at lower degrees, if there
    /// are more than 4096 monomials of the next degree, or if that degree takes too many operations.
    #[must_use]
    pub const fn degree(&self) -> u8 {
        self.degree
    }
}

/// Finds the polynomial Casimirs up to degree 4 of an algebra, from its brackets alone.
///
/// The number of independent Casimirs is dim 𝔤 − r, where r is the rank of the Poisson tensor Λ_ij(μ) = Σ_k c_ijk μ_k
/// at a generic point. A polynomial C is a Casimir if {μ_i, C} = 0 for every i, which is linear in its coefficients.
/// The null space is computed exactly, modulo a prime of 61 bits, for structure constants that are small fractions, or
/// small fractions times square roots of products of 2, 3, 5 and 7. For other constants, such as those in a basis with
/// rounded coordinates, some or all Casimirs may be missing. Each Casimir is checked at three points in floating point,
/// and none is listed that is a function of the others.
///
/// # Errors
/// Returns [`CasimirError`] if there are fewer or more names than dimensions, or if a structure constant is not finite.
///
/// # Example
/// The Poincaré algebra of one space dimension, with the Casimir of mass:
/// ```
/// use lie_poisson_formulas::{Coordinates, StructureEntry, find_casimirs, structure_constants};
/// // [K, H] = P and [K, P] = H
/// let poincare = structure_constants::<3>(&[
///     StructureEntry { i: 0, j: 1, k: 2, value: 1.0 },
///     StructureEntry { i: 0, j: 2, k: 1, value: 1.0 },
/// ])?;
/// let found = find_casimirs(&poincare, &Coordinates::scalars(["K", "H", "P"])?)?;
/// assert_eq!(found.formulas()[0].to_string(), "H^2 - P^2");
/// assert_eq!((found.independent(), found.missing(), found.degree()), (1, 0, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn find_casimirs<A: LieAlgebra>(
    algebra: &A,
    coordinates: &Coordinates,
) -> Result<PolynomialCasimirs, CasimirError> {
    let dimension = A::Element::<f64>::DIM;
    let names = coordinates.dimension();
    if names != dimension {
        return Err(CasimirError::WrongDimension { names, dimension });
    }
    let vocabulary = Vocabulary::new(coordinates, &Parameters::new())?;
    let table = BracketTable::new(algebra)?;
    let independent = dimension - table.generic_rank();
    let point = generic(dimension, 1);
    let (mut formulas, mut gradients, mut searched) = (Vec::new(), Vec::new(), 0);
    for degree in 1..=HIGHEST_DEGREE {
        if formulas.len() >= independent || count(dimension, degree) > MOST_MONOMIALS {
            break;
        }
        let Some(invariants) = invariants(&table, degree) else { break };
        for polynomial in invariants {
            let mut with = gradients.clone();
            with.push(polynomial.gradient(&point));
            if rank(with.clone()) < with.len() {
                continue;
            }
            let formula = polynomial
                .text(coordinates)
                .and_then(|text| Formula::new(&text, &vocabulary).ok())
                .filter(|formula| is_casimir(algebra, formula));
            if let Some(formula) = formula {
                formulas.push(formula);
                gradients = with;
            }
        }
        searched = degree;
    }
    Ok(PolynomialCasimirs { formulas, independent, degree: searched })
}

/// Returns a basis of the Casimirs of a degree, those with few terms first, or `None` if the search takes too long.
fn invariants(table: &BracketTable, degree: u8) -> Option<Vec<Polynomial>> {
    let monomials = monomials(table.dimension(), degree);
    let space = null_space(equations(table, &monomials), monomials.len())?;
    let polynomial = |vector: Vec<(usize, _)>| {
        let terms = vector.into_iter();
        let named =
            terms.filter_map(|(column, entry)| Some((monomials.get(column)?.clone(), entry)));
        Polynomial { terms: named.collect() }
    };
    let mut found: Vec<Polynomial> = space.into_iter().map(polynomial).collect();
    found.sort_by_key(|polynomial| polynomial.terms.len());
    Some(found)
}

/// Returns whether `ad∗_ξ μ` = 0 for ξ = dC(μ) at three points, up to rounding.
fn is_casimir<A: LieAlgebra>(algebra: &A, casimir: &Formula) -> bool {
    (1..4).all(|sample| {
        let coordinate = |i: usize| (1.0 + (i * i + 7 * i * sample + 3 * sample) as f64).sin();
        let mu: Momentum<A> = Vector::from_coordinates(coordinate);
        let xi = casimir.differential(&mu);
        let rate = algebra.coadjoint::<f64>(&xi, &mu);
        let terms = (0..A::Element::<f64>::DIM).map(|i| {
            let part: A::Element<f64> = A::Element::<f64>::basis(i).scaled(xi.coordinate(i));
            algebra.coadjoint::<f64>(&part, &mu).max_abs()
        });
        rate.max_abs() <= ROUNDING * terms.sum::<f64>()
    })
}

#[cfg(test)]
mod tests {
    use super::{CasimirError, is_casimir};
    use crate::{Formula, NamedAlgebra, Parameters, Vocabulary};
    use lie_poisson::Se3;

    #[test]
    fn what_is_no_casimir_is_not_listed() -> Result<(), CasimirError> {
        let se3 = Se3::default();
        let names = Vocabulary::new(&se3.coordinates()?, &Parameters::new())?;
        let casimirs = ["|Gamma|^2", "Pi·Gamma", "1e20*Pi·Gamma", "1e-20*|Gamma|^2"];
        let others = ["|Pi|^2", "1e-20*|Pi|^2", "Gamma3", "|Gamma|^2 + 1e-6*Pi1^2"];
        for (texts, expected) in [(casimirs, true), (others, false)] {
            for text in texts {
                let found = Formula::new(text, &names).map(|formula| is_casimir(&se3, &formula));
                assert_eq!(found.ok(), Some(expected), "{text}");
            }
        }
        Ok(())
    }
}
