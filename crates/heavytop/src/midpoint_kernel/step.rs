//! One step of a group of tops, a lane each.

use super::components::{Components, State, each};
use super::guess::Guess;
use super::parameters::Parameters;
use lie_poisson::{Lanes, Mask};

/// Guesses after which a lane counts as not settled.
const GUESSES: usize = 40;

/// What a step came to.
pub(super) struct Outcome<T: Lanes> {
    /// (Π₁, Γ₁), in the lanes that settled.
    pub end: State<T>,
    /// a
    pub a: Components<T>,
    /// Where a settled and the end is finite; elsewhere there is no result.
    pub settled: T::Mask,
    /// How many guesses it took, the extrapolated one included.
    pub guesses: usize,
}

/// One step from `start`, with a guess of a; without one, a = (h/4) I⁻¹Π₀.
///
/// Each lane stops by itself: a lane that has settled keeps its guess while others go on, and
/// everything computed from that is the same again, bit for bit. Lanes in which `given_up` is true
/// are not waited for.
#[inline(always)]
pub(super) fn step<T: Lanes>(
    top: &Parameters<T>,
    start: &State<T>,
    guess: Option<Components<T>>,
    given_up: T::Mask,
) -> Outcome<T> {
    let mut a = match guess {
        Some(a) => a,
        None => each!(i => (top.rate[i] + top.rate[i]) * start.momentum[i]),
    };
    let mut previous = T::from_f64(f64::INFINITY);
    let mut guesses = 1;
    loop {
        let guess = Guess::new(top, start, a);
        let mut settled = guess.settled(top);
        if !settled.or(given_up).all() {
            settled = settled.or(guess.stalled(top, previous));
            if guesses < GUESSES && !settled.or(given_up).all() {
                let change = guess.change();
                previous = T::select(settled, previous, change);
                a = keep(settled, &a, &guess.corrected());
                guesses += 1;
                continue;
            }
        }
        let end = guess.end(start);
        let settled = settled.and(end.square().at_most(T::from_f64(f64::MAX)));
        return Outcome { end, a: guess.corrected(), settled, guesses };
    }
}

/// `kept` where the mask is true, `new` elsewhere.
#[inline(always)]
fn keep<T: Lanes>(mask: T::Mask, kept: &Components<T>, new: &Components<T>) -> Components<T> {
    each!(i => T::select(mask, kept[i], new[i]))
}
