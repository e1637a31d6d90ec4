//! Suggestions for misspelt names.

use strsim::damerau_levenshtein;

/// The largest length of a name for which a suggestion is searched for.
const LONGEST: usize = 64;

/// Returns the closest name, if it is close: one change in a short name, or a third of the letters.
///
/// A name that differs only between capital and small letters is closest.
///
/// # Example
/// ```
/// use lie_poisson_formulas::closest_name;
/// let names = ["inertia", "mass", "gravity"];
/// assert_eq!(closest_name("intertia", names.into_iter()).as_deref(), Some("inertia"));
/// assert_eq!(closest_name("colour", names.into_iter()), None);
/// ```
pub fn closest_name<'a>(name: &str, names: impl Iterator<Item = &'a str>) -> Option<String> {
    let length = name.chars().count();
    if length > LONGEST {
        return None;
    }
    let distance = |other: &str| {
        if name.eq_ignore_ascii_case(other) { 0 } else { damerau_levenshtein(name, other) }
    };
    let (away, best) = names.map(|other| (distance(other), other)).min()?;
    (length > 1 && away <= length.div_ceil(3) || away == 0).then(|| best.to_owned())
}
