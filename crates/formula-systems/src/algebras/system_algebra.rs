//! The Lie algebra of a system, with names for its coordinates: [`SystemAlgebra`].

use super::bracket_texts::entries;
use super::expressions::parser::parse;
use super::expressions::part::Part;
use super::family::{Family, MOST_DIMENSIONS};
use crate::casimirs::summand::Summand;
use crate::error::FormulaSystemError;
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use crate::realisations::verdict::Verdict;
use lie_poisson::{
    Inherited, SO3OnR3, SemidirectAlgebra, State, StructureError, StructureTable, Vector,
};
use lie_poisson_formulas::{
    Coordinates, EntryError, NameError, NamedAlgebra, Parameters, StructureEntry, Vocabulary,
    table_of_entries,
};
use nalgebra::DMatrix;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The dimensions that the compiler knows, in which steps take less time. A smaller algebra is completed by central coordinates,
/// which stay zero.
const WIDTHS: [usize; 2] = [3, 6];

/// The dimensions of the algebras that may have a Clebsch map.
const CLEBSCH_MAPS: core::ops::RangeInclusive<usize> = 2..=MOST_DIMENSIONS;

/// The dimensions of the algebras of matrices that are realised by their own matrices.
const OWN_MATRICES: core::ops::RangeInclusive<usize> = 4..=64;

/// A Lie algebra 𝔤 of up to 256 dimensions, with names for the coordinates of its dual.
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
    /// The structure constants c_ijk with i < j.
    entries: Vec<StructureEntry>,
    table: StructureTable,
    pub(crate) family: Family,
    /// Momenta of one's own for the collective formulation, and what they obey.
    realisation: Option<(Arc<QuadraticMomenta>, Verdict)>,
    /// The Clebsch map that is taken where there are no other momenta.
    clebsch: Option<Arc<QuadraticMomenta>>,
    /// The direct summands whose Casimirs are known without a search.
    pub(crate) summands: Vec<Summand>,
}

impl SystemAlgebra {
    /// The largest dimension of an algebra.
    pub const MOST_DIMENSIONS: usize = MOST_DIMENSIONS;

