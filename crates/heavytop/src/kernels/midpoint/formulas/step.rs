//! One step: of one top in registers, or of a group of tops, one in each SIMD lane.

use super::components::TopState;
use super::guess::Guess;
use super::midpoint_parameters::MidpointParameters;
use super::register_vector::{MaskOf, RegisterVector};
use lie_poisson::{Mask, Real};

/// The number of guesses after which a lane counts as not converged.
const GUESSES: usize = 40;

/// The result of a step.
pub(super) struct Outcome<V: RegisterVector> {
    /// The end (Π₁, Γ₁), in the lanes that converged.
    pub end: TopState<V>,
    /// The solution a = (h/4) Ωₘ of the step.
    pub a: V,
    /// The lanes where a converged and the end is finite; the others have no result.
    pub converged: MaskOf<V>,
    /// The number of guesses, including the extrapolated one.
    pub guesses: usize,
}

/// Advances by one step from `start`, with a guess of a; without one, a = (h/4) I⁻¹Π₀.
///
/// Each lane stops by itself. A lane that has converged keeps its guess while others continue, so that repeated
/// computations from it give bit-identical results. The iteration does not wait for lanes in which `given_up` is true.
#[cfg_attr(optimised, inline(always))]
pub(super) fn step<V: RegisterVector>(
    top: &MidpointParameters<V, V::Scalar>,
    start: &TopState<V>,
    guess: Option<V>,
    given_up: MaskOf<V>,
) -> Outcome<V> {
    let number = V::Scalar::from_f64;
    let mut a = match guess {
        Some(a) => a,
        None => top.rate.times(start.momentum),
    };
    let mut previous = number(f64::INFINITY);
    let mut guesses = 1;
    loop {
        let guess = Guess::new(top, start, a);
        let mut converged = guess.converged(top);
        if !converged.or(given_up).all() {
            converged = converged.or(guess.stalled(top, previous));
            if guesses < GUESSES && !converged.or(given_up).all() {
                previous = V::Scalar::select(converged, previous, guess.change());
                a = V::select(converged, a, guess.corrected());
                guesses += 1;
                continue;
            }
        }
        let end = guess.end(start);
        let converged = converged.and(end.is_finite());
        return Outcome { end, a: guess.corrected(), converged, guesses };
    }
}
