//! The kinds of cases of the target `integrators`, by name.

use super::{attitudes, chains, cocycles, doubled_spaces, sites, stages_side_by_side};
use crate::input::Input;

/// A kind of cases: its name, and a function that panics if a law is broken, and returns whether the laws of a result were
/// checked.
pub(super) type Kind = (&'static str, fn(&mut Input<'_>) -> bool);

fn kinds() -> impl Iterator<Item = Kind> {
    let rooms = [
        chains::KINDS,
        sites::KINDS,
        cocycles::KINDS,
        doubled_spaces::KINDS,
        stages_side_by_side::KINDS,
        attitudes::KINDS,
    ];
    rooms.into_iter().flatten().copied()
}

pub(crate) fn run(case: &[u8]) {
    let _ = kind_of_case(case);
}

/// Returns the names of the kinds of the target `integrators`.
#[must_use]
pub fn names_of_kinds() -> Vec<&'static str> {
    kinds().map(|(name, _)| name).collect()
}

/// Runs the target `integrators`. Returns the kind of the case if it had a result whose laws were checked.
#[must_use]
pub fn kind_of_case(case: &[u8]) -> Option<&'static str> {
    let mut input = Input::new(case);
    let chosen = input.choice(kinds().count());
    let (name, holds) = kinds().nth(chosen)?;
    holds(&mut input).then_some(name)
}
