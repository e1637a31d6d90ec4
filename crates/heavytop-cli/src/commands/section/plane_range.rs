//! The part of the plane of a section that its picture shows: [`PlaneRange`].

use crate::configuration::PlaneLimits;
use crate::pictures::{Axis, Scale};
use std::f64::consts::TAU;

/// The number of parts of a turn in which points are looked for.
const PARTS: usize = 360;

/// The part of a turn that must be without points, in one piece, for the picture to leave it out.
const LEAST_GAP: f64 = 0.2;

/// The largest number of intervals between ticks.
const INTERVALS: u32 = 6;

/// The part of the plane of a section that its picture shows: that of `[section] limits`, and along an axis without
/// limits that of all points.
///
/// The picture of an abscissa that is an angle shows a turn from 0, or the arc with the points, if that is shorter.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PlaneRange {
    limits: PlaneLimits,
    is_angle: bool,
    /// The extremes of x and of y.
    extremes: [[f64; 2]; 2],
    /// Whether there are points in the parts of a turn.
    parts: Vec<bool>,
    /// The number of points outside of the limits.
    pub outside: usize,
}

impl PlaneRange {
    /// Creates the range of no points.
    pub fn new(limits: PlaneLimits, is_angle: bool) -> Self {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let parts = vec![false; if is_angle { PARTS } else { 0 }];
        Self { limits, is_angle, extremes: [nothing; 2], parts, outside: 0 }
    }

    /// Includes a point; one outside of the limits counts as such.
    pub fn include(&mut self, [x, y]: [f64; 2]) {
        let is_inside = |value: f64, ends: Option<[f64; 2]>| {
            ends.is_none_or(|[from, to]| (from..=to).contains(&value))
        };
        let from = self.limits.x.map(|[from, _]| from);
        let x = from.filter(|_| self.is_angle).map_or(x, |from| turned(x, from));
        if !(is_inside(x, self.limits.x) && is_inside(y, self.limits.y)) {
            self.outside += 1;
            return;
        }
        for (extremes, value) in self.extremes.iter_mut().zip([x, y]) {
            *extremes = [extremes[0].min(value), extremes[1].max(value)];
        }
        let part = (turned(x, 0.0) / TAU * PARTS as f64) as usize;
        // An angle just below 0 is rounded to a whole turn.
        if let Some(part) = self.parts.get_mut(part % PARTS) {
            *part = true;
        }
    }

    /// Returns the ordinate.
    pub fn ordinate(&self) -> Axis {
        match self.limits.y {
            Some([from, to]) => Axis::new(from, to, INTERVALS),
            None => Axis::around(self.extremes[1].into_iter(), INTERVALS),
        }
    }

    /// Returns the abscissa of this length, as a multiple of the size of its labels, and its scale.
    pub fn abscissa(&self, title: &str, length: f64) -> (Abscissa, Scale) {
        let arc = self.is_angle.then(|| self.arc());
        let axis = match (self.limits.x.or(arc.flatten()), arc) {
            (Some([from, to]), _) => Axis::along_line(from, to, INTERVALS, length),
            (None, None) => {
                Axis::around_along_line(self.extremes[0].into_iter(), INTERVALS, length)
            }
            (None, Some(_)) => {
                let labels = ["0", "π/2", "π", "3π/2", "2π"].into_iter().map(String::from);
                let ticks = [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().zip(labels).collect();
                let abscissa = Abscissa { axis: Axis::new(0.0, TAU, INTERVALS), turn: Some(0.0) };
                return (abscissa, Scale { ticks, title: title.into(), ..Scale::default() });
            }
        };
        let scale = Scale::linear(&axis, title, false);
        let turn = self.limits.x.or(arc.flatten()).filter(|_| self.is_angle);
        (Abscissa { axis, turn: turn.map(|[from, _]| from) }, scale)
    }

    /// Returns the arc that has all points, with some room, if it leaves out enough of the turn. It begins between −2π and
    /// 2π.
    fn arc(&self) -> Option<[f64; 2]> {
        let first = self.parts.iter().position(|part| *part)?;
        let (mut gap, mut longest) = (0, (0, 0));
        // The last part is the first one again, a turn later.
        for index in first + 1..=first + PARTS {
            match self.parts.get(index % PARTS).copied().unwrap_or(false) {
                true => gap = 0,
                false => gap += 1,
            }
            if gap > longest.0 {
                longest = (gap, index + 1);
            }
        }
        let (gap, end) = longest;
        let turn = |parts: f64| TAU * parts / PARTS as f64;
        let (from, size) = (end as f64, (PARTS - gap) as f64);
        let room = 0.05 * size.max(1.0);
        (gap as f64 >= LEAST_GAP * PARTS as f64).then(|| {
            // An arc across 0 begins below it.
            let from = if from + size > PARTS as f64 { from - PARTS as f64 } else { from };
            [turn(from - room), turn(from + size + room)]
        })
    }
}

/// The abscissa of a section.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Abscissa {
    axis: Axis,
    /// Where the turn begins, if x is an angle.
    turn: Option<f64>,
}

