//! Checkpoints and rows that are cut, altered or of another run: each is refused, or the run goes on to the same bytes.
#![cfg(unix)]

use crate::program::{Finished, Folder, heavytop};
use crate::writing::SYSTEM;
use std::process::Command;

/// A run of 3000 steps, with checkpoints after 1024 and 2048 of them where the disk is not full before.
const RUN: [&str; 4] = ["--set", "integrator.end=60", "--set", "output.every=1"];
/// The same of a system.
const RUN_OF_SYSTEM: [&str; 6] = [RUN[0], RUN[1], RUN[2], RUN[3], "--set", SYSTEM];

/// An interrupted run: the bytes of its checkpoint and of its rows, and those of an uninterrupted one.
struct Interrupted {
    folder: Folder,
    run: &'static [&'static str],
    out: &'static str,
    rows: String,
    saved: [Vec<u8>; 2],
    whole: Vec<u8>,
}

impl Interrupted {
    /// Interrupts a run by files that can have no more than so many blocks, of 512 or of 1024 bytes.
    fn new(run: &'static [&'static str], out: &'static str, blocks: u32) -> Self {
        let folder = Folder::new();
        let whole = folder.heavytop(&[&["simulate", "--out", out], run].concat());
        assert_eq!(whole.code(), 0, "{}", whole.stderr());
        let whole = std::fs::read(folder.path(out)).unwrap();
        std::fs::remove_file(folder.path(out)).unwrap();
        let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$@\"");
        let mut command = Command::new("sh");
        command.args(["-c", &script, "sh", heavytop(), "simulate"]);
        command.args(["--out", out, "--checkpoint-interval", "0"]).args(run);
        let done = Finished::of(command.current_dir(folder.path(".")).output().unwrap());
        assert_eq!(done.code(), 1, "{}", done.stderr());
        let rows = format!("{out}.{}", if out.ends_with(".csv") { "partial" } else { "rows" });
        let checkpoint = format!("{out}.checkpoint");
        let saved = [&checkpoint, &rows].map(|name| std::fs::read(folder.path(name)).unwrap());
        Self { folder, run, out, rows, saved, whole }
    }

    fn checkpoint(&self) -> String {
        format!("{}.checkpoint", self.out)
    }

    /// Resumes the run from these files.
    fn resume(&self, checkpoint: &[u8], rows: &[u8], more: &[&str]) -> Finished {
        let _ = std::fs::remove_file(self.folder.path(self.out));
        std::fs::write(self.folder.path(&self.checkpoint()), checkpoint).unwrap();
        std::fs::write(self.folder.path(&self.rows), rows).unwrap();
        let checkpoint = self.checkpoint();
        self.folder
            .heavytop(&[&["simulate", "--out", self.out, "--resume", &checkpoint], more].concat())
    }

    /// Checks that the files are refused in one line that says what is wrong and what to do, and stay as they are.
    fn assert_refused(&self, checkpoint: &[u8], rows: &[u8], reason: &str) {
        let run = self.resume(checkpoint, rows, &[]);
        let said = run.stderr();
        assert_eq!((run.code(), said.lines().count()), (2, 1), "{reason}: {said}");
        let beginning = format!("heavytop: cannot go on from {}: ", self.checkpoint());
        assert!(said.starts_with(&beginning) && said.contains(reason), "{reason}: {said}");
        assert!(said.ends_with("; start anew with --restart\n"), "{said}");
        let read = |name: &str| std::fs::read(self.folder.path(name)).unwrap();
        assert!(read(&self.checkpoint()) == checkpoint && read(&self.rows) == rows, "{reason}");
        assert!(!self.folder.path(self.out).exists(), "{reason}");
    }

    fn assert_same_bytes(&self, run: &Finished) {
        assert_eq!((run.code(), run.complaints()), (0, String::new()));
        assert!(std::fs::read(self.folder.path(self.out)).unwrap() == self.whole);
        assert_eq!(self.folder.names(), [self.out]);
    }
}

fn interrupted() -> [Interrupted; 5] {
    let (top, system): (&[&str], &[&str]) = (&RUN, &RUN_OF_SYSTEM);
    // CSV takes some 200 bytes for each row, the rows of the other formats 88; those of a system 100 and 48.
    [
        (top, "a.csv", 500),
        (top, "a.npz", 250),
        (top, "a.parquet", 250),
        (system, "b.csv", 250),
        (system, "b.npz", 130),
    ]
    .map(|(run, out, blocks)| Interrupted::new(run, out, blocks))
}

/// Returns about so many numbers from 0 to a length, the last three included.
fn sampled(length: usize, count: usize) -> impl Iterator<Item = usize> {
    (0..length).step_by(length.div_ceil(count)).chain(length - 3..length)
}

#[test]
#[ignore = "long"]
fn a_checkpoint_that_is_cut_or_altered_is_refused() {
    for run in interrupted() {
        let [checkpoint, rows] = &run.saved;
        for length in sampled(checkpoint.len(), 24) {
            run.assert_refused(&checkpoint[..length], rows, "damaged, or no checkpoint: ");
        }
        for (number, place) in sampled(checkpoint.len(), 32).enumerate() {
            let mut altered = checkpoint.clone();
            // Any bit, that of no ASCII character included.
            altered[place] ^= 1 << (number % 8);
            run.assert_refused(&altered, rows, "damaged, or no checkpoint: ");
        }
        let longer = [&checkpoint[..], b"\n"].concat();
        run.assert_refused(&longer, rows, "its checksum is not that of its contents");
        run.assert_same_bytes(&run.resume(checkpoint, rows, &[]));
    }
}

