//! The Lie algebra of a system: its brackets, the names of the coordinates, and how it is integrated.

use lie_poisson::{Inherited, SO3OnR3, Se2, Se3, SemidirectAlgebra, Sl2, So3, Su2, Vector};
use lie_poisson_formulas::{
    Coordinates, NameError, NamedAlgebra, Parameters, StructureEntry, Vocabulary,
};

/// The widths of the states of systems. A smaller algebra is completed by central coordinates, which stay zero.
pub(super) const WIDTHS: [usize; 4] = [3, 6, 10, 15];

/// The largest dimension of the algebra of a system.
pub const WIDEST: usize = 15;

/// What is known of an algebra besides its brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Family {
    /// so(3) and su(2).
    Rotations,
    /// se(3).
    Motions,
    /// Any other.
    Other,
}

/// A Lie algebra with names for the coordinates of its dual.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemAlgebra {
    /// The name in messages.
    pub name: String,
    /// The names of the coordinates.
    pub coordinates: Coordinates,
    /// The structure constants.
    pub entries: Vec<StructureEntry>,
    pub(super) family: Family,
}

impl SystemAlgebra {
    /// The names of the algebras of the library.
    pub const NAMES: [&'static str; 6] = ["so(3)", "su(2)", "sl(2)", "se(2)", "se(3)", "se(3)+R3"];

    /// Returns the algebra of the library with this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let base = SemidirectAlgebra(Inherited { quotient: SO3OnR3, representation: SO3OnR3 });
        match name {
            "so(3)" => of_library(name, &So3, Family::Rotations),
            "su(2)" => of_library(name, &Su2, Family::Rotations),
            "sl(2)" => of_library(name, &Sl2, Family::Other),
            "se(2)" => of_library(name, &Se2::default(), Family::Other),
            "se(3)" => of_library(name, &Se3::default(), Family::Motions),
            "se(3)+R3" => of_library(name, &base, Family::Other),
            _ => None,
        }
    }

    /// Creates the algebra of a table.
    #[must_use]
    pub fn of_table(coordinates: Coordinates, entries: Vec<StructureEntry>) -> Self {
        Self { name: "this algebra".into(), coordinates, entries, family: Family::Other }
    }

    /// Returns the dimension.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.coordinates.dimension()
    }

    /// Returns the width of a state: the dimension, with the central coordinates that complete it.
    pub(super) fn width(&self) -> usize {
        WIDTHS.into_iter().find(|width| *width >= self.dimension()).unwrap_or(WIDEST)
    }

    /// Returns the names for formulas at a state, of which the last ones stand for coordinates that stay zero.
    ///
    /// # Errors
    /// Returns [`NameError`] if two names are the same.
    pub fn vocabulary(&self, parameters: &Parameters) -> Result<Vocabulary, NameError> {
        let completed = (self.dimension()..self.width())
            .try_fold(self.coordinates.clone(), |all, i| all.scalar(&format!("zero_{i}")));
        Vocabulary::new(&completed?, parameters)
    }
}

/// Returns the table of an algebra of the library.
fn of_library<A: NamedAlgebra>(name: &str, algebra: &A, family: Family) -> Option<SystemAlgebra> {
    let dimension = A::Element::<f64>::DIM;
    let mut entries = Vec::new();
    for (i, j) in (0..dimension).flat_map(|i| (i + 1..dimension).map(move |j| (i, j))) {
        let bracket = algebra.bracket::<f64>(&Vector::basis(i), &Vector::basis(j));
        let constants = (0..dimension).map(|k| (k, bracket.coordinate(k)));
        let nonzero = constants.filter(|(_, value)| *value != 0.0);
        entries.extend(nonzero.map(|(k, value)| StructureEntry { i, j, k, value }));
    }
    let coordinates = algebra.coordinates().ok()?;
    Some(SystemAlgebra { name: name.into(), coordinates, entries, family })
}
