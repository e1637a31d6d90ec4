//! A scheme that calls fields through a pointer: [`ByPointer`].

use crate::error::StepError;
use crate::schemes::scheme::{Equivariant, Increment, Scheme, Step};
use crate::stages::newton::FieldOn;
use crate::vector_field::VectorField;
use lie_poisson::{Real, State};

/// A scheme that calls fields through a pointer, so that its steps are compiled once for each type of points, and not for each
/// field. Its steps are those of the scheme, to the last bit, if the field neither has lanes nor remembers its stages in other
/// coordinates.
///
/// It is meant for fields that cost much more than a call, and of which there are many types.
///
/// # Example
/// ```
/// use collective_integrators::{ByPointer, Direct, RungeKutta, Start, from_fn};
/// use nalgebra::Vector2;
/// let pendulum = || from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
/// let (gauss, start) = (RungeKutta::gauss(2)?, Vector2::new(1.0, 0.0));
/// let end = Direct::new(gauss.clone(), pendulum()).after(&start, 0.1, 100)?.state;
/// assert_eq!(Direct::new(ByPointer(gauss), pendulum()).after(&start, 0.1, 100)?.state, end);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ByPointer<S>(pub S);

/// A field behind a pointer.
struct Pointed<'a, V: State>(&'a FieldOn<'a, V>);

impl<V: State> VectorField<V::Scalar> for Pointed<'_, V> {
    type Point = V;

    fn at(&self, z: &V) -> V {
        self.0.at(z)
    }

    fn at_into(&self, z: &V, value: &mut V) {
        self.0.at_into(z, value);
    }

    fn derivative(&self, z: &V, v: &V) -> Option<V> {
        self.0.derivative(z, v)
    }
}

#[inline(never)]
fn increment_of<S: Scheme, V: State>(
    scheme: &S,
    field: &FieldOn<'_, V>,
    z: &V,
    step: f64,
    workspace: &mut S::Workspace<V>,
) -> Result<Step<V>, StepError> {
    scheme.increment::<V::Scalar, _>(&Pointed(field), z, step, workspace)
}

impl<S: Equivariant> Equivariant for ByPointer<S> {}

impl<S: Scheme> Scheme for ByPointer<S> {
    type Workspace<V: State> = S::Workspace<V>;

    fn workspace<V: State>(&self) -> Self::Workspace<V> {
        self.0.workspace()
    }

    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        increment_of(&self.0, field, z, step, workspace)
    }

    fn refined_increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        (z, e): (&F::Point, &F::Point),
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Increment<F::Point>, StepError> {
        self.0.refined_increment(&Pointed(field), (z, e), step, workspace)
    }

    fn temporaries<'a, V: State>(
        &self,
        workspace: &'a mut Self::Workspace<V>,
    ) -> Option<&'a mut V::Pool> {
        self.0.temporaries(workspace)
    }

    fn forget<V: State>(&self, workspace: &mut Self::Workspace<V>) {
        self.0.forget(workspace);
    }

    fn order(&self) -> usize {
        self.0.order()
    }

    fn is_symplectic(&self) -> bool {
        self.0.is_symplectic()
    }

    fn is_symmetric(&self) -> bool {
        self.0.is_symmetric()
    }

    fn preserves_quadratic_invariants(&self) -> bool {
        self.0.preserves_quadratic_invariants()
    }
}
