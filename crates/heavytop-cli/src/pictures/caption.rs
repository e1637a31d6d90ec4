//! The words of captions: how a motion was computed, and of which top.

use super::numerals::significant;
use super::symbols;
use heavytop::methods::{Formulation, SchemeName};
use heavytop::{HeavyTop, PrincipalAxes};
use lie_poisson::{Covector, Pair, Se3Dual};

/// The number of significant digits in captions.
const DIGITS: usize = 6;

/// Formats a number of a caption.
pub(crate) fn number(x: f64) -> String {
    significant(x, DIGITS)
}

/// Returns a text of a user as the inside of an SVG text.
pub(crate) fn plain(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// Returns a formula as the inside of an SVG text, with the symbols of its names.
pub(crate) fn formula(text: impl ToString) -> String {
    plain(&symbols::formula(&text.to_string()))
}

/// Returns the equation of a Hamiltonian.
pub(crate) fn hamiltonian(text: impl ToString) -> String {
    format!("<tspan font-style='italic'>h</tspan> = {}", formula(text))
}

/// Formats a vector of a caption.
pub(crate) fn vector(components: impl IntoIterator<Item = f64>) -> String {
    format!("({})", components.into_iter().map(number).collect::<Vec<_>>().join(", "))
}

/// Returns the components of a vector, with the symbols of those that have one; `None` if all have one.
pub(crate) fn vector_of(
    name: &str,
    components: &[f64],
    symbol: impl Fn(usize) -> Option<String>,
) -> Option<String> {
    let shown = |(i, x): (usize, &f64)| symbol(i).unwrap_or_else(|| number(*x));
    let text = components.iter().enumerate().map(shown).collect::<Vec<_>>().join(", ");
    let is_known = (0..components.len()).any(|i| symbol(i).is_none());
    is_known.then(|| format!("{name} = ({text})"))
}

/// Returns the formulation, the scheme and the step (s).
pub(crate) fn method(formulation: Formulation, scheme: SchemeName, step: f64) -> String {
    format!("{formulation}, {scheme}, step {} s", number(step))
}

/// Returns the numbers of a top.
pub(crate) fn top(top: &HeavyTop) -> String {
    top_in(top, &PrincipalAxes::aligned(top.inertia()))
}

/// Returns the parameters of a top whose users have other axes than the principal ones: c is in theirs.
pub(crate) fn top_in(top: &HeavyTop, axes: &PrincipalAxes) -> String {
    let inertia: [f64; 3] = top.inertia().into();
    let center: [f64; 3] = axes.from_principal(&top.center_of_mass()).into();
    let (weight, moments) = (number(top.weight_moment()), vector(inertia));
    let moments = match axes.is_aligned() {
        true => format!("I = {moments} kg m²"),
        false => format!("principal moments {moments} kg m²"),
    };
    format!("{moments}, m g l = {weight} N m, c = {}", vector(center))
}

/// Returns the numbers of an initial state.
pub(crate) fn start(Covector(Pair(pi, gamma)): &Se3Dual) -> String {
    let (pi, gamma) = (pi.iter().copied(), gamma.iter().copied());
    format!("Π(0) = {} kg m²/s, Γ(0) = {}", vector(pi), vector(gamma))
}
