//! A top that moves while its method and its step change: [`Simulation`].

use crate::error::PageError;
use crate::motions::damped::Frictions;
use crate::motions::motion::Motion;
use crate::motions::page_method::PageMethod;
use crate::motions::snapshot::Snapshot;
use crate::records::deviation_record::{DeviationColumn, MOST_INVARIANTS};
use crate::records::section_record::{SectionPoint, SectionRecord};
use crate::simulation::clock::Clock;
use crate::simulation::measurement::Measurement;
use collective_integrators::Direction;
use core::fmt;
use heavytop::{
    Coordinate, EnergyLevel, HeavyTop, Invariant, Section, SectionError, Surface,
    attitude_of_vertical,
};
use lie_poisson::Se3Dual;

/// A thrown top: its motion, the deviations of its invariants and its Poincaré section.
///
/// A step that fails ends in an error, and the state is that before it. Another method or a shorter step can continue.
pub struct Simulation {
    top: HeavyTop,
    method: PageMethod,
    /// The coefficient c of the friction, N m s.
    friction: f64,
    clock: Clock,
    motion: Motion,
    measurement: Measurement,
    section: Result<SectionRecord, SectionError>,
}

impl Simulation {
    /// Throws a top without friction from (Π, Γ), with the shortest attitude that has this vertical. Its section is that at
    /// Γ₃ = 0.
    ///
    /// # Errors
    /// Returns [`PageError`] if a number is not finite, if Γ = 0, if the step is not positive, or if a thin rod has an
    /// angular momentum about itself.
    pub fn new(
        top: HeavyTop,
        start: &Se3Dual,
        method: PageMethod,
        step: f64,
    ) -> Result<Self, PageError> {
        top.require_state(start)?;
        let clock = Clock::new(positive(step)?);
        let friction = 0.0;
        let motion = method.motion(&top, friction, &upright(start))?;
        let measurement = Measurement::new(&top, start, 0.0)?;
        let section = section(&top, &measurement, Coordinate::Gamma3).map(SectionRecord::new);
        Ok(Self { top, method, friction, clock, motion, measurement, section })
    }

    /// Replaces the method, from a time within the last step on.
    ///
    /// # Errors
    /// Returns [`PageError`] if the new method has no state for the moment. The old method stays.
    pub fn change_method(&mut self, method: PageMethod, time: f64) -> Result<(), PageError> {
        self.go_on(method, self.friction, time)
    }

    /// Replaces the coefficient c of the friction, N m s, from a time within the last step on. The torque is −c Ω in the
    /// body frame.
    ///
    /// # Errors
    /// Returns [`PageError::Friction`] if c is negative, or if c/I is not finite. The old friction stays.
    pub fn change_friction(&mut self, friction: f64, time: f64) -> Result<(), PageError> {
        match friction == self.friction {
            true => Ok(()),
            false => self.go_on(self.method, friction, time),
        }
    }

    /// Goes on from a time within the last step with a method and a friction.
    fn go_on(&mut self, method: PageMethod, friction: f64, time: f64) -> Result<(), PageError> {
        let within = self.within(time);
        let moment = within.map_or_else(|| self.motion.now(), |(moment, _)| moment);
        let motion = method.motion(&self.top, friction, &moment)?;
        if let Some((moment, frictions)) = within {
            self.measurement.go_back(&moment.momentum, frictions, time)?;
        }
        (self.motion, self.method, self.friction) = (motion, method, friction);
        self.clock.go_back(time);
        self.leave_level();
        Ok(())
    }

    /// Forgets the invariant that holds on Π·Γ = 0 alone, which a friction leaves.
    fn leave_level(&mut self) {
        if self.friction > 0.0 {
            self.measurement.keep_general();
        }
    }

    /// Replaces the step size, s.
    ///
    /// # Errors
    /// Returns [`PageError::StepSize`] unless the step is positive. The old step stays.
    pub fn change_step(&mut self, step: f64) -> Result<(), PageError> {
        self.clock.change_step(positive(step)?);
        Ok(())
    }

    /// Replaces the section by that at which the coordinate increases through 0. Its points are lost.
    ///
    /// # Errors
    /// Returns [`PageError::Section`] if the section does not exist. The run continues without a section.
    pub fn change_section(&mut self, coordinate: Coordinate) -> Result<(), PageError> {
        let section = section(&self.top, &self.measurement, coordinate);
        self.section = section.map(SectionRecord::new);
        Ok(self.section.as_ref().map(|_| ()).map_err(|error| *error)?)
    }

    /// Throws the top anew, from a point of its section. The points of the section stay.
    ///
    /// # Errors
    /// Returns [`PageError::NotAccessible`] if no state of the section is at this point.
    pub fn begin_orbit(&mut self, x: f64, y: f64) -> Result<(), PageError> {
        let record = self.section.as_mut().map_err(|error| *error)?;
        let start = record.begin_orbit(x, y)?;
        let measurement = Measurement::new(&self.top, &start, 0.0)?;
        self.motion = self.method.motion(&self.top, self.friction, &upright(&start))?;
        self.measurement = measurement;
        self.clock = Clock::new(self.clock.step());
        self.leave_level();
        Ok(())
    }

