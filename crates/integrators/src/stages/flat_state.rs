//! A state whose dimension and blocks are known only when the program runs: [`FlatState`].

use crate::stages::newton::{FieldOn, without_derivatives};
use crate::vector_field::VectorField;
use lie_poisson::{Real, State};
use std::sync::Arc;

/// The largest number of blocks of coordinates.
const MOST_BLOCKS: usize = 8;

/// One value for each of four blocks.
pub(crate) type Four<T> = (((T,), (T,)), ((T,), (T,)));

/// The coordinates of a state of any type. Code that few steps need works on them, so that it is compiled once for each
/// scalar, and not for each type of states. Blocks after the seventh count as one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FlatState<T> {
    values: Vec<T>,
    /// The block of each coordinate.
    blocks: Arc<[usize]>,
}

impl<T: Real> FlatState<T> {
    /// Returns the coordinates of a state.
    pub(crate) fn of<V: State<Scalar = T>>(v: &V) -> Self {
        let block = |i| v.block(i).min(MOST_BLOCKS - 1);
        let zero = Self::zeros_of(&(0..v.dimension()).map(block).collect());
        zero.with(v)
    }

    /// Returns the coordinates of another state of the space that this one is from.
    pub(crate) fn with<V: State<Scalar = T>>(&self, v: &V) -> Self {
        let mut flat = self.clone();
        flat.set_coordinates(|i| v.coordinate(i));
        flat
    }

    /// Writes the coordinates to a state.
    pub(crate) fn write_to<V: State<Scalar = T>>(&self, v: &mut V) {
        v.set_coordinates(|i| self.coordinate(i));
    }
}

impl<T: Real> State for FlatState<T> {
    type Scalar = T;
    type Blocks = (Four<T>, Four<T>);
    type Shape = Arc<[usize]>;
    type Pool = Vec<Self>;

    fn dimension(&self) -> usize {
        self.values.len()
    }

    fn shape(&self) -> Arc<[usize]> {
        self.blocks.clone()
    }

    fn zeros_of(blocks: &Arc<[usize]>) -> Self {
        Self { values: vec![T::zero(); blocks.len()], blocks: blocks.clone() }
    }

    fn take(pool: &mut Vec<Self>, like: &Self) -> Self {
        pool.pop().filter(|v| v.same_shape(like)).unwrap_or_else(|| like.zeros_like())
    }

    fn give(self, pool: &mut Vec<Self>) {
        pool.push(self);
    }

    fn coordinate(&self, i: usize) -> T {
        self.values.get(i).copied().unwrap_or_else(T::zero)
    }

    fn set_coordinate(&mut self, i: usize, x: T) {
        if let Some(value) = self.values.get_mut(i) {
            *value = x;
        }
    }

    fn blocks(&self) -> usize {
        self.blocks.iter().max().map_or(1, |last| last + 1)
    }

    fn block(&self, i: usize) -> usize {
        self.blocks.get(i).copied().unwrap_or(0)
    }

    fn scale_in_place(&mut self, s: T) {
        self.values.iter_mut().for_each(|v| *v *= s);
    }

    fn add_multiple(&mut self, s: T, x: &Self) {
        self.values.iter_mut().zip(&x.values).for_each(|(v, x)| *v += s * *x);
    }
}

/// A field on the coordinates of points of a space.
pub(crate) struct FlatField<'a, V: State> {
    pub(crate) field: &'a FieldOn<'a, V>,
    pub(crate) space: V::Shape,
}

impl<V: State> VectorField<V::Scalar> for FlatField<'_, V> {
    type Point = FlatState<V::Scalar>;

    fn at(&self, z: &FlatState<V::Scalar>) -> FlatState<V::Scalar> {
        let mut value = z.zeros_like();
        self.at_into(z, &mut value);
        value
    }

    fn at_into(&self, z: &FlatState<V::Scalar>, value: &mut FlatState<V::Scalar>) {
        let (mut point, mut rate) = (V::zeros_of(&self.space), V::zeros_of(&self.space));
        z.write_to(&mut point);
        self.field.at_into(&point, &mut rate);
        value.set_coordinates(|i| rate.coordinate(i));
    }

    fn derivative(
        &self,
        z: &FlatState<V::Scalar>,
        v: &FlatState<V::Scalar>,
    ) -> Option<FlatState<V::Scalar>> {
        let (mut point, mut tangent) = (V::zeros_of(&self.space), V::zeros_of(&self.space));
        z.write_to(&mut point);
        v.write_to(&mut tangent);
        self.field.derivative(&point, &tangent).map(|slope| z.with(&slope))
    }
}

/// The values of a field, with all derivatives zero.
pub(crate) struct ValueField<'a, V: State>(pub(crate) &'a FieldOn<'a, V>);

impl<V: State> VectorField<V::Scalar> for ValueField<'_, V> {
    type Point = V;

    fn at(&self, z: &V) -> V {
        without_derivatives(&self.0.at(z))
    }

    fn derivative(&self, z: &V, v: &V) -> Option<V> {
        self.0.derivative(z, v).map(|slope| without_derivatives(&slope))
    }
}

#[cfg(test)]
mod tests {
    use super::{FlatField, FlatState};
    use crate::vector_field::{VectorField, from_fn};
    use lie_poisson::{Pair, Sites, State, Vector};
    use nalgebra::{Vector1, Vector2};

    type Two = Pair<Vector1<f64>, Vector2<f64>>;

    /// The sites of a lattice share their blocks, which are then not contiguous.
    #[test]
    fn coordinates_keep_their_values_and_blocks() {
        let site = |x: f64| Two::from_coordinates(|i| x + i as f64);
        let z = Sites::new(vec![site(1.0), site(10.0)]);
        let flat = FlatState::of(&z);
        assert_eq!(flat.values, [1.0, 2.0, 3.0, 10.0, 11.0, 12.0]);
        assert_eq!((0..6).map(|i| flat.block(i)).collect::<Vec<_>>(), [0, 1, 1, 0, 1, 1]);
        let other = Sites::new(vec![site(-3.0), site(0.5)]);
        let mut written = z.zeros_like();
        flat.with(&other).write_to(&mut written);
        assert!(written == other && flat.with(&other).same_shape(&flat) && flat.blocks() == 2);
    }

    #[test]
    fn blocks_after_the_seventh_count_as_one() {
        type Four = Pair<Pair<Vector1<f64>, Vector1<f64>>, Pair<Vector1<f64>, Vector1<f64>>>;
        let flat = FlatState::of(&Pair::<Four, Pair<Four, Vector1<f64>>>::zero());
        assert_eq!((0..9).map(|i| flat.block(i)).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5, 6, 7, 7]);
    }

    #[test]
    fn a_field_on_coordinates_is_the_field() {
        let field = from_fn(|z: &Two| Pair(-z.0, z.1 * z.0.x));
        let z: Two = Pair(Vector1::new(0.5), Vector2::new(2.0, -3.0));
        let (flat, on_coordinates) =
            (FlatState::of(&z), FlatField { field: &field, space: z.shape() });
        assert_eq!(on_coordinates.at(&flat), FlatState::of(&field.at(&z)));
        assert_eq!(on_coordinates.derivative(&flat, &flat), None);
    }
}
