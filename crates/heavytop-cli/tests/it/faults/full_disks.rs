//! Disks that are full: small file systems, each for one command.
#![cfg(target_os = "linux")]

use super::no_room::{assert_goes_on, assert_nothing_is_lost};
use super::private_mounts::with_mount;
use crate::program::{Finished, Folder};
use crate::writing::{SYSTEM, WRITING, Writing, contents};
use std::process::Command;
use std::sync::LazyLock;

const FULL: &str = ": No space left on device";

/// Runs a command on a disk with the files of a folder and room for so many pages besides. Returns the files as the
/// command left them; `None`, with a message, where no disk can be mounted.
fn on_small_disk(old: &Folder, arguments: &[&str], pages: u64) -> Option<(Folder, Finished)> {
    let (disk, left) = (Folder::new(), Folder::new());
    let [at, to] = [&disk, &left].map(|folder| folder.path("").display().to_string());
    let old_pages = pages_of(old);
    // `nr_blocks=0` would mean no limit, so there is always one page more, which the file `taken` fills.
    let blocks = old_pages + pages + 1;
    let mount = format!("mount -t tmpfs -o nr_blocks={blocks} heavytop {at}");
    let then = format!(
        "mkdir {at}/work && cp -R . {at}/work && echo taken >{at}/taken && cd {at}/work || exit 99
        \"$@\"
        code=$?
        cp -R . {to} && exit $code || exit 99"
    );
    let run = with_mount(&old.path("."), &mount, &then, arguments)?;
    assert_ne!(run.code(), 99, "the disk could not be prepared or read: {}", run.stderr());
    Some((left, run))
}

/// Returns the number of pages of the files of a folder.
fn pages_of(folder: &Folder) -> u64 {
    contents(folder).values().map(|bytes| pages(bytes.len())).sum()
}

/// Returns the number of pages of so many bytes.
fn pages(bytes: usize) -> u64 {
    static PAGE: LazyLock<u64> = LazyLock::new(|| {
        let said = Command::new("getconf").arg("PAGESIZE").output().unwrap().stdout;
        String::from_utf8(said).unwrap().trim().parse().unwrap()
    });
    (bytes as u64).div_ceil(*PAGE)
}

/// Returns the number of pages of the files that a command makes.
fn needed(writing: &Writing) -> u64 {
    writing.undisturbed().files.values().map(|bytes| pages(bytes.len())).sum()
}

/// Runs a command on a disk with room for so many pages, and then on one with enough; returns whether the room was too
/// little.
fn run_out(writing: &Writing, pages: u64, repeat: bool) -> Option<bool> {
    // Some commands ask before they write more than the disk has room for; `--yes` answers them.
    let yes: &[&str] = if writing.anew.is_empty() { &[] } else { &["--yes"] };
    let arguments = [writing.arguments, yes].concat();
    let (folder, run) = on_small_disk(&writing.with_old_files(), &arguments, pages)?;
    if run.code() == 0 {
        return Some(false);
    }
    assert_nothing_is_lost(writing, &folder, &run, FULL);
    if repeat {
        assert_goes_on(writing, &folder, &run);
    }
    Some(true)
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn on_a_full_disk_the_old_files_stay_and_the_run_is_repeated_with_success() {
    for writing in &WRITING {
        let needed = needed(writing);
        // One page less than the new files need beside the old ones; those of `compare`, which takes seconds, vary a
        // little in length.
        let nearly = if writing.repeats { needed - 1 } else { needed * 15 / 16 };
        let Some(full) = run_out(writing, nearly, writing.repeats) else { return };
        assert!(full, "{writing} had room");
        if writing.repeats {
            assert_eq!(run_out(writing, 0, false), Some(true), "{writing} had room");
        }
    }
}

/// Where nobody can be asked, a run that would fill the disk is refused.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_run_that_would_fill_the_disk_is_refused() {
    for writing in WRITING.iter().filter(|writing| !writing.anew.is_empty()) {
        let old = writing.with_old_files();
        let Some((folder, run)) = on_small_disk(&old, writing.arguments, 0) else { return };
        let said = run.stderr();
        assert_eq!((run.code(), said.lines().count()), (2, 1), "{writing}: {said}");
        assert!(said.starts_with("heavytop: the run would write about "), "{writing}: {said}");
        assert!(contents(&folder) == contents(&old), "{writing}");
    }
}

