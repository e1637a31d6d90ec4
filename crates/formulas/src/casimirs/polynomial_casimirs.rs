//! The polynomial Casimirs of an algebra: [`find_casimirs`].

use super::bounds::{HIGHEST_DEGREE, most_monomials};
use super::casimir_error::CasimirError;
use super::exact::recognition::recognised;
use super::monomials::count;
use super::numeric::balance::{Scales, shifted};
use super::numeric::numeric_brackets::{NumericBrackets, NumericRank};
use super::polynomial::{Polynomial, generic_point};
use super::structure_entries::constants;
use super::summands::{Summand, summands};
use crate::hamiltonians::formula::Formula;
use crate::names::coordinates::Coordinates;
use crate::names::parameters::Parameters;
use crate::names::vocabulary::Vocabulary;
use lie_poisson::{LieAlgebra, StructureEntry, StructureTable, Vector};

/// The largest bracket of a Casimir with a coordinate, relative to its terms, that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// The smallest distance of a unit gradient from the space of the others for which a Casimir is no function of them.
const INDEPENDENT: f64 = 1e-7;

/// The Casimirs that [`find_casimirs`] found, and how many there are.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolynomialCasimirs {
    formulas: Vec<Formula>,
    degrees: Vec<u8>,
    independent: usize,
    degree: u8,
    gap: Option<[f64; 2]>,
    /// The number of polynomials that are no Casimirs of the given constants.
    refused: usize,
}

impl PolynomialCasimirs {
    /// Returns the Casimirs, in order of increasing degree. None is a function of the others. The largest coefficient of
    /// each is 1 or −1, and its first coefficient is positive.
    #[must_use]
    pub fn formulas(&self) -> &[Formula] {
        &self.formulas
    }

    /// Returns the degrees of the Casimirs, which are homogeneous polynomials.
    #[must_use]
    pub fn degrees(&self) -> &[u8] {
        &self.degrees
    }

    /// Returns the number of independent Casimirs near a generic point: the dimension of 𝔤 minus that of the largest
    /// orbits.
    #[must_use]
    pub const fn independent(&self) -> usize {
        self.independent
    }

    /// Returns how many independent Casimirs were not found: they are not polynomials, or they have higher degrees.
    #[must_use]
    pub const fn missing(&self) -> usize {
        self.independent.saturating_sub(self.formulas.len())
    }

    /// Returns the highest degree that was searched in a summand. It is 8, or less if all Casimirs were found before, if there are
    /// more than 4096 monomials of the next degree, 6435 above degree 4 (1024 if the structure constants are rounded
    /// numbers), or if the next degree needs too many operations.
    #[must_use]
    pub const fn degree(&self) -> u8 {
        self.degree
    }

    /// Returns `None` if the structure constants were recognised as exact numbers, so that the rank of the Poisson
    /// tensor is exact. Otherwise returns the two singular values of the tensor between which the rank was drawn, relative
    /// to the largest one: the largest that counts as zero (0 if none does), and the smallest that does not.
    #[must_use]
    pub const fn gap(&self) -> Option<[f64; 2]> {
        self.gap
    }
}

/// Finds the polynomial Casimirs of an algebra up to degree 4, and in few dimensions, if the
/// constants are fractions or roots, up to degree 8, from its brackets alone.
///
/// The Casimirs of a direct sum of ideals that basis vectors span are those of the ideals, which are searched one by one. The
/// number of independent Casimirs is dim 𝔤 − r, where r is the rank of the Poisson tensor Λ_ij(μ) = Σ_k c_ijk μ_k
/// at a generic point. A polynomial C is a Casimir if {μ_i, C} = 0 for every i, which is linear in its coefficients.
///
/// Structure constants are rounded numbers. If there is a Lie algebra whose constants are fractions, or fractions times
/// square roots of products of 2, 3, 5 and 7, and round to the given ones, the rank and the null space are computed
/// exactly, modulo a prime of 61 bits. Otherwise, as in a basis with rounded coordinates, they are computed with
/// tolerances: a singular value counts as zero below 10⁻¹⁰ of the largest for the rank, and below 10⁻¹¹ for the
/// coefficients, in units of the coordinates that make the constants as equal as possible. [`PolynomialCasimirs::gap`]
/// says how clear the decision was. Each Casimir is checked at three points, and a Casimir that is a function of the
/// others is not listed.
///
/// # Errors
/// Returns [`CasimirError`] if the number of names differs from the dimension, or if a structure constant is not
/// finite.
///
/// # Example
/// The Poincaré algebra of one space dimension, with the Casimir of mass, also after rounding:
/// ```
/// use lie_poisson_formulas::{Coordinates, StructureEntry, find_casimirs, structure_constants};
/// // [K, H] = P and [K, P] = H
/// let poincare = structure_constants::<3>(&[
///     StructureEntry { i: 0, j: 1, k: 2, value: 1.0 },
///     StructureEntry { i: 0, j: 2, k: 1, value: 1.0 + f64::EPSILON },
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
    search_of((A::Element::<f64>::DIM, &constants(algebra)?), coordinates)
}

