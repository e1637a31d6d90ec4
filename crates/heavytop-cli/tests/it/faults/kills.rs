//! Kills at moments that are not chosen.
#![cfg(unix)]

use crate::writing::{WRITING, Writing, contents};
use std::thread::sleep;

/// Kills runs at moments that are spread over the time that one takes, and repeats each.
fn kill(writing: &Writing, kills: u32) {
    let took = writing.undisturbed().took;
    let mut killed = 0;
    for number in 1..=kills {
        let folder = writing.with_old_files();
        let mut child = folder.start(&[writing.arguments, &["--quiet"]].concat());
        // Multiples of the golden section lie everywhere within the run.
        sleep(took.mul_f64((f64::from(number) * 0.618).fract()));
        let _ = child.kill();
        killed += u32::from(!child.wait().unwrap().success());
        for (name, bytes) in contents(&folder) {
            // A file under its name is complete: it is the old or the new one.
            if writing.files.contains(&name.as_str()) {
                let is_whole = bytes == b"old" || writing.is_whole(&name, &bytes);
                assert!(is_whole, "{writing}, kill {number}: {name} is torn");
            }
        }
        if writing.arguments[0] == "init" {
            let _ = std::fs::remove_file(folder.path(writing.files[0]));
        }
        writing.assert_repeats(&folder, writing.anew);
    }
    println!("{writing}: {killed} of {kills} runs were killed before their end");
}

#[test]
fn what_was_killed_is_repeated_with_success() {
    WRITING.iter().for_each(|writing| kill(writing, 1));
}

#[test]
#[ignore = "takes minutes"]
fn what_was_killed_a_hundred_times_is_repeated_with_success() {
    WRITING.iter().for_each(|writing| kill(writing, 100));
}
