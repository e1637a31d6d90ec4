//! A survey of all orbits before they are drawn.

use super::orbits::orbit::Orbit;
use super::plane_range::PlaneRange;
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
    /// The part of the plane that the picture shows.
    pub plane: PlaneRange,
    /// The mean of |y| over each orbit.
    pub means: Vec<f64>,
}

impl Survey {
    /// Creates the survey of no orbit.
    pub fn new(settings: &Settings) -> Self {
        let deviations = vec![0.0; settings.problem.conserved().len()];
        let (_, is_angle) = settings.problem.drawing(&settings.limits).abscissa;
        let plane = PlaneRange::new(settings.plane, is_angle);
        Self { points: 0, short: 0, deviations, plane, means: Vec::new() }
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
            self.plane.include(point.plane);
            sum += point.plane[1].abs();
        }
        self.points += orbit.crossings.len();
        self.short += usize::from(orbit.crossings.len() <= settings.limits.crossings);
        self.means.push(sum / orbit.crossings.len().max(1) as f64);
    }
}
