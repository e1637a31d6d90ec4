//! A survey of all orbits before they are drawn.

use super::orbit::Orbit;
use super::settings::Settings;
use heavytop::Invariant;
use lie_poisson::larger;

/// Sums and extremes over the orbits so far.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Survey {
    /// The number of points, the starts included.
    pub points: usize,
    /// The number of starts that have fewer returns than were asked for.
    pub short: usize,
    /// The largest deviations of h, f₁ and f₂ from the level.
    pub deviations: [f64; 3],
    /// The least and the largest y.
    pub heights: [f64; 2],
    /// The mean of |y| over each orbit.
    pub means: Vec<f64>,
}

impl Survey {
    /// Creates the survey of no orbit.
    pub fn new() -> Self {
        let heights = [f64::INFINITY, f64::NEG_INFINITY];
        Self { points: 0, short: 0, deviations: [0.0; 3], heights, means: Vec::new() }
    }

    /// Adds an orbit to the survey.
    pub fn add(&mut self, settings: &Settings, orbit: &Orbit) {
        let level = settings.section.level();
        let expected = [
            (Invariant::Energy, level.energy),
            (Invariant::VerticalSquared, 1.0),
            (Invariant::VerticalMomentum, level.vertical_momentum),
        ];
        let mut sum = 0.0;
        for point in &orbit.crossings {
            for (deviation, (invariant, value)) in self.deviations.iter_mut().zip(expected) {
                *deviation =
                    larger(*deviation, (invariant.value(&level.top, &point.mu) - value).abs());
            }
            let y = point.plane.y;
            self.heights = [self.heights[0].min(y), self.heights[1].max(y)];
            sum += y.abs();
        }
        self.points += orbit.crossings.len();
        self.short += usize::from(orbit.crossings.len() <= settings.crossings);
        self.means.push(sum / orbit.crossings.len().max(1) as f64);
    }
}
