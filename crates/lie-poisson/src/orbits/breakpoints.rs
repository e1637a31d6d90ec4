//! Fields with given breakpoints: [`WithBreakpoints`].

use crate::brackets::poisson::PoissonSpace;
use crate::orbits::orbit_field::OrbitField;
use generic_scalars::{Differential, Point, Real};
use thiserror::Error;

/// The error returned for a breakpoint that is no time.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("breakpoint {place} is {time}, which is not a finite number")]
pub struct BreakpointError {
    /// The place among the given times, from 1.
    pub place: usize,
    /// The time that was given.
    pub time: f64,
}

/// A field with breakpoints that it does not tell itself: times at which it, or a derivative of it, jumps.
///
/// A Hamiltonian h(μ, t) that contains inputs by tables is [`TimeDependent`](crate::TimeDependent), which knows nothing
/// of the tables. With their [`breakpoints`](crate::InputTable::breakpoints) integrators end their steps there, and keep
/// their order. Breakpoints that the field tells are kept.
///
/// # Example
/// A spin in a field along e₁ whose strength is a table:
/// ```
/// use lie_poisson::{Automatic, Covector, Energy, InTime, InputTable, Interpolation, LiePoisson, OrbitField, Pair, Point};
/// use lie_poisson::{Real, So3, Time, TimeDependent, WithBreakpoints};
/// struct Spin(InputTable);
/// impl Energy for Spin {
///     type Space = InTime<LiePoisson<So3>>;
///     fn energy<T: Real>(&self, Pair(Covector(s), Time(t)): &Point<Self::Space, T>) -> T {
///         -(s.x * self.0.at(*t))
///     }
/// }
/// let table = InputTable::new(vec![0.0, 0.3, 2.0], vec![1.0, -1.0, 0.5], Interpolation::Linear)?;
/// let times = table.breakpoints().to_vec();
/// let field = TimeDependent(Automatic(Spin(table)));
/// let next = |field: &dyn OrbitField<LiePoisson<So3>>| field.next_break(0.1, true);
/// assert_eq!(next(&field), None);
/// assert_eq!(next(&WithBreakpoints::new(field, times)?), Some(0.3));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WithBreakpoints<X> {
    field: X,
    times: Vec<f64>,
}

impl<X> WithBreakpoints<X> {
    /// Creates a field with breakpoints from a field and the times, in any order.
    ///
    /// # Errors
    /// Returns [`BreakpointError`] for a time that is NaN or infinite.
    pub fn new(field: X, mut times: Vec<f64>) -> Result<Self, BreakpointError> {
        if let Some(place) = times.iter().position(|time| !time.is_finite()) {
            return Err(BreakpointError { place: place + 1, time: times[place] });
        }
        times.sort_by(f64::total_cmp);
        Ok(Self { field, times })
    }

    /// Returns the field without the breakpoints that were given.
    pub const fn field(&self) -> &X {
        &self.field
    }
}

impl<P, X, T> OrbitField<P, T> for WithBreakpoints<X>
where
    P: PoissonSpace,
    X: OrbitField<P, T>,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T> {
        self.field.element(mu, time)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let told = self.field.next_break(time, forward);
        nearest_break(told, next_of(&self.times, time, forward), forward)
    }
}

/// Returns the next breakpoint of a sum from those of its two parts: the earlier one, or the later one if `forward` is false.
///
/// # Example
/// ```
/// use lie_poisson::nearest_break;
/// assert_eq!(nearest_break(Some(0.3), Some(0.7), true), Some(0.3));
/// assert_eq!(nearest_break(Some(0.3), Some(0.7), false), Some(0.7));
/// assert_eq!(nearest_break(None, Some(0.7), true), Some(0.7));
/// ```
#[must_use]
pub fn nearest_break(one: Option<f64>, other: Option<f64>, forward: bool) -> Option<f64> {
    let nearer = |a: f64, b: f64| if forward { a.min(b) } else { a.max(b) };
    one.into_iter().chain(other).reduce(nearer)
}

/// Returns the next of times that increase strictly after `time`, or strictly before it if `forward` is false. There is
/// none for NaN.
pub(crate) fn next_of(times: &[f64], time: f64, forward: bool) -> Option<f64> {
    if time.is_nan() {
        return None;
    }
    let place = match forward {
        true => Some(times.partition_point(|t| *t <= time)),
        false => times.partition_point(|t| *t < time).checked_sub(1),
    };
    place.and_then(|place| times.get(place)).copied()
}
