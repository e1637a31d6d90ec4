//! Files that cannot grow, and what a run without room must leave.
#![cfg(unix)]

use crate::program::{Finished, Folder, heavytop};
use crate::writing::{WRITING, Writing, contents};
use std::process::Command;

/// Runs a command where no file can have more than so many blocks, of 512 or of 1024 bytes: shells differ.
fn in_little_room(folder: &Folder, writing: &Writing, blocks: u32) -> Finished {
    let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$@\"");
    let mut command = Command::new("sh");
    command.args(["-c", &script, "sh", heavytop()]).args(writing.arguments);
    Finished::of(command.current_dir(folder.path(".")).output().unwrap())
}

/// Returns the argument that resumes the run, if a message names one.
fn resumption(said: &str) -> Option<&str> {
    Some(said.trim_end().split_once("; go on by the same command with ")?.1)
}

/// Checks what a run has said and left that had no room, and that it is repeated with success.
pub fn assert_nothing_is_lost(writing: &Writing, folder: &Folder, run: &Finished, reason: &str) {
    let said = run.complaints();
    assert_eq!((run.code(), said.lines().count()), (1, 1), "{writing}: {said}");
    assert!(said.starts_with("heavytop: cannot write "), "{writing}: {said}");
    assert!(said.contains(reason), "{writing}: {said}");
    let kept =
        said.trim_end().split_once("; what was computed until then is in ").map(|(_, kept)| kept);
    for (name, bytes) in contents(folder) {
        // The old files are as they were, and the others are those that the message speaks of.
        let is_old = writing.is_old(&name, &bytes);
        let is_kept = kept.is_some_and(|kept| std::path::Path::new(kept).ends_with(&name));
        let is_for_resumption = resumption(&said).is_some() && name.contains(".partial/");
        assert!(is_old || is_kept || is_for_resumption, "{writing}: {name} is left; {said}");
        if is_kept && name.ends_with(".csv.partial") {
            // Each line is complete.
            let text = String::from_utf8(bytes).unwrap();
            let cells = |line: &str| line.matches(',').count();
            let header = text.lines().next().map_or(0, cells);
            assert!(text.is_empty() || text.ends_with('\n'), "{name} is torn");
            assert!(text.lines().all(|line| cells(line) == header), "{name} is torn");
        }
    }
}

/// Runs a command in so little room, and then with enough; returns whether the room was too little.
fn run_out(writing: &Writing, blocks: u32, repeat: bool) -> bool {
    let folder = writing.with_old_files();
    let run = in_little_room(&folder, writing, blocks);
    if run.code() == 0 {
        return false;
    }
    assert_nothing_is_lost(writing, &folder, &run, ": File too large");
    if repeat {
        assert_goes_on(writing, &folder, &run);
    }
    true
}

/// Checks that the run is repeated with success, or resumed if its message says so.
pub fn assert_goes_on(writing: &Writing, folder: &Folder, run: &Finished) {
    let said = run.stderr();
    let resume: Vec<_> = resumption(&said).iter().flat_map(|s| s.split(' ')).collect();
    writing.assert_repeats(folder, &resume);
}

/// Returns the length of the largest file in KiB.
fn largest(writing: &Writing) -> u32 {
    writing.undisturbed().files.values().map(Vec::len).max().unwrap() as u32 / 1024
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn without_room_the_old_files_stay_and_the_run_is_repeated_with_success() {
    for writing in &WRITING {
        let nearly = largest(writing) * 15 / 16;
        // `compare` takes seconds.
        assert!(run_out(writing, nearly, writing.repeats), "{writing} had room");
        if writing.repeats {
            assert!(run_out(writing, 1, true), "{writing} had room");
        }
    }
}

#[test]
#[ignore = "takes minutes"]
fn without_room_at_any_moment_the_old_files_stay_and_the_run_is_repeated_with_success() {
    for writing in &WRITING {
        let largest = largest(writing) + 1;
        let rooms = (0..largest).step_by(largest.div_ceil(24) as usize);
        let failed = rooms.clone().filter(|&blocks| run_out(writing, blocks, true)).count();
        println!("{writing}: {failed} of {} runs had no room", rooms.count());
    }
}
