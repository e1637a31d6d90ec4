//! Inputs by tables: [`InputTable`].

use crate::orbits::breakpoints::next_of;
use crate::orbits::interpolation::{Interpolation, Piece};
use generic_scalars::{Mask, Real};
use thiserror::Error;

/// The reason why two columns are no table of an input, or a table is not enough for a run.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputTableError {
    /// The columns have different lengths.
    #[error("a table of an input has a value for each time, got {times} times and {values} values")]
    DifferentLengths {
        /// The number of times.
        times: usize,
        /// The number of values.
        values: usize,
    },
    /// A table with fewer than two times covers no interval.
    #[error("a table of an input needs at least two times, got {times}")]
    TooShort {
        /// The number of times.
        times: usize,
    },
    /// A time or a value is not a finite number.
    #[error("{column} {row} of the table is {number}, which is not a finite number")]
    NotFinite {
        /// The column, `time` or `value`.
        column: &'static str,
        /// The row, from 1.
        row: usize,
        /// The number there.
        number: f64,
    },
    /// A time is not after the one before it.
    #[error("the times of a table must increase: time {row} is {time}, after {before}")]
    NotIncreasing {
        /// The row of the later entry, from 1.
        row: usize,
        /// The time before it.
        before: f64,
        /// The time there.
        time: f64,
    },
    /// A slope of the interpolation is above the largest number.
    #[error(
        "between rows {row} and {} of the table, at the times {from} and {to}, the slope of the input overflows",
        .row + 1
    )]
    TooSteep {
        /// The row at which the interval begins, from 1.
        row: usize,
        /// The time at which it begins.
        from: f64,
        /// The time at which it ends.
        to: f64,
    },
    /// A run needs times that the table does not have.
    #[error(
        "the table of the input goes from {first} to {last}, and the run from {begin} to {end}"
    )]
    Outside {
        /// The first time of the table.
        first: f64,
        /// The last time of the table.
        last: f64,
        /// The time at which the run begins.
        begin: f64,
        /// The time at which the run ends.
        end: f64,
    },
}

/// An input u(t) by a table of times and values, with an [`Interpolation`] between them.
///
/// The input is known from the first time to the last, both included, and is never extrapolated. Times and values have
/// any units. At the times of the table the input, or a derivative of it, jumps: a step of an integrator should end
/// there.
///
/// Gauss's methods evaluate an input within their steps alone. A method that evaluates it at the ends of a step, such
/// as the classical one of Runge and Kutta, sees the value after a jump also at the end of the step before; at the last
/// time of the table, round-off of its time may make it NaN, unless the table goes on a little longer than the run.
///
/// # Example
/// ```
/// use lie_poisson::{DualNumber, InputTable, InputTableError, Interpolation};
/// let (times, values) = (vec![0.0, 1.0, 3.0], vec![2.0, 5.0, 1.0]);
/// let held = InputTable::new(times.clone(), values.clone(), Interpolation::Constant)?;
/// assert_eq!([0.0, 0.9, 1.0, 2.9, 3.0].map(|t| held.at(t)), [2.0, 2.0, 5.0, 5.0, 1.0]);
/// let lines = InputTable::new(times, values, Interpolation::Linear)?;
/// assert_eq!((lines.at(0.5), lines.at(2.0)), (3.5, 3.0));
/// assert_eq!(lines.at(DualNumber::variable(2.0)).derivative(), -2.0);
/// assert!(lines.at(3.5).is_nan());
/// assert_eq!(lines.next_break(1.0, true), Some(3.0));
/// # Ok::<(), InputTableError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct InputTable {
    times: Vec<f64>,
    pieces: Vec<Piece>,
}