#[test]
#[ignore = "long"]
fn rows_that_are_cut_or_altered_are_refused_and_what_follows_the_checkpoint_does_not_matter() {
    for run in interrupted() {
        let [checkpoint, rows] = &run.saved;
        let text = std::str::from_utf8(checkpoint).unwrap();
        let marked = text.lines().find_map(|line| line.strip_prefix("bytes = ")).unwrap();
        let marked: usize = marked.parse().unwrap();
        assert!(marked > 1024 && marked < rows.len(), "{marked} of {}", rows.len());
        let foreign = "are not those that belong to it";
        for length in sampled(marked, 8) {
            run.assert_refused(checkpoint, &rows[..length], foreign);
        }
        for place in sampled(marked, 8) {
            let mut altered = rows.clone();
            altered[place] ^= 1;
            run.assert_refused(checkpoint, &altered, foreign);
        }
        for rest in [&rows[..marked], &[&rows[..marked], b"1,2,nonsense\xff"].concat()] {
            run.assert_same_bytes(&run.resume(checkpoint, rest, &[]));
        }
    }
}

/// Runs that differ from that of a top, and the difference.
const OTHERS: [(&[&str], &str); 5] = [
    (&["--preset", "lagrange"], "[body] center_of_mass: "),
    (&[RUN[0], RUN[1], "--set", "integrator.scheme=gauss-4"], "[integrator] scheme: "),
    (&[RUN[0], RUN[1], "--set", "integrator.step=0.01"], "[integrator] step: "),
    (&[RUN[0], RUN[1], "--set", "output.attitude=true"], "[output] attitude: "),
    (&RUN_OF_SYSTEM, "[system] hamiltonian: nothing against "),
];

/// Changes of the run of a system, and the difference.
const OTHER_SYSTEMS: [(&str, &str); 4] = [
    ("system.hamiltonian='Pi1^2'", "[system] hamiltonian: "),
    ("system.initial.Pi=[1.0,0.5,0.4]", "[system] initial: "),
    ("integrator.scheme=gauss-4", "[integrator] scheme: "),
    ("integrator.step=0.01", "[integrator] step: "),
];

#[test]
#[ignore = "long"]
fn a_checkpoint_of_another_run_is_refused() {
    for run in interrupted() {
        let [checkpoint, rows] = &run.saved;
        let others: Vec<(Vec<&str>, &str)> = if run.out.starts_with('a') {
            OTHERS.map(|(arguments, difference)| (arguments.to_vec(), difference)).into()
        } else {
            let changed = OTHER_SYSTEMS
                .map(|(set, difference)| ([run.run, &["--set", set]].concat(), difference));
            // A top, too.
            [&changed[..], &[(RUN.to_vec(), " against nothing")]].concat()
        };
        for (arguments, difference) in others {
            let refused = run.resume(checkpoint, rows, &arguments);
            let said = refused.stderr();
            assert_eq!((refused.code(), said.lines().count()), (2, 1), "{arguments:?}: {said}");
            let reason = "it is of another configuration: ";
            assert!(said.contains(reason) && said.contains(difference), "{arguments:?}: {said}");
            assert!(said.ends_with("; start anew with --restart\n"), "{said}");
        }
        // Control: of the same configuration it is accepted, though it is given again.
        run.assert_same_bytes(&run.resume(checkpoint, rows, run.run));
    }
}

/// A line of the checkpoint is missing or there twice, and the checksum is that of the lines that are there.
#[test]
#[ignore = "long"]
fn no_contents_of_a_checkpoint_make_the_program_panic() {
    let [of_top, _, _, of_system, _] = interrupted();
    [of_top, of_system].iter().for_each(leave_out_and_repeat);
}

/// Leaves out each line of a checkpoint, and repeats each.
fn leave_out_and_repeat(run: &Interrupted) {
    let [checkpoint, rows] = &run.saved;
    let contents = std::str::from_utf8(checkpoint).unwrap().split_once('\n').unwrap().1;
    let lines: Vec<_> = contents.lines().collect();
    let mut refused = 0;
    for (number, left_out) in lines.iter().enumerate() {
        for times in [0, 2] {
            let repeat = |(index, line): (usize, &&str)| {
                format!("{line}\n").repeat(if index == number { times } else { 1 })
            };
            let changed: String = lines.iter().enumerate().map(repeat).collect();
            let checksum = crc32fast::hash(changed.as_bytes());
            let sealed = format!("heavytop-checkpoint {checksum:08x}\n{changed}");
            let resumed = run.resume(sealed.as_bytes(), rows, &["--quiet"]);
            assert!([0, 2].contains(&resumed.code()), "{left_out}: {}", resumed.stderr());
            refused += usize::from(resumed.code() == 2);
        }
    }
    // What is left out of the configuration has its default, which is that of this run but for the end.
    assert!(refused > lines.len(), "{refused} of {}", 2 * lines.len());
}
