//! One top, step by step, with a memory of the steps before.

use super::Top;
use super::components::{State, each};
use super::extrapolation::Extrapolation;
use super::parameters::Parameters;
use super::step::step;
use collective_integrators::Step;
use lie_poisson::{InstructionSet, LaneTask, Lanes, Mask, Se3Dual, Width, dispatch};
use nalgebra::Vector3;

/// What one step leaves to the next of the same size, if that starts where it ended, bit for bit.
#[derive(Clone, Debug)]
pub(crate) struct Memory {
    past: Extrapolation<f64>,
    /// The top and the step size of the parameters.
    top: Option<(Top, f64)>,
    parameters: Parameters<f64>,
    /// Where the last step ended.
    end: State<f64>,
}

impl Memory {
    /// Remembers nothing.
    pub fn new() -> Self {
        Self {
            past: Extrapolation::new(),
            top: None,
            parameters: Parameters::gather(|_| Top::NONE, |_| 0.0, 0.0),
            end: State { momentum: [0.0; 3], vertical: [0.0; 3] },
        }
    }

    /// Forgets the steps before.
    pub fn forget(&mut self) {
        self.top = None;
    }

    /// a of the last step.
    pub fn newest(&self) -> Vector3<f64> {
        self.past.newest().into()
    }

    /// One step, and the number of guesses; none if a does not settle or the end is not finite.
    /// Then nothing is remembered.
    #[inline]
    pub fn step(
        &mut self,
        top: &Top,
        mu: &Se3Dual,
        step: f64,
        set: InstructionSet,
    ) -> Option<Step<Se3Dual>> {
        if self.top != Some((*top, step)) || self.end.lane(0) != *mu {
            let square = mu.0.1.norm_squared();
            self.parameters = Parameters::gather(|_| *top, |_| square, step);
            self.top = Some((*top, step));
            self.end = State::gather(|_| *mu);
            self.past = Extrapolation::new();
        }
        let iterations = dispatch(OneStep(self), set, Width::Single).ok()??;
        Some(Step { point: self.end.lane(0), iterations })
    }
}

/// A step from where the last one ended. What is computed waits for that alone, not for its way
/// through the caller.
struct OneStep<'a>(&'a mut Memory);

impl LaneTask for OneStep<'_> {
    type Output = Option<usize>;

    #[inline(always)]
    fn run<T: Lanes>(self) -> Self::Output {
        let Self(memory) = self;
        let guess = memory.past.predict(T::from_f64);
        let top = memory.parameters.splat::<T>();
        let outcome = step(&top, &memory.end.splat(), guess, T::Mask::from_bool(false));
        if !outcome.settled.all() {
            memory.forget();
            return None;
        }
        memory.past.push(each!(i => outcome.a[i].lane(0)));
        memory.end.momentum = each!(i => outcome.end.momentum[i].lane(0));
        memory.end.vertical = each!(i => outcome.end.vertical[i].lane(0));
        Some(outcome.guesses)
    }
}
