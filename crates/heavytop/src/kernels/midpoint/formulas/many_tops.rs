//! Many tops, a lane each.

use super::components::{Components, State};
use super::extrapolation::Extrapolation;
use super::parameters::Parameters;
use super::step::step;
use crate::HeavyTop;
use collective_integrators::CHECKPOINT;
use core::ops::Range;
use lie_poisson::{LaneTask, Lanes, Mask, Se3Dual};

/// One of many tops.
pub(crate) trait Member {
    /// (Π, Γ)
    fn state(&self) -> &Se3Dual;
    /// (Π, Γ), to be changed.
    fn state_mut(&mut self) -> &mut Se3Dual;
}

/// The steps of many tops, in groups of as many as there are lanes.
///
/// A top that comes to a step without result leaves its group, whose other lanes go on as if it
/// had not been there.
pub(crate) struct ManyTops<'a, M, F> {
    /// The top of a member.
    pub top: F,
    /// What is advanced.
    pub members: &'a mut [M],
    /// The size of a step.
    pub step: f64,
    /// The steps to make.
    pub steps: Range<u64>,
    /// Called for a member that leaves, in the state before the step that had no result, with its
    /// index and the number of steps made.
    pub left: &'a mut dyn FnMut(usize, u64, &mut M),
}

impl<M: Member, F: Fn(&M) -> HeavyTop> LaneTask for ManyTops<'_, M, F> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Self { top, members, step, steps, left } = self;
        let mut first = 0;
        for group in members.chunks_mut(T::COUNT) {
            let mut leave = |i: usize, made: u64, member: &mut M| left(first + i, made, member);
            advance::<T, M>(&top, group, step, steps.clone(), &mut leave);
            first += T::COUNT;
        }
    }
}

/// The steps of one group, of which lanes beyond the last member repeat it.
#[inline(always)]
fn advance<T: Lanes, M: Member>(
    top: &impl Fn(&M) -> HeavyTop,
    group: &mut [M],
    size: f64,
    steps: Range<u64>,
    leave: &mut dyn FnMut(usize, u64, &mut M),
) {
    let last = group.len() - 1;
    let mut state = State::<Components<T>>::gather(|i| *group[i.min(last)].state());
    let mut gone = T::Mask::from_bool(false);
    let mut made = steps.start;
    while made < steps.end && !gone.all() {
        let square = |i| state.lane(i).0.1.norm_squared();
        let parameters =
            Parameters::<Components<T>, T>::gather(|i| top(&group[i.min(last)]), square, size);
        let mut past = Extrapolation::<Components<T>>::new([T::from_f64(0.0); 3]);
        let until = (made - made % CHECKPOINT).saturating_add(CHECKPOINT).min(steps.end);
        while made < until {
            let outcome = step(&parameters, &state, past.predict(|a| *a), gone);
            if !outcome.settled.or(gone).all() {
                for (i, member) in group.iter_mut().enumerate() {
                    if !outcome.settled.or(gone).lane(i) {
                        *member.state_mut() = state.lane(i);
                        leave(i, made, member);
                    }
                }
                gone = gone.or(outcome.settled.not());
            }
            past.push(|place| *place = outcome.a);
            state = outcome.end;
            made += 1;
        }
    }
    for (i, member) in group.iter_mut().enumerate() {
        if !gone.lane(i) {
            *member.state_mut() = state.lane(i);
        }
    }
}
