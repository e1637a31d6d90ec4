//! The names of the coordinates of a space: [`Coordinates`].

use super::letters::{RESERVED, canonical, is_name};
use super::name_error::NameError;
use core::ops::Range;

/// The largest number of coordinates. It is limited because a formula computes in a bounded number of registers.
pub(crate) const MOST_COORDINATES: usize = 256;

/// The names of the coordinates of a space, in their order: scalars, and vectors with their components.
///
/// A vector `Pi` of dimension 3 names three coordinates, `Pi1`, `Pi2` and `Pi3`; the coordinates of a vector `x_1`
/// are `x_1_1`, `x_1_2` and so on. A Greek letter stands for its name, and a subscript for a digit, so that Π₁ and
/// `Pi1` are the same name.
///
/// # Example
/// ```
/// use lie_poisson_formulas::Coordinates;
/// let heavy_top = Coordinates::new().vector("Π", 3)?.vector("Γ", 3)?;
/// assert_eq!(heavy_top.dimension(), 6);
/// assert_eq!(heavy_top.names().last().as_deref(), Some("Gamma3"));
/// let poincare = Coordinates::scalars(["K", "H", "P"])?;
/// assert!(poincare.scalar("H").is_err()); // there is one already
/// # Ok::<(), lie_poisson_formulas::NameError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Coordinates {
    fields: Vec<Field>,
}

/// A scalar or a vector among the coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Field {
    pub(crate) name: String,
    /// The index of the first coordinate.
    pub(crate) start: usize,
    /// The dimension of a vector, or `None` for a scalar.
    pub(crate) dimension: Option<usize>,
}

impl Field {
    /// Returns the number of coordinates.
    pub(crate) fn width(&self) -> usize {
        self.dimension.unwrap_or(1)
    }

    /// Returns the name of each coordinate.
    pub(crate) fn names(&self) -> impl Iterator<Item = String> + '_ {
        (0..self.width()).map(|i| match self.dimension {
            Some(_) => component(&self.name, i),
            None => self.name.clone(),
        })
    }
}

/// Returns the name of a component. Components count from 1: `Pi1`, but `Pi_1_1` for a vector whose name ends in a
/// digit.
pub(crate) fn component(name: &str, i: usize) -> String {
    let separator = if name.ends_with(|end: char| end.is_ascii_digit()) { "_" } else { "" };
    format!("{name}{separator}{}", i + 1)
}

/// Returns the plain form of a name that is neither reserved nor malformed.
pub(crate) fn checked(name: &str) -> Result<String, NameError> {
    if !is_name(name) {
        return Err(NameError::NotAName { name: name.to_owned() });
    }
    let name = canonical(name);
    if RESERVED.contains(&name.as_str()) { Err(NameError::Reserved { name }) } else { Ok(name) }
}

impl Coordinates {
    /// Creates an empty list of coordinates.
    #[must_use]
    pub const fn new() -> Self {
        Self { fields: Vec::new() }
    }

