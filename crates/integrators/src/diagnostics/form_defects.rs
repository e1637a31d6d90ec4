//! Defects of a map with respect to a symplectic form or a Poisson bracket.

use super::tangent::{linearised, tangent_map};
use core::convert::Infallible;
use lie_poisson::{DualNumber, Point, PoissonSpace, Vector, larger};
use momentum_map::SymplecticSpace;
use nalgebra::DMatrix;

/// Returns max |DΦᵀ J DΦ − J| at z for a map Φ of a symplectic space (P, Ω), where J_ij = Ω(e_i, e_j).
///
/// It is zero if and only if Φ*Ω = Ω at z. It is in the units of Ω, and NaN if a derivative is NaN.
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
/// assert_eq!(symplecticity_defect(&SymplecticComplexSpace::<1>, dilation, &z), 3.0);
/// ```
pub fn symplecticity_defect<P: SymplecticSpace>(
    space: &P,
    f: impl Fn(&Point<P, DualNumber>) -> Point<P, DualNumber>,
    z: &Point<P>,
) -> f64 {
    form_change(space, &tangent_map(f, z))
}

/// Returns max |DφᵀJDφ − J| for the given tangent map Dφ.
pub(super) fn form_change<P: SymplecticSpace>(space: &P, tangent: &DMatrix<f64>) -> f64 {
    let n = Point::<P>::DIM;
    let form = DMatrix::from_fn(n, n, |i, j| {
        space.symplectic_form::<f64>(&Vector::basis(i), &Vector::basis(j))
    });
    largest(&(tangent.transpose() * &form * tangent - form))
}

/// Returns max |Dφ Λ Dφᵀ − Λ∘φ| at z for a map φ of a Poisson space with tensor Λ_ij(z) = {z_i, z_j}.
///
/// Entry (i, j) is {φ_i, φ_j}(z) − {z_i, z_j}(φ(z)). All entries vanish if and only if φ preserves the bracket at z.
/// The defect is in the units of Λ, and NaN if a derivative is NaN.
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
/// assert_eq!(poisson_defect(&space, reflection, &pi), 6.0);
/// ```
pub fn poisson_defect<P: PoissonSpace>(
    space: &P,
    f: impl Fn(&Point<P, DualNumber>) -> Point<P, DualNumber>,
    z: &Point<P>,
) -> f64 {
    let f = |z: &Point<P, DualNumber>| Ok::<_, Infallible>(f(z));
    match linearised(f, z) {
        Ok((image, tangent)) => bracket_change(space, z, &image, &tangent),
        Err(never) => match never {},
    }
}

/// Returns max |Dφ Λ(z) Dφᵀ − Λ(φ(z))| for the given tangent map Dφ.
pub(super) fn bracket_change<P: PoissonSpace>(
    space: &P,
    z: &Point<P>,
    image: &Point<P>,
    tangent: &DMatrix<f64>,
) -> f64 {
    let (before, after) = (space.poisson_tensor::<f64>(z), space.poisson_tensor::<f64>(image));
    largest(&(tangent * before * tangent.transpose() - after))
}

/// Returns the largest magnitude of an entry, or NaN if an entry is NaN; nalgebra's `amax` would drop the NaN.
fn largest(matrix: &DMatrix<f64>) -> f64 {
    matrix.iter().fold(0.0, |m, x| larger(m, x.abs()))
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
        assert_eq!(stretch(3.0), 0.5);
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
