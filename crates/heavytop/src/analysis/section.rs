//! Poincaré sections of a top: [`Section`].

use crate::analysis::section_error::SectionError;
use crate::analysis::section_level::{least_energy, quasi_random};
use crate::analysis::surface::{Place, Surface, SurfaceVariable};
use crate::tops::energy_level::EnergyLevel;
use crate::tops::principal_axes::PrincipalAxes;
use crate::tops::top::HeavyTopSpace;
use collective_integrators::{Direction, EventError, Events, RunError, SampleOf, Start};
use lie_poisson::{Hamiltonian, LiePoisson, PoissonSpace, Se3, Se3Dual, State, Vector};
use nalgebra::{Vector2, Vector3};
use std::borrow::Cow;

/// The number of points of the plane that are tried for starts.
const CANDIDATES: u64 = 10_000_000;

/// The Poincaré section of an energy level: its states on a surface, of dimension 2, with the return map.
///
/// The surface fixes Γ_i or Π_i, i = 1, 2, 3, or the angle of Γ about e_i. The section is drawn in a plane with the
/// coordinates
///
/// ```text
/// Γ_i or Π_i:  x = atan2(Γ_k, Γ_j) in [0, 2π], (i, j, k) cyclic: the angle of Γ about e_i, rad
///              y = Π_i (kg m²/s) where the surface fixes Γ_i; Γ_i where it fixes Π_i
/// the angle:   x = arccos Γ_i in [0, π]: the inclination of Γ to e_i, rad
///              y = Π·n (kg m²/s), n = e_i × Γ/|e_i × Γ|
/// ```
///
/// On a surface that fixes Γ_i or the angle these are, up to sign, an Euler angle and its momentum. They are canonical
/// coordinates of the section, and for one crossing direction each accessible point of the plane has one state. The
/// return map conserves the area dx dy.
///
/// Source: H. Poincaré, *Les méthodes nouvelles de la mécanique céleste* III (1899), ch. XXVII.
///
/// # Example
/// The returns of Kovalevskaya's top lie on curves K = const.:
/// ```
/// use collective_integrators::{Direction, LiftFree, RungeKutta};
/// use heavytop::{Coordinate, EnergyLevel, HeavyTop, Invariant, Section, Surface};
/// use momentum_map::DualQuaternions;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
/// let level = EnergyLevel { top, energy: 2.0, vertical_momentum: 0.3 };
/// let surface =
///     Surface { variable: Coordinate::Gamma3.into(), level: 0.0, direction: Direction::Up };
/// let section = Section::new(level, surface)?;
/// let gauss = LiftFree::new(RungeKutta::gauss(5)?, DualQuaternions, top);
/// for start in section.starts(3, 0)? {
///     let mut count = 0;
///     for crossing in section.crossings(&gauss, &start, 0.1, 1000)? {
///         let mu = crossing?.momentum;
///         let deviation = |f: Invariant| (f.value(&top, &mu) - f.value(&top, &start)).abs();
///         assert!(section.value(&mu).abs() < 1e-15);
///         assert!(deviation(Invariant::Energy) < 1e-10);
///         assert!(deviation(Invariant::Kovalevskaya) < 1e-9);
///         count += 1;
///     }
///     assert!(count > 10);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    level: EnergyLevel,
    surface: Surface,
    /// The principal axes in the axes of the surface, where these are others.
    axes: Option<PrincipalAxes>,
}

impl Section {
    /// Creates the section of the level by the surface.
    ///
    /// # Errors
    /// Returns [`SectionError`] if a number is not finite, if the top is a thin rod, if Γ_i is given a level outside −1 < level < 1, or if no
    /// state has this energy. In the last case the error names the least energy.
    pub fn new(level: EnergyLevel, surface: Surface) -> Result<Self, SectionError> {
        Self::in_axes(level, surface, &PrincipalAxes::aligned(level.top.inertia()))
    }

