//! The accuracy of the worst of some members of a sweep.

use crate::commands::sweep::sweep_plan::Plan;
use crate::configuration::{Spread, SweepAxis};
use crate::runs::run_check::worse;
use collective_integrators::diagnostics::RunAccuracy;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// The least and the largest number of members that are measured, apart from the corners of a grid.
const PROBES: [u64; 2] = [8, 64];

/// The share of the members of a large sweep that are measured: one of so many.
const PARTS: u64 = 20;

/// The largest number of axes of a grid whose corners are measured, too.
const MOST_AXES: usize = 5;

/// Returns the largest angle of a step and the largest error of members spread evenly over the sweep, and of those at the
/// corners of a grid. Members that cannot be followed do not count; there may be no other. `going` may tell it to end.
pub(in crate::commands::sweep) fn worst_accuracy(
    plan: &Plan,
    going: &(dyn Fn() -> bool + Sync),
) -> Option<RunAccuracy> {
    let accuracy =
        |number| plan.family.accuracy(&plan.parameters(number), &plan.course, &|| going());
    let measured = probes(plan).into_par_iter().filter_map(|number| accuracy(number).ok());
    measured.reduce_with(worse)
}

/// Returns the warning about the worst of the members that are measured, if there is one.
pub(in crate::commands::sweep) fn worst_warning(
    plan: &Plan,
    accuracy: &RunAccuracy,
) -> Option<String> {
    let (measured, members, nouns) = (probes(plan).len(), plan.members, plan.nouns());
    let text = plan.family.accuracy_warning(accuracy)?;
    Some(format!(
        "warning: in the worst of {measured} that were tried of {members} {nouns}, {text}"
    ))
}

/// Returns the numbers of the members that are measured, in ascending order.
fn probes(plan: &Plan) -> Vec<u64> {
    let [least, most] = PROBES;
    let (last, count) = (plan.members - 1, (plan.members / PARTS).clamp(least, most));
    let spread =
        (0..count).map(|n| (u128::from(last) * u128::from(n) / u128::from(count - 1)) as u64);
    let mut numbers: Vec<u64> = spread.chain(corners(&plan.axes)).collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}

/// Returns the numbers of the members at the corners of a grid, in which the last axis runs fastest.
fn corners(axes: &[SweepAxis]) -> Vec<u64> {
    let count = |axis: &SweepAxis| match axis.spread {
        Spread::Grid { count, .. } => Some(u64::from(count)),
        _ => None,
    };
    let Some(counts) = axes.iter().map(count).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    if counts.len() > MOST_AXES {
        return Vec::new();
    }
    counts.iter().fold(vec![0], |numbers, count| {
        numbers.iter().flat_map(|n| [n * count, n * count + count.saturating_sub(1)]).collect()
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn plan(text: &str) -> Plan {
        Plan::new(&toml::from_str(text).unwrap()).unwrap()
    }

    #[test]
    fn the_corners_of_a_grid_and_some_members_between_are_measured() {
        let grid = "[[sweep.axes]]\nparameter = 'body.mass'\nfrom = 1\nto = 2\ncount = 30\n\
                    [[sweep.axes]]\nparameter = 'body.length'\nfrom = 1\nto = 2\ncount = 40";
        let numbers = probes(&plan(grid));
        assert!([0, 39, 1160, 1199].iter().all(|corner| numbers.contains(corner)), "{numbers:?}");
        assert_eq!(numbers.len(), 60 + 2, "two corners are among the 60 that are spread evenly");
        let random =
            "sweep.count = 3\nsweep.axes = [{ parameter = 'body.mass', normal = [3, 0.5] }]";
        assert_eq!(probes(&plan(random)), [0, 1, 2]);
    }

    /// The member that turns fastest, at a corner, decides.
    #[test]
    fn the_worst_member_counts() {
        let sweep = |most: f64| {
            let text = format!(
                "[integrator]\nstep = 0.1\nend = 10\n[[sweep.axes]]\n\
                 parameter = 'initial.angular_momentum[2]'\nfrom = 0\nto = {most}\ncount = 3"
            );
            worst_accuracy(&plan(&text), &|| true).unwrap()
        };
        let (slow, fast) = (sweep(1.0), sweep(60.0));
        assert!(slow.angle < 1.0 && slow.warning().is_none(), "{slow:?}");
        assert!(fast.angle > 5.0 && fast.warning().is_some(), "{fast:?}");
    }
}
