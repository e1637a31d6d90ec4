//! The Lie algebra of a system, with names for its coordinates: [`SystemAlgebra`].

use super::bracket_texts::entries;
use crate::error::FormulaSystemError;
use lie_poisson::{
    Inherited, SO3OnR3, Se2, Se3, SemidirectAlgebra, Sl2, So3, State, StructureError, Su2, Vector,
};
use lie_poisson_formulas::{
    Coordinates, DimensionTask, EntryError, NameError, NamedAlgebra, Parameters, StructureEntry,
    Vocabulary, for_dimension, structure_constants,
};

/// The widths of the states of systems. A smaller algebra is completed by central coordinates, which stay zero.
const WIDTHS: [usize; 4] = [3, 6, 10, 15];

/// The kind of an algebra. It decides which methods, besides the direct ones, integrate its systems.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    /// The algebras of rotations, so(3) and su(2).
    Rotations,
    /// The algebra of rigid motions, se(3).
    Motions,
    /// Any other Lie algebra.
    Other,
}

/// A Lie algebra 𝔤 of up to 15 dimensions, with names for the coordinates of its dual.
///
/// # Example
/// The Poincaré algebra of one space dimension, [K, H] = P and [K, P] = H, and so(3) by its name:
/// ```
/// use lie_poisson_formula_systems::SystemAlgebra;
/// use lie_poisson_formulas::{Coordinates, Parameters};
/// let names = Coordinates::scalars(["K", "H", "P"])?;
/// let brackets = [("K, H", "P"), ("K, P", "H")];
/// let poincare = SystemAlgebra::of_brackets(names.clone(), brackets, &Parameters::new())?;
/// assert_eq!((poincare.dimension(), poincare.entries().len()), (3, 2));
///
/// let so3 = SystemAlgebra::named("so(3)")?;
/// assert_eq!(so3.coordinates().names().collect::<Vec<_>>(), ["Pi1", "Pi2", "Pi3"]);
///
/// let brackets = [("K, H", "P"), ("K, P", "H"), ("H, P", "H")];
/// let error = SystemAlgebra::of_brackets(names, brackets, &Parameters::new()).unwrap_err();
/// assert!(error.to_string().starts_with("the Jacobi identity fails for K, H, P by "));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SystemAlgebra {
    name: String,
    coordinates: Coordinates,
    entries: Vec<StructureEntry>,
    pub(crate) family: Family,
}

impl SystemAlgebra {
    /// The names of the algebras of the library: so(3), su(2), sl(2), se(2), se(3) and se(3) ⋉ R³.
    pub const NAMES: [&'static str; 6] = ["so(3)", "su(2)", "sl(2)", "se(2)", "se(3)", "se(3)+R3"];

    /// The largest dimension of an algebra.
    pub const MOST_DIMENSIONS: usize = 15;

    /// Returns the algebra of the library with this name; [`NamedAlgebra`] lists the names of its coordinates.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoAlgebra`] for a name that is not one of [`NAMES`](Self::NAMES).
    pub fn named(name: &str) -> Result<Self, FormulaSystemError> {
        let base = SemidirectAlgebra(Inherited { quotient: SO3OnR3, representation: SO3OnR3 });
        match name {
            "so(3)" => of_library(name, &So3, Family::Rotations),
            "su(2)" => of_library(name, &Su2, Family::Rotations),
            "sl(2)" => of_library(name, &Sl2, Family::Other),
            "se(2)" => of_library(name, &Se2::default(), Family::Other),
            "se(3)" => of_library(name, &Se3::default(), Family::Motions),
            "se(3)+R3" => of_library(name, &base, Family::Other),
            _ => {
                let names = Self::NAMES.to_vec();
                Err(FormulaSystemError::NoAlgebra { name: name.into(), names })
            }
        }
    }

    /// Creates the algebra from brackets [x, y] = Σ c z, which are written with the names of coordinates, such as
    /// `("K, H", "P")`. The coefficients may contain parameters. All other brackets are zero, except that [y, x] = −[x,
    /// y].
    ///
    /// # Errors
    /// Returns [`FormulaSystemError`] if there are no coordinates or more than
    /// [`MOST_DIMENSIONS`](Self::MOST_DIMENSIONS), if a key is not a pair of coordinates, if a bracket is not linear,
    /// or if the Jacobi identity fails.
    pub fn of_brackets<'a>(
        coordinates: Coordinates,
        brackets: impl IntoIterator<Item = (&'a str, &'a str)>,
        parameters: &Parameters,
    ) -> Result<Self, FormulaSystemError> {
        require_dimension(&coordinates)?;
        let entries = entries(&coordinates, parameters, brackets)?;
        Self::checked(coordinates, entries, FormulaSystemError::Brackets)
    }

