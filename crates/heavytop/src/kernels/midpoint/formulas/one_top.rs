//! The steps of one top, each with the history of the earlier steps.

use super::components::TopState;
use super::extrapolation::Extrapolation;
use super::in_register::{InRegister, Stored, vector};
use super::midpoint_parameters::{MidpointParameters, numbers};
use super::step::step;
use crate::tops::top::HeavyTop;
use collective_integrators::Step;
use lie_poisson::{FourLanes, FourLanesTask, InstructionSet, Mask, Se3Dual, dispatch_four};
use nalgebra::Vector3;

/// The data that one step leaves for the next step, if that has the same size and continues from its end, bit for bit.
#[derive(Clone, Debug)]
pub(crate) struct GuessHistory {
    past: Extrapolation<Stored>,
    /// The numbers of the top and the step size for which `parameters` are computed.
    numbers: Option<[f64; 7]>,
    parameters: MidpointParameters<Stored, f64>,
    /// The point where the last step ended.
    end: TopState<Stored>,
}

impl GuessHistory {
    /// Creates an empty history.
    pub fn new(top: &HeavyTop) -> Self {
        Self {
            past: Extrapolation::new([0.0; 4]),
            numbers: None,
            parameters: MidpointParameters::stored(top, 0.0, 0.0),
            end: TopState { momentum: [0.0; 4], vertical: [0.0; 4] },
        }
    }

    /// Forgets the last steps.
    pub fn forget(&mut self) {
        self.numbers = None;
    }

    /// Returns a of the last step.
    pub fn newest(&self) -> Vector3<f64> {
        vector(self.past.newest())
    }

    /// Advances by one step, and returns the end with the number of guesses.
    ///
    /// Returns `None` if a does not converge or the end is not finite. The history is then empty.
    #[inline]
    pub fn step(
        &mut self,
        top: &HeavyTop,
        mu: &Se3Dual,
        step: f64,
        set: InstructionSet,
    ) -> Option<Step<Se3Dual>> {
        let numbers = numbers(top, step);
        let known = self.numbers.as_ref().is_some_and(|known| same(known, &numbers));
        if !(known && same(&self.end.numbers(), &TopState::of(mu).numbers())) {
            self.begin(top, mu, step);
        }
        let iterations = dispatch_four(OneStep(self), set).ok()??;
        Some(Step { point: self.end.point(), iterations })
    }

    /// Sets the history for a step from a new point.
    #[cold]
    fn begin(&mut self, top: &HeavyTop, mu: &Se3Dual, step: f64) {
        self.parameters = MidpointParameters::stored(top, mu.0.1.norm_squared(), step);
        self.numbers = Some(numbers(top, step));
        self.end = TopState::of(mu);
        self.past = Extrapolation::new([0.0; 4]);
    }
}

/// Returns whether all numbers are the same, bit for bit, without a branch for each.
#[inline]
fn same<const N: usize>(a: &[f64; N], b: &[f64; N]) -> bool {
    a.iter().zip(b).fold(0, |different, (a, b)| different | (a.to_bits() ^ b.to_bits())) == 0
}

/// A step from the end of the last one, which is read from the history and not from the caller, so that the
/// computation waits for nothing else.
struct OneStep<'a>(&'a mut GuessHistory);

impl FourLanesTask for OneStep<'_> {
    type Output = Option<usize>;

    #[cfg_attr(optimised, inline(always))]
    fn run<T: FourLanes>(self) -> Self::Output {
        let Self(history) = self;
        let top = history.parameters.load::<T>();
        let start = TopState {
            momentum: InRegister::<T>::load(&history.end.momentum),
            vertical: InRegister::load(&history.end.vertical),
        };
        let guess = history.past.predict(InRegister::load);
        let outcome = step(&top, &start, guess, T::Mask::from_bool(false));
        if !outcome.converged.all() {
            history.forget();
            return None;
        }
        history.past.push(|place| outcome.a.store(place));
        outcome.end.momentum.store(&mut history.end.momentum);
        outcome.end.vertical.store(&mut history.end.vertical);
        Some(outcome.guesses)
    }
}
