//! The motion of an axis of a body, measured along a run: [`MeasuredMotion`].

use super::axis_frame::{AxisAngles, AxisFrame};
use super::steady_rotation::SteadyRotation;
use crate::error::RunFailure;
use crate::models::top_in_axes::TopInAxes;
use crate::runs::experiment::Experiment;
use crate::runs::schedule::Schedule;
use collective_integrators::{
    AnyIntegrator, AnyState, Direction, EventError, EventSearch, SampleOf, Start,
};
use core::f64::consts::{PI, TAU};
use heavytop::methods::attitude_of;
use lie_poisson::larger;

/// The largest change of an angle from sample to sample that tells its direction, rad.
const RESOLVED: f64 = 2.5;

/// The range of the inclination below which it is constant, and the inclination below which the axis is upright, rad: those
/// of rounding errors.
const STEADY: f64 = 1e-9;

/// The motion of an axis, from one of its highest points to the last one, or over the whole run if there are no two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MeasuredMotion {
    /// The least and the largest inclination, rad.
    pub inclination: [f64; 2],
    /// The mean time from one highest point to the next, s.
    pub period: Option<f64>,
    /// The mean rate of the precession, rad/s; `None` if a step does not resolve it, or the axis stays upright.
    pub precession: Option<f64>,
    /// The mean rate of the spin, rad/s; `None` as that of the precession.
    pub spin: Option<f64>,
}

/// An angle that is followed over its turns.
#[derive(Clone, Copy, Default)]
struct Winding {
    total: f64,
    last: Option<f64>,
    is_lost: bool,
}

impl Winding {
    /// Returns the angle, which is near the last one.
    fn near(&self, angle: f64) -> f64 {
        let change = self.last.map_or(0.0, |last| angle - last);
        self.total + change - TAU * (change / TAU).round()
    }

    fn follow(&mut self, angle: f64) {
        let total = self.near(angle);
        self.is_lost |= (total - self.total).abs() > RESOLVED;
        (self.total, self.last) = (total, Some(angle));
    }
}

/// A moment of the motion: the time, and the angles of precession and spin with their turns until then.
#[derive(Clone, Copy)]
struct Moment {
    time: f64,
    turned: [f64; 2],
}

/// What is kept of a run.
#[derive(Default)]
struct Record {
    /// The angles of precession and spin.
    windings: [Winding; 2],
    /// The least and the largest inclination.
    inclination: Option<[f64; 2]>,
    /// The first and the last highest point, and how many there are.
    highest: [Option<Moment>; 2],
    count: u64,
    /// The first and the last sample.
    ends: [Option<Moment>; 2],
}

impl Record {
    fn include(&mut self, inclination: f64) {
        let [least, largest] = self.inclination.unwrap_or([inclination; 2]);
        self.inclination = Some([least.min(inclination), larger(largest, inclination)]);
    }

    /// Adds a turning point of the step after the last sample.
    fn turn(&mut self, time: f64, angles: AxisAngles, is_highest: bool) {
        self.include(angles.inclination);
        if is_highest {
            let [precession, spin] = &self.windings;
            let turned = [precession.near(angles.precession), spin.near(angles.spin)];
            let moment = Some(Moment { time, turned });
            self.highest = [self.highest[0].or(moment), moment];
            self.count += 1;
        }
    }

    /// Adds the next sample.
    fn sample(&mut self, time: f64, angles: AxisAngles) {
        self.include(angles.inclination);
        self.windings[0].follow(angles.precession);
        self.windings[1].follow(angles.spin);
        let moment = Some(Moment { time, turned: self.windings.map(|winding| winding.total) });
        self.ends = [self.ends[0].or(moment), moment];
    }

    fn motion(&self) -> MeasuredMotion {
        let inclination = self.inclination.unwrap_or([f64::NAN; 2]);
        let nods = inclination[1] - inclination[0] > STEADY && self.count >= 2;
        let between = if nods { self.highest } else { self.ends };
        // Of an upright axis, only the sum of precession and spin has a meaning.
        let is_upright = inclination[1] < STEADY || inclination[0] > PI - STEADY;
        let mean = |place: usize| {
            let [Some(from), Some(to)] = between else { return None };
            let mean = (to.turned[place] - from.turned[place]) / (to.time - from.time);
            let is_known = mean.is_finite() && !self.windings[place].is_lost && !is_upright;
            is_known.then_some(mean)
        };
        let period = match self.highest {
            [Some(from), Some(to)] if nods => {
                Some((to.time - from.time).abs() / (self.count - 1) as f64)
            }
            _ => None,
        };
        MeasuredMotion { inclination, period, precession: mean(0), spin: mean(1) }
    }
}

/// Follows the run of a top with its attitude, and measures the motion of the axis of a frame. The steady rotations learn how
/// near the run comes to them.
///
/// # Errors
/// If a step fails, or the formulation has no attitude.
pub(super) fn measure(
    run: &Experiment<TopInAxes>,
    frame: &AxisFrame,
    steady: &mut [SteadyRotation],
) -> Result<MeasuredMotion, RunFailure> {
    let (integrator, start) = run.begin()?;
    // The cosine of the inclination falls after a highest point of the axis, and rises after a lowest one.
    let mut searches = [Direction::Down, Direction::Up].map(|direction| {
        let rate = |mu: &AnyState| frame.rate(&TopInAxes::state(mu.as_slice()));
        (EventSearch::new(&integrator, rate, direction), direction == Direction::Down)
    });
    let angles = |sample: &SampleOf<AnyIntegrator>| {
        let mu = TopInAxes::state(sample.momentum.as_slice());
        frame.angles(&mu, &attitude_of(sample.state.as_slice()))
    };
    let (mut record, Schedule { step, steps }) = (Record::default(), run.pace.schedule);
    for sample in integrator.trajectory(&start, step)? {
        let sample = sample.map_err(|source| RunFailure::of_step(&run.method, source))?;
        for (search, is_highest) in &mut searches {
            let found = search.observe(&sample).map_err(|error| of_event(error, run))?;
            for event in found.into_iter().flatten() {
                record.turn(event.time, angles(&event), *is_highest);
            }
        }
        record.sample(sample.time, angles(&sample));
        let direction = frame.direction(&TopInAxes::state(sample.momentum.as_slice()));
        steady.iter_mut().for_each(|rotation| rotation.observe(&direction));
        if sample.step >= steps {
            break;
        }
    }
    Ok(record.motion())
}

/// Returns the error of a run that fails, or at whose states the rate has no value.
fn of_event(error: EventError, run: &Experiment<TopInAxes>) -> RunFailure {
    match error {
        EventError::Integration(source) => RunFailure::of_step(&run.method, source),
        EventError::NotANumber { time } => RunFailure::NoValue {
            time,
            reason: "the rate of the inclination is not a number".into(),
        },
        other => RunFailure::NoValue { time: f64::NAN, reason: other.to_string() },
    }
}
