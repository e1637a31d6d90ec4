//! Exact derivatives of maps between vector spaces, by dual numbers.

use crate::numbers::dual_number::DualNumber;
use crate::numbers::real::Real;
use crate::spaces::vector::Vector;

/// Returns z + ε v, the dual point at which a map is evaluated to get its derivative along v.
#[cfg_attr(optimised, inline(always))]
pub fn seed<V, W>(z: &V, v: &V) -> W
where
    V: Vector,
    W: Vector<Scalar = DualNumber<V::Scalar>>,
{
    W::from_coordinates(
        #[cfg_attr(optimised, inline(always))]
        |i| DualNumber::new(z.coordinate(i), v.coordinate(i)),
    )
}

/// Returns the coefficient of ε in w, the derivative of a map that was evaluated at a dual point.
#[cfg_attr(optimised, inline(always))]
pub fn derivative_part<T, W, V>(w: &W) -> V
where
    T: Real,
    W: Vector<Scalar = DualNumber<T>>,
    V: Vector<Scalar = T>,
{
    V::from_coordinates(
        #[cfg_attr(optimised, inline(always))]
        |i| w.coordinate(i).derivative(),
    )
}

/// Computes the differential df(z) ∈ V∗ by dual numbers, with one evaluation of `f` for each coordinate.
///
/// # Example
/// ```
/// use generic_scalars::{Covector, DualNumber, differential};
/// use nalgebra::Vector2;
/// // f(x, y) = x² y, df = (2xy, x²)
/// let f = |v: &Vector2<DualNumber>| v.x * v.x * v.y;
/// assert_eq!(differential(f, &Vector2::new(3.0, 5.0)), Covector(Vector2::new(30.0, 9.0)));
/// ```
#[cfg_attr(optimised, inline(always))]
pub fn differential<V, W>(f: impl Fn(&W) -> DualNumber<V::Scalar>, z: &V) -> V::Dual
where
    V: Vector,
    W: Vector<Scalar = DualNumber<V::Scalar>>,
{
    V::Dual::from_coordinates(
        #[cfg_attr(optimised, inline(always))]
        |i| f(&seed(z, &V::basis(i))).derivative(),
    )
}

/// Computes the transposed tangent map (T_z f)ᵀ α ∈ V∗ of f: V → W for a covector α ∈ W∗.
///
/// `A` is the type of α; `V2` and `W2` are V and W over dual numbers.
#[cfg_attr(optimised, inline(always))]
pub fn transposed_tangent<V, V2, A, W2>(f: impl Fn(&V2) -> W2, z: &V, alpha: &A) -> V::Dual
where
    V: Vector,
    V2: Vector<Scalar = DualNumber<V::Scalar>>,
    A: Vector<Scalar = V::Scalar>,
    W2: Vector<Scalar = DualNumber<V::Scalar>>,
{
    V::Dual::from_coordinates(
        #[cfg_attr(optimised, inline(always))]
        |i| {
            let column: A::Dual = derivative_part(&f(&seed(z, &V::basis(i))));
            alpha.pairing(&column)
        },
    )
}