    /// Creates the algebra from structure constants: the coordinates of [e_i, e_j] at e_k that are not zero.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError`] if there are no coordinates or more than
    /// [`MOST_DIMENSIONS`](Self::MOST_DIMENSIONS), or if [`structure_constants`] rejects the entries, for example
    /// because the Jacobi identity fails.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::SystemAlgebra;
    /// use lie_poisson_formulas::{Coordinates, StructureEntry};
    /// let constants = vec![StructureEntry { i: 0, j: 1, k: 2, value: 1.0 }];
    /// assert_eq!(SystemAlgebra::of_entries(Coordinates::scalars(["p", "q", "z"])?, constants)?.dimension(), 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_entries(
        coordinates: Coordinates,
        entries: Vec<StructureEntry>,
    ) -> Result<Self, FormulaSystemError> {
        require_dimension(&coordinates)?;
        Self::checked(coordinates, entries, FormulaSystemError::Structure)
    }

    /// Creates the algebra if the Jacobi identity holds; `wrong` makes the error for entries with another fault.
    fn checked(
        coordinates: Coordinates,
        entries: Vec<StructureEntry>,
        wrong: impl Fn(EntryError) -> FormulaSystemError,
    ) -> Result<Self, FormulaSystemError> {
        let check = for_dimension(coordinates.dimension(), Check { entries: &entries });
        check.transpose().map_err(|error| match error {
            EntryError::Structure(StructureError::Jacobi { i, j, k, residual, allowed }) => {
                let name = |i: usize| coordinates.names().nth(i).unwrap_or_default();
                FormulaSystemError::Jacobi { names: [i, j, k].map(name), residual, allowed }
            }
            error => wrong(error),
        })?;
        let entries = ordered(entries);
        Ok(Self { name: "this algebra".into(), coordinates, entries, family: Family::Other })
    }

    /// Returns the name in messages: that of [`named`](Self::named), or "this algebra".
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the names of the coordinates.
    #[must_use]
    pub const fn coordinates(&self) -> &Coordinates {
        &self.coordinates
    }

    /// Returns the structure constants c_ijk with i < j that are not zero, in the order of their indices.
    #[must_use]
    pub fn entries(&self) -> &[StructureEntry] {
        &self.entries
    }

    /// Returns the dimension of the algebra.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.coordinates.dimension()
    }

    /// Returns the names of coordinates and parameters for formulas on 𝔤∗.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Parameters`] if a parameter has the name of a coordinate.
    pub fn vocabulary(&self, parameters: &Parameters) -> Result<Vocabulary, FormulaSystemError> {
        Vocabulary::new(&self.coordinates, parameters).map_err(FormulaSystemError::Parameters)
    }

    /// Returns the width of the states of direct integrators: the dimension, plus the number of central coordinates
    /// that complete it.
    pub(crate) fn width(&self) -> usize {
        let fits = |width: &usize| *width >= self.dimension();
        WIDTHS.into_iter().find(fits).unwrap_or(Self::MOST_DIMENSIONS)
    }

    /// Returns the names for formulas on the completed space, of which the last ones stand for coordinates that stay
    /// zero.
    pub(crate) fn completed(&self, parameters: &Parameters) -> Result<Vocabulary, NameError> {
        let completed = (self.dimension()..self.width())
            .try_fold(self.coordinates.clone(), |all, i| all.scalar(&format!("zero_{i}")));
        Vocabulary::new(&completed?, parameters)
    }
}

/// Checks that there are 1 to 15 coordinates.
fn require_dimension(coordinates: &Coordinates) -> Result<(), FormulaSystemError> {
    let (count, most) = (coordinates.dimension(), SystemAlgebra::MOST_DIMENSIONS);
    match count {
        0 => Err(FormulaSystemError::Dimension { count, most }),
        _ if count > most => Err(FormulaSystemError::Dimension { count, most }),
        _ => Ok(()),
    }
}

/// Returns the entries that are not zero, each once, with i < j.
fn ordered(entries: Vec<StructureEntry>) -> Vec<StructureEntry> {
    let nonzero = entries.into_iter().filter(|entry| entry.value != 0.0);
    let mut ordered: Vec<StructureEntry> = nonzero
        .map(|StructureEntry { i, j, k, value }| match i < j {
            true => StructureEntry { i, j, k, value },
            false => StructureEntry { i: j, j: i, k, value: -value },
        })
        .collect();
    ordered.sort_by_key(|entry| (entry.i, entry.j, entry.k));
    ordered.dedup();
    ordered
}

/// The check that entries are the structure constants of a Lie algebra.
struct Check<'a> {
    entries: &'a [StructureEntry],
}

impl DimensionTask for Check<'_> {
    type Output = Result<(), EntryError>;

    fn run<const N: usize>(self) -> Self::Output {
        structure_constants::<N>(self.entries).map(|_| ())
    }
}

/// Returns the table of an algebra of the library.
fn of_library<A: NamedAlgebra>(
    name: &str,
    algebra: &A,
    family: Family,
) -> Result<SystemAlgebra, FormulaSystemError> {
    let dimension = A::Element::<f64>::DIM;
    let mut entries = Vec::new();
    for (i, j) in (0..dimension).flat_map(|i| (i + 1..dimension).map(move |j| (i, j))) {
        let bracket = algebra.bracket::<f64>(&Vector::basis(i), &Vector::basis(j));
        let constants = (0..dimension).map(|k| (k, bracket.coordinate(k)));
        let nonzero = constants.filter(|(_, value)| *value != 0.0);
        entries.extend(nonzero.map(|(k, value)| StructureEntry { i, j, k, value }));
    }
    let coordinates = algebra.coordinates().map_err(FormulaSystemError::Coordinates)?;
    Ok(SystemAlgebra { name: name.into(), coordinates, entries, family })
}
