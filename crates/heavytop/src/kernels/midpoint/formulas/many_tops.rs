//! The steps of many tops, one in each SIMD lane.

use super::components::{Components, TopState};
use super::extrapolation::Extrapolation;
use super::midpoint_parameters::MidpointParameters;
use super::step::step;
use crate::tops::top::HeavyTop;
use collective_integrators::LaneResults;
use lie_poisson::{Lanes, Mask, Se3Dual};

/// A member of a batch of tops, with its state.
pub(crate) trait Member {
    /// Returns the state (Π, Γ).
    fn state(&self) -> &Se3Dual;
    /// Returns the state (Π, Γ) for changes.
    fn state_mut(&mut self) -> &mut Se3Dual;
}

/// Advances a group of tops by `count` steps, and returns where every step has a result.
///
/// Lanes beyond the last member repeat it. The iteration does not wait for a lane in which a step has no
/// result.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn together<T: Lanes, M: Member>(
    top: impl Fn(&M) -> HeavyTop,
    group: &mut [M],
    size: f64,
    count: u64,
) -> LaneResults {
    let last = group.len() - 1;
    let mut state = TopState::<Components<T>>::gather(|i| *group[i.min(last)].state());
    let square = |i: usize| group[i.min(last)].state().0.1.norm_squared();
    let parameters =
        MidpointParameters::<Components<T>, T>::gather(|i| top(&group[i.min(last)]), square, size);
    let mut past = Extrapolation::<Components<T>>::new([T::from_f64(0.0); 3]);
    let mut gone = T::Mask::from_bool(false);
    for _ in 0..count {
        let outcome = step(&parameters, &state, past.predict(|a| *a), gone);
        gone = gone.or(outcome.converged.not());
        if gone.all() {
            break;
        }
        past.push(|place| *place = outcome.a);
        state = outcome.end;
    }
    let mut results = LaneResults::default();
    for (i, member) in group.iter_mut().enumerate() {
        *member.state_mut() = state.lane(i);
        results[i] = !gone.lane(i);
    }
    results
}
