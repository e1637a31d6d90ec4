//! Defects of a map with respect to a symplectic form or a Poisson bracket.

use super::tangent::linearised;
use crate::natural_scales::natural_scales;
use core::convert::Infallible;
use lie_poisson::{BlockScales, DualNumber, Point, PoissonSpace, State, Vector, larger};
use momentum_map::SymplecticSpace;
use nalgebra::DMatrix;

/// Returns max |DΦᵀ J DΦ − J| / max |J| at z for a map Φ of a symplectic space (P, Ω), where J_ij = Ω(e_i, e_j).
///
/// It is zero if and only if Φ*Ω = Ω at z, and NaN if a derivative is NaN.
///
/// The entries are those of coordinates in units of a [scale](BlockScales) for each [block](lie_poisson::State::BLOCKS),
/// such as q and p: the size of the block at z or Φ(z), or what DΦ gives to it from the other blocks. The defect is
/// therefore a number that does not depend on the units of q and p. On a space of one block it is the ratio of the largest
/// entries of the two matrices.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed., Def. VI.2.2.
///
/// # Example
/// A shear is symplectic on R² = T∗R; a dilation is not:
/// ```
/// use collective_integrators::diagnostics::symplecticity_defect;
/// use lie_poisson::{DualNumber, Vector};
/// use momentum_map::SymplecticComplexSpace;
/// use nalgebra::Vector1;
/// use lie_poisson::num_complex::Complex;
/// type Point = Vector1<Complex<DualNumber>>;
/// let z = Vector1::new(Complex::new(0.3, 0.4));
/// let shear = |z: &Point| Vector1::new(Complex::new(z[0].re, z[0].im - z[0].re * z[0].re));
/// assert_eq!(symplecticity_defect(&SymplecticComplexSpace::<1>, shear, &z), 0.0);
/// let dilation = |z: &Point| z.scaled(DualNumber::constant(2.0));
/// assert!((symplecticity_defect(&SymplecticComplexSpace::<1>, dilation, &z) - 3.0).abs() < 1e-15);
/// ```
pub fn symplecticity_defect<P: SymplecticSpace>(
    space: &P,
    f: impl Fn(&Point<P, DualNumber>) -> Point<P, DualNumber>,
    z: &Point<P>,
) -> f64 {
    let f = |z: &Point<P, DualNumber>| Ok::<_, Infallible>(f(z));
    match linearised(f, z) {
        Ok((image, tangent)) => form_change(space, [z, &image], &tangent),
        Err(never) => match never {},
    }
}

/// Returns the defect of the form for a map with the given tangent map Dφ that takes the first point to the second.
pub(super) fn form_change<P: SymplecticSpace>(
    space: &P,
    points: [&Point<P>; 2],
    tangent: &DMatrix<f64>,
) -> f64 {
    let n = Point::<P>::DIM;
    let form = DMatrix::from_fn(n, n, |i, j| {
        space.symplectic_form::<f64>(&Vector::basis(i), &Vector::basis(j))
    });
    let scales = scales_of(points, tangent);
    let at = |i: usize| scales.at(points[0].block(i));
    // Vectors of the size of the scales have forms of this size.
    let in_scales = |i, j, entry: f64| entry * at(i) * at(j);
    let change = largest(&(tangent.transpose() * &form * tangent - &form), in_scales);
    relative(change, largest(&form, in_scales))
}

/// Returns max |Dφ Λ Dφᵀ − Λ∘φ| / max |Λ| at z for a map φ of a Poisson space with tensor Λ_ij(z) = {z_i, z_j}, where
/// max |Λ| is the largest entry at z and at φ(z).
///
/// Entry (i, j) is {φ_i, φ_j}(z) − {z_i, z_j}(φ(z)). All entries vanish if and only if φ preserves the bracket at z.
/// The defect is NaN if a derivative is NaN.
///
/// The entries are those of coordinates in units of a [scale](BlockScales) for each [block](lie_poisson::State::BLOCKS),
/// such as Π and Γ: the size of the block at z or φ(z), or what Dφ gives to it from the other blocks. The defect is
/// therefore a number that does not depend on units. On a space of one block it is the ratio of the largest entries of the
/// two matrices.
///
/// Source: Hairer, Lubich & Wanner, *Geometric Numerical Integration*, 2nd ed., Def. VII.2.6 and
/// Lemma VII.2.8; Ohsawa 2019, §5.1.
///
/// # Example
/// Rotations of so(3)∗ are Poisson maps; the reflection Π ↦ −Π is not:
/// ```
/// use collective_integrators::diagnostics::poisson_defect;
/// use lie_poisson::{Covector, DualNumber, LiePoisson, So3};
/// use nalgebra::Vector3;
/// let space = LiePoisson::minus(So3);
/// let pi = Covector(Vector3::new(1.0, 2.0, 3.0));
/// type Momentum = Covector<Vector3<DualNumber>>;
/// let quarter_turn = |p: &Momentum| Covector(Vector3::new(-p.0.y, p.0.x, p.0.z));
/// assert_eq!(poisson_defect(&space, quarter_turn, &pi), 0.0);
/// let reflection = |p: &Momentum| -*p;
/// assert!((poisson_defect(&space, reflection, &pi) - 2.0).abs() < 1e-15);
/// ```
pub fn poisson_defect<P: PoissonSpace>(
    space: &P,
    f: impl Fn(&Point<P, DualNumber>) -> Point<P, DualNumber>,
    z: &Point<P>,
) -> f64 {
    let f = |z: &Point<P, DualNumber>| Ok::<_, Infallible>(f(z));
    match linearised(f, z) {
        Ok((image, tangent)) => bracket_change(space, [z, &image], &tangent),
        Err(never) => match never {},
    }
}

