//! Kills at moments that are not chosen.
#![cfg(unix)]

use crate::program::Folder;
use crate::writing::{WRITING, Writing, contents};
use std::process::Child;
use std::thread::sleep;
use std::time::Duration;

/// Kills runs at moments that are spread over a part of the time that one takes, and repeats each. Returns how many were
/// killed before their end.
fn kill(writing: &Writing, kills: u32, part: f64) -> u32 {
    let took = writing.undisturbed().took.mul_f64(part);
    let mut killed = 0;
    for number in 1..=kills {
        let folder = writing.with_old_files();
        let mut child = folder.start(&[writing.arguments, &["--quiet"]].concat());
        // Multiples of the golden section lie everywhere within the run.
        sleep(took.mul_f64((f64::from(number) * 0.618).fract()));
        killed += u32::from(kill_before_end(&mut child));
        assert_goes_on(writing, &folder);
    }
    println!("{writing}: {killed} of {kills} runs were killed before their end");
    killed
}

/// Kills a run. Returns whether that was before its end.
fn kill_before_end(child: &mut Child) -> bool {
    let _ = child.kill();
    !child.wait().unwrap().success()
}

/// Checks that no file is torn, and that the run is repeated with success.
fn assert_goes_on(writing: &Writing, folder: &Folder) {
    for (name, bytes) in contents(folder) {
        // A file under its name is complete: it is the old or a new one.
        if writing.files.contains(&name.as_str()) {
            let is_whole = writing.is_old(&name, &bytes) || writing.is_whole(&name, &bytes);
            assert!(is_whole, "{writing}: {name} is torn");
        }
    }
    if writing.arguments[0] == "init" {
        let _ = std::fs::remove_file(folder.path(writing.files[0]));
    }
    writing.assert_repeats(folder, writing.anew);
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn what_was_killed_is_repeated_with_success() {
    for writing in &WRITING {
        // A run may be over before it is killed. Then the next one is killed earlier.
        let is_killed = (0..8).any(|halvings| kill(writing, 1, 0.5_f64.powi(halvings)) > 0);
        assert!(is_killed, "{writing}: no run was killed before its end");
    }
}

/// The files of `compare` hold times, and get their names together, after seconds of work.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_comparison_that_is_killed_while_it_writes_is_repeated_with_success() {
    let compare = WRITING.iter().find(|writing| writing.arguments[0] == "compare").unwrap();
    let is_killed = (0..8).any(|_| {
        let folder = compare.with_old_files();
        let mut child = folder.start(&[compare.arguments, &["--quiet"]].concat());
        let begun = folder.path("made/work-precision.svg.partial");
        while !begun.exists() && child.try_wait().unwrap().is_none() {
            sleep(Duration::from_micros(500));
        }
        let is_killed = kill_before_end(&mut child);
        assert_goes_on(compare, &folder);
        is_killed
    });
    assert!(is_killed, "no run was killed before its end");
}

#[test]
#[ignore = "takes minutes"]
fn what_was_killed_a_hundred_times_is_repeated_with_success() {
    for writing in &WRITING {
        kill(writing, 100, 1.0);
    }
}
