//! Controls: [`Controlled`] fields, and [`Inputs`] along fixed elements of the Lie algebra.

use crate::brackets::poisson::PoissonSpace;
use crate::orbits::breakpoints::nearest_break;
use crate::orbits::input_table::{InputTable, InputTableError};
use crate::orbits::orbit_field::OrbitField;
use generic_scalars::{Differential, Point, Real, State, Vector, map_coordinates};
use thiserror::Error;

/// The reason why vectors are not those of [`Inputs`].
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputsError {
    /// A coordinate of a vector is not a finite number.
    #[error(
        "coordinate {coordinate} of the vector of input {input} is {number}, which is not a finite number"
    )]
    NotFinite {
        /// The input, from 1.
        input: usize,
        /// The coordinate, from 1.
        coordinate: usize,
        /// The number there.
        number: f64,
    },
}

/// The sum Σ uᵢ(t) vᵢ of inputs uᵢ along fixed vectors vᵢ, which have the type `D`.
///
/// Along elements ξᵢ of 𝔤 it is the field ξ(t) = Σ uᵢ(t) ξᵢ.
///
/// # Example
/// A pulse that turns a spin about e₁ by a right angle:
/// ```
/// use lie_poisson::{Covector, InputTable, Inputs, Interpolation, OrbitField};
/// use nalgebra::Vector3;
/// use std::f64::consts::FRAC_PI_2;
/// let pulse = InputTable::new(vec![0.0, 2.0, 3.0], vec![0.0, FRAC_PI_2, 0.0], Interpolation::Constant)?;
/// let inputs = Inputs::new(vec![(Vector3::x(), pulse)])?;
/// let at = |t| OrbitField::<lie_poisson::LiePoisson<lie_poisson::So3>>::element(&inputs, &Covector(Vector3::z()), t);
/// assert_eq!((at(1.0).x, at(2.5).x), (0.0, FRAC_PI_2));
/// assert!(inputs.require_until(0.0, 5.0).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Inputs<D> {
    inputs: Vec<(D, InputTable)>,
}

impl<D: State<Scalar = f64>> Inputs<D> {
    /// Creates the sum from the vector vᵢ and the table of each input. Without inputs it is 0.
    ///
    /// # Errors
    /// Returns [`InputsError`] if a coordinate of a vector is NaN or infinite.
    pub fn new(inputs: Vec<(D, InputTable)>) -> Result<Self, InputsError> {
        for (place, (vector, _)) in inputs.iter().enumerate() {
            let wrong = (0..vector.dimension()).find(|i| !vector.coordinate(*i).is_finite());
            if let Some(i) = wrong {
                let (input, coordinate, number) = (place + 1, i + 1, vector.coordinate(i));
                return Err(InputsError::NotFinite { input, coordinate, number });
            }
        }
        Ok(Self { inputs })
    }

    /// Returns the vector and the table of each input.
    pub fn iter(&self) -> impl Iterator<Item = &(D, InputTable)> {
        self.inputs.iter()
    }

    /// Returns the next time of a table strictly after a time, or strictly before it.
    #[must_use]
    pub fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let breaks = self.iter().map(|(_, table)| table.next_break(time, forward));
        breaks.fold(None, |one, other| nearest_break(one, other, forward))
    }

    /// Requires that all inputs are known from `begin` to `end`, in either direction of time.
    ///
    /// # Errors
    /// Returns [`InputTableError::Outside`] of the first one that is not.
    pub fn require_until(&self, begin: f64, end: f64) -> Result<(), InputTableError> {
        self.iter().try_for_each(|(_, table)| table.require_until(begin, end))
    }
}

impl<P, D, T> OrbitField<P, T> for Inputs<D>
where
    P: PoissonSpace,
    Point<P>: Vector<Dual = D>,
    D: Vector<Scalar = f64>,
    T: Real,
{
    fn element(&self, _: &Point<P, T>, time: T) -> Differential<P, T> {
        self.iter().fold(Vector::zero(), |sum: Differential<P, T>, (element, table)| {
            let input = table.at(time);
            sum + map_coordinates(element, |x| input * x)
        })
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        Self::next_break(self, time, forward)
    }
}

/// The sum ξ₀ + u of a field and of a control law, which is a field too: [`Inputs`], or a law that depends on the
/// state.
///
/// # Example
/// A rigid body, and a law −k Π₃ e₃ that turns it in its own frame. The motion stays on the sphere, whatever the law:
/// ```
/// use lie_poisson::{Autonomous, Controlled, Covector, LiePoisson, OrbitField, PoissonSpace, Real, So3, from_closure};
/// use nalgebra::Vector3;
/// struct Feedback(f64);
/// impl<T: Real> OrbitField<LiePoisson<So3>, T> for Feedback {
///     fn element(&self, Covector(pi): &Covector<Vector3<T>>, _: T) -> Vector3<T> {
///         Vector3::new(T::zero(), T::zero(), -pi.z * self.0)
///     }
/// }
/// let body = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
/// let field = Controlled { field: Autonomous(body), control: Feedback(0.5) };
/// let pi = Covector(Vector3::new(1.0, 2.0, 2.0));
/// let xi = field.element(&pi, 0.0);
/// assert_eq!(xi, Vector3::new(1.0, 4.0, -1.0));
/// assert_eq!(LiePoisson::minus(So3).hamiltonian_vector(&pi, &xi).0.dot(&pi.0), 0.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Controlled<X, U> {
    /// The field ξ₀ without control.
    pub field: X,
    /// The control law u.
    pub control: U,
}

impl<P, X, U, T> OrbitField<P, T> for Controlled<X, U>
where
    P: PoissonSpace,
    X: OrbitField<P, T>,
    U: OrbitField<P, T>,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T> {
        self.field.element(mu, time) + self.control.element(mu, time)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let [field, control] =
            [self.field.next_break(time, forward), self.control.next_break(time, forward)];
        nearest_break(field, control, forward)
    }
}
