//! The corpora of the fuzzer: each case ends as its target says.
#![allow(clippy::unwrap_used)]

use fuzz_targets::{cases, targets};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

#[test]
fn every_case_of_the_corpora_ends_in_an_error_or_obeys_the_laws() {
    for target in targets() {
        let path =
            Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("corpus/{}.txt", target.name));
        let text = std::fs::read_to_string(&path).unwrap();
        let cases = cases(&text);
        assert!(cases.len() > 10, "{}", target.name);
        for case in cases {
            let run = catch_unwind(AssertUnwindSafe(|| (target.run)(&case)));
            assert!(run.is_ok(), "{}: {}", target.name, fuzz_targets::line(&case));
        }
    }
}
