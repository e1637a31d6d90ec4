//! Elements of the dual space, as a separate type: [`Covector`].

use crate::spaces::state::State;
use crate::spaces::vector::Vector;
use crate::{state_of_parts, vector_operators};

/// An element of the dual space V∗, stored by its coordinates in the dual basis.
///
/// A momentum in 𝔤∗ is a `Covector` of the element type of the algebra. It cannot be confused with a
/// velocity in 𝔤, though both may hold three numbers. Pattern matching gives access to the coordinates:
///
/// ```
/// use generic_scalars::Covector;
/// use nalgebra::Vector3;
/// let momentum = Covector(Vector3::new(1.0, 0.0, 0.0));
/// let Covector(coordinates) = momentum;
/// assert_eq!(coordinates.x, 1.0);
/// ```
/// ```compile_fail
/// use generic_scalars::Covector;
/// use nalgebra::Vector3;
/// let velocity = Vector3::new(1.0, 0.0, 0.0);
/// let _ = velocity + Covector(velocity); // 𝔤 + 𝔤* has no meaning
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(transparent)]
pub struct Covector<V>(pub V);

state_of_parts!([V: State] Covector<V>, V::Scalar, 0: V);
vector_operators!([V: Vector] Covector<V>);

impl<V: Vector<Dual = Covector<V>>> Vector for Covector<V> {
    type Dual = V;
    const DIM: usize = V::DIM;

    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(f: impl FnMut(usize) -> V::Scalar) -> Self {
        Self(V::from_coordinates(f))
    }
}
