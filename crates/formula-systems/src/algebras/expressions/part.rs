//! A Lie algebra with names, of which expressions are made: [`Part`].

use super::given_representation::require_representation;
use crate::algebras::family::Family;
use crate::casimirs::summand::Summand;
use crate::error::FormulaSystemError;
use lie_poisson_formulas::{Coordinates, StructureEntry};
use nalgebra::DMatrix;

/// A Lie algebra with names for the coordinates of its dual, and the representation by which it acts on vectors.
#[derive(Clone)]
pub(in crate::algebras) struct Part {
    pub(in crate::algebras) coordinates: Coordinates,
    /// The structure constants, of each pair of basis vectors once.
    pub(in crate::algebras) constants: Vec<StructureEntry>,
    /// The representation that a semidirect product with Rⁿ or Cⁿ takes.
    pub(in crate::algebras) acts: Option<Representation>,
    pub(in crate::algebras) family: Family,
    /// The direct summands whose Casimirs are known.
    pub(in crate::algebras) summands: Vec<Summand>,
}

/// Real matrices, one for each basis vector, on Rⁿ or on Cⁿ as R²ⁿ.
#[derive(Clone)]
pub(in crate::algebras) struct Representation {
    pub(in crate::algebras) matrices: Vec<DMatrix<f64>>,
    pub(super) space: Space,
}

/// A space of vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Space {
    /// Rⁿ
    Real(usize),
    /// Cⁿ, with the coordinates Re v₁, Im v₁, Re v₂, …
    Complex(usize),
}

impl Space {
    /// Returns the dimension over the reals.
    pub(super) fn dimension(self) -> usize {
        match self {
            Self::Real(n) => n,
            Self::Complex(n) => 2 * n,
        }
    }

    /// Returns the text that names the space.
    pub(super) fn name(self) -> String {
        match self {
            Self::Real(n) => format!("R{n}"),
            Self::Complex(n) => format!("C{n}"),
        }
    }

    /// Returns the name of the vectors of its dual.
    fn symbol(self) -> &'static str {
        match self {
            Self::Real(_) => "Gamma",
            Self::Complex(_) => "alpha",
        }
    }
}

impl Part {
    /// Returns the direct sum with another algebra.
    pub(super) fn plus(self, other: &Self) -> Result<Self, FormulaSystemError> {
        let first = self.coordinates.dimension();
        let coordinates = self.coordinates.then(&other.coordinates)?;
        let constants = self.constants.iter().copied().chain(moved(&other.constants, first));
        let family = self.family.with(other.family);
        let others = other.summands.iter().map(|summand| summand.after(first));
        let summands = self.summands.iter().cloned().chain(others).collect();
        Ok(Self { coordinates, constants: constants.collect(), acts: None, family, summands })
    }

    /// Returns the direct sum of so many copies.
    pub(super) fn power(self, count: usize) -> Result<Self, FormulaSystemError> {
        if count == 1 {
            return Ok(self);
        }
        let dimension = self.coordinates.dimension();
        let coordinates = self.coordinates.repeated(count)?;
        let copies = (0..count).flat_map(|copy| moved(&self.constants, copy * dimension));
        let family = self.family.with(self.family);
        let firsts = (0..count).map(|copy| copy * dimension);
        let summands =
            firsts.flat_map(|first| self.summands.iter().map(move |summand| summand.after(first)));
        let summands = summands.collect();
        Ok(Self { constants: copies.collect(), coordinates, acts: None, family, summands })
    }

    /// Returns the semidirect product with `copies` of the space on which the algebra acts, or `None` if it acts on none.
    ///
    /// Its bracket is [(ξ, v), (η, w)] = ([ξ, η], ξw − ηv). Translations act trivially on further vectors.
    pub(super) fn acting(self, copies: usize) -> Option<Result<Self, FormulaSystemError>> {
        let Representation { matrices, space } = self.acts.clone()?;
        let n = space.dimension();
        let none = vec![DMatrix::zeros(n, n); copies * n];
        let acts = Representation { matrices: [&matrices[..], &none].concat(), space };
        let made = self.with_vectors(&matrices, space.symbol(), copies);
        Some(made.map(|part| Self { acts: Some(acts), ..part }))
    }

    /// Returns the semidirect product with so many copies of the vectors of each representation that is given by its matrices.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Representation`] if the matrices are none of the algebra.
    pub(super) fn acting_by(
        self,
        given: &[(&str, &[DMatrix<f64>], usize)],
    ) -> Result<Self, FormulaSystemError> {
        let mut part = self.clone();
        for (name, matrices, copies) in given {
            require_representation(name, matrices, (&self.coordinates, &self.constants))?;
            part = part.with_vectors(matrices, name, *copies)?;
        }
        Ok(part)
    }

    /// Returns the semidirect product with so many copies of a space on which the first basis vectors act by these matrices,
    /// and the others trivially.
    fn with_vectors(
        self,
        matrices: &[DMatrix<f64>],
        symbol: &str,
        copies: usize,
    ) -> Result<Self, FormulaSystemError> {
        let (first, n) = (self.coordinates.dimension(), matrices.first().map_or(0, DMatrix::nrows));
        let mut constants = self.constants.clone();
        for (copy, (i, matrix)) in
            (0..copies).flat_map(|copy| matrices.iter().enumerate().map(move |of| (copy, of)))
        {
            let start = first + copy * n;
            let entries = (0..n).flat_map(|j| (0..n).map(move |k| (j, k, matrix[(k, j)])));
            constants.extend(
                entries.filter(|(_, _, value)| *value != 0.0).map(|(j, k, value)| StructureEntry {
                    i,
                    j: start + j,
                    k: start + k,
                    value,
                }),
            );
        }
        let vectors = Coordinates::new().vector(symbol, n);
        let vectors =
            vectors.and_then(|one| if copies == 1 { Ok(one) } else { one.repeated(copies) });
        let coordinates = vectors.and_then(|vectors| self.coordinates.then(&vectors));
        let coordinates = coordinates.map_err(FormulaSystemError::Coordinates)?;
        let summands = match &self.summands[..] {
            [summand] if copies == 1 => summand.with_vector(matrices).into_iter().collect(),
            _ => Vec::new(),
        };
        let family = Family::Other;
        Ok(Self { coordinates, constants, acts: None, family, summands })
    }
}

/// Returns structure constants of basis vectors that come after `first` others.
fn moved(constants: &[StructureEntry], first: usize) -> impl Iterator<Item = StructureEntry> + '_ {
    constants.iter().map(move |entry| StructureEntry {
        i: entry.i + first,
        j: entry.j + first,
        k: entry.k + first,
        value: entry.value,
    })
}