    /// Creates scalar coordinates with the given names.
    ///
    /// # Errors
    /// Returns [`NameError`] for the first name that [`scalar`](Self::scalar) rejects.
    pub fn scalars<'a>(names: impl IntoIterator<Item = &'a str>) -> Result<Self, NameError> {
        names.into_iter().try_fold(Self::new(), |coordinates, name| coordinates.scalar(name))
    }

    /// Adds a scalar coordinate after the others.
    ///
    /// # Errors
    /// Returns [`NameError`] if the name is malformed, reserved or taken, or if there are too many coordinates.
    pub fn scalar(self, name: &str) -> Result<Self, NameError> {
        self.field(name, None)
    }

    /// Adds the components of a vector, of any dimension up to 256.
    ///
    /// # Errors
    /// Returns [`NameError`] if the name, or that of a component, is malformed, reserved or taken, or if the vector
    /// has no component, or if there are too many coordinates.
    pub fn vector(self, name: &str, dimension: usize) -> Result<Self, NameError> {
        if dimension == 0 {
            let name = name.to_owned();
            return Err(NameError::Dimension { name, dimension, limit: MOST_COORDINATES });
        }
        self.field(name, Some(dimension))
    }

    fn field(mut self, name: &str, dimension: Option<usize>) -> Result<Self, NameError> {
        let (name, start) = (checked(name)?, self.dimension());
        let count = start.saturating_add(dimension.unwrap_or(1));
        if count > MOST_COORDINATES {
            return Err(NameError::TooMany { count, limit: MOST_COORDINATES });
        }
        let field = Field { name, start, dimension };
        let mut new = field.names().chain([field.name.clone()]);
        if let Some(name) = new.find(|new| self.taken(new)) {
            return Err(NameError::Repeated { name });
        }
        drop(new);
        self.fields.push(field);
        Ok(self)
    }

    fn taken(&self, name: &str) -> bool {
        self.fields.iter().any(|field| field.name == name || field.names().any(|own| own == name))
    }

    /// Returns the number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.fields.iter().map(Field::width).sum()
    }

    /// Returns the name of each coordinate, such as `Pi1`.
    pub fn names(&self) -> impl Iterator<Item = String> + '_ {
        self.fields.iter().flat_map(Field::names)
    }

    /// Returns the indices of the coordinates with a name: the name of a vector, of one component, or of a scalar.
    ///
    /// ```
    /// use lie_poisson_formulas::Coordinates;
    /// let heavy_top = Coordinates::new().vector("Pi", 3)?.vector("Gamma", 3)?;
    /// assert_eq!((heavy_top.places("Γ"), heavy_top.places("Gamma2")), (Some(3..6), Some(4..5)));
    /// assert_eq!(heavy_top.places("Omega"), None);
    /// # Ok::<(), lie_poisson_formulas::NameError>(())
    /// ```
    #[must_use]
    pub fn places(&self, name: &str) -> Option<Range<usize>> {
        let name = canonical(name);
        self.fields.iter().find_map(|field| {
            if field.name == name {
                return Some(field.start..field.start + field.width());
            }
            let i = field.names().position(|own| own == name)?;
            Some(field.start + i..field.start + i + 1)
        })
    }

    /// Returns the names of the scalars and vectors, with the indices of their coordinates.
    pub fn groups(&self) -> impl Iterator<Item = (&str, Range<usize>)> {
        self.fields.iter().map(|f| (f.name.as_str(), f.start..f.start + f.width()))
    }

    /// Returns the scalars and vectors.
    pub(crate) fn fields(&self) -> &[Field] {
        &self.fields
    }

    /// Returns the coordinates at the places for which `belongs` is true, under the same names. A vector of which some
    /// components are missing is left as scalars.
    pub(crate) fn only(&self, belongs: impl Fn(usize) -> bool) -> Self {
        let mut fields = Vec::new();
        let mut start = 0;
        let mut add = |name: String, dimension: Option<usize>| {
            fields.push(Field { name, start, dimension });
            start += dimension.unwrap_or(1);
        };
        for field in &self.fields {
            let own = |i: &usize| belongs(field.start + i);
            if (0..field.width()).all(|i| own(&i)) {
                add(field.name.clone(), field.dimension);
            } else {
                let kept = field.names().enumerate().filter(|(i, _)| own(i));
                kept.for_each(|(_, name)| add(name, None));
            }
        }
        Self { fields }
    }

    /// Returns the coordinates under other names of the scalars and vectors.
    ///
    /// # Errors
    /// Returns [`NameError`] if a name is malformed, reserved, or used twice.
    ///
    /// ```
    /// use lie_poisson_formulas::Coordinates;
    /// let spins = Coordinates::new().vector("Pi", 3)?.repeated(2)?;
    /// let spins = spins.renamed(|name| name.replace("Pi", "S"))?;
    /// assert_eq!(spins.names().last().as_deref(), Some("S_2_3"));
    /// # Ok::<(), lie_poisson_formulas::NameError>(())
    /// ```
    pub fn renamed(&self, name: impl Fn(&str) -> String) -> Result<Self, NameError> {
        let named = |all: Self, field: &Field| all.field(&name(&field.name), field.dimension);
        self.fields.iter().try_fold(Self::new(), named)
    }

    /// Returns these coordinates followed by others. If some names clash, all names get the suffixes `_1` and `_2`.
    ///
    /// # Errors
    /// Returns [`NameError`] if the names clash even with suffixes, or if there are too many coordinates.
    pub fn then(&self, other: &Self) -> Result<Self, NameError> {
        let both = |suffixes: [&str; 2]| {
            [self, other].iter().zip(suffixes).try_fold(Self::new(), |all, (part, suffix)| {
                part.fields.iter().try_fold(all, |all, field| {
                    all.field(&format!("{}{suffix}", field.name), field.dimension)
                })
            })
        };
        match both(["", ""]) {
            Err(NameError::Repeated { .. }) => both(["_1", "_2"]),
            done => done,
        }
    }

    /// Returns `count` copies of these coordinates, with the suffixes `_1`, `_2` and so on.
    ///
    /// # Errors
    /// Returns [`NameError`] if there are too many coordinates.
    pub fn repeated(&self, count: usize) -> Result<Self, NameError> {
        (1..=count).try_fold(Self::new(), |all, copy| {
            self.fields.iter().try_fold(all, |all, field| {
                all.field(&format!("{}_{copy}", field.name), field.dimension)
            })
        })
    }
}
