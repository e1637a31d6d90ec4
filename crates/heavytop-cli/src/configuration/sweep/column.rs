//! The columns of the table of a sweep.

/// A column of the table of a sweep, and how its picture is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// The name of the column, which is also that of its picture.
    pub name: String,
    /// The quantity in the column, with its unit.
    pub label: String,
    /// Whether the picture shows the logarithm of the value.
    pub is_logarithmic: bool,
}

impl Column {
    /// Creates a column whose picture shows the value.
    #[must_use]
    pub fn linear(name: &str, label: &str) -> Self {
        Self { name: name.into(), label: label.into(), is_logarithmic: false }
    }

    /// Creates a column whose picture shows the logarithm of the value.
    #[must_use]
    pub fn logarithmic(name: &str, label: &str) -> Self {
        Self { is_logarithmic: true, ..Self::linear(name, label) }
    }
}
