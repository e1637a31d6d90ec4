//! Defects of Poisson maps: how far a map is from preserving brackets, with exact derivatives.

use lie_poisson::{
    DualNumber, Point, PoissonSpace, State, Vector, derivative_part, larger, map_coordinates, seed,
};
use momentum_map::{PoissonMap, SourcePoint};
use nalgebra::DMatrix;

/// Returns the matrix {w_i∘f, w_j∘f}(z) − {w_i, w_j}(f(z)) over all coordinates w of the target.
///
/// It vanishes if and only if f: P → Q respects the brackets at z, for brackets are determined by
/// the coordinates. Derivatives of `f` are taken by dual numbers, one evaluation per direction.
pub fn bracket_defects<P: PoissonSpace, Q: PoissonSpace>(
    source: &P,
    target: &Q,
    f: impl Fn(&Point<P, DualNumber>) -> Point<Q, DualNumber>,
    z: &Point<P>,
) -> DMatrix<f64> {
    let columns: Vec<Point<Q>> = (0..Point::<P>::DIM)
        .map(|k| {
            let along: Point<P> = Vector::basis(k);
            derivative_part(&f(&seed(z, &along)))
        })
        .collect();
    let constant: Point<P, DualNumber> = map_coordinates(z, DualNumber::constant);
    let image: Point<Q> =
        map_coordinates(&f(&constant), |x: DualNumber| x.value_without_derivative());
    let expected = target.poisson_tensor::<f64>(&image);
    let gradient = |i: usize| Vector::from_coordinates(|k| columns[k].coordinate(i));
    let n = Point::<Q>::DIM;
    DMatrix::from_fn(n, n, |i, j| {
        source.bracket::<f64>(z, &gradient(i), &gradient(j)) - expected[(i, j)]
    })
}

/// Returns the largest of the [`bracket_defects`] of a map that claims to be Poisson, from its `apply` alone.
pub fn map_defect<M: PoissonMap>(map: &M, z: &SourcePoint<M>) -> f64 {
    let apply = |z: &SourcePoint<M, DualNumber>| map.apply::<DualNumber>(z);
    largest(&bracket_defects(&map.source(), &map.target(), apply, z))
}

/// Returns max |entry|; NaN if one is NaN, where nalgebra's `amax` would drop it.
pub fn largest(matrix: &DMatrix<f64>) -> f64 {
    matrix.iter().fold(0.0, |m, x| larger(m, x.abs()))
}

#[cfg(test)]
mod tests {
    use super::largest;
    use nalgebra::DMatrix;

    #[test]
    fn a_nan_is_the_largest() {
        let largest_of = |entries| largest(&DMatrix::from_row_slice(2, 2, entries));
        assert_eq!(largest_of(&[1.0, -3.0, 2.0, 0.5]), 3.0);
        assert!(largest_of(&[1.0, f64::NAN, 2.0, 0.5]).is_nan());
        assert!(largest_of(&[f64::NAN, 1.0, 2.0, 0.5]).is_nan());
    }
}
