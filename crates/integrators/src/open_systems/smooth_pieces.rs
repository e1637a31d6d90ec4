//! The parts of a step in which a field is smooth: [`smooth_pieces`].

use crate::error::StepError;
use lie_poisson::{Mask, Real};

/// The part of a step by which a time may miss a breakpoint and still count as the breakpoint.
const SLACK: f64 = 1e-9;

/// The times at which a field may be evaluated in a part of a step, so that no stage sees the other side of a breakpoint.
#[derive(Clone, Copy, Debug)]
pub struct Window<T>(Option<(T, T)>);

impl<T: Real> Window<T> {
    /// The window of all times.
    pub const ALL: Self = Self(None);

    /// Returns the time in the window that is nearest to a time.
    #[cfg_attr(optimised, inline(always))]
    #[must_use]
    pub fn nearest(&self, time: T) -> T {
        let Some((first, last)) = self.0 else { return time };
        let late = T::select(first.at_most(time), time, first);
        T::select(late.at_most(last), late, last)
    }
}

/// Divides the step from a time at the breakpoints of a field. `next_break` returns the next one strictly after a time, or strictly
/// before it. Calls `piece` for each part with its window, the time since the beginning of the step, and its size. Returns the
/// sum of what it returns.
///
/// # Errors
/// That of the part that fails; [`StepError::BreakpointsApart`] if the step would be divided at different places in different
/// lanes, since then no division is that of each lane alone.
#[cfg_attr(optimised, inline(always))]
pub(super) fn smooth_pieces<T: Real>(
    time: T,
    step: f64,
    next_break: impl Fn(f64, bool) -> Option<f64>,
    mut piece: impl FnMut(Window<T>, f64, f64) -> Result<usize, StepError>,
) -> Result<usize, StepError> {
    let (mut elapsed, mut iterations) = (0.0, 0);
    loop {
        let Part { window, size, is_last } = next_part(time, step, elapsed, &next_break)?;
        // In wide registers the field has to be called at one place, to be inlined there.
        iterations += piece(window, elapsed, size)?;
        if is_last {
            return Ok(iterations);
        }
        elapsed += size;
    }
}

/// A part of a step.
struct Part<T> {
    window: Window<T>,
    size: f64,
    is_last: bool,
}

/// Returns the part of a step that begins so long after its beginning.
#[inline]
fn next_part<T: Real>(
    time: T,
    step: f64,
    elapsed: f64,
    next_break: &impl Fn(f64, bool) -> Option<f64>,
) -> Result<Part<T>, StepError> {
    let forward = step >= 0.0;
    let slack = SLACK * step.abs();
    let beyond = slack.copysign(step);
    // Without a breakpoint from here on, as of most fields, there is nothing to divide.
    if elapsed == 0.0
        && first_breaks(time, 0.0, &|time| next_break(time - beyond, forward)).0 == f64::INFINITY
    {
        return Ok(Part { window: Window::ALL, size: step, is_last: true });
    }
    let left = (step - elapsed).abs();
    let (distance, most) = first_breaks(time, elapsed, &|time| next_break(time + beyond, forward));
    let is_last = distance + slack >= left;
    if !is_last && distance < most {
        return Err(StepError::BreakpointsApart { first: distance, last: most });
    }
    let size = if is_last { step - elapsed } else { distance.copysign(step) };
    let window = window(time, (elapsed, elapsed + size), slack, next_break);
    Ok(Part { window, size, is_last })
}

/// Returns the shortest and the longest distance in any lane from a time after `elapsed` to the next breakpoint; ∞ if there is
/// none.
#[inline]
fn first_breaks<T: Real>(
    time: T,
    elapsed: f64,
    next_break: &impl Fn(f64) -> Option<f64>,
) -> (f64, f64) {
    let (mut shortest, mut longest) = (f64::INFINITY, 0.0_f64);
    let _ = time.lane_by_lane(time, |time, _| {
        let now = time + elapsed;
        let distance = next_break(now).map_or(f64::INFINITY, |next| (next - now).abs());
        (shortest, longest) = (shortest.min(distance), longest.max(distance));
        distance
    });
    (shortest, longest)
}

/// Returns the window of the part of a step between two times after its beginning.
fn window<T: Real>(
    time: T,
    (from, to): (f64, f64),
    slack: f64,
    next_break: &impl Fn(f64, bool) -> Option<f64>,
) -> Window<T> {
    let (earlier, later) = (from.min(to), from.max(to));
    let near = |now: f64| next_break(now - slack, true).filter(|next| *next <= now + slack);
    let first =
        time.lane_by_lane(time, |time, _| near(time + earlier).unwrap_or(f64::NEG_INFINITY));
    // Fields have the value of the later side at a breakpoint.
    let last =
        time.lane_by_lane(time, |time, _| near(time + later).map_or(f64::INFINITY, f64::next_down));
    let all = T::from_f64(f64::INFINITY);
    match first.at_most(-all).all() && all.at_most(last).all() {
        true => Window::ALL,
        false => Window(Some((first, last))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the parts of a step with breakpoints at whole numbers.
    fn pieces(time: f64, step: f64) -> Vec<(f64, f64, f64, f64)> {
        let whole = |time: f64, forward: bool| match forward {
            true => Some(time.floor() + 1.0),
            false => Some(time.ceil() - 1.0),
        };
        let mut pieces = Vec::new();
        let made = smooth_pieces(time, step, whole, |window: Window<f64>, elapsed, size| {
            let begin = time + elapsed;
            pieces.push((elapsed, size, window.nearest(begin), window.nearest(begin + size)));
            Ok(1)
        });
        assert_eq!(made, Ok(pieces.len()));
        pieces
    }

    #[test]
    fn no_part_straddles_a_breakpoint() {
        let below = |x: f64| x.next_down();
        assert_eq!(pieces(0.25, 0.5), [(0.0, 0.5, 0.25, 0.75)]);
        assert_eq!(pieces(0.75, 0.5), [(0.0, 0.25, 0.75, below(1.0)), (0.25, 0.25, 1.0, 1.25)]);
        assert_eq!(pieces(0.0, 2.0), [(0.0, 1.0, 0.0, below(1.0)), (1.0, 1.0, 1.0, below(2.0))]);
        assert_eq!(pieces(1.25, -0.5), [(0.0, -0.25, 1.25, 1.0), (-0.25, -0.25, below(1.0), 0.75)]);
        // Rounding errors of a time make no short parts.
        let late = pieces(1.0 - 1e-13, 1.0);
        assert!(late.len() == 1 && late[0].2 == 1.0 && late[0].3 < 2.0);
        let early = pieces(1.0 + 1e-13, 1.0);
        assert_eq!((early.len(), early[0].3), (1, below(2.0)));
    }
}
