//! The numbers of the paths of a noise as a Poisson space: [`PathAxis`], and its points: [`PathNumber`].

use crate::orbits::known_coordinate::axis_of_known_coordinate;

/// The axis R of the numbers of paths, whose bracket is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PathAxis;

/// The number of a path of a [noise](crate::Noise) as a coordinate of a state, such as (μ, (number, t)): a whole number, the same
/// along the path. As that of a [`Time`](crate::Time), its rate is known, here as 0.
///
/// ```
/// use lie_poisson::{LiePoisson, PathAxis, PathNumber, PoissonSpace, ProductSpace, So3};
/// use lie_poisson::{Covector, Pair, Vector};
/// use nalgebra::Vector3;
/// let space = ProductSpace(LiePoisson::minus(So3), PathAxis);
/// let point = Pair(Covector(Vector3::new(1.0, 2.0, 3.0)), PathNumber(7.0));
/// let rate = space.hamiltonian_vector(&point, &Vector::basis(3)); // of the path's own number as a Hamiltonian
/// assert_eq!(rate, Vector::zero());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PathNumber<T = f64>(pub T);

axis_of_known_coordinate!(PathAxis, PathNumber);
