//! A survey of all orbits before they are drawn.

use super::orbits::orbit::Orbit;
use super::settings::Settings;
use lie_poisson::larger;

/// Sums and extremes over the orbits so far.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Survey {
    /// The number of points, the starts included.
    pub points: usize,
    /// The number of starts that have fewer returns than were asked for.
    pub short: usize,
    /// The largest deviations of the conserved quantities from those of the section.
    pub deviations: Vec<f64>,
    /// The least and the largest x.
    pub widths: [f64; 2],
    /// The least and the largest y.
    pub heights: [f64; 2],
    /// The mean of |y| over each orbit.
    pub means: Vec<f64>,
}

impl Survey {
    /// Creates the survey of no orbit.
    pub fn new(settings: &Settings) -> Self {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let deviations = vec![0.0; settings.problem.conserved().len()];
        let (widths, heights) = (nothing, nothing);
        Self { points: 0, short: 0, deviations, widths, heights, means: Vec::new() }
    }

    /// Adds an orbit to the survey.
    pub fn add(&mut self, settings: &Settings, orbit: &Orbit) {
        let mut sum = 0.0;
        let start = orbit.crossings.first().map(|start| start.state.as_slice());
        let start = start.unwrap_or_default();
        for point in &orbit.crossings {
            let deviations = settings.problem.deviations(start, &point.state);
            for (most, deviation) in self.deviations.iter_mut().zip(deviations) {
                *most = larger(*most, deviation);
            }
            let [x, y] = point.plane;
            self.widths = [self.widths[0].min(x), self.widths[1].max(x)];
            self.heights = [self.heights[0].min(y), self.heights[1].max(y)];
            sum += y.abs();
        }
        self.points += orbit.crossings.len();
        self.short += usize::from(orbit.crossings.len() <= settings.limits.crossings);
        self.means.push(sum / orbit.crossings.len().max(1) as f64);
    }
}
