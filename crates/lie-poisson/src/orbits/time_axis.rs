//! The axis of time as a Poisson space: [`TimeAxis`], and its points: [`Time`].

use crate::brackets::product_space::ProductSpace;
use crate::orbits::known_coordinate::axis_of_known_coordinate;

/// The axis of time R, whose bracket is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TimeAxis;

/// The product P × R of a Poisson space with the axis of time, whose points are (μ, t). Functions of t are Casimirs of
/// it, so that the bracket is that of P at each time.
pub type InTime<P> = ProductSpace<P, TimeAxis>;

/// A time t as a coordinate of a state, such as (μ, t).
///
/// Its rate dt/dt = 1 is known before the stages of a step are. So no iteration for stages waits for it: the difference of two
/// times [has the size](generic_scalars::State::measure_difference) 0. Its own size is that of any number.
///
/// ```
/// use lie_poisson::{Pair, State, Time};
/// use nalgebra::Vector3;
/// let at = |time: f64| Pair(Vector3::new(1.0, 0.0, 0.0), Time(time));
/// let (first, second) = (at(1.0), at(3.0));
/// let (mut largest, mut sum) = (((0.0,), (0.0,)), 0.0);
/// second.measure(&mut largest, &mut sum);
/// assert_eq!((largest, sum), (((1.0,), (3.0,)), 4.0));
/// let (mut largest, mut sum) = (((0.0,), (0.0,)), 0.0);
/// second.measure_difference(&first, &mut largest, &mut sum);
/// assert_eq!((largest, sum), (((0.0,), (0.0,)), 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Time<T = f64>(pub T);

axis_of_known_coordinate!(TimeAxis, Time);
