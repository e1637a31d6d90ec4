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

/// A representation with infinite matrix elements.
#[derive(Clone)]
struct NotFinite;

impl Representation for NotFinite {
    type Algebra = So3;
    type Space<T: Real> = Vector3<T>;
    fn algebra(&self) -> So3 {
        So3
    }
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector3<T>) -> Vector3<T> {
        xi.cross(v) * T::from_f64(f64::INFINITY)
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

/// The projection is linear, also where the sum of the entries overflows.
#[test]
fn the_nearest_cocycle_has_no_units() {
    let affine = StructureConstants::<2>::new(|i, j, k| match (i, j, k) {
        (0, 1, 0) => 1.0,
        (1, 0, 0) => -1.0,
        _ => 0.0,
    });
    let affine = InfinitesimalAdjoint(affine.unwrap());
    let nearest = |size: f64| Cocycle::nearest_to(affine.clone(), |_, _| size);
    let one = nearest(1.0).unwrap();
    // A few roundings of entries of size 1, here and below.
    assert!((one.entry(0, 0) - 1.0).abs() < 1e-15 && one.entry(1, 1) == 0.0, "{one:?}");
    for size in [1e-300, 1e279, 1e290, 0.9 * f64::MAX] {
        let large = nearest(size).unwrap();
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let error = (large.entry(i, j) / size - one.entry(i, j)).abs();
            assert!(error < 1e-15, "{size:e} {i} {j}: {error:e}");
        }
    }
    // The derivation diag(2, 2, 4)/3 times the largest number overflows.
    let identity = |i: usize, j: usize| if i == j { f64::MAX } else { 0.0 };
    let huge = Cocycle::nearest_to(InfinitesimalAdjoint(heisenberg(1.0)), identity);
    let expected = CocycleError::NotFinite {
        matrix: "nearest cocycle",
        row: 2,
        column: 2,
        value: f64::INFINITY,
    };
    assert_eq!(huge.unwrap_err(), expected);
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
    // The derivation diag(2, 2, 4)/3 times the largest constant overflows in one entry.
    let huge = ExtendedAdjoint::of(heisenberg(f64::MAX));
    let expected = CocycleError::NotFinite {
        matrix: "scaled cocycle",
        row: 2,
        column: 2,
        value: f64::INFINITY,
    };
    assert_eq!(huge.unwrap_err(), expected);
    assert!(ExtendedAdjoint::of(heisenberg(0.5 * f64::MAX)).is_ok());
    let dilation = Cocycle::new(adjoint(), |i, j| [[1.0, 1.0, 2.0][i], 0.0][usize::from(i != j)]);
    let dilation = dilation.unwrap();
    assert_eq!(dilation.scaled(3.0).unwrap().entry(2, 2), 6.0);
    assert!(matches!(dilation.scaled(f64::NAN), Err(CocycleError::NotFinite { .. })));
}

/// Derivations are accepted, and other maps refused with one residual, for constants and maps of every size.
#[test]
fn the_test_of_a_cocycle_has_no_units() {
    let sizes = [1e-300, 1e-200, 1.0, 1e200, 1e300];
    for constants in sizes {
        for size in sizes {
            let diagonal = |weights: [f64; 3]| {
                let adjoint = InfinitesimalAdjoint(heisenberg(constants));
                Cocycle::new(adjoint, |i, j| if i == j { weights[i] * size } else { 0.0 })
            };
            assert!(diagonal([1.0, 1.0, 2.0]).is_ok(), "{constants:e} {size:e}");
            // Negative control: it misses the equation by 10⁻⁸ of its size.
            match diagonal([1.0, 1.0, 2.0 + 2e-8]) {
                Err(CocycleError::NotACocycle { i: 0, j: 1, residual, .. }) => {
                    assert!(
                        (residual - 1e-8).abs() < 1e-14,
                        "{constants:e} {size:e}: {residual:e}"
                    );
                }
                other => panic!("{constants:e} {size:e}: {other:?}"),
            }
        }
    }
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
    // The largest number, and numbers beyond it.
    let huge = InfinitesimalAdjoint(heisenberg(f64::MAX));
    assert!(odd_power_defect(&huge) < 1e-15);
    assert!(odd_power_defect(&NotFinite).is_nan());
}
