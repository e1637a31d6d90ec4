//! Computing times and errors of the integrators of tops: [`Contest`].

mod problem;
mod clock;
mod contestants;

pub use clock::TimedRun;
pub use contestants::Contest;
pub use problem::{EARLY, TimedProblem};
