//! How far the starts of a section are followed.

/// The steps and the returns of each start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::commands::section) struct Limits {
    /// The time step, s, negative if the starts are followed backward in time.
    pub step: f64,
    /// The time for which a start is followed at most, up to a step, s.
    pub longest: f64,
    /// The number of steps for each start.
    pub steps: usize,
    /// The number of returns of each start.
    pub crossings: usize,
    /// The number of starts.
    pub starts: usize,
    /// The seed of the random choice of starts.
    pub seed: u64,
}