    /// Returns the algebra of an expression, such as `so(3)`, `so(3)^64` or `so(4) ⋉ (R4 + R4)`.
    ///
    /// | text | algebra | coordinates of 𝔤∗ |
    /// |---|---|---|
    /// | `so(2)`, `so(3)` | rotations | `Pi`, a number; `Pi`, a vector, whose bracket is the cross product |
    /// | `so(n)`, `so(p,q)` | rotations and Lorentz transformations, of matrices η_i E_ji − η_j E_ij | `L12`, `L13`, … |
    /// | `se(n)` | rigid motions, `so(n) ⋉ Rn` | those of so(n), `Gamma` |
    /// | `su(2)`, `su(n)` | of −(i/2) λ_a with Pauli's and Gell-Mann's matrices | `mu` |
    /// | `sl(2)` or `sl(2,R)` | of [α β; γ −α] | `alpha`, `beta`, `gamma` |
    /// | `sl(n,R)` | matrices without trace | `M12`, … of E₁₂, …; `H1`, … of E₁₁ − E₂₂, … |
    /// | `gl(n)` | all matrices | `M11`, `M12`, … |
    /// | `sp(2n,R)` | quadratic functions with their Poisson brackets | `Q11`, … of q_i q_j; `R11`, … of q_i p_j; `P11`, … of p_i p_j |
    /// | `heisenberg(n)` | [q_i, p_i] = z | `q`, `p`, `z` |
    /// | `galilei`; `bargmann` | [K_i, H] = P_i; with a mass, [K_i, P_j] = δ_ij M | `J`, `K`, `P`, `H`; `M` |
    /// | `poincare(1,n)`, n ≤ 3 | [K_i, H] = P_i, [K_i, P_j] = δ_ij H | `J`, `K`, `P`, `H` |
    /// | `R3` | abelian | `p` |
    /// | `a + b`, `a ⊕ b` | direct sum | those of both; with `_1` and `_2` if names are the same |
    /// | `a^4` | a + a + a + a | those of a with `_1` to `_4` |
    /// | `a ⋉ R3`, <code>a &#124;x R3</code> | semidirect product with the space on which a acts | those of a; `Gamma`, or `alpha` for C2 |
    /// | `a ⋉ (R3 + R3)`, `a ⋉ R3^2` | the same with several vectors | those of a; `Gamma_1`, `Gamma_2` |
    /// | `a ⋉ V` | the same with a representation of your own: [`named_with`](Self::named_with) | those of a; `V` |
    ///
    /// The text `se(3)+R3`, without spaces or with some, is the algebra se(3) ⋉ R³ of a top on a movable base, with `Pi`,
    /// `P` and `Gamma`. Spaces do not matter otherwise either.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoAlgebra`] for a name that there is not, [`FormulaSystemError::AlgebraText`] with the
    /// column from which on the text is no algebra, and [`FormulaSystemError::Dimension`] if it is too large.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::Parameters;
    /// let two_fields = SystemAlgebra::named("so(3) ⋉ (R3 + R3)")?;
    /// let names: Vec<&str> = two_fields.coordinates().groups().map(|(name, _)| name).collect();
    /// assert_eq!(names, ["Pi", "Gamma_1", "Gamma_2"]);
    /// let text = "|Pi|^2/2 + Gamma_1_1 + Gamma_2_2";
    /// let compass = FormulaSystem::new(two_fields, text, &Parameters::new())?.with_found_casimirs()?;
    /// let casimirs: Vec<String> = compass.casimirs().iter().map(ToString::to_string).collect();
    /// assert_eq!(casimirs, ["|Gamma_1|^2", "Gamma_1·Gamma_2", "|Gamma_2|^2"]);
    /// let error = SystemAlgebra::named("so(3) + ").unwrap_err().to_string();
    /// assert!(error.starts_with("algebra: `so(3) + `, column 9: an algebra, such as so(3), must stand"));
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn named(text: &str) -> Result<Self, FormulaSystemError> {
        Self::named_with(text, &BTreeMap::new())
    }

    /// Returns the algebra of an expression in which a semidirect product may be one with a representation of your own: `so(3)
    /// ⋉ V`, or `so(3) ⋉ (V^2 + W)`, where V and W are names with a matrix ρ_a for each coordinate of the algebra before, and
    /// [(ξ, v), (η, w)] = ([ξ, η], ρ(ξ)w − ρ(η)v). The coordinates are those of vectors of this name.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Representation`] for matrices that are no representation, and the errors of
    /// [`named`](Self::named).
    ///
    /// # Example
    /// The symmetric tensors of the plane, which turn by twice the angle:
    /// ```
    /// use lie_poisson_formula_systems::SystemAlgebra;
    /// use nalgebra::DMatrix;
    /// let tensors = vec![DMatrix::from_row_slice(2, 2, &[0.0, -2.0, 2.0, 0.0])];
    /// let algebra = SystemAlgebra::named_with("so(2) ⋉ Q", &[("Q".into(), tensors)].into())?;
    /// assert_eq!(algebra.coordinates().names().collect::<Vec<_>>(), ["Pi", "Q1", "Q2"]);
    /// let wrong = vec![DMatrix::identity(2, 2); 2];
    /// assert!(SystemAlgebra::named_with("so(2) ⋉ Q", &[("Q".into(), wrong)].into()).is_err());
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn named_with(
        text: &str,
        representations: &BTreeMap<String, Vec<DMatrix<f64>>>,
    ) -> Result<Self, FormulaSystemError> {
        let name: String = text.trim().into();
        if name.split_whitespace().collect::<String>() == "se(3)+R3" {
            let base = SemidirectAlgebra(Inherited { quotient: SO3OnR3, representation: SO3OnR3 });
            return of_library(name, &base);
        }
        let Part { coordinates, constants, family, acts, summands } = parse(text, representations)?;
        let table = table_of_entries(coordinates.dimension(), &constants);
        let table = table.map_err(FormulaSystemError::Structure)?;
        let algebra = Self::of_table(name, coordinates, table, family);
        let matrices = acts
            .map(|acts| acts.matrices)
            .filter(|_| family == Family::Other && OWN_MATRICES.contains(&algebra.dimension()));
        let momenta = matrices.and_then(|matrices| QuadraticMomenta::reaching(&matrices));
        let realisation = momenta.map(|(momenta, verdict)| (Arc::new(momenta), verdict));
        Ok(Self { realisation, summands, ..algebra }.with_clebsch_map())
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
    /// [`MOST_DIMENSIONS`](Self::MOST_DIMENSIONS), or if [`table_of_entries`] rejects the entries, for example
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
        let table = table_of_entries(coordinates.dimension(), &entries);
        let table = table.map_err(|error| match error {
            EntryError::Structure(StructureError::Jacobi { i, j, k, residual, allowed }) => {
                let name = |i: usize| coordinates.names().nth(i).unwrap_or_default();
                FormulaSystemError::Jacobi { names: [i, j, k].map(name), residual, allowed }
            }
            error => wrong(error),
        })?;
        let name = "this algebra".into();
        Ok(Self::of_table(name, coordinates, table, Family::Other).with_clebsch_map())
    }

