//! The instruction set with the fastest steps, found by measurement: [`FastestSet`].

use lie_poisson::InstructionSet;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// The number of runs on each set, of which the fastest counts, since other work of the machine only adds to a time.
const ROUNDS: usize = 5;

/// The instruction set on which an integrator makes its steps: one that was asked for, or the fastest.
///
/// Which set is the fastest depends on whether the compiler inlined the formulas of the field into the code for its
/// registers, and nobody but the clock can tell. The measurement is made once, before the first step, so it is for
/// steps whose bits are the same on all sets.
#[derive(Clone, Debug)]
pub(crate) struct FastestSet {
    /// The set that was asked for, or the widest one of those to choose from.
    widest: InstructionSet,
    /// Whether there is a choice.
    chooses: bool,
    /// The set of the steps, once it is known.
    found: OnceLock<InstructionSet>,
}

impl FastestSet {
    /// Creates the choice of one set, without a measurement.
    pub(crate) fn given(set: InstructionSet) -> Self {
        Self { widest: set, chooses: false, found: OnceLock::from(set) }
    }

    /// Creates the choice of the fastest set that this processor has, up to the given one.
    pub(crate) fn up_to(widest: InstructionSet) -> Self {
        let widest = widest.min(InstructionSet::detected());
        Self { widest, chooses: true, found: OnceLock::new() }
    }

    /// Returns the set of the steps, or before the first one the widest of those to choose from.
    pub(crate) fn current(&self) -> InstructionSet {
        self.found.get().copied().unwrap_or(self.widest)
    }

    /// Returns the set of the steps. If it is not known, the runs of `trial` on each set are timed, provided that the
    /// motion `starts`: steps that fail say nothing.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn find(
        &self,
        starts: impl FnOnce() -> bool,
        trial: impl FnMut(InstructionSet),
    ) -> InstructionSet {
        match self.found.get() {
            Some(set) => *set,
            None if starts() => self.measure(trial),
            None => self.widest,
        }
    }

    #[cold]
    #[inline(never)]
    fn measure(&self, mut trial: impl FnMut(InstructionSet)) -> InstructionSet {
        *self.found.get_or_init(|| {
            let sets = InstructionSet::available().filter(|set| *set <= self.widest);
            let mut times: Vec<_> = sets.map(|set| (Duration::MAX, set)).collect();
            // There may be no clock where there is nothing to choose from.
            if times.len() > 1 {
                for _ in 0..ROUNDS {
                    for (best, set) in &mut times {
                        let clock = Instant::now();
                        trial(*set);
                        *best = clock.elapsed().min(*best);
                    }
                }
            }
            times.into_iter().min().map_or(InstructionSet::Portable, |(_, set)| set)
        })
    }
}

/// Two choices are equal if the same was asked for. What a measurement has found does not count.
impl PartialEq for FastestSet {
    fn eq(&self, other: &Self) -> bool {
        (self.widest, self.chooses) == (other.widest, other.chooses)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;
    use std::thread::sleep;

    /// The runs on one set take a hundredth of a second more than those on the others, a hundred times what these take.
    #[test]
    fn the_set_that_takes_the_least_time_is_found_once() {
        let sets: Vec<_> = InstructionSet::available().collect();
        for fast in &sets {
            let (choice, runs) = (FastestSet::up_to(InstructionSet::detected()), Cell::new(0));
            let trial = |set: InstructionSet| {
                runs.set(runs.get() + 1);
                sleep(Duration::from_millis(if set == *fast { 0 } else { 10 }));
            };
            assert_eq!(choice.find(|| false, trial), InstructionSet::detected());
            assert_eq!(choice.current(), InstructionSet::detected());
            assert_eq!(choice.find(|| true, trial), *fast);
            assert_eq!(choice.current(), *fast);
            let made = runs.get();
            assert_eq!(made, if sets.len() > 1 { ROUNDS * sets.len() } else { 0 });
            assert_eq!(choice.find(|| true, trial), *fast);
            assert_eq!(runs.get(), made);
            // A choice is the same one before and after it is made.
            assert_eq!(choice, FastestSet::up_to(InstructionSet::detected()));
            assert_ne!(choice, FastestSet::given(InstructionSet::detected()));
        }
    }

    #[test]
    fn a_set_that_was_asked_for_is_not_measured() {
        for set in InstructionSet::available() {
            assert_eq!(FastestSet::given(set).find(|| true, |set| unreachable!("{set}")), set);
            assert!(FastestSet::up_to(set).current() <= set);
        }
    }
}