    /// Creates the section of the level by a surface that fixes a variable in the axes in which the body is described.
    /// The states of the section are in principal axes, as those of the level are; its plane is that of the variable.
    ///
    /// # Errors
    /// Those of [`Section::new`].
    pub fn in_axes(
        level: EnergyLevel,
        surface: Surface,
        axes: &PrincipalAxes,
    ) -> Result<Self, SectionError> {
        for (name, value) in [
            ("energy", level.energy),
            ("vertical_momentum", level.vertical_momentum),
            ("level", surface.level),
        ] {
            if !value.is_finite() {
                return Err(SectionError::NotFinite { name, value });
            }
        }
        if level.top.rod_axis().is_some() {
            return Err(SectionError::ThinRod);
        }
        if let Surface { variable: SurfaceVariable::Coordinate(coordinate), level, .. } = surface
            && !coordinate.is_momentum()
            && level.abs() >= 1.0
        {
            return Err(SectionError::NoSuchVertical { coordinate, level });
        }
        let section = Self { level, surface, axes: Some(*axes).filter(|axes| !axes.is_aligned()) };
        let least = least_energy(|angle, height| section.least_energy_over(angle, height));
        if level.energy < least {
            return Err(SectionError::Empty { energy: level.energy, least });
        }
        Ok(section)
    }

    /// Returns the energy level of the section.
    #[must_use]
    pub fn level(&self) -> &EnergyLevel {
        &self.level
    }

    /// Returns the surface of the section.
    #[must_use]
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// Returns the variable that the surface fixes, minus its level; for an angle the difference of least size.
    #[must_use]
    pub fn value(&self, mu: &Se3Dual) -> f64 {
        self.surface.value(&self.given(mu))
    }

