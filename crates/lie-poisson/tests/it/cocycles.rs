//! Cocycles, the representations that they extend, and the odd powers of representations.

use crate::support::{holds, laws, samples};
use lie_poisson::*;
use nalgebra::Vector3;

/// Heisenberg's algebra [e₀, e₁] = e₂ with all constants multiplied by a number.
fn heisenberg(scale: f64) -> StructureConstants<3> {
    StructureConstants::new(|i, j, k| match (i, j, k) {
        (0, 1, 2) => scale,
        (1, 0, 2) => -scale,
        _ => 0.0,
    })
    .unwrap()
}

fn representation_laws<R: Representation>(r: &R) {
    holds(laws::representation(r, &samples(), &samples()).unwrap());
}

/// A map that is not a cocycle, without the check.
#[derive(Clone)]
struct NotExtended(StructureConstants<3>);

impl Representation for NotExtended {
    type Algebra = StructureConstants<3>;
    type Space<T: Real> = Pair<Vector3<T>, nalgebra::Vector1<T>>;
    fn algebra(&self) -> Self::Algebra {
        self.0.clone()
    }
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Self::Space<T>) -> Self::Space<T> {
        Pair(self.0.bracket::<T>(xi, &v.0) - xi.scaled(v.1.x), Vector::zero())
    }
}

#[test]
fn new_representations_obey_the_laws() {
    representation_laws(&InfinitesimalAdjoint(So3));
    representation_laws(&InfinitesimalAdjoint(Se3::default()));
    representation_laws(&Contragredient(SL2OnR2));
    representation_laws(&Contragredient(InfinitesimalAdjoint(heisenberg(1.0))));
    representation_laws(&ExtendedAdjoint::of(heisenberg(1.0)).unwrap());
    representation_laws(&ExtendedAdjoint::of(Se3::default()).unwrap());
    representation_laws(&ExtendedCoadjoint::of(heisenberg(1.0)).unwrap());
    representation_laws(&ExtendedCoadjoint::of(Se3::default()).unwrap());
    // Negative control: the identity of Heisenberg's algebra is not a derivation.
    let broken = laws::representation(&NotExtended(heisenberg(1.0)), &samples(), &samples());
    assert!(broken.unwrap().check(1e-13).is_err());
}

/// A group and its algebra have one adjoint representation.
#[test]
fn the_adjoint_representation_needs_no_group() {
    let (with_group, without) = (Adjoint(SE3::default()), InfinitesimalAdjoint(Se3::default()));
    for xi in samples() {
        for v in samples() {
            assert_eq!(with_group.act::<f64>(&xi, &v), without.act::<f64>(&xi, &v));
        }
        for alpha in samples() {
            let (one, other) =
                (with_group.transpose_act::<f64>(&xi, &alpha), without.transpose_act(&xi, &alpha));
            assert_eq!(one, other);
            assert_eq!(with_group.diamond::<f64>(&xi, &alpha), without.diamond(&xi, &alpha));
        }
    }
}

/// The derivation of Heisenberg's algebra nearest to the identity: diag(a, a, 2a) with (a−1)² + (a−1)² + (2a−1)² least
/// at a = 2/3. It does not depend on the size of the structure constants.
#[test]
fn the_nearest_derivation_is_known_and_has_no_units() {
    let identity = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
    for scale in [1e-30, 1.0, 1e30] {
        let algebra = InfinitesimalAdjoint(heisenberg(scale));
        let d = Cocycle::nearest_to(algebra.clone(), identity).unwrap();
        for i in 0..3 {
            for j in 0..3 {
                let expected = identity(i, j) * [2.0, 2.0, 4.0][i] / 3.0;
                assert!((d.entry(i, j) - expected).abs() < 1e-15, "{scale:e}: {i} {j}");
            }
        }
        // The constructor accepts what the projection returns.
        assert_eq!(Cocycle::new(algebra.clone(), |i, j| d.entry(i, j)).unwrap(), d);
        let extended = ExtendedAdjoint::of(heisenberg(scale)).unwrap();
        assert!((extended.0.entry(2, 2) / scale - 4.0 / 3.0).abs() < 1e-15);
    }
    let inner = Cocycle::new(InfinitesimalAdjoint(So3), |i, j| {
        So3.bracket(&Vector3::new(1.0, 2.0, 3.0), &Vector::basis(j)).coordinate(i)
    });
    assert!(inner.is_ok(), "ad_ξ is a derivation");
}

#[test]
fn what_is_not_a_cocycle_is_refused() {
    let adjoint = || InfinitesimalAdjoint(heisenberg(1.0));
    let error = Cocycle::new(adjoint(), |i, j| if i == j { 1.0 } else { 0.0 }).unwrap_err();
    assert!(
        matches!(error, CocycleError::NotACocycle { i: 0, j: 1, residual, .. } if residual == 1.0)
    );
    assert!(error.to_string().contains("c[e0, e1]"), "{error}");
    let nan = Cocycle::new(adjoint(), |i, j| if (i, j) == (1, 2) { f64::NAN } else { 0.0 });
    assert!(matches!(nan, Err(CocycleError::NotFinite { row: 1, column: 2, .. })));
    let nan = Cocycle::nearest_to(adjoint(), |_, _| f64::INFINITY);
    assert!(matches!(nan, Err(CocycleError::NotFinite { .. })));
    // A bracket that overflows.
    let huge = heisenberg(f64::MAX);
    assert!(ExtendedAdjoint::of(huge).is_ok());
}

/// The matrices of an algebra of dimension 0 and of an abelian one.
#[test]
fn small_algebras() {
    let point = StructureConstants::<0>::new(|_, _, _| 0.0).unwrap();
    assert_eq!(odd_power_defect(&InfinitesimalAdjoint(point.clone())), 0.0);
    assert!(ExtendedAdjoint::of(point).is_ok());
    let line = StructureConstants::<1>::new(|_, _, _| 0.0).unwrap();
    assert_eq!(ExtendedAdjoint::of(line).unwrap().0.entry(0, 0), 1.0);
}

/// Orthogonal, symplectic and unitary matrices contain their odd powers, and so does the extension of what does. The
/// dilation of the plane with two rates does not.
#[test]
fn odd_powers() {
    assert!(odd_power_defect(&SO3OnR3) < 1e-15);
    assert!(odd_power_defect(&SL2OnR2) < 1e-15);
    assert!(odd_power_defect(&UnitaryOnComplexSpace::<3>) < 1e-15);
    assert!(odd_power_defect(&Diagonal::<_, 2>(SO3OnR3)) < 1e-15);
    assert!(odd_power_defect(&InfinitesimalAdjoint(Se3::default())) < 1e-15);
    assert!(odd_power_defect(&InfinitesimalAdjoint(heisenberg(1e30))) < 1e-15);
    // su(3) on itself: the cube of ad is not in ad.
    assert!(odd_power_defect(&InfinitesimalAdjoint(UnitaryAlgebra::<3>)) > 0.01);
    let rates = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
        (0, 2, 0) => 1.0,
        (2, 0, 0) => -1.0,
        (1, 2, 1) => 2.0,
        (2, 1, 1) => -2.0,
        _ => 0.0,
    });
    assert!(odd_power_defect(&InfinitesimalAdjoint(rates.unwrap())) > 0.1);
}