#[test]
#[ignore = "takes minutes"]
fn on_a_disk_that_is_full_at_any_moment_the_old_files_stay_and_the_run_is_repeated_with_success() {
    for writing in &WRITING {
        // Tiles and rows need room besides the files that are made of them.
        let most = 2 * needed(writing) + 4;
        let count = if writing.repeats { 32 } else { 4 };
        let rooms = (0..most).step_by(most.div_ceil(count) as usize);
        let mut failed = 0;
        for pages in rooms.clone() {
            let Some(full) = run_out(writing, pages, true) else { return };
            failed += u32::from(full);
        }
        println!("{writing}: {failed} of {} disks were full", rooms.count());
    }
}

/// Runs of 3000 steps, each with a checkpoint before the first, and after 1024 and 2048 of them.
const LONG: [&str; 5] = ["--set", "integrator.end=60", "--checkpoint-interval", "0", "--yes"];

/// The runs, the files of their rows, and the bytes of a row: `None` for CSV, whose rows differ in length.
const RUNS: [(&[&str], &str, Option<usize>); 4] = [
    (&["simulate", "--out", "a.csv"], "a.csv.partial", None),
    (&["simulate", "--out", "a.npz"], "a.npz.rows", Some(8 * 11)),
    (&["simulate", "--out", "a.parquet"], "a.parquet.rows", Some(8 * 11)),
    (&["simulate", "--out", "b.csv", "--set", SYSTEM], "b.csv.partial", None),
];

/// The disk is full when a checkpoint is written: the first one, or a later one, while the one before is kept.
#[test]
#[ignore = "a fault, which .ci/run makes"]
fn a_disk_that_is_full_when_the_checkpoint_is_written_loses_nothing() {
    for (arguments, rows, bytes_of_row) in RUNS {
        let (folder, out) = (Folder::new(), arguments[2]);
        let arguments = [arguments, &LONG].concat();
        assert_eq!(folder.heavytop(&arguments).code(), 0);
        let whole = std::fs::read(folder.path(out)).unwrap();
        let until = |step: usize| match bytes_of_row {
            Some(bytes) => (step + 1) * bytes,
            // The header and the rows.
            None => whole.split_inclusive(|&b| b == b'\n').take(step + 2).map(<[u8]>::len).sum(),
        };
        let checkpoint = format!("{out}.checkpoint");
        let cannot = format!("{checkpoint}{FULL} (os error 28); ");
        let goes_on = format!("{cannot}go on by the same command with --resume\n");
        let keeps = format!("{cannot}what was computed until then is in {rows}\n");
        for (step, before) in [(0, None), (1024, Some(0)), (2048, Some(1024))] {
            // There is room for the rows and for the checkpoint before, but for nothing else.
            let room = pages(until(step)) + u64::from(before.is_some());
            let Some((left, run)) = on_small_disk(&Folder::new(), &arguments, room) else { return };
            let said = if before.is_some() { &goes_on } else { &keeps };
            assert!(run.code() == 1 && run.stderr().ends_with(said), "{step}: {}", run.stderr());
            assert!(
                run.stderr().starts_with("heavytop: cannot write "),
                "{step}: {}",
                run.stderr()
            );
            assert_eq!(left.path(rows).metadata().unwrap().len(), until(step) as u64, "{rows}");
            let Some(before) = before else {
                assert_eq!(left.names(), [rows]);
                continue;
            };
            assert_eq!(left.names(), [&checkpoint, rows]);
            let kept = left.read(&checkpoint);
            assert!(kept.contains(&format!("\nstep = {before}\n")), "{kept}");
            let resumed = left.heavytop(&["simulate", "--out", out, "--resume", &checkpoint]);
            assert_eq!((resumed.code(), resumed.complaints()), (0, String::new()));
            assert!(std::fs::read(left.path(out)).unwrap() == whole, "{out}");
            assert_eq!(left.names(), [out]);
        }
    }
}
