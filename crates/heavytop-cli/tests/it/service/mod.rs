//! The program as a service uses it: very many runs in one folder, many at a time, some of which are interrupted.
#![cfg(target_os = "linux")]

mod attempt;
mod growth;
mod request;

use crate::program::{Folder, is_about_accuracy};
use attempt::{Attempt, Disturbance, Outcome};
use growth::Growth;
use heavytop_cli::commands::simulate::{SimulateOptions, simulate};
use heavytop_cli::configuration::Config;
use request::{Random, Request};
use std::collections::BTreeMap;
use std::ops::AddAssign;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::Instant;

/// How often a run is disturbed at most, so that each ends.
const MOST_DISTURBANCES: usize = 20;

/// The service: its folder, and the bytes that each kind of run makes when nothing disturbs it.
struct Service {
    folder: Folder,
    references: Vec<Vec<u8>>,
    /// The time that a run takes, on the average of the last ones, µs.
    typical: AtomicU64,
}

/// What became of the attempts.
#[derive(Debug, Default)]
struct Tally {
    attempts: u64,
    /// The number of attempts by how they ended.
    ends: BTreeMap<Outcome, u64>,
    resumed: u64,
    /// The number of checkpoints whose rows had become the output already when the run was killed.
    finished: u64,
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.attempts += other.attempts;
        self.resumed += other.resumed;
        self.finished += other.finished;
        other.ends.into_iter().for_each(|(end, count)| *self.ends.entry(end).or_default() += count);
    }
}

impl Service {
    fn new() -> Self {
        let (folder, begun) = (Folder::new(), Instant::now());
        let reference = |kind: usize| {
            let request = Request { kind, number: 0 };
            let run = Attempt::make(&folder, &request, &[], None);
            let is_silent = run.said.lines().all(is_about_accuracy);
            assert_eq!((run.outcome, is_silent), (Outcome::Code(0), true), "{request:?} {run:?}");
            let bytes = std::fs::read(folder.path(&request.out())).unwrap();
            std::fs::remove_file(folder.path(&request.out())).unwrap();
            bytes
        };
        let references: Vec<_> = (0..Request::KINDS).map(reference).collect();
        let typical = begun.elapsed().as_micros() as u64 / references.len() as u64;
        Self { folder, references, typical: typical.into() }
    }

    /// Makes a run, and makes it again until nothing disturbs it; returns its peak of memory (KiB) as well.
    fn serve(&self, request: Request, random: &mut Random) -> (Tally, u64) {
        let (mut tally, mut restart) = (Tally::default(), false);
        loop {
            let is_resumed = self.folder.path(&request.checkpoint()).exists() && !restart;
            let mut disturbance = random.disturbance(self.typical.load(Ordering::Relaxed));
            if tally.attempts as usize >= MOST_DISTURBANCES {
                disturbance = None;
            }
            let beginning = if restart {
                vec!["--restart".into()]
            } else if is_resumed {
                vec!["--resume".into()]
            } else {
                Vec::new()
            };
            let attempt = Attempt::make(&self.folder, &request, &beginning, disturbance);
            tally.attempts += 1;
            *tally.ends.entry(attempt.outcome).or_default() += 1;
            tally.resumed += u64::from(is_resumed && attempt.outcome == Outcome::Code(0));
            restart = match attempt.outcome {
                Outcome::Code(0) => {
                    self.assert_complete(&request);
                    if disturbance.is_none() {
                        self.renew(&attempt);
                    }
                    return (tally, attempt.peak);
                }
                // A run that was killed after it gave the output its name, and before it removed its checkpoint.
                Outcome::Code(2) if is_resumed => {
                    assert!(attempt.said.ends_with("; start anew with --restart\n"), "{attempt:?}");
                    self.assert_complete(&request);
                    tally.finished += 1;
                    true
                }
                _ => {
                    self.assert_interrupted(&request, &attempt, disturbance);
                    false
                }
            };
        }
    }

    /// Checks that the output is that of an undisturbed run.
    fn assert_complete(&self, request: &Request) {
        let bytes = std::fs::read(self.folder.path(&request.out())).unwrap();
        assert!(bytes == self.references[request.kind], "{request:?}");
    }

