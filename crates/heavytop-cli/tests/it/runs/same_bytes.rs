//! The same input gives the same bytes, on any number of threads, and with portable instructions on any processor.

use crate::program::{Folder, numbers};
use crate::writing::{Contents, WRITING, Writing, contents};
use heavytop::methods::Method;
use lie_poisson::InstructionSet;

/// Returns the files of a run on so many threads.
fn files(writing: &Writing, threads: &str) -> Contents {
    let folder = Folder::new();
    let run = folder.heavytop_on(threads, writing.arguments);
    assert_eq!((run.code(), run.complaints()), (0, String::new()), "{writing}");
    contents(&folder)
}

/// Returns a table of `compare` without what it has timed.
fn without_times(csv: &[u8]) -> Vec<Vec<String>> {
    let csv = std::str::from_utf8(csv).unwrap();
    let header: Vec<_> = csv.lines().next().unwrap().split(',').collect();
    let timed = |column: &str| column.contains("second") || column.contains("time");
    assert_eq!(header.iter().filter(|column| timed(column)).count(), 1, "{header:?}");
    let cells = |line: &str| {
        let cells = line.split(',').zip(&header).filter(|(_, column)| !timed(column));
        cells.map(|(cell, _)| cell.to_string()).collect()
    };
    csv.lines().map(cells).collect()
}

/// Compares the files of an undisturbed run with those of runs on these numbers of threads.
fn assert_same_bytes(writing: &Writing, numbers: &[&str]) {
    // As many threads as there are processors.
    let expected = &writing.undisturbed().files;
    for threads in numbers {
        let files = files(writing, threads);
        if writing.repeats {
            assert!(files == *expected, "{writing} on {threads} threads");
        } else {
            let table = writing.files[0];
            let [here, there] = [&files, expected].map(|files| without_times(&files[table]));
            assert_eq!(here, there, "{writing} on {threads} threads");
        }
    }
}

#[test]
#[ignore = "long"]
fn the_commands_with_threads_write_the_same_bytes_on_any_number_of_them() {
    for writing in WRITING.iter().filter(|w| ["section", "sweep"].contains(&w.arguments[0])) {
        assert_same_bytes(writing, &["1", "2", "3", "8"]);
    }
}

#[test]
#[ignore = "long"]
fn the_other_commands_write_the_same_bytes_again() {
    for writing in &WRITING {
        // `compare`, whose files hold times, takes seconds.
        if writing.repeats && !["section", "sweep"].contains(&writing.arguments[0]) {
            assert_same_bytes(writing, &["3"]);
        }
    }
}

#[test]
#[ignore = "takes a minute"]
fn every_command_writes_the_same_bytes_on_any_number_of_threads() {
    WRITING.iter().for_each(|writing| assert_same_bytes(writing, &["1", "2", "3", "8"]));
}

/// Where the fastest instructions round otherwise, `instructions = "portable"` gives other last digits, and only there.
#[test]
fn portable_instructions_change_the_last_digits_of_the_kernels_alone() {
    for (formulation, scheme) in [
        ("collective", "gauss-4"),
        ("collective", "gauss-16"),
        ("reduced", "implicit-midpoint"),
        ("collective", "implicit-midpoint"),
        ("reduced", "gauss-4"),
        ("direct", "rk4"),
        ("splitting", "yoshida-4"),
    ] {
        let method = Method::new(formulation.parse().unwrap(), scheme.parse().unwrap(), 0.0);
        let is_portable = method.unwrap().fastest().instructions() == InstructionSet::Portable;
        let folder = Folder::new();
        let integrator = format!("formulation='{formulation}',scheme='{scheme}',end=2");
        let run = |instructions: &str| {
            let all = format!("integrator={{{integrator},instructions='{instructions}'}}");
            let out = format!("{instructions}.csv");
            let run = folder.heavytop(&["simulate", "--out", &out, "--set", &all]);
            assert_eq!((run.code(), run.complaints()), (0, String::new()));
            folder.read(&out)
        };
        let [native, portable] = ["native", "portable"].map(run);
        assert_eq!(native == portable, is_portable, "{formulation} {scheme}");
        let [native, portable] = [native, portable].map(|csv| numbers(&csv).1.concat());
        for (a, b) in native.iter().zip(&portable) {
            // A hundred steps, each with some roundings of numbers of size 5.
            assert!((a - b).abs() < 1e-12, "{formulation} {scheme}: {a} {b}");
        }
    }
    let refused = Folder::new().heavytop(&[
        "simulate",
        "--out",
        "a.csv",
        "--set",
        "integrator.instructions=fast",
    ]);
    assert_eq!(refused.code(), 2);
    assert!(refused.stderr().contains("`native`"), "{}", refused.stderr());
}
