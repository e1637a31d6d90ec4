//! Types that implement only what a trait requires, and have the rest from its defaults.

use crate::support::{TOLERANCE, holds, laws, samples};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::Vector2;
use num_complex::Complex;

/// The Hopf map, by its values alone.
#[derive(Clone)]
struct Values;

impl PoissonMap for Values {
    type Source = Symplectic<So3OnC2>;
    type Target = LiePoisson<So3>;
    fn source(&self) -> Self::Source {
        HOPF.source()
    }
    fn target(&self) -> Self::Target {
        HOPF.target()
    }
    fn apply<T: Real>(&self, z: &Vector2<Complex<T>>) -> TargetPoint<Self, T> {
        HOPF.apply::<T>(z)
    }
}

#[test]
fn a_map_by_its_values() {
    holds(laws::poisson_map(&Values, &samples()).unwrap());
    for (z, alpha) in samples().iter().zip(samples()) {
        let [derived, closed] =
            [Values.pull_back::<f64>(&alpha, z), HOPF.pull_back::<f64>(&alpha, z)];
        assert!((derived - closed).max_abs() < TOLERANCE);
        let [derived, closed] =
            [Values.generator::<f64>(&alpha, z), HOPF.generator::<f64>(&alpha, z)];
        assert!((derived - closed).max_abs() < TOLERANCE);
        assert!(closed.max_abs() > 0.01);
    }
}

/// The plane with Ω(u, v) = det(u, v).
#[derive(Clone)]
struct Plane;

impl VectorSpace for Plane {
    type Point<T: Real> = Vector2<T>;
}

impl PoissonSpace for Plane {
    fn hamiltonian_vector<T: Real>(&self, _: &Vector2<T>, dh: &Covector<Vector2<T>>) -> Vector2<T> {
        Vector2::new(dh.0.y, -dh.0.x)
    }
}

impl SymplecticSpace for Plane {
    fn symplectic_form<T: Real>(&self, u: &Vector2<T>, v: &Vector2<T>) -> T {
        u.x * v.y - u.y * v.x
    }
}

#[test]
fn a_symplectic_space_by_its_form() {
    holds(laws::symplectic_space(&Plane, &samples()).unwrap());
    let flat: Covector<Vector2<f64>> = Plane.flat(&Vector2::new(3.0, 5.0));
    assert_eq!(flat.0, Vector2::new(-5.0, 3.0));
}

/// SL(2) on the plane, by its action and its form.
#[derive(Clone)]
struct Unimodular;

impl Representation for Unimodular {
    type Algebra = Sl2;
    type Space<T: Real> = Vector2<T>;
    fn algebra(&self) -> Sl2 {
        SL2OnR2.algebra()
    }
    fn act<T: Real>(&self, xi: &RepresentedElement<Self, T>, v: &Vector2<T>) -> Vector2<T> {
        SL2OnR2.act::<T>(xi, v)
    }
}

impl SymplecticRepresentation for Unimodular {
    fn form<T: Real>(&self, u: &Vector2<T>, v: &Vector2<T>) -> T {
        SL2OnR2.form::<T>(u, v)
    }
    fn sharp<T: Real>(&self, alpha: &Covector<Vector2<T>>) -> Vector2<T> {
        SL2OnR2.sharp::<T>(alpha)
    }
}

#[test]
fn a_symplectic_representation_by_its_form() {
    holds(laws::symplectic_space(&Symplectic(Unimodular), &samples()).unwrap());
    let map = QuadraticMomentumMap::new(Unimodular, Side::Left);
    holds(laws::poisson_map(&map, &samples()).unwrap());
    for x in samples::<Vector2<f64>>() {
        let difference = Unimodular.flat::<f64>(&x) - SL2OnR2.flat::<f64>(&x);
        assert!(difference.max_abs() < TOLERANCE);
    }
}

/// What a representation says of its odd powers is what the default computes from its matrices.
#[test]
fn odd_powers_belong_where_their_defect_is_round_off() {
    fn check<R: SymplecticRepresentation>(r: &R) {
        assert_eq!(r.odd_powers_belong(), odd_power_defect(r) < 1e-12);
    }
    check(&SL2OnR2);
    check(&So3OnC2);
    check(&Reversed(SL2OnR2));
    check(&Reversed(Diagonal::<_, 2>(Unimodular)));
    check(&Sum(SL2OnR2, Reversed(SL2OnR2)));
    check(&UnitaryOnComplexSpace::<2>);
    assert!(Unimodular.odd_powers_belong());
}
