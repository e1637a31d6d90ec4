//! The law suites for families of algebras and representations, from the smallest member to dimensions in the tens.

use crate::support::{holds, laws, samples};
use lie_poisson::*;
use nalgebra::SVector;

/// Checks the laws of an algebra and of its brackets. The basis counts as samples, too.
fn algebra_laws<A: LieAlgebra>(algebra: &A) {
    holds(laws::lie_algebra(algebra, &samples()[..1]).unwrap());
    holds(laws::poisson_space(&LiePoisson::minus(algebra.clone()), &samples()[..1]).unwrap());
}

fn with_casimirs<A: Casimirs>(algebra: &A) {
    algebra_laws(algebra);
    holds(laws::casimirs(algebra, &samples()).unwrap());
}

#[test]
#[ignore = "long"]
fn families_of_algebras() {
    with_casimirs(&RealSpace::<1>);
    with_casimirs(&RealSpace::<20>);
    with_casimirs(&UnitaryAlgebra::<1>);
    with_casimirs(&UnitaryAlgebra::<2>);
    with_casimirs(&UnitaryAlgebra::<4>);
    with_casimirs(&Su2);
    with_casimirs(&PowerAlgebra::<_, 1>(So3));
    with_casimirs(&PowerAlgebra::<_, 6>(So3));
    with_casimirs(&PowerAlgebra::<_, 3>(Se3::default()));
    with_casimirs(&ProductAlgebra(UnitaryAlgebra::<2>, PowerAlgebra::<_, 3>(Sl2)));
    algebra_laws(&RealSpace::<0>);
    algebra_laws(&UnitaryAlgebra::<0>);
    algebra_laws(&PowerAlgebra::<_, 0>(So3));
}

/// Returns the pairs j < k of numbers below n, which number the planes of rotations.
fn planes(n: usize) -> Vec<(usize, usize)> {
    (0..n).flat_map(|j| (j + 1..n).map(move |k| (j, k))).collect()
}

/// Returns the algebra so(M) of dimension N = M(M − 1)/2 in the basis E_jk − E_kj, with constants times a number.
fn rotations<const N: usize>(m: usize, scale: f64) -> StructureConstants<N> {
    let planes = planes(m);
    assert_eq!(planes.len(), N);
    // The entry (a, b) of E_jk − E_kj
    let entry = |(j, k): (usize, usize), a, b| {
        f64::from(u8::from((a, b) == (j, k))) - f64::from(u8::from((a, b) == (k, j)))
    };
    StructureConstants::new(|x, y, z| {
        let product = |x, y, (a, b)| -> f64 {
            (0..m).map(|c| entry(planes[x], a, c) * entry(planes[y], c, b)).sum()
        };
        scale * (product(x, y, planes[z]) - product(y, x, planes[z]))
    })
    .unwrap()
}

#[test]
fn tables_of_structure_constants() {
    algebra_laws(&StructureConstants::<1>::new(|_, _, _| 0.0).unwrap());
    algebra_laws(&rotations::<1>(2, 1.0));
    algebra_laws(&rotations::<3>(3, 1e-3));
    algebra_laws(&rotations::<6>(4, 1.0));
    algebra_laws(&rotations::<10>(5, 0.7));
    // The constructor has checked Jacobi's identity, for which the suite would take seconds.
    let so6 = LiePoisson::minus(rotations::<15>(6, 1.0));
    holds(laws::poisson_space(&so6, &samples()[..1]).unwrap());
    // control: one constant of so(5) with another value, and its opposite
    let so5 = rotations::<10>(5, 1.0);
    let spoilt = StructureConstants::<10>::new(|i, j, k| {
        let change = f64::from(u8::from((i, j, k) == (0, 1, 4)));
        so5.constant(i, j, k) + change - f64::from(u8::from((i, j, k) == (1, 0, 4)))
    });
    assert!(matches!(spoilt, Err(StructureError::Jacobi { .. })));
}

fn representation_laws<R: GroupRepresentation>(r: &R) {
    holds(laws::representation(r, &samples()[..2], &samples()[..2]).unwrap());
    holds(laws::group_representation(r, &samples()[..2], &samples()[..2]).unwrap());
    let group = SemidirectGroup(r.clone());
    holds(laws::lie_group(&group, &samples()[..2]).unwrap());
}

