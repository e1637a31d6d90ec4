//! Faults of small elements alone. The law suites see them, because each residual is relative to the elements.

use crate::support::{TOLERANCE, laws, samples};
use lie_poisson::*;
use nalgebra::{Matrix3, Vector3};

/// Rotations with an infinitesimal and a finite adjoint action that are wrong for elements of 𝔤 of the size 10⁻⁸.
#[derive(Clone)]
struct WrongNearZero;

fn is_small<T: Real>(xi: &Vector3<T>) -> bool {
    xi.iter().all(|x| x.all_below(1e-7))
}

impl LieAlgebra for WrongNearZero {
    type Element<T: Real> = Vector3<T>;
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        let exact = xi.cross(eta);
        if is_small(xi) || is_small(eta) { exact + xi.component_mul(eta) } else { exact }
    }
}

impl LieGroup for WrongNearZero {
    type Algebra = Self;
    type Element<T: Real> = Matrix3<T>;
    fn algebra(&self) -> Self {
        Self
    }
    fn identity<T: Real>(&self) -> Matrix3<T> {
        SO3.identity()
    }
    fn compose<T: Real>(&self, g: &Matrix3<T>, h: &Matrix3<T>) -> Matrix3<T> {
        SO3.compose(g, h)
    }
    fn inverse<T: Real>(&self, g: &Matrix3<T>) -> Matrix3<T> {
        SO3.inverse(g)
    }
    fn exp<T: Real>(&self, xi: &Vector3<T>) -> Matrix3<T> {
        SO3.exp(xi)
    }
    fn adjoint<T: Real>(&self, g: &Matrix3<T>, xi: &Vector3<T>) -> Vector3<T> {
        SO3.adjoint(g, xi) * T::from_f64(if is_small(xi) { 1.5 } else { 1.0 })
    }
}

#[test]
fn of_algebras() {
    let report = laws::lie_algebra(&WrongNearZero, &samples()).unwrap();
    for law in ["antisymmetry", "Jacobi"] {
        assert!(report.residual(law).unwrap() > 0.1, "{law}: {report:?}");
    }
}

#[test]
fn of_groups() {
    let report = laws::lie_group(&WrongNearZero, &samples()).unwrap();
    for law in ["Ad preserves brackets", "ad is the derivative of Ad", "Ad* is the transpose of Ad"]
    {
        assert!(report.residual(law).unwrap() > 0.1, "{law}: {report:?}");
    }
    assert!(report.residual("associativity").unwrap() < TOLERANCE);
}

impl Representation for WrongNearZero {
    type Algebra = So3;
    type Space<T: Real> = Vector3<T>;
    fn algebra(&self) -> So3 {
        So3
    }
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector3<T>) -> Vector3<T> {
        SO3OnR3.act(xi, v) * T::from_f64(if is_small(xi) { 1.5 } else { 1.0 })
    }
    fn transpose_act<T: Real>(
        &self,
        xi: &Vector3<T>,
        alpha: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        SO3OnR3.transpose_act(xi, alpha)
    }
    fn diamond<T: Real>(
        &self,
        v: &Vector3<T>,
        alpha: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        SO3OnR3.diamond(v, alpha)
    }
}

impl GroupRepresentation for WrongNearZero {
    type Group = SO3;
    fn group(&self) -> SO3 {
        SO3
    }
    fn transform<T: Real>(&self, g: &Matrix3<T>, v: &Vector3<T>) -> Vector3<T> {
        g * v
    }
}

#[test]
fn of_representations() {
    let report = laws::representation(&WrongNearZero, &samples(), &samples()).unwrap();
    for law in ["commutator", "transpose", "diamond"] {
        assert!(report.residual(law).unwrap() > 0.1, "{law}: {report:?}");
    }
    let report = laws::group_representation(&WrongNearZero, &samples(), &samples()).unwrap();
    assert!(report.residual("derivative").unwrap() > 0.1);
    assert!(report.residual("homomorphism").unwrap() < TOLERANCE);
}
