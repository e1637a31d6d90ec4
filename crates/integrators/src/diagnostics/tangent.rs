//! Tangent maps by dual numbers.

use core::convert::Infallible;
use lie_poisson::{DualNumber, Real, Vector, map_coordinates, seed};
use nalgebra::DMatrix;

/// Returns the matrix (T_z f)_ij = ∂f_i/∂z_j of a map f: V → W at z, of size dim W × dim V.
///
/// The derivative is exact: `f` is evaluated over dual numbers, once for each direction. A derivative that is NaN is
/// NaN in the matrix.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::tangent_map;
/// use lie_poisson::DualNumber;
/// use nalgebra::{DMatrix, Vector2, Vector3};
/// // f(x, y) = (xy, x², y)
/// let f = |z: &Vector2<DualNumber>| Vector3::new(z.x * z.y, z.x * z.x, z.y);
/// let expected = DMatrix::from_row_slice(3, 2, &[3.0, 2.0, 4.0, 0.0, 0.0, 1.0]);
/// assert_eq!(tangent_map(f, &Vector2::new(2.0, 3.0)), expected);
/// ```
pub fn tangent_map<V, V2, W2>(f: impl Fn(&V2) -> W2, z: &V) -> DMatrix<V::Scalar>
where
    V: Vector,
    V2: Vector<Scalar = DualNumber<V::Scalar>>,
    W2: Vector<Scalar = DualNumber<V::Scalar>>,
{
    match tangent_of(|z: &V2| Ok::<W2, Infallible>(f(z)), z) {
        Ok(tangent) => tangent,
        Err(never) => match never {},
    }
}

/// Returns the tangent map T_z f of a map that may have no value.
fn tangent_of<V, V2, W2, E>(
    f: impl Fn(&V2) -> Result<W2, E>,
    z: &V,
) -> Result<DMatrix<V::Scalar>, E>
where
    V: Vector,
    V2: Vector<Scalar = DualNumber<V::Scalar>>,
    W2: Vector<Scalar = DualNumber<V::Scalar>>,
{
    let mut tangent = DMatrix::from_element(W2::DIM, V::DIM, Real::from_f64(0.0));
    for j in 0..V::DIM {
        let column = f(&seed(z, &V::basis(j)))?;
        for i in 0..W2::DIM {
            tangent[(i, j)] = column.coordinate(i).derivative();
        }
    }
    Ok(tangent)
}

/// Returns f(z) and T_z f for a map of a space to itself.
pub(super) fn linearised<V, V2, E>(
    f: impl Fn(&V2) -> Result<V2, E>,
    z: &V,
) -> Result<(V, DMatrix<V::Scalar>), E>
where
    V: Vector,
    V2: Vector<Scalar = DualNumber<V::Scalar>>,
{
    let image = f(&map_coordinates(z, DualNumber::constant))?;
    Ok((
        map_coordinates(&image, |x: DualNumber<V::Scalar>| x.value_without_derivative()),
        tangent_of(f, z)?,
    ))
}