#[test]
fn families_of_representations() {
    representation_laws(&UnitaryOnComplexSpace::<1>);
    representation_laws(&UnitaryOnComplexSpace::<3>);
    representation_laws(&SP1OnQuaternions::<1>);
    representation_laws(&SP1OnQuaternions::<7>);
    representation_laws(&Diagonal::<_, 1>(SO3OnR3));
    representation_laws(&Diagonal::<_, 12>(SO3OnR3));
    representation_laws(&Sum(Diagonal::<_, 5>(SU2OnC2), Adjoint(SU2)));
    holds(laws::lie_group(&UnitaryGroup::<1>, &samples()).unwrap());
}

#[test]
#[ignore = "long"]
fn families_of_large_groups() {
    representation_laws(&UnitaryOnComplexSpace::<5>);
    holds(laws::lie_group(&UnitaryGroup::<5>, &samples()).unwrap());
    holds(laws::lie_group(&PowerGroup::<_, 12>(SU2), &samples()).unwrap());
    holds(laws::cayley(&PowerGroup::<_, 12>(SE3::default()), &samples()).unwrap());
}

/// The constant bracket of a canonical plane, for products that are no duals of algebras.
#[derive(Clone)]
struct Plane;

impl VectorSpace for Plane {
    type Point<T: Real> = SVector<T, 2>;
}

impl PoissonSpace for Plane {
    fn hamiltonian_vector<T: Real>(
        &self,
        _: &SVector<T, 2>,
        dh: &Covector<SVector<T, 2>>,
    ) -> SVector<T, 2> {
        SVector::from([dh.0.y, -dh.0.x])
    }
}

/// A bracket {f, g} = v·(∇f × ∇g) on R³ with v = (y, z, x). Jacobi's identity fails, since v·curl v ≠ 0.
#[derive(Clone)]
struct NotPoisson;

impl VectorSpace for NotPoisson {
    type Point<T: Real> = SVector<T, 3>;
}

impl PoissonSpace for NotPoisson {
    fn hamiltonian_vector<T: Real>(
        &self,
        z: &SVector<T, 3>,
        dh: &Covector<SVector<T, 3>>,
    ) -> SVector<T, 3> {
        SVector::from([z.y, z.z, z.x]).cross(&dh.0)
    }
}

#[test]
fn products_and_powers_of_poisson_spaces() {
    let so3 = LiePoisson::plus(So3);
    holds(laws::poisson_space(&ProductSpace(so3, Plane), &samples()).unwrap());
    holds(laws::poisson_space(&PowerSpace::<_, 1>(so3), &samples()).unwrap());
    let many = ProductSpace(PowerSpace::<_, 6>(so3), PowerSpace::<_, 5>(Plane));
    holds(laws::poisson_space(&many, &samples()[..1]).unwrap());
    // control: a factor that breaks the identity breaks that of the product
    let broken = ProductSpace(Plane, PowerSpace::<_, 4>(NotPoisson));
    let report = laws::poisson_space(&broken, &samples()).unwrap();
    assert!(report.residual("Jacobi").unwrap() > 1e-3);
    assert!(report.residual("antisymmetry").unwrap() < 1e-15);
}

/// Every coordinate of a large family counts: the suites see a wrong one among 18.
#[test]
#[ignore = "long"]
fn one_wrong_coordinate_among_many_is_seen() {
    #[derive(Clone)]
    struct Spoilt;
    impl LieAlgebra for Spoilt {
        type Element<T: Real> = Power<SVector<T, 3>, 6>;
        fn bracket<T: Real>(
            &self,
            xi: &Self::Element<T>,
            eta: &Self::Element<T>,
        ) -> Self::Element<T> {
            let mut bracket = PowerAlgebra::<_, 6>(So3).bracket(xi, eta);
            bracket.0[5].z = bracket.0[5].z * 1.5 + xi.0[5].x * eta.0[5].z - xi.0[5].z * eta.0[5].x;
            bracket
        }
    }
    let report = laws::lie_algebra(&Spoilt, &samples()[..1]).unwrap();
    assert!(report.residual("Jacobi").unwrap() > 1e-2);
    assert!(report.residual("antisymmetry").unwrap() < 1e-15);
}
