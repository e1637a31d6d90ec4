//! The timing of integrators.

use crate::support::{START, top};
use lie_poisson::{Se3Dual, Vector};
use lie_poisson_runs::contests::{Contest, TimedProblem, TimedRun};
use std::collections::BTreeSet;

/// Times the integrators with a part of a name, and returns their runs and the names of the others.
fn timed(problem: &TimedProblem, only: &str) -> (Vec<TimedRun>, BTreeSet<String>) {
    let (mut runs, mut others) = (Vec::new(), BTreeSet::new());
    let mut done = |run| runs.push(run);
    let only = Some(only);
    Contest { problem, only, others: &mut others, done: &mut done }.run().unwrap();
    (runs, others)
}

/// The reference and the timed methods are different ones, so that a wrong one would be seen.
#[test]
fn errors_are_those_of_the_methods() {
    let start = Se3Dual::from_coordinates(|i| START[i]);
    let one = TimedProblem::with_references(top(), 12.0, vec![start]).unwrap();
    let (runs, others) = timed(&one, "midpoint");
    assert_eq!(runs.len(), 3);
    assert!(others.contains("heavytop collective Gauss-16"));
    for run in &runs {
        // a method of order 2 with a step of 0.01 s
        assert!(run.relative_error_end > 1e-7 && run.relative_error_end < 1e-2, "{run:?}");
        assert!(run.seconds > 0.0 && run.steps == 1200 && run.tops == 1);
    }
    let (runs, _) = timed(&one, "Gauss-16, compensated");
    assert!(runs.len() == 1 && runs[0].relative_error_end < 1e-12, "{runs:?}");

    let many = TimedProblem { tops: 20, ..one };
    let (runs, _) = timed(&many, "separate parameters");
    assert!(runs.len() == 1 && runs[0].tops == 20, "{runs:?}");
    assert!(runs[0].relative_error_end > 1e-7 && runs[0].relative_error_end < 1e-2);
}
