//! One attempt at a run: how it was disturbed, how it ended, and the most memory that it had.

use super::request::Request;
use crate::program::Folder;
use std::io::Read;
use std::os::unix::fs::MetadataExt;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, ExitStatus};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A signal that is sent to a run after some time.
#[derive(Clone, Copy, Debug)]
pub struct Disturbance {
    pub signal: i32,
    pub after: Duration,
}

/// How a process ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    Code(i32),
    Signal(i32),
}

/// A process that has ended.
#[derive(Debug)]
pub struct Attempt {
    pub outcome: Outcome,
    /// What it said on stderr.
    pub said: String,
    /// The most memory that it had at a time, KiB.
    pub peak: u64,
    pub took: Duration,
}

impl Attempt {
    /// Runs the program on a request, and sends it a signal.
    #[allow(clippy::zombie_processes)] // `wait` waits for it.
    pub fn make(
        folder: &Folder,
        request: &Request,
        beginning: &[String],
        disturbance: Option<Disturbance>,
    ) -> Self {
        let begun = Instant::now();
        let arguments = [&request.arguments(), beginning].concat();
        let mut child = folder.start(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
        if let Some(Disturbance { signal, after }) = disturbance {
            sleep(after);
            // A process that is over stays there until somebody asks how it ended, so its number is not another's.
            send(&child, signal);
        }
        let (status, peak) = wait(&child);
        let mut said = String::new();
        child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        let signal = || Outcome::Signal(status.signal().unwrap());
        let outcome = status.code().map_or_else(signal, Outcome::Code);
        Self { outcome, said, peak, took: begun.elapsed() }
    }
}

#[allow(unsafe_code)]
fn send(child: &Child, signal: i32) {
    // SAFETY: kill reads no memory; the process is a child that nobody has waited for.
    let sent = unsafe { libc::kill(child.id() as i32, signal) };
    assert_eq!(sent, 0, "{}", std::io::Error::last_os_error());
}

/// Waits for a process, and returns how it ended and the most memory that it had, KiB.
///
/// Linux counts what this process had when it started the other, so that the number may be too large.
#[allow(unsafe_code)]
fn wait(child: &Child) -> (ExitStatus, u64) {
    let mut status = 0;
    // SAFETY: a structure of integers, which wait4 fills.
    let mut usage: libc::rusage = unsafe { std::mem::zeroed() };
    // SAFETY: both pointers are valid during the call, and nobody else waits for the child.
    let waited = unsafe { libc::wait4(child.id() as i32, &raw mut status, 0, &raw mut usage) };
    assert_eq!(waited, child.id() as i32, "{}", std::io::Error::last_os_error());
    (ExitStatus::from_raw(status), usage.ru_maxrss as u64)
}

/// Returns the memory that this process has, KiB.
pub fn resident() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let resident = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap();
    resident.trim().trim_end_matches(" kB").parse().unwrap()
}

/// Returns the number of locks on files in the folder.
pub fn locks(folder: &Folder) -> usize {
    let inode = |name: &String| std::fs::metadata(folder.path(name)).unwrap().ino();
    let inodes: Vec<_> = folder.names().iter().map(inode).collect();
    // The sixth column is the device and the number of the file.
    let locked = |line: &&str| {
        let file = line.split_whitespace().nth(5).and_then(|file| file.rsplit(':').next());
        file.and_then(|file| file.parse().ok()).is_some_and(|file| inodes.contains(&file))
    };
    std::fs::read_to_string("/proc/locks").unwrap().lines().filter(locked).count()
}

#[test]
fn a_lock_is_counted() {
    let folder = Folder::new();
    folder.write("a", "");
    let file = std::fs::File::open(folder.path("a")).unwrap();
    assert_eq!(locks(&folder), 0);
    file.lock().unwrap();
    assert_eq!(locks(&folder), 1);
}