    /// Checks that a run has ended as it was asked to, and has left no part of an output under its name.
    fn assert_interrupted(
        &self,
        request: &Request,
        attempt: &Attempt,
        disturbance: Option<Disturbance>,
    ) {
        let signal =
            disturbance.unwrap_or_else(|| panic!("{request:?} failed: {attempt:?}")).signal;
        match attempt.outcome {
            Outcome::Code(130) => {
                let expected = "interrupted; go on by the same command with --resume\n";
                assert!(attempt.said.ends_with(expected), "{attempt:?}");
                assert!(self.folder.path(&request.checkpoint()).exists(), "{attempt:?}");
            }
            // A signal to a program that is not yet ready for it ends it, as it does every program.
            outcome => assert_eq!(outcome, Outcome::Signal(signal), "{request:?}: {attempt:?}"),
        }
        if self.folder.path(&request.out()).exists() {
            self.assert_complete(request);
        }
    }

    fn renew(&self, attempt: &Attempt) {
        let average = |old| Some((7 * old + attempt.took.as_micros() as u64) / 8);
        let _ = self.typical.fetch_update(Ordering::Relaxed, Ordering::Relaxed, average);
    }

    /// Serves all requests, so many at a time, and checks that nothing is lost and nothing left behind.
    fn serve_all(&self, count: u64, at_a_time: usize) -> (Tally, Growth) {
        let (next, total) = (AtomicU64::new(0), Mutex::new((Tally::default(), Growth::default())));
        let work = || {
            loop {
                let number = next.fetch_add(1, Ordering::Relaxed);
                if number >= count {
                    return;
                }
                let mut random = Random::new(number);
                let request =
                    Request { kind: random.below(Request::KINDS as u64) as usize, number };
                let (tally, peak) = self.serve(request, &mut random);
                let mut total = total.lock().unwrap();
                total.0 += tally;
                total.1.add(request.kind, number, peak);
            }
        };
        thread::scope(|scope| (0..at_a_time).for_each(|_| _ = scope.spawn(work)));
        let request = |number| {
            let kind = Random::new(number).below(Request::KINDS as u64) as usize;
            Request { kind, number }
        };
        let mut names: Vec<_> = (0..count).map(|number| request(number).out()).collect();
        names.sort();
        assert!(self.folder.names() == names, "something was left, or lost");
        (0..count).for_each(|number| self.assert_complete(&request(number)));
        assert_eq!(attempt::locks(&self.folder), 0, "a file is locked");
        total.into_inner().unwrap()
    }
}

#[test]
#[ignore = "a fault, which .ci/run makes"]
fn runs_at_a_time_with_kills_lose_nothing_and_leave_nothing() {
    let (tally, _) = Service::new().serve_all(48, 8);
    // Control: some were disturbed, and some resumed.
    assert!(tally.attempts > 48 && tally.resumed > 0, "{tally:?}");
}

#[test]
#[ignore = "takes minutes"]
fn ten_thousand_runs_64_at_a_time_with_kills_lose_nothing_and_leave_nothing() {
    let begun = Instant::now();
    let (tally, growth) = Service::new().serve_all(10_000, 64);
    println!("{:.0} s; {tally:#?}; {growth}", begun.elapsed().as_secs_f64());
    growth.assert_flat();
}

/// Runs in one process, one after the other; memory, open files and threads stay as many.
fn in_a_row(count: u64) -> Growth {
    let (folder, mut growth) = (Folder::new(), Growth::default());
    let mut config = Config::default();
    config.integrator.end = Some(4.0);
    let open = || {
        ["fd", "task"].map(|name| std::fs::read_dir(format!("/proc/self/{name}")).unwrap().count())
    };
    let mut before = None;
    for number in 0..count {
        let out = folder.path(["a.csv", "a.npz", "a.parquet"][number as usize % 3]);
        simulate(&config, &out, &SimulateOptions::default()).unwrap();
        // The first runs fill the caches of the allocator, and each measurement itself takes memory.
        if number >= count / 10 && number.is_multiple_of(100) {
            before.get_or_insert_with(open);
            growth.add(0, number, attempt::resident());
        }
    }
    assert_eq!(before, Some(open()), "open files and threads");
    assert_eq!(folder.names(), ["a.csv", "a.npz", "a.parquet"]);
    growth
}

#[test]
#[ignore = "measures the memory of the process, in which no other test may run"]
fn ten_thousand_runs_in_a_row_need_no_more_memory() {
    let growth = in_a_row(10_000);
    println!("{growth}");
    growth.assert_flat();
}
