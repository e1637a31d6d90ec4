//! How far a search for Casimirs goes: [`HIGHEST_DEGREE`], [`most_monomials`], [`most_changes`].

/// The largest degree of the Casimirs that are searched for.
pub(crate) const HIGHEST_DEGREE: u8 = 8;

/// The degree up to which a search may take seconds, and up to which the coefficients may be rounded: of a higher degree, there
/// would be hundreds of them in a basis where none is a fraction.
pub(crate) const LOW_DEGREE: u8 = 4;

/// Returns the largest number of monomials for which a degree is searched.
///
/// Above degree 4 all degrees together should take less than a second. With sparse brackets, such as those of sl(2, R) on
/// binary forms, 6435 monomials, those of degree 7 in 9 dimensions, take 0.1 s without optimisation.
pub(crate) const fn most_monomials(degree: u8) -> usize {
    if degree <= LOW_DEGREE { 4096 } else { 6435 }
}

/// Returns the largest number of changes of entries in the elimination of a degree.
///
/// It bounds the search with brackets that are not sparse, as in a generic basis. Without optimisation 4 million take 1.6 s,
/// and 20 million 7 s.
pub(crate) const fn most_changes(degree: u8) -> usize {
    if degree <= LOW_DEGREE { 20_000_000 } else { 4_000_000 }
}
