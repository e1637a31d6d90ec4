//! Signals that ask the program to end.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// The time within which signals count as one: launchers send them to a process and to its group.
const TOGETHER: Duration = Duration::from_millis(500);

/// Returns the flag that Ctrl-C sets, and other signals that ask a program to end.
///
/// A second signal, later, ends the program at once.
pub(super) fn interrupted() -> &'static AtomicBool {
    static INTERRUPTED: AtomicBool = AtomicBool::new(false);
    let mut first: Option<Instant> = None;
    // Without a handler such a signal ends the program, as usual.
    let _ = ctrlc::set_handler(move || {
        if first.get_or_insert_with(Instant::now).elapsed() > TOGETHER {
            std::process::exit(130);
        }
        INTERRUPTED.store(true, Ordering::Relaxed);
    });
    &INTERRUPTED
}