/// Returns the defect of the bracket for a map with the given tangent map Dφ that takes the first point to the second.
pub(super) fn bracket_change<P: PoissonSpace>(
    space: &P,
    points: [&Point<P>; 2],
    tangent: &DMatrix<f64>,
) -> f64 {
    let [before, after] = points.map(|z| space.poisson_tensor::<f64>(z));
    let scales = scales_of(points, tangent);
    let at = |i: usize| scales.at(points[0].block(i));
    let in_scales = |i, j, entry: f64| entry / at(i) / at(j);
    let size = larger(largest(&before, in_scales), largest(&after, in_scales));
    let change = tangent * before * tangent.transpose() - after;
    relative(largest(&change, in_scales), size)
}

/// Returns the scales of the blocks for a map that takes the first point to the second.
fn scales_of<V: Vector<Scalar = f64>>(
    [z, image]: [&V; 2],
    tangent: &DMatrix<f64>,
) -> BlockScales<V> {
    let mut sizes = BlockScales::of(z);
    sizes.include(image);
    natural_scales(V::BLOCKS, &sizes, |a, b| {
        let change = |i: usize, j: usize| tangent[(i, j)] - if i == j { 1.0 } else { 0.0 };
        let of = |block| (0..V::DIM).filter(move |&i| z.block(i) == block);
        let entries = of(a).flat_map(|i| of(b).map(move |j| (i, j)));
        entries.fold(0.0, |size: f64, (i, j)| size.hypot(change(i, j)))
    })
}

/// Returns the largest magnitude of an entry in the units of its row and column, or NaN if an entry is NaN; nalgebra's
/// `amax` would drop the NaN.
fn largest(matrix: &DMatrix<f64>, in_units: impl Fn(usize, usize, f64) -> f64) -> f64 {
    let entry = |i: usize, j: usize| in_units(i, j, matrix[(i, j)]).abs();
    let entries = (0..matrix.ncols()).flat_map(|j| (0..matrix.nrows()).map(move |i| (i, j)));
    entries.fold(0.0, |most, (i, j)| larger(most, entry(i, j)))
}

/// Returns a change relative to a size. No change is none of any size.
fn relative(change: f64, size: f64) -> f64 {
    if change == 0.0 { 0.0 } else { change / size }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lie_poisson::{Covector, LiePoisson, RealSpace, So3};
    use momentum_map::{Cotangent, CotangentBundle};
    use nalgebra::{Vector2, Vector3};

    #[test]
    fn the_linear_map_of_a_factor_changes_the_form_by_its_determinant() {
        let space = CotangentBundle(RealSpace::<2>);
        let z = Cotangent::new(Vector2::new(1.0, 2.0), Covector(Vector2::new(0.5, -1.0)));
        let stretch = |factor: f64| {
            symplecticity_defect(
                &space,
                |z| Cotangent::new(z.q.map(|x| x * factor), Covector(z.p.0.map(|x| x / 2.0))),
                &z,
            )
        };
        assert_eq!(stretch(2.0), 0.0);
        assert!((stretch(3.0) - 0.5).abs() < 1e-15);
    }

    /// The map (q, p) ↦ (2q, p) doubles the form, whatever the units of q and p.
    #[test]
    fn a_defect_of_a_form_is_the_same_in_all_units() {
        let space = CotangentBundle(RealSpace::<2>);
        for (q, p) in [(1.0, 1.0), (1e30, 1.0), (1e-30, 1e-30), (1e-30, 1e30), (0.0, 1.0)] {
            let z =
                Cotangent::new(Vector2::new(1.0, 2.0) * q, Covector(Vector2::new(0.5, -1.0) * p));
            let bend = |z: &Cotangent<Vector2<DualNumber>>| {
                let turned = Vector2::new(z.p.0.y, z.p.0.x) * DualNumber::constant(0.5 * q / p);
                Cotangent::new(z.q + z.q + turned, z.p)
            };
            let defect = symplecticity_defect(&space, bend, &z);
            assert!((defect - 1.0).abs() < 1e-15, "{q:e} {p:e} {defect}");
        }
    }

    #[test]
    fn a_nan_derivative_is_a_nan_defect() {
        let space = LiePoisson::minus(So3);
        let pi = Covector(Vector3::new(1.0, 2.0, 3.0));
        for broken in 0..3 {
            let f = |p: &Covector<Vector3<DualNumber>>| {
                let mut image = *p;
                image.0[broken] = DualNumber::new(p.0[broken].value_without_derivative(), f64::NAN);
                image
            };
            assert!(poisson_defect(&space, f, &pi).is_nan());
        }
        let nan = DualNumber::constant(f64::NAN);
        let f = |_: &Covector<Vector3<DualNumber>>| Vector::from_coordinates(|_| nan);
        assert!(poisson_defect(&space, f, &pi).is_nan());
    }
}
