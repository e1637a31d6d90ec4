//! The corpora of the fuzzer: each case ends as its target says.
#![allow(clippy::unwrap_used)]

use fuzz_targets::{
    cases, goes_on, kind_of_case, line, method_of_case, names_of_kinds, names_of_methods, targets,
};
use rayon::prelude::*;
use std::collections::BTreeSet;
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
    cases.par_iter().filter(|case| !holds(case)).map(|case| line(case)).collect()
}

#[test]
#[ignore = "long"]
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

/// Not all checkpoints are refused: the laws of the runs that follow them are tested, too.
#[test]
fn some_checkpoints_are_accepted() {
    let (accepted, refused): (Vec<_>, Vec<_>) =
        corpus("checkpoint").into_iter().partition(|case| goes_on(case));
    assert!(accepted.len() >= 10 && refused.len() >= 10, "{} {}", accepted.len(), refused.len());
    // Control: the same files with another checksum go nowhere.
    for case in &accepted {
        assert!(!goes_on(&[&[0], &case[..]].concat()), "{}", line(case));
    }
}

/// Every method has a case in which it makes steps, and in which its Casimirs are checked if it should conserve them.
#[test]
#[ignore = "long"]
fn every_method_is_reached() {
    let reached: BTreeSet<String> =
        corpus("one_step").iter().filter_map(|case| method_of_case(case)).collect();
    let names = BTreeSet::from_iter(names_of_methods());
    let missing: Vec<_> = names.difference(&reached).collect();
    assert!(missing.is_empty(), "{missing:#?}");
    // Controls: there are as many as the documentation says, and a case without a top reaches none.
    assert_eq!((names.len(), method_of_case(b"")), (131, None));
}

/// The kinds of integrators that promise finite numbers alone, and one without coordinates.
const WITHOUT_LAWS: [&str; 3] =
    ["StagesInLanes<Direct>", "TaoFlows, composed", "Cocycle on a point"];

/// Every other kind of system and integrator has a case in which it makes steps whose laws are compared.
#[test]
#[ignore = "long"]
fn every_kind_of_integrators_is_reached() {
    let reached: BTreeSet<&str> =
        corpus("integrators").iter().filter_map(|case| kind_of_case(case)).collect();
    let names = BTreeSet::from_iter(names_of_kinds());
    let missing: Vec<_> =
        names.difference(&reached).filter(|name| !WITHOUT_LAWS.contains(name)).collect();
    assert!(missing.is_empty(), "{missing:#?}");
    // Controls: there are as many as the documentation says, and an infinite exchange is refused.
    assert_eq!((names.len(), kind_of_case(b"\x01\x01\x05")), (44, None));
}
