//! Signals that ask the program to end.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Signals that come together are one: launchers send them to a process and to its group.
const TOGETHER: Duration = Duration::from_millis(500);

/// What Ctrl-C, and the signals that ask a program to end, make true. A second one, later, ends it at
/// once.
pub(super) fn interrupted() -> &'static AtomicBool {
    static INTERRUPTED: AtomicBool = AtomicBool::new(false);
    let mut first: Option<Instant> = None;
    // Where there is no handler such a signal ends the program, as ever.
    let _ = ctrlc::set_handler(move || {
        if first.get_or_insert_with(Instant::now).elapsed() > TOGETHER {
            std::process::exit(130);
        }
        INTERRUPTED.store(true, Ordering::Relaxed);
    });
    &INTERRUPTED
}