    /// Returns the algebra under a name for messages.
    pub(crate) fn called(self, name: &str) -> Self {
        Self { name: name.into(), ..self }
    }

    fn of_table(
        name: String,
        coordinates: Coordinates,
        table: StructureTable,
        family: Family,
    ) -> Self {
        let entries = table.entries().iter().copied().filter(|entry| entry.i < entry.j).collect();
        let (realisation, summands, clebsch) = (None, Vec::new(), None);
        Self { name, coordinates, entries, table, family, realisation, clebsch, summands }
    }

    /// Looks for a Clebsch map, where no other realisation is known.
    fn with_clebsch_map(self) -> Self {
        let is_needed = CLEBSCH_MAPS.contains(&self.dimension())
            && self.family == Family::Other
            && self.realisation.is_none();
        let momenta = is_needed.then(|| QuadraticMomenta::clebsch(&self.table)).flatten();
        Self { clebsch: momenta.map(Arc::new), ..self }
    }

    /// Returns the algebra with other symbols for its coordinates, in the order in which their own symbols come: `S` for
    /// so(3)^64 makes the names `S_1` to `S_64`.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Symbols`] if there are not as many symbols, and [`FormulaSystemError::Coordinates`] if
    /// one cannot be a name.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::SystemAlgebra;
    /// let spins = SystemAlgebra::named("so(3)^2")?.with_symbols(&["S"])?;
    /// let names: Vec<String> = spins.coordinates().names().collect();
    /// assert_eq!(names, ["S_1_1", "S_1_2", "S_1_3", "S_2_1", "S_2_2", "S_2_3"]);
    /// assert!(spins.with_symbols(&["S", "T"]).is_err());
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn with_symbols(self, symbols: &[&str]) -> Result<Self, FormulaSystemError> {
        let mut own: Vec<&str> = Vec::new();
        for (name, _) in self.coordinates.groups() {
            let symbol = split(name).0;
            if !own.contains(&symbol) {
                own.push(symbol);
            }
        }
        if own.len() != symbols.len() {
            let own = own.iter().map(ToString::to_string).collect();
            return Err(FormulaSystemError::Symbols { found: symbols.len(), own });
        }
        let coordinates = self.coordinates.renamed(|name| {
            let (symbol, number) = split(name);
            let place = own.iter().position(|own| *own == symbol);
            let symbol = place.and_then(|place| symbols.get(place)).unwrap_or(&symbol);
            format!("{symbol}{number}")
        })?;
        Ok(Self { coordinates, ..self })
    }