impl InputTable {
    /// Creates an input from its times, which increase, and as many values.
    ///
    /// # Errors
    /// Returns [`InputTableError`] if the numbers of times and values differ, if there are fewer than two, if a time
    /// does not increase, if a number is NaN or infinite, or if the interpolation overflows.
    pub fn new(
        times: Vec<f64>,
        values: Vec<f64>,
        interpolation: Interpolation,
    ) -> Result<Self, InputTableError> {
        if times.len() != values.len() {
            let (times, values) = (times.len(), values.len());
            return Err(InputTableError::DifferentLengths { times, values });
        }
        if times.len() < 2 {
            return Err(InputTableError::TooShort { times: times.len() });
        }
        for (column, numbers) in [("time", &times), ("value", &values)] {
            if let Some(place) = numbers.iter().position(|x| !x.is_finite()) {
                let (row, number) = (place + 1, numbers[place]);
                return Err(InputTableError::NotFinite { column, row, number });
            }
        }
        if let Some(place) = times.windows(2).position(|pair| pair[0] >= pair[1]) {
            let (before, time) = (times[place], times[place + 1]);
            return Err(InputTableError::NotIncreasing { row: place + 2, before, time });
        }
        let pieces = interpolation.pieces(&times, &values);
        if let Some(place) = pieces.iter().position(|piece| !piece.is_finite()) {
            let place = place.min(times.len() - 2);
            let (from, to) = (times[place], times[place + 1]);
            return Err(InputTableError::TooSteep { row: place + 1, from, to });
        }
        Ok(Self { times, pieces })
    }

    /// Returns u(t). It is NaN outside the table.
    ///
    /// The table is searched by bisection. SIMD lanes whose times lie in different intervals have the bits of each lane
    /// alone.
    #[must_use]
    pub fn at<T: Real>(&self, time: T) -> T {
        self.piecewise(time, |piece| piece.at(time))
    }

    /// Returns at t the polynomial of the interval in which the time `inside` lies: u(t) if t lies there too, and otherwise
    /// its continuation beyond the times of the table. It is NaN if `inside` is outside the table.
    ///
    /// A method sees a smooth input by it, also at the end of a step where the input jumps, or where a composition goes
    /// beyond the step.
    ///
    /// ```
    /// use lie_poisson::{InputTable, Interpolation};
    /// let table = InputTable::new(vec![0.0, 1.0, 3.0], vec![2.0, 5.0, 1.0], Interpolation::Linear)?;
    /// assert_eq!((table.continued(0.5, 0.9), table.continued(0.5, 2.0)), (table.at(0.9), 8.0));
    /// # Ok::<(), lie_poisson::InputTableError>(())
    /// ```
    #[must_use]
    pub fn continued<T: Real>(&self, inside: T, time: T) -> T {
        self.piecewise(inside, |piece| piece.at(time))
    }

    /// Returns the derivative du/dt at t, that from the right at the times of the table and from the left at the last
    /// one. It is 0 between jumps of a [constant](Interpolation::Constant) input, and NaN outside the table.
    #[must_use]
    pub fn derivative<T: Real>(&self, time: T) -> T {
        self.piecewise(time, |piece| piece.derivative(time))
    }

    /// Returns f of the piece in which t lies, lane by lane.
    fn piecewise<T: Real>(&self, time: T, f: impl Fn(&Piece) -> T) -> T {
        let has_begun = |begin: &f64| T::from_f64(*begin).at_most(time);
        let outside = T::from_f64(f64::NAN);
        let until = |last: &f64| time.at_most(T::from_f64(*last));
        let (Some(first), Some(last)) = (self.times.first(), self.times.last()) else {
            return outside;
        };
        // The last piece that has begun in every lane, and those after it that have begun in some lanes.
        let begun = self.times.partition_point(|begin| has_begun(begin).all());
        let place = begun.clamp(1, self.pieces.len()) - 1;
        let mut value = f(&self.pieces[place]);
        for (begin, piece) in self.times.iter().zip(&self.pieces).skip(place + 1) {
            let later = has_begun(begin);
            if !later.any() {
                break;
            }
            value = T::select(later, f(piece), value);
        }
        T::select(has_begun(first).and(until(last)), value, outside)
    }

    /// Returns the times of the table, at which the input or a derivative of it may jump.
    #[must_use]
    pub fn breakpoints(&self) -> &[f64] {
        &self.times
    }

    /// Returns the next time of the table strictly after `time`, or strictly before it if `forward` is false. There is
    /// none beyond the ends, nor for NaN.
    #[must_use]
    pub fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        next_of(&self.times, time, forward)
    }

    /// Requires that the input is known from `begin` to `end`, in either direction of time.
    ///
    /// # Errors
    /// Returns [`InputTableError::Outside`] if it is not.
    pub fn require_until(&self, begin: f64, end: f64) -> Result<(), InputTableError> {
        let (first, last) = (self.times[0], self.times[self.times.len() - 1]);
        match [begin, end].iter().all(|time| (first..=last).contains(time)) {
            true => Ok(()),
            false => Err(InputTableError::Outside { first, last, begin, end }),
        }
    }
}
