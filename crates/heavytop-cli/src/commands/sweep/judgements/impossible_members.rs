//! The members of a sweep that no body is.

use crate::commands::sweep::sweep_plan::Plan;
use crate::configuration::IMPOSSIBLE;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// Returns a warning if there are members that no body is, with their number and the first of them.
///
/// All members are tested: that takes far less time than their motions.
pub(in crate::commands::sweep) fn impossible_members(plan: &Plan) -> Option<String> {
    let family = &plan.family;
    if !family.judges_members() {
        return None;
    }
    let reason = |number: u64| plan.family.impossibility(&plan.parameters(number));
    let found = (0..plan.members).into_par_iter().filter(|number| reason(*number).is_some());
    let found = found.map(|number| (number, 1_u64));
    let (first, count) = found.reduce_with(|one, other| (one.0.min(other.0), one.1 + other.1))?;
    let (members, nouns, reason) = (plan.members, plan.nouns(), reason(first)?);
    Some(format!(
        "warning: no body is {count} of {members} {nouns}, the first of index {first}: [body] {reason}; the sweep \
         {IMPOSSIBLE}"
    ))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn warning(text: &str) -> Option<String> {
        impossible_members(&Plan::new(&toml::from_str(text).unwrap()).unwrap())
    }

    const AXIS: &str = "[[sweep.axes]]\nparameter = 'body.length'\nfrom = 0.1\nto = 0.5\ncount = 5";

    /// About the centre of mass the moments are (2, 2, 2)e-3 − 0.05 l² (1, 1, 0): all lengths but the first are too large.
    #[test]
    fn members_are_counted_and_the_first_is_named() {
        let body = "[body]\ninertia = [2e-3, 2e-3, 2e-3]\nmass = 0.05\ngravity = 9.81\nlength = 0.1\n\
                    center_of_mass = [0, 0, 1]\n";
        let text = warning(&format!("{body}{AXIS}")).unwrap();
        assert!(text.contains("4 of 5 tops, the first of index 1: [body] "), "{text}");
        assert!(text.ends_with(IMPOSSIBLE), "{text}");
    }

    /// Controls: possible bodies; a top of which m g l alone is known; an axis that does not change the body.
    #[test]
    fn what_is_possible_or_unknown_is_not_warned_about() {
        let large = "[body]\ninertia = [2, 2, 3]\nmass = 0.05\ngravity = 9.81\nlength = 0.1\n\
                     center_of_mass = [0, 0, 1]\n";
        assert_eq!(warning(&format!("{large}{AXIS}")), None);
        assert_eq!(warning(AXIS), None);
        let momentum = "[[sweep.axes]]\nparameter = 'initial.angular_momentum[0]'\nfrom = 1\nto = 2\ncount = 2";
        assert_eq!(warning(momentum), None);
    }
}
