//! A scheme that calls fields through a pointer: [`ByPointer`].

use crate::stages::flat_state::{FlatField, FlatState};
use crate::stages::newton::FieldOn;
use crate::{Equivariant, Increment, Scheme, Step, StepError, VectorField};
use lie_poisson::{Pair, Real, State};

/// A scheme that calls fields through a pointer, and computes with coordinates whose number it learns when it runs. Its steps
/// are compiled once for each scalar, and not for each field and each type of points. They are those of the scheme, to the last
/// bit, if the field neither has lanes nor remembers its stages in other coordinates.
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

/// The storage of the steps of a [`ByPointer`]: that of the scheme on coordinates, the coordinates of a point, those of its
/// rounding errors, and the points that are given back.
pub struct PointerSpace<S: Scheme, V: State> {
    scheme: S::Workspace<FlatState<V::Scalar>>,
    start: Option<FlatState<V::Scalar>>,
    low: Option<FlatState<V::Scalar>>,
    pool: V::Pool,
}

/// Writes the coordinates of z into a place that may have those of another point.
fn write<'a, V: State>(
    z: &V,
    place: &'a mut Option<FlatState<V::Scalar>>,
) -> &'a FlatState<V::Scalar> {
    if let Some(flat) = place.as_mut().filter(|flat| flat.has_shape_of(z)) {
        flat.set_entries(|i| z.entry(i));
    } else {
        *place = Some(FlatState::of(z));
    }
    place.get_or_insert_with(|| FlatState::of(z))
}

#[inline(never)]
fn increment_of<S: Scheme, T: Real>(
    scheme: &S,
    field: &FieldOn<'_, FlatState<T>>,
    z: &FlatState<T>,
    step: f64,
    workspace: &mut S::Workspace<FlatState<T>>,
) -> Result<Step<FlatState<T>>, StepError> {
    scheme.increment(&Pointed(field), z, step, workspace)
}

#[inline(never)]
fn refined_increment_of<S: Scheme, T: Real>(
    scheme: &S,
    field: &FieldOn<'_, FlatState<T>>,
    point: (&FlatState<T>, &FlatState<T>),
    step: f64,
    workspace: &mut S::Workspace<FlatState<T>>,
) -> Result<Increment<FlatState<T>>, StepError> {
    scheme.refined_increment(&Pointed(field), point, step, workspace)
}

impl<S: Scheme, V: State> PointerSpace<S, V> {
    /// Returns a point of its coordinates, whose storage goes back to the scheme.
    fn typed(&mut self, scheme: &S, z: &V, flat: FlatState<V::Scalar>) -> V {
        let mut point = V::take(&mut self.pool, z);
        flat.write_to(&mut point);
        if let Some(pool) = scheme.temporaries(&mut self.scheme) {
            flat.give(pool);
        }
        point
    }
}

impl<S: Equivariant> Equivariant for ByPointer<S> {}

impl<S: Scheme> Scheme for ByPointer<S> {
    type Workspace<V: State> = PointerSpace<S, V>;

    fn workspace<V: State>(&self) -> PointerSpace<S, V> {
        let scheme = self.0.workspace();
        PointerSpace { scheme, start: None, low: None, pool: V::Pool::default() }
    }

    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut PointerSpace<S, F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        let field = FlatField { field, space: z.shape() };
        let start = write(z, &mut workspace.start);
        let made = increment_of(&self.0, &field, start, step, &mut workspace.scheme)?;
        let Step { point, iterations } = made;
        Ok(Step { point: workspace.typed(&self.0, z, point), iterations })
    }

    fn refined_increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        (z, e): (&F::Point, &F::Point),
        step: f64,
        workspace: &mut PointerSpace<S, F::Point>,
    ) -> Result<Increment<F::Point>, StepError> {
        let field = FlatField { field, space: z.shape() };
        let PointerSpace { scheme, start, low, .. } = workspace;
        let point = (write(z, start), write(e, low));
        let Step { point: Pair(change, rest), iterations } =
            refined_increment_of(&self.0, &field, point, step, scheme)?;
        let mut typed = |flat| workspace.typed(&self.0, z, flat);
        Ok(Step { point: Pair(typed(change), typed(rest)), iterations })
    }

    fn temporaries<'a, V: State>(
        &self,
        workspace: &'a mut PointerSpace<S, V>,
    ) -> Option<&'a mut V::Pool> {
        Some(&mut workspace.pool)
    }

    fn forget<V: State>(&self, workspace: &mut PointerSpace<S, V>) {
        self.0.forget(&mut workspace.scheme);
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
