//! The accuracy of a run, and the warning about it: [`RunAccuracy`].

use core::fmt;

/// How accurate a run is, as far as a repetition of its beginning with half the step shows.
///
/// Conserved quantities do not show it: a Poisson integrator conserves them with wrong motions, too.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RunAccuracy {
    /// The size of a step.
    pub step: f64,
    /// The order of the method.
    pub order: u16,
    /// The angle by which the fastest part of the motion turns in a step, rad.
    pub angle: f64,
    /// The estimated error, to two digits: the largest |Δμ_b|/|μ_b| over the blocks b of coordinates and over the run. 1
    /// means that nothing of the state is right. It is `None` if the repetition failed.
    pub error: Option<f64>,
    /// The time in which errors grow e-fold, if neighbouring motions part that fast and magnify rounding errors to more than
    /// [`MOST_ERROR`](Self::MOST_ERROR): then no step gives the state at the end.
    pub chaos: Option<f64>,
}

impl RunAccuracy {
    /// The largest angle of a step, rad, without a [warning](Self::warning).
    pub const MOST_ANGLE: f64 = 1.0;

    /// The largest error without a [warning](Self::warning).
    pub const MOST_ERROR: f64 = 1e-3;

    /// The number of e-folds by which rounding errors of 10⁻¹⁶ become 1.
    pub(super) const FOLDS: f64 = 37.0;

    /// Returns a warning in words if a step turns by more than 1 rad, or if the error is above 10⁻³. It is the same for
    /// every method and system, and ends without a full stop.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let Self { step, order, angle, error, chaos } = *self;
        let is_wrong = error.is_some_and(|error| error > Self::MOST_ERROR);
        let is_long = angle > Self::MOST_ANGLE;
        if !(is_wrong || is_long) {
            return None;
        }
        if let Some(time) = chaos.filter(|_| !is_long) {
            return Some(format!(
                "the motion is chaotic, or about an unstable rotation: errors grow e-fold in about {time:.1e}, so that beyond \
                 about {:.1e} no step gives the state, and with this one it may be wrong sooner; what does not depend on it, \
                 such as a section or an exponent, keeps its meaning",
                Self::FOLDS * time
            ));
        }
        let shorter = |share: f64| step.abs() * if share < 1.0 { share } else { 0.5 };
        let by_error = error.filter(|_| is_wrong).map_or(f64::INFINITY, |error| {
            shorter((Self::MOST_ERROR / error).powf(1.0 / f64::from(order.max(1))))
        });
        let by_angle = if is_long { shorter(Self::MOST_ANGLE / angle) } else { f64::INFINITY };
        let turn = format!("the motion turns by about {} rad in a step", Digits(angle));
        let compare = format!("compare with a step of {:.1e} or less", by_error.min(by_angle));
        Some(match error {
            Some(error) if error >= 1.0 => format!(
                "{turn}, and somewhere in the run nothing of the state is right; the invariants do not show it: {compare}"
            ),
            Some(error) if is_wrong => format!(
                "{turn}, and its relative error is about {error:.1e} somewhere in the run; the invariants do not show it: {compare}"
            ),
            Some(error) => format!(
                "{turn}; half the step gives the same state to {error:.1e} of its size, which may be chance: {compare}"
            ),
            None => format!("{turn}, and may be wrong; the invariants do not show it: {compare}"),
        })
    }
}

/// A number in two digits.
struct Digits(f64);

impl fmt::Display for Digits {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            small if small < 0.1 => write!(to, "{small:.1e}"),
            middle if middle < 10.0 => write!(to, "{middle:.1}"),
            large if large < 1e4 => write!(to, "{large:.0}"),
            huge => write!(to, "{huge:.1e}"),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn warning(angle: f64, error: Option<f64>) -> Option<String> {
        RunAccuracy { step: 0.1, order: 2, angle, error, chaos: None }.warning()
    }

    #[test]
    fn warnings_say_what_is_wrong_and_where() {
        for (angle, error, expected) in [
            (
                0.2,
                Some(1.0),
                "the motion turns by about 0.2 rad in a step, and somewhere in the run nothing of the state \
                              is right; the invariants do not show it: compare with a step of 3.2e-3 or less",
            ),
            (
                0.2,
                Some(0.1),
                "the motion turns by about 0.2 rad in a step, and its relative error is about 1.0e-1 \
                              somewhere in the run; the invariants do not show it: compare with a step of 1.0e-2 or less",
            ),
            (
                4.0,
                Some(1e-9),
                "the motion turns by about 4.0 rad in a step; half the step gives the same state to 1.0e-9 \
                               of its size, which may be chance: compare with a step of 2.5e-2 or less",
            ),
            (
                1.9e154,
                Some(0.0),
                "the motion turns by about 1.9e154 rad in a step; half the step gives the same state to \
                                  0.0e0 of its size, which may be chance: compare with a step of 5.3e-156 or less",
            ),
            (
                4.0,
                None,
                "the motion turns by about 4.0 rad in a step, and may be wrong; the invariants do not show it: \
                         compare with a step of 2.5e-2 or less",
            ),
        ] {
            assert_eq!(warning(angle, error).unwrap(), expected);
        }
        let chaotic =
            RunAccuracy { step: 0.1, order: 8, angle: 0.2, error: Some(1.0), chaos: Some(0.6) };
        assert_eq!(
            chaotic.warning().unwrap(),
            "the motion is chaotic, or about an unstable rotation: errors grow e-fold in about 6.0e-1, so that beyond about \
             2.2e1 no step gives the state, and with this one it may be wrong sooner; what does not depend on it, such as a \
             section or an exponent, keeps its meaning"
        );
        // Controls: short steps, and a small error.
        assert_eq!((warning(1.0, Some(1e-3)), warning(0.5, None)), (None, None));
    }
}
