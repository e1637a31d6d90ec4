//! One step of one top in registers, or of a group of tops, a lane each.

use super::components::State;
use super::guess::Guess;
use super::parameters::Parameters;
use super::vector::{MaskOf, Vector};
use lie_poisson::{Mask, Real};

/// Guesses after which a lane counts as not settled.
const GUESSES: usize = 40;

/// What a step came to.
pub(super) struct Outcome<V: Vector> {
    /// (Π₁, Γ₁), in the lanes that settled.
    pub end: State<V>,
    /// a
    pub a: V,
    /// Where a settled and the end is finite; elsewhere there is no result.
    pub settled: MaskOf<V>,
    /// How many guesses it took, the extrapolated one included.
    pub guesses: usize,
}

/// One step from `start`, with a guess of a; without one, a = (h/4) I⁻¹Π₀.
///
/// Each lane stops by itself: a lane that has settled keeps its guess while others go on, and
/// everything computed from that is the same again, bit for bit. Lanes in which `given_up` is true
/// are not waited for.
#[inline(always)]
pub(super) fn step<V: Vector>(
    top: &Parameters<V, V::Scalar>,
    start: &State<V>,
    guess: Option<V>,
    given_up: MaskOf<V>,
) -> Outcome<V> {
    let number = V::Scalar::from_f64;
    let mut a = match guess {
        Some(a) => a,
        None => top.rate.times(V::uniform(number(0.5))).times(start.momentum),
    };
    let mut previous = number(f64::INFINITY);
    let mut guesses = 1;
    loop {
        let guess = Guess::new(top, start, a);
        let mut settled = guess.settled(top);
        if !settled.or(given_up).all() {
            settled = settled.or(guess.stalled(top, previous));
            if guesses < GUESSES && !settled.or(given_up).all() {
                previous = V::Scalar::select(settled, previous, guess.change());
                a = V::select(settled, a, guess.corrected());
                guesses += 1;
                continue;
            }
        }
        let end = guess.end(start);
        let settled = settled.and(end.square().at_most(number(f64::MAX)));
        return Outcome { end, a: guess.corrected(), settled, guesses };
    }
}