impl Abscissa {
    /// Returns the place of x: from 0 to 1 inside of the axis.
    pub fn along(&self, x: f64) -> f64 {
        self.axis.along(self.turn.map_or(x, |from| turned(x, from)))
    }
}

/// Returns the angle that differs by whole turns and is at least `from`, less than a turn above it.
fn turned(angle: f64, from: f64) -> f64 {
    from + (angle - from).rem_euclid(TAU)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn range(limits: PlaneLimits, angles: &[f64]) -> PlaneRange {
        let mut range = PlaneRange::new(limits, true);
        angles.iter().for_each(|x| range.include([*x, *x]));
        range
    }

    #[test]
    fn an_angle_shows_the_arc_with_points_or_the_whole_turn() {
        let labels = |range: &PlaneRange| {
            let (_, scale) = range.abscissa("angle (rad)", 30.0);
            scale.ticks.into_iter().map(|(_, label)| label).collect::<Vec<_>>()
        };
        let spread: Vec<f64> = (0..60).map(|n| TAU * f64::from(n) / 60.0).collect();
        assert_eq!(
            labels(&range(PlaneLimits::default(), &spread)),
            ["0", "π/2", "π", "3π/2", "2π"]
        );
        // An angle that is rounded to a whole turn is at 0.
        assert_eq!(
            range(PlaneLimits::default(), &[-1e-17]).parts.iter().position(|part| *part),
            Some(0)
        );
        // Points on both sides of 0 are together.
        let across = range(PlaneLimits::default(), &[6.1, 6.2, 0.0, 0.3]);
        let [from, to] = across.arc().unwrap();
        assert!((-0.25..-0.18).contains(&from) && (0.3..0.35).contains(&to), "{from} {to}");
        let (abscissa, _) = across.abscissa("angle (rad)", 30.0);
        for (x, y) in [(6.1, 0.3), (0.0, 6.2)] {
            assert!([x, y].iter().all(|x| (0.0..=1.0).contains(&abscissa.along(*x))));
        }
        assert!(abscissa.along(6.2) < abscissa.along(0.0));
        // One point, and none.
        assert!(range(PlaneLimits::default(), &[1.0]).arc().is_some());
        assert_eq!(labels(&range(PlaneLimits::default(), &[])).len(), 5);
    }

    #[test]
    fn points_outside_of_the_limits_are_counted_and_do_not_widen_the_other_axis() {
        let limits = PlaneLimits { x: Some([-1.0, 1.0]), y: None };
        let all = range;
        let range = range(limits, &[0.5, 3.0, 6.0, 2.0]);
        assert_eq!((range.outside, range.extremes[1]), (2, [0.5, 6.0]));
        let (abscissa, _) = range.abscissa("angle (rad)", 30.0);
        assert!((abscissa.along(6.0) - (1.0 + 6.0 - TAU) / 2.0).abs() < 1e-12);
        // Control: without limits nothing is outside.
        assert_eq!(all(PlaneLimits::default(), &[0.5, 3.0, 6.0, 2.0]).outside, 0);
    }
}