/// Finds the polynomial Casimirs of an algebra whose dimension is known only when the program runs, as
/// [`find_casimirs`] does.
///
/// # Errors
/// Returns [`CasimirError`] if the number of names differs from the dimension.
///
/// # Example
/// ```
/// use lie_poisson_formulas::{Coordinates, StructureEntry, find_casimirs_of_table, table_of_entries};
/// // so(3) twice: the Casimirs of a direct sum are those of its summands.
/// let cyclic = [(0, 1, 2), (1, 2, 0), (2, 0, 1), (3, 4, 5), (4, 5, 3), (5, 3, 4)];
/// let table = table_of_entries(6, &cyclic.map(|(i, j, k)| StructureEntry { i, j, k, value: 1.0 }))?;
/// let found = find_casimirs_of_table(&table, &Coordinates::new().vector("S", 3)?.vector("T", 3)?)?;
/// let texts: Vec<String> = found.formulas().iter().map(ToString::to_string).collect();
/// assert_eq!(texts, ["|S|^2", "|T|^2"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn find_casimirs_of_table(
    table: &StructureTable,
    coordinates: &Coordinates,
) -> Result<PolynomialCasimirs, CasimirError> {
    search_of((table.dimension(), table.entries()), coordinates)
}

/// Finds the Casimirs of each summand of an algebra. The dimension is no parameter of a type, so that the search is compiled
/// once.
fn search_of(
    (dimension, constants): (usize, &[StructureEntry]),
    coordinates: &Coordinates,
) -> Result<PolynomialCasimirs, CasimirError> {
    let names = coordinates.dimension();
    if names != dimension {
        return Err(CasimirError::WrongDimension { names, dimension });
    }
    let vocabulary = Vocabulary::new(coordinates, &Parameters::new())?;
    let mut all = PolynomialCasimirs::default();
    let mut found: Vec<(u8, Formula)> = Vec::new();
    for Summand { coordinates, constants } in summands(constants, coordinates) {
        let own = search(&constants, &coordinates)?;
        all.independent += own.independent;
        all.degree = all.degree.max(own.degree);
        all.refused += own.refused;
        all.gap = match (all.gap, own.gap) {
            (Some([zero, other]), Some([own_zero, own_other])) => {
                Some([zero.max(own_zero), other.min(own_other)])
            }
            (one, other) => one.or(other),
        };
        let own = own.degrees.iter().zip(&own.formulas);
        let in_all_names =
            own.filter_map(|(degree, f)| Some((*degree, f.renamed(&vocabulary).ok()?)));
        found.extend(in_all_names);
    }
    found.sort_by_key(|(degree, _)| *degree);
    (all.degrees, all.formulas) = found.into_iter().unzip();
    Ok(all)
}

/// Finds the Casimirs of the algebra with these constants.
fn search(
    constants: &[StructureEntry],
    coordinates: &Coordinates,
) -> Result<PolynomialCasimirs, CasimirError> {
    let dimension = coordinates.dimension();
    let scales = Scales::of(dimension, constants);
    let vocabulary = Vocabulary::new(coordinates, &Parameters::new())?;
    let search = Search { constants, coordinates, vocabulary: &vocabulary, scales: &scales };
    let numeric = NumericBrackets::new(dimension, constants, &scales);
    let Some(exact) = recognised(dimension, constants, &scales) else {
        let NumericRank { rank, gap } = numeric.generic_rank();
        let found = search.run(dimension - rank, |degree| numeric.invariants(degree));
        return Ok(PolynomialCasimirs { gap: Some(gap), ..found });
    };
    let (independent, mut others) = (dimension - exact.generic_rank(), 0);
    let found = search.run(independent, |degree| {
        let (small, rest) = exact.invariants(degree)?;
        others += rest;
        Some(small)
    });
    if found.missing() == 0 || (others == 0 && found.refused == 0) {
        return Ok(found);
    }
    // Coefficients such as 299792458² are no small fractions, and a number that is small in the given units may be large
    // in others.
    let rounded = search.run(independent, |degree| numeric.invariants(degree));
    Ok(if rounded.missing() < found.missing() { rounded } else { found })
}

/// The search for the Casimirs of an algebra.
struct Search<'a> {
    constants: &'a [StructureEntry],
    coordinates: &'a Coordinates,
    vocabulary: &'a Vocabulary,
    scales: &'a Scales,
}

