//! The points of a Poincaré section.

use crate::error::PageError;
use heavytop::Section;
use lie_poisson::Se3Dual;
use nalgebra::Vector2;

/// The largest number of points; later ones are not recorded.
pub const MOST_POINTS: usize = 100_000;

/// A point of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct SectionPoint {
    /// The angle of Γ about the axis of the surface, rad.
    pub x: f64,
    /// The other coordinate: Π_i or Γ_i.
    pub y: f64,
    /// The number of the orbit.
    pub orbit: f64,
}

/// The points at which orbits of one energy level cross a surface.
#[derive(Clone, Debug)]
pub(crate) struct SectionRecord {
    section: Section,
    points: Vec<SectionPoint>,
    orbit: u32,
}

impl SectionRecord {
    pub(crate) fn new(section: Section) -> Self {
        Self { section, points: Vec::new(), orbit: 0 }
    }

    pub(crate) fn section(&self) -> &Section {
        &self.section
    }

    pub(crate) fn points(&self) -> &[SectionPoint] {
        &self.points
    }

    /// Adds a crossing of the orbit, unless it is not finite or there is no room.
    pub(crate) fn push(&mut self, mu: &Se3Dual) {
        let plane = self.section.plane(mu);
        if self.points.len() < MOST_POINTS && plane.x.is_finite() && plane.y.is_finite() {
            let orbit = f64::from(self.orbit);
            self.points.push(SectionPoint { x: plane.x, y: plane.y, orbit });
        }
    }

    /// Begins another orbit at a point of the plane, and returns its state.
    ///
    /// # Errors
    /// Returns [`PageError::NotAccessible`] if no state is at this point.
    pub(crate) fn begin_orbit(&mut self, x: f64, y: f64) -> Result<Se3Dual, PageError> {
        let start = self.section.states(&Vector2::new(x, y)).next();
        let start = start.ok_or(PageError::NotAccessible { x, y })?;
        self.orbit = self.orbit.saturating_add(1);
        Ok(start)
    }
}
