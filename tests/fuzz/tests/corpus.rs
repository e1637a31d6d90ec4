//! The corpora of the fuzzer: each case ends as its target says.
#![allow(clippy::unwrap_used)]

use fuzz_targets::{cases, line, targets};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// Returns the cases of a corpus.
fn corpus(name: &str) -> Vec<Vec<u8>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("corpus/{name}.txt"));
    cases(&std::fs::read_to_string(&path).unwrap())
}

/// Returns the cases for which a target panics.
fn broken(run: fn(&[u8]), cases: &[Vec<u8>]) -> Vec<String> {
    let holds = |case: &Vec<u8>| catch_unwind(AssertUnwindSafe(|| run(case))).is_ok();
    cases.iter().filter(|case| !holds(case)).map(|case| line(case)).collect()
}

#[test]
fn every_case_of_the_corpora_ends_in_an_error_or_obeys_the_laws() {
    for target in targets() {
        let cases = corpus(target.name);
        assert!(cases.len() > 10, "{}", target.name);
        let broken = broken(target.run, &cases);
        assert!(broken.is_empty(), "{}: {broken:#?}", target.name);
    }
}

/// Negative control: a law that does not hold, here that no formula is longer than 60 bytes, is broken by some cases.
#[test]
fn a_law_that_does_not_hold_is_seen_to_be_broken() {
    let cases = corpus("formula");
    let broken = broken(|case| assert!(case.len() <= 60), &cases);
    let long = cases.iter().filter(|case| case.len() > 60).count();
    assert!(broken.len() == long && (1..cases.len()).contains(&long), "{long}");
}
