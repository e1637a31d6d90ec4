//! Structure constants from a text, one per line: [`structure_table`].

use crate::algebras::system_algebra::SystemAlgebra;
use lie_poisson::StructureError;
use lie_poisson_formulas::{EntryError, StructureEntry, shown, table_of_entries};
use thiserror::Error;

/// The reason why a text is not a table of structure constants, with the number of the line. Lines count from 1.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StructureTableError {
    /// A line has fewer or more than four fields.
    #[error("line {line} has {count} fields; it needs four: i, j, k, value")]
    Fields {
        /// The number of the line.
        line: usize,
        /// The number of fields.
        count: usize,
    },
    /// An index is not a whole number from 1 to the largest index.
    #[error("line {line}: the index `{}` is not a whole number from 1 to {most}", shown(text))]
    Index {
        /// The number of the line.
        line: usize,
        /// The text of the field with the index.
        text: String,
        /// The largest index of any algebra.
        most: usize,
    },
    /// A value is not a finite number.
    #[error("line {line}: the value `{}` is not a finite number", shown(text))]
    Value {
        /// The number of the line.
        line: usize,
        /// The text of the field with the value.
        text: String,
    },
    /// The bracket of a basis vector with itself is not zero.
    #[error("line {line} says that [e{index}, e{index}] is not zero")]
    WithItself {
        /// The number of the line.
        line: usize,
        /// The index of the basis vector, from 1.
        index: usize,
    },
    /// Two lines contradict each other.
    #[error("line {line} contradicts line {earlier}, which has the same bracket up to its sign")]
    Contradiction {
        /// The number of the line.
        line: usize,
        /// The number of the earlier line.
        earlier: usize,
    },
    /// The Jacobi identity fails: the cyclic sum of [e_i, [e_j, e_k]] is not zero.
    #[error(
        "the Jacobi identity fails for e{}, e{}, e{} by {residual:e} of the size of its terms (allowed {allowed:e})",
        indices[0], indices[1], indices[2]
    )]
    Jacobi {
        /// The indices of the three basis vectors, from 1.
        indices: [usize; 3],
        /// The largest coordinate of the sum, relative to the size of its terms.
        residual: f64,
        /// The relative rounding error that is allowed.
        allowed: f64,
    },
    /// The table has another fault.
    #[error(transparent)]
    Entries(EntryError),
}

/// Reads structure constants from a text: on each line the indices i, j, k and the value c of the coordinate of
/// [e_i, e_j] at e_k, separated by commas. Indices count from 1, in the order of the coordinates.
///
/// Constants that are not listed are zero, except that c_jik = −c_ijk. Empty lines are skipped, and so are comments
/// that begin with `#`, and a first line `i, j, k, value`. A byte order mark before the text, quotation marks around
/// fields, and indices such as `2.0` are read as spreadsheets write them.
///
/// # Errors
/// Returns [`StructureTableError`] with the number of the line: if a line does not have four fields, if an index is not
/// a whole number from 1 to [`MOST_DIMENSIONS`](crate::SystemAlgebra::MOST_DIMENSIONS), if a value is not finite, if
/// some [e_i, e_i] is not zero, or if two lines contradict each other. If the Jacobi identity fails, the error names
/// the triple of basis vectors.
///
/// # Example
/// ```
/// use lie_poisson_formula_systems::{SystemAlgebra, structure_table};
/// use lie_poisson_formulas::Coordinates;
/// let entries = structure_table("# so(3)\n1, 2, 3, 1\n2, 3, 1, 1\n3, 1, 2, 1\n")?;
/// let so3 = SystemAlgebra::of_entries(Coordinates::new().vector("L", 3)?, entries)?;
/// assert_eq!(so3.dimension(), 3);
/// let of_spreadsheet = "\u{feff}\"i\",\"j\",\"k\",\"value\"\r\n1.0,2.0,3.0,1\r\n1,3,2,-1\r\n2,3,1,1\r\n";
/// assert_eq!(structure_table(of_spreadsheet)?, so3.entries());
/// let error = structure_table("1, 2, 3, 1\n0, 3, 1, 1").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: the index `0` is not a whole number from 1 to 256");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn structure_table(text: &str) -> Result<Vec<StructureEntry>, StructureTableError> {
    let (mut numbers, mut entries) = (Vec::new(), Vec::new());
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.split('#').next().unwrap_or_default().trim();
        let fields: Vec<&str> = line.split(',').map(unquoted).collect();
        let is_header = entries.is_empty() && fields == ["i", "j", "k", "value"];
        if !(line.is_empty() || is_header) {
            entries.push(entry(number, &fields)?);
            numbers.push(number);
        }
    }
    let line = |entry: usize| numbers.get(entry).copied().unwrap_or_default();
    // Indices that do not occur belong to central elements, which do not enter the identity.
    match table_of_entries(SystemAlgebra::MOST_DIMENSIONS, &entries) {
        Ok(_) => Ok(entries),
        Err(EntryError::WithItself { entry, index }) => {
            Err(StructureTableError::WithItself { line: line(entry), index: index + 1 })
        }
        Err(EntryError::Contradiction { entry, earlier }) => {
            let (line, earlier) = (line(entry), line(earlier));
            Err(StructureTableError::Contradiction { line, earlier })
        }
        Err(EntryError::Structure(StructureError::Jacobi { i, j, k, residual, allowed })) => {
            let indices = [i, j, k].map(|index| index + 1);
            Err(StructureTableError::Jacobi { indices, residual, allowed })
        }
        Err(error) => Err(StructureTableError::Entries(error)),
    }
}

/// The character that some programs write before a text in UTF-8.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Returns a field without the quotation marks around it.
fn unquoted(field: &str) -> &str {
    let field = field.trim();
    let inner = field.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    inner.map_or(field, str::trim)
}

/// Reads the fields of a line.
fn entry(line: usize, fields: &[&str]) -> Result<StructureEntry, StructureTableError> {
    let [i, j, k, value] = *fields else {
        return Err(StructureTableError::Fields { line, count: fields.len() });
    };
    let most = SystemAlgebra::MOST_DIMENSIONS;
    let index = |text: &str| {
        // Spreadsheets write whole numbers as decimals.
        let number = text.parse().ok().filter(|number: &f64| number.fract() == 0.0);
        let index = number.map(|number| number as usize).filter(|index| (1..=most).contains(index));
        let error = || StructureTableError::Index { line, text: text.into(), most };
        index.map(|index| index - 1).ok_or_else(error)
    };
    let number = value.parse().ok().filter(|number: &f64| number.is_finite());
    let number = number.ok_or_else(|| StructureTableError::Value { line, text: value.into() });
    Ok(StructureEntry { i: index(i)?, j: index(j)?, k: index(k)?, value: number? })
}