    /// Measures deviations from the values of now on.
    ///
    /// # Errors
    /// Returns [`PageError::NotFinite`] if an invariant is too large for a number.
    pub fn measure_anew(&mut self) -> Result<(), PageError> {
        let now = self.motion.now().momentum;
        self.measurement = self.measurement.anew(&now, self.time())?;
        self.leave_level();
        Ok(())
    }

    /// Makes steps until the time is reached, but no more than `most`. Returns their number.
    ///
    /// # Errors
    /// Returns [`PageError`] with the number and the time of a step that fails, and the reason.
    pub fn advance(&mut self, until: f64, most: u32) -> Result<u32, PageError> {
        let mut made = 0;
        while made < most && self.time() < until {
            self.make_step()?;
            made += 1;
        }
        Ok(made)
    }

    fn make_step(&mut self) -> Result<(), PageError> {
        let (start, step) = (self.time(), self.clock.step());
        let made = self.motion.advance(step);
        let frictions =
            made.map_err(|error| PageError::of_step(self.clock.total(), start, error))?;
        self.clock.advance();
        self.measurement.measure(&self.motion.now().momentum, frictions, self.time())?;
        if let Ok(record) = &mut self.section
            && let Some(mu) = self.motion.crossing(record.section(), step)?
        {
            record.push(&mu);
        }
        Ok(())
    }

    /// Returns the moment at a time within the last step; that after it for later times.
    ///
    /// Within a step it is found by a step of partial size, with the accuracy of the method.
    pub fn at(&mut self, time: f64) -> Snapshot {
        let within = self.within(time);
        within.map_or_else(|| self.motion.now(), |(moment, _)| moment)
    }

    /// Returns the moment at a time within the last step, and what the friction has done in the step until then; `None` for
    /// later times.
    fn within(&mut self, time: f64) -> Option<(Snapshot, Option<Frictions>)> {
        match time < self.time() {
            true => self.motion.within(self.clock.since_last_step(time)),
            false => None,
        }
    }
}

impl Simulation {
    /// Returns the top that moves.
    #[must_use]
    pub fn top(&self) -> &HeavyTop {
        &self.top
    }

    /// Returns the method in use.
    #[must_use]
    pub fn method(&self) -> PageMethod {
        self.method
    }

    /// Returns the coefficient c of the friction, N m s.
    #[must_use]
    pub fn friction(&self) -> f64 {
        self.friction
    }

    /// Returns the time after the last step, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.clock.time()
    }

    /// Returns the number of steps since the throw.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.clock.total()
    }

    /// Returns the invariants of the top; there are at most [`MOST_INVARIANTS`].
    #[must_use]
    pub fn invariants(&self) -> &[Invariant] {
        self.measurement.invariants()
    }

    /// Returns the values of the invariants after the last step, and zeros after them.
    #[must_use]
    pub fn values(&self) -> &[f64; MOST_INVARIANTS] {
        self.measurement.values()
    }

    /// Returns the changes of the invariants by the friction since the start, and zeros after them. Each is the sum of the
    /// changes where the friction acts in the steps, without an error of the method.
    #[must_use]
    pub fn by_friction(&self) -> [f64; MOST_INVARIANTS] {
        self.measurement.by_friction()
    }

    /// Returns the values of the invariants minus those at the start, minus their changes by the friction, and zeros after
    /// them.
    #[must_use]
    pub fn deviations(&self) -> [f64; MOST_INVARIANTS] {
        self.measurement.deviations()
    }

    /// Returns the largest deviations since the start, in columns of time.
    #[must_use]
    pub fn columns(&self) -> &[DeviationColumn] {
        self.measurement.record().columns()
    }

    /// Returns the points of the section; none if it does not exist.
    #[must_use]
    pub fn section_points(&self) -> &[SectionPoint] {
        self.section.as_ref().map_or(&[], |record| record.points())
    }
}

impl fmt::Debug for Simulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut fields = f.debug_struct("Simulation");
        fields.field("top", &self.top).field("method", &self.method).field("clock", &self.clock);
        fields.finish_non_exhaustive()
    }
}

fn upright(start: &Se3Dual) -> Snapshot {
    Snapshot::new(*start, attitude_of_vertical(&start.0.1))
}

fn positive(step: f64) -> Result<f64, PageError> {
    if step > 0.0 && step.is_finite() { Ok(step) } else { Err(PageError::StepSize { step }) }
}

/// Returns the section of the energy level of the start, at which a coordinate increases through 0.
fn section(
    top: &HeavyTop,
    measurement: &Measurement,
    coordinate: Coordinate,
) -> Result<Section, SectionError> {
    let [h, _, f2, ..] = *measurement.initial();
    let level = EnergyLevel { top: *top, energy: h, vertical_momentum: f2 };
    Section::new(
        level,
        Surface { variable: coordinate.into(), level: 0.0, direction: Direction::Up },
    )
}