    /// Returns the period 2π of [`value`](Self::value) if the surface fixes an angle.
    /// [`Events::modulo`](collective_integrators::Events::modulo) takes it.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.surface.variable.period()
    }

    /// Returns a state in principal axes, or a rate, in the axes of the surface.
    fn given<'a>(&self, mu: &'a Se3Dual) -> Cow<'a, Se3Dual> {
        match &self.axes {
            Some(axes) => Cow::Owned(axes.state_from_principal(mu)),
            None => Cow::Borrowed(mu),
        }
    }

    /// Returns a vector in the axes of the surface in principal axes.
    fn principal(&self, v: Vector3<f64>) -> Vector3<f64> {
        self.axes.map_or(v, |axes| axes.to_principal(&v))
    }

    /// Returns what a point of the plane says of the states over it, in principal axes.
    fn place(&self, plane: &Vector2<f64>) -> Place {
        let Place { gamma, axis, momentum } = self.surface.place(plane);
        Place { gamma: self.principal(gamma), axis: self.principal(axis), momentum }
    }

    /// Returns the point (x, y) of the plane for a state in principal axes.
    #[must_use]
    pub fn plane(&self, mu: &Se3Dual) -> Vector2<f64> {
        self.surface.plane(&self.given(mu))
    }

    /// Returns the states at (x, y) that cross the surface in its direction: none, one or two.
    pub fn states<'a>(&'a self, plane: &Vector2<f64>) -> impl Iterator<Item = Se3Dual> + use<'a> {
        let Place { gamma, axis, momentum } = self.place(plane);
        let states = self.level.states_along(&gamma, &axis, momentum);
        states.into_iter().flatten().filter(|mu| self.crosses(mu))
    }

    /// Returns states of the section, spread evenly over the accessible part of the plane.
    ///
    /// The seed determines the sequence, and a longer sequence begins with the points of a shorter one.
    ///
    /// The points (x, y) are the accessible points of Weyl's sequence (n/g, n/g²) mod 1, g³ = g + 1, shifted at random.
    ///
    /// Source: H. Weyl, Math. Ann. 77 (1916); M. Roberts, *The unreasonable effectiveness of
    /// quasirandom sequences* (2018), for g.
    ///
    /// # Errors
    /// Returns [`SectionError::TooSmall`] if too few of ten million points are accessible, because the energy is near
    /// its minimum.
    pub fn starts(&self, count: usize, seed: u64) -> Result<Vec<Se3Dual>, SectionError> {
        let (width, bound) = (self.surface.width(), self.bound());
        let candidates = quasi_random(seed).take(CANDIDATES as usize);
        let candidates = candidates.map(|[s, t]| Vector2::new(width * s, (2.0 * t - 1.0) * bound));
        let starts: Vec<Se3Dual> =
            candidates.flat_map(|plane| self.states(&plane)).take(count).collect();
        match starts.len() {
            found if found < count => {
                Err(SectionError::TooSmall { count, found, candidates: CANDIDATES })
            }
            _ => Ok(starts),
        }
    }

    /// Returns the points where the motion through `start`, a state of the section, crosses the section in the first
    /// `steps` steps of size `step` (s). With a negative step they are its antecedents, which lie on the same section.
    ///
    /// The momenta of the integrator have the coordinates (Π, Γ). The start is no crossing, although it lies on the surface.
    /// The crossings within the first step are reported.
    ///
    /// # Errors
    /// Returns [`RunError`] if the start has no lift, or is not finite. If a step fails, the iterator returns an
    /// [`EventError`] for each remaining step.
    pub fn crossings<'a, I: Start>(
        &self,
        integrator: &'a I,
        start: &I::Momentum,
        step: f64,
        steps: usize,
    ) -> Result<impl Iterator<Item = Result<SampleOf<I>, EventError>> + use<'a, I>, RunError> {
        let section = *self;
        let run = integrator.trajectory(start, step)?.take(steps.saturating_add(1));
        let value =
            move |mu: &I::Momentum| section.value(&Se3Dual::from_coordinates(|i| mu.coordinate(i)));
        let events = Events::new(integrator, run, value, self.surface.direction.along_run(step));
        Ok(match self.period() {
            Some(period) => events.modulo(period),
            None => events,
        })
    }

    /// Returns whether the state crosses the surface in the right direction.
    fn crosses(&self, mu: &Se3Dual) -> bool {
        let space: HeavyTopSpace = LiePoisson::minus(Se3::default());
        let differential = Hamiltonian::<HeavyTopSpace>::differential(&self.level.top, mu);
        let rate = space.hamiltonian_vector(mu, &differential);
        let rate = self.surface.rate(&self.given(mu), &self.given(&rate));
        match self.surface.direction {
            Direction::Up => rate > 0.0,
            Direction::Down => rate < 0.0,
            Direction::Both => rate != 0.0,
        }
    }

    /// Returns the least energy on the surface over Γ at this angle about the axis, or at any angle if the surface fixes
    /// that. Γ_i is `height` unless the surface fixes it.
    fn least_energy_over(&self, angle: f64, height: f64) -> f64 {
        let at = |x: f64, y: f64| self.place(&Vector2::new(x, y));
        match self.surface.variable {
            SurfaceVariable::Coordinate(coordinate) if coordinate.is_momentum() => {
                let Place { gamma, axis, momentum } = at(angle, height);
                self.level.least_energy(&gamma, &axis, momentum)
            }
            SurfaceVariable::Coordinate(_) => self.level.amended_potential(&at(angle, 0.0).gamma),
            _ => self.level.amended_potential(&at(height.acos(), 0.0).gamma),
        }
    }

    /// Returns the bound of |y|: |Γ_i| ≤ 1, or (Π·n)² ≤ 2 n·In (E − m g l Γ·c) with the direction n of the component.
    fn bound(&self) -> f64 {
        let EnergyLevel { top, energy, .. } = self.level;
        let (axis, level) = (self.principal(self.surface.axis()), self.surface.level);
        let along = top.center_of_mass().dot(&axis);
        let across = |x: f64| (1.0 - x * x).max(0.0).sqrt();
        // The least of Γ·c on the surface; on one of an angle n is at right angles to Γ.
        let lowest = match self.surface.variable {
            SurfaceVariable::Coordinate(coordinate) if coordinate.is_momentum() => return 1.0,
            SurfaceVariable::Coordinate(_) => along * level - across(along) * across(level),
            _ => -across(along),
        };
        let moment = top.inertia().component_mul(&axis).dot(&axis);
        (2.0 * moment * (energy - top.weight_moment() * lowest)).max(0.0).sqrt()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::analysis::surface::vertical;
    use crate::tops::coordinate::Coordinate;
    use crate::tops::top::{Body, HeavyTop};
    use core::f64::consts::{PI, TAU};

    /// The bound of Π_i on Γ_i = level is that of the energy at the most favourable angle.
    #[test]
    fn the_bound_of_a_momentum_is_attained() {
        let body = Body {
            inertia: Vector3::new(1.5, 1.2, 0.7),
            mass: 1.3,
            gravity: 0.9,
            length: 0.7,
            center_of_mass: Vector3::new(0.48, 0.6, 0.64),
        };
        let top = HeavyTop::new(&body).unwrap();
        let energy = 2.0;
        let level = EnergyLevel { top, energy, vertical_momentum: 0.3 };
        for coordinate in [Coordinate::Gamma1, Coordinate::Gamma2, Coordinate::Gamma3] {
            for height in [-0.6, 0.2, 0.9] {
                let variable = coordinate.into();
                let surface = Surface { variable, level: height, direction: Direction::Both };
                let section = Section::new(level, surface).unwrap();
                let axis = coordinate.axis();
                let momentum = |angle: f64| {
                    let gamma = vertical(axis, angle, height);
                    let weight = top.weight_moment() * gamma.dot(&top.center_of_mass());
                    (2.0 * top.inertia()[axis] * (energy - weight)).sqrt()
                };
                let angles = (0..100_000).map(|n| TAU * f64::from(n) / 100_000.0);
                let most = angles.map(momentum).fold(0.0, f64::max);
                // Between angles the maximum is larger by the square of their distance.
                let bound = section.bound();
                assert!((bound - most).abs() < 1e-8, "{coordinate:?} {height}: {bound} {most}");
            }
        }
    }

    /// On a half circle around e₃ the bound of Π·n is that of the energy at the most favourable inclination, or larger
    /// if that is on the other half.
    #[test]
    fn the_bound_of_the_momentum_of_the_inclination_is_attained() {
        let body = Body {
            inertia: Vector3::new(1.5, 1.2, 0.7),
            mass: 1.3,
            gravity: 0.9,
            length: 0.7,
            center_of_mass: Vector3::new(0.48, 0.6, 0.64),
        };
        let top = HeavyTop::new(&body).unwrap();
        let level = EnergyLevel { top, energy: 2.0, vertical_momentum: 0.3 };
        for angle in [-2.5, -0.4, 0.9, PI] {
            let variable = SurfaceVariable::Angle3;
            let surface = Surface { variable, level: angle, direction: Direction::Both };
            let section = Section::new(level, surface).unwrap();
            let node = Vector3::new(-angle.sin(), angle.cos(), 0.0);
            let moment = top.inertia().component_mul(&node).dot(&node);
            let momentum = |x: f64| {
                let gamma = Vector3::new(x.sin() * angle.cos(), x.sin() * angle.sin(), x.cos());
                let weight = top.weight_moment() * gamma.dot(&top.center_of_mass());
                (2.0 * moment * (level.energy - weight)).sqrt()
            };
            let most = |from: f64| {
                let angles = (0..100_000).map(|n| from + PI * f64::from(n) / 100_000.0);
                angles.map(momentum).fold(0.0, f64::max)
            };
            let (half, whole, bound) = (most(0.0), most(0.0).max(most(PI)), section.bound());
            assert!(
                half <= bound && (bound - whole).abs() < 1e-8,
                "{angle}: {bound} {half} {whole}"
            );
        }
    }
}