impl Search<'_> {
    /// Collects independent Casimirs, degree by degree, from a basis of those of each degree. `None` ends the search.
    fn run(
        &self,
        independent: usize,
        mut invariants: impl FnMut(u8) -> Option<Vec<Polynomial>>,
    ) -> PolynomialCasimirs {
        let dimension = self.coordinates.dimension();
        let point = generic_point(dimension, 0);
        let (mut formulas, mut degrees, mut searched) = (Vec::new(), Vec::new(), 0);
        let mut directions: Vec<Vec<f64>> = Vec::new();
        let mut refused = 0;
        for degree in 1..=HIGHEST_DEGREE {
            if formulas.len() >= independent || count(dimension, degree) > most_monomials(degree) {
                break;
            }
            let Some(mut found) = invariants(degree) else { break };
            found.sort_by_key(|polynomial| polynomial.terms.len());
            for polynomial in found {
                let gradient = polynomial.gradient(&point, self.scales);
                let Some(direction) = apart(gradient, &directions) else { continue };
                let Some(formula) = self.formula(polynomial) else {
                    refused += 1;
                    continue;
                };
                formulas.push(formula);
                degrees.push(degree);
                directions.push(direction);
            }
            searched = degree;
        }
        let degree = searched;
        PolynomialCasimirs { formulas, degrees, independent, degree, gap: None, refused }
    }

    /// Returns the formula of a polynomial, if it is a Casimir.
    fn formula(&self, polynomial: Polynomial) -> Option<Formula> {
        let text = polynomial.normalised().text(self.coordinates);
        let formula = Formula::new(&text, self.vocabulary).ok();
        formula.filter(|formula| is_casimir(self.constants, formula, self.scales))
    }
}

/// Returns the direction of a vector at right angles to the others, which are orthonormal, or `None` if it lies in their
/// space.
fn apart(mut vector: Vec<f64>, others: &[Vec<f64>]) -> Option<Vec<f64>> {
    // The second round removes the rounding errors of the first.
    for other in others.iter().chain(others) {
        let along: f64 = vector.iter().zip(other).map(|(x, y)| x * y).sum();
        vector.iter_mut().zip(other).for_each(|(x, y)| *x -= along * y);
    }
    let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > INDEPENDENT).then(|| vector.iter().map(|x| x / length).collect())
}

/// Returns whether `ad∗_ξ μ` = 0 for ξ = dC(μ) at three points, up to rounding, in units of the coordinates: the largest of
/// the sums Σ_ik c_ijk ξ_i μ_k against the sum over i of the largest Σ_k c_ijk ξ_i μ_k.
fn is_casimir(constants: &[StructureEntry], casimir: &Formula, scales: &Scales) -> bool {
    let dimension = casimir.dimension();
    let size = |rate: &[f64]| {
        let relative = rate.iter().enumerate().map(|(j, rate)| shifted(*rate, -scales.exponent(j)));
        relative.fold(0.0_f64, |size, x| if x.abs() <= size { size } else { x.abs() })
    };
    (1..4).all(|sample| {
        let point = generic_point(dimension, sample);
        let mu: Vec<f64> =
            point.iter().enumerate().map(|(i, x)| shifted(*x, scales.exponent(i))).collect();
        let xi = casimir.differential_at(&mu);
        let mut parts = vec![vec![0.0; dimension]; dimension];
        for &StructureEntry { i, j, k, value } in constants {
            parts[i][j] += value * xi[i] * mu[k];
        }
        let rate: Vec<f64> =
            (0..dimension).map(|j| parts.iter().map(|part| part[j]).sum()).collect();
        let terms: f64 = parts.iter().map(|part| size(part)).sum();
        size(&rate) <= ROUNDING * terms
    })
}

#[cfg(test)]
mod tests {
    use super::{CasimirError, Scales, is_casimir};
    use crate::casimirs::structure_entries::constants;
    use crate::hamiltonians::formula::Formula;
    use crate::names::named_algebra::NamedAlgebra;
    use crate::names::parameters::Parameters;
    use crate::names::vocabulary::Vocabulary;
    use lie_poisson::Se3;

    #[test]
    fn what_is_no_casimir_is_not_listed() -> Result<(), CasimirError> {
        let se3 = Se3::default();
        let names = Vocabulary::new(&se3.coordinates()?, &Parameters::new())?;
        let table = constants(&se3)?;
        let casimirs = ["|Gamma|^2", "Pi·Gamma", "1e20*Pi·Gamma", "1e-20*|Gamma|^2"];
        let others = ["|Pi|^2", "1e-20*|Pi|^2", "Gamma3", "|Gamma|^2 + 1e-6*Pi1^2"];
        for (texts, expected) in [(casimirs, true), (others, false)] {
            for text in texts {
                let found = Formula::new(text, &names)
                    .map(|formula| is_casimir(&table, &formula, &Scales::equal(6, &[])));
                assert_eq!(found.ok(), Some(expected), "{text}");
            }
        }
        Ok(())
    }
}
