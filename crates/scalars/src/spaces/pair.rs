//! Direct sums V ⊕ W of two vector spaces.

use crate::numbers::real::Real;
use crate::spaces::covector::Covector;
use crate::spaces::state::State;
use crate::spaces::vector::Vector;
use crate::{state_of_parts, vector_operators};

/// An element (v, w) of a direct sum V ⊕ W; the coordinates of v come first.
///
/// Elements (ξ, φ) ∈ 𝔤 ⋉ V of semidirect products, elements of direct products, and elements of the
/// corresponding groups are pairs.
///
/// ```
/// use generic_scalars::Pair;
/// use nalgebra::{Vector2, Vector3};
/// let Pair(angular, linear) = Pair(Vector3::new(1.0, 0.0, 0.0), Vector2::new(0.0, 1.0));
/// assert_eq!(angular.x, linear.y);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pair<A, B>(pub A, pub B);

impl<A, B> Covector<Pair<A, B>> {
    /// Creates the covector (α, β) from its two parts, for example the momentum (Π, Γ) of a heavy top.
    #[cfg_attr(optimised, inline(always))]
    pub const fn new(alpha: A, beta: B) -> Self {
        Self(Pair(alpha, beta))
    }
}

state_of_parts!([T: Real, A: State<Scalar = T>, B: State<Scalar = T>] Pair<A, B>, T, 0: A, 1: B);
vector_operators!([T: Real, A: Vector<Scalar = T>, B: Vector<Scalar = T>] Pair<A, B>);

impl<T: Real, A: Vector<Scalar = T>, B: Vector<Scalar = T>> Vector for Pair<A, B> {
    type Dual = Covector<Self>;
    const DIM: usize = A::DIM + B::DIM;

    #[allow(clippy::redundant_closure)] // `&mut f` would be called, and this closure is inlined.
    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(mut f: impl FnMut(usize) -> T) -> Self {
        let first = A::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| f(i),
        );
        let second = B::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| f(A::DIM + i),
        );
        Self(first, second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Vector1, Vector2};

    #[test]
    fn blocks_are_numbered_from_the_left() {
        type First = Pair<Vector2<f64>, Vector1<f64>>;
        type Second = Pair<Vector1<f64>, Pair<Vector2<f64>, Vector1<f64>>>;
        type Both = Pair<First, Second>;
        let expected = [0, 0, 1, 2, 3, 3, 4];
        let point = Both::from_coordinates(|i| i as f64);
        for (i, block) in expected.into_iter().enumerate() {
            assert_eq!(point.block(i), block, "{i}");
        }
        assert_eq!((Both::BLOCKS, Both::DIM), (5, expected.len()));
    }
}