    /// Returns the algebra with momenta of your own, along which its collective formulation goes.
    ///
    /// # Errors
    /// Returns the errors of [`QuadraticMomenta::verdict`].
    pub fn with_realisation(self, momenta: QuadraticMomenta) -> Result<Self, FormulaSystemError> {
        let verdict = momenta.verdict(&self.table, &self.coordinates)?;
        Ok(Self { realisation: Some((Arc::new(momenta), verdict)), ..self })
    }

    /// Returns what the momenta of your own obey, if there are such.
    #[must_use]
    pub fn verdict(&self) -> Option<Verdict> {
        self.realisation.as_ref().map(|(_, verdict)| *verdict)
    }

    /// Returns the momenta along which the collective formulation goes, and whether they are a Poisson map to the plus bracket:
    /// momenta of one's own, or those of a Clebsch map. Rotations and rigid motions by name need none.
    pub(crate) fn momenta(&self) -> Option<(Arc<QuadraticMomenta>, bool)> {
        match &self.realisation {
            Some((momenta, verdict)) => Some((Arc::clone(momenta), verdict.is_plus)),
            None => Some((Arc::clone(self.clebsch.as_ref()?), true)),
        }
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

    /// Returns the algebra as its structure constants alone, those with i > j too.
    #[must_use]
    pub const fn table(&self) -> &StructureTable {
        &self.table
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

    /// Returns the dimension to which the algebra is completed by central coordinates: the least of those that the
    /// compiler knows, or its own if it is larger.
    pub(crate) fn width(&self) -> usize {
        let fits = |width: &usize| *width >= self.dimension();
        WIDTHS.into_iter().find(fits).unwrap_or(self.dimension())
    }

    /// Returns the names for formulas on the completed space, of which the last ones stand for coordinates that stay
    /// zero.
    pub(crate) fn completed(&self, parameters: &Parameters) -> Result<Vocabulary, NameError> {
        let completed = (self.dimension()..self.width())
            .try_fold(self.coordinates.clone(), |all, i| all.scalar(&format!("zero_{i}")));
        Vocabulary::new(&completed?, parameters)
    }
}

/// Checks that there are coordinates, and not too many.
fn require_dimension(coordinates: &Coordinates) -> Result<(), FormulaSystemError> {
    let (count, most) = (coordinates.dimension(), SystemAlgebra::MOST_DIMENSIONS);
    match count {
        0 => Err(FormulaSystemError::Dimension { count, most }),
        _ if count > most => Err(FormulaSystemError::Dimension { count, most }),
        _ => Ok(()),
    }
}

/// Returns the table of an algebra of the library.
fn of_library<A: NamedAlgebra>(
    name: String,
    algebra: &A,
) -> Result<SystemAlgebra, FormulaSystemError> {
    let basis = |i| Vector::basis(i);
    let pairs = (0..A::Element::<f64>::DIM).flat_map(|j| (0..j).map(move |i| (i, j)));
    let constants = pairs.flat_map(|(i, j)| {
        let bracket = algebra.bracket::<f64>(&basis(i), &basis(j));
        (0..bracket.dimension()).map(move |k| (i, j, k, bracket.coordinate(k)))
    });
    let entries = constants.map(|(i, j, k, value)| StructureEntry { i, j, k, value });
    let coordinates = algebra.coordinates().map_err(FormulaSystemError::Coordinates)?;
    let table = table_of_entries(coordinates.dimension(), &entries.collect::<Vec<_>>());
    let table = table.map_err(FormulaSystemError::Structure)?;
    Ok(SystemAlgebra::of_table(name, coordinates, table, Family::Other).with_clebsch_map())
}

/// Returns a name without the numbers that powers and sums put behind it, and these.
fn split(name: &str) -> (&str, &str) {
    let is_number = |c: char| c == '_' || c.is_ascii_digit();
    let symbol = name.find('_').filter(|at| name[*at..].chars().all(is_number));
    name.split_at(symbol.unwrap_or(name.len()))
}
