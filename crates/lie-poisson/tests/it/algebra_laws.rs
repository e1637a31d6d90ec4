//! The law suites of algebras, groups and representations: every type of the crate obeys its laws, and each law
//! rejects something that breaks it.

use crate::support::{TOLERANCE, holds, laws, samples};
use lie_poisson::*;
use nalgebra::{SVector, Vector2, Vector3};

fn group_laws<G: LieGroup>(group: &G) {
    holds(laws::lie_algebra(&group.algebra(), &samples()).unwrap());
    holds(laws::lie_group(group, &samples()).unwrap());
    let momenta = samples();
    holds(laws::poisson_space(&LiePoisson::minus(group.algebra()), &momenta).unwrap());
    holds(laws::poisson_space(&LiePoisson::plus(group.algebra()), &momenta).unwrap());
}

fn representation_laws<R: GroupRepresentation>(representation: R) {
    holds(laws::representation(&representation, &samples(), &samples()).unwrap());
    holds(laws::group_representation(&representation, &samples(), &samples()).unwrap());
    group_laws(&SemidirectGroup(representation));
}

#[test]
fn groups() {
    group_laws(&RealSpace::<3>);
    group_laws(&SO2);
    group_laws(&SO3);
    group_laws(&SU2);
    group_laws(&SP1);
    group_laws(&SL2);
    group_laws(&UnitaryGroup::<2>);
    group_laws(&ProductGroup(SO3, SL2));
}

#[test]
#[ignore = "long"]
fn large_groups() {
    group_laws(&UnitaryGroup::<3>);
    group_laws(&PowerGroup::<_, 3>(SU2));
}

#[test]
#[ignore = "long"]
fn representations_and_their_semidirect_products() {
    representation_laws(SO2OnR2);
    representation_laws(SO3OnR3);
    representation_laws(SU2OnC2);
    representation_laws(SL2OnR2);
    representation_laws(UnitaryOnComplexSpace::<2>);
    representation_laws(SP1OnQuaternions::<2>);
    representation_laws(Adjoint(SO3));
    representation_laws(Adjoint(SL2));
    representation_laws(Diagonal::<_, 2>(SO3OnR3));
    representation_laws(Sum(SU2OnC2, Adjoint(SU2)));
    // The algebra is (se(3) ⋉ R³), of the heavy top on a movable base.
    representation_laws(Inherited { quotient: SO3OnR3, representation: SO3OnR3 });
}

#[test]
fn the_integral_of_a_large_exponential() {
    let representation = UnitaryOnComplexSpace::<2>;
    for (xi, phi) in samples::<SkewHermitian<f64, 2>>().iter().zip(samples()) {
        for size in [3.0, 1e3, 1e5] {
            let xi = xi.scaled(size / xi.max_abs());
            let integral = representation.exp_integral(&xi, &phi);
            // ξ ∫₀¹ exp(σξ) φ dσ = (exp ξ − 1) φ
            let moved = representation.transform(&UnitaryGroup.exp(&xi), &phi) - phi;
            let error = (representation.act(&xi, &integral) - moved).max_abs();
            // Every doubling doubles the rounding error.
            assert!(error < 16.0 * f64::EPSILON * size, "{size}: {error:e}");
        }
    }
}

#[test]
fn composed_representations_use_the_closed_forms_of_their_parts() {
    let (xi, v, w) = (samples::<Vector3<f64>>()[0] * 1e3, samples(), samples());
    let (v, w): (Vec<Vector3<f64>>, Vec<Vector2<num_complex::Complex<f64>>>) = (v, w);
    let powers = Diagonal::<_, 2>(SO3OnR3).exp_integral(&xi, &Power([v[0], v[1]]));
    assert_eq!(powers, Power([0, 1].map(|n| SO3OnR3.exp_integral(&xi, &v[n]))));
    let pairs = Sum(SU2OnC2, SU2OnC2).exp_integral(&xi, &Pair(w[0], w[1]));
    assert_eq!(pairs, Pair(SU2OnC2.exp_integral(&xi, &w[0]), SU2OnC2.exp_integral(&xi, &w[1])));
    let inherited = Inherited { quotient: SO3OnR3, representation: SO3OnR3 };
    let diamond = inherited.diamond(&v[0], &Covector(v[1]));
    assert_eq!(diamond, Covector(Pair(v[0].cross(&v[1]), Vector3::zeros())));
    // det ξ = 10⁸, elliptic: ξ ∫₀¹ exp(σξ) φ dσ = (exp ξ − 1) φ without loss of digits.
    let (xi, phi) = (Vector3::new(0.0, -1e4, 1e4), Vector2::new(0.3, -0.7));
    let moved = SL2OnR2.act(&xi, &SL2OnR2.exp_integral(&xi, &phi));
    assert!((moved - (SL2.exp(&xi) * phi - phi)).norm() < 1e-15);
}

#[test]
fn cayley_maps() {
    fn check<G: Cayley>(group: &G) {
        holds(laws::cayley(group, &samples()).unwrap());
    }
    check(&RealSpace::<3>);
    check(&SO2);
    check(&SO3);
    check(&SU2);
    check(&SP1);
    check(&SL2);
    check(&SE2::default());
    check(&SE3::default());
    check(&ProductGroup(SP1, SE2::default()));
    check(&PowerGroup::<_, 3>(SU2));
}

/// The algebra so(3) with the wrong sign of ad*.
#[derive(Clone)]
struct WrongCoadjoint;

impl LieAlgebra for WrongCoadjoint {
    type Element<T: Real> = Vector3<T>;
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        xi.cross(eta)
    }
    fn coadjoint<T: Real>(
        &self,
        xi: &Vector3<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        Covector(xi.cross(&mu.0))
    }
}

#[test]
fn a_wrong_sign_in_the_coadjoint_is_rejected() {
    let report = laws::lie_algebra(&WrongCoadjoint, &samples()).unwrap();
    assert!(report.residual("pairing").unwrap() > 0.1);
    assert!(report.residual("Jacobi").unwrap() < TOLERANCE);
}

/// The group SO(3) over an algebra whose bracket has the wrong sign.
#[derive(Clone)]
struct WrongSign;

impl LieAlgebra for WrongSign {
    type Element<T: Real> = Vector3<T>;
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        eta.cross(xi)
    }
}

impl LieGroup for WrongSign {
    type Algebra = WrongSign;
    type Element<T: Real> = nalgebra::Matrix3<T>;
    fn algebra(&self) -> WrongSign {
        WrongSign
    }
    fn identity<T: Real>(&self) -> Self::Element<T> {
        SO3.identity()
    }
    fn compose<T: Real>(&self, g: &Self::Element<T>, h: &Self::Element<T>) -> Self::Element<T> {
        SO3.compose(g, h)
    }
    fn inverse<T: Real>(&self, g: &Self::Element<T>) -> Self::Element<T> {
        SO3.inverse(g)
    }
    fn exp<T: Real>(&self, xi: &Vector3<T>) -> Self::Element<T> {
        SO3.exp(xi)
    }
    fn adjoint<T: Real>(&self, g: &Self::Element<T>, xi: &Vector3<T>) -> Vector3<T> {
        SO3.adjoint(g, xi)
    }
}

#[test]
fn a_wrong_sign_of_the_bracket_is_rejected() {
    // The algebra is a Lie algebra, but not that of the group.
    let report = laws::lie_group(&WrongSign, &samples()).unwrap();
    assert!(report.residual("ad is the derivative of Ad").unwrap() > 0.1);
    holds(laws::lie_algebra(&WrongSign, &samples()).unwrap());
}

/// The Cayley map with a quadratic term that is wrong by a factor of 2.
impl Cayley for WrongSign {
    fn cayley<T: Real>(&self, xi: &Vector3<T>) -> Self::Element<T> {
        let hat = So3.hat(xi);
        SO3.cayley(xi) + hat * hat * T::from_f64(0.5)
    }
}

#[test]
fn a_cayley_map_of_first_order_is_rejected() {
    let report = laws::cayley(&WrongSign, &samples()).unwrap();
    assert!(report.residual("cay agrees with exp to second order").unwrap() > 0.1);
}

/// An antisymmetric bracket on R⁵ that is not Lie.
#[derive(Clone)]
struct NotLie;

fn not_lie(i: usize, j: usize, k: usize) -> f64 {
    let value = |i: usize, j: usize| ((7 * i + 3 * j + 5 * k) % 11) as f64 - 5.0;
    if i < j { value(i, j) } else { if j < i { -value(j, i) } else { 0.0 } }
}

impl LieAlgebra for NotLie {
    type Element<T: Real> = SVector<T, 5>;
    fn bracket<T: Real>(&self, xi: &SVector<T, 5>, eta: &SVector<T, 5>) -> SVector<T, 5> {
        SVector::from_fn(|k, _| {
            let terms = (0..25).map(|n| (n / 5, n % 5));
            terms.fold(T::zero(), |sum, (i, j)| sum + xi[i] * eta[j] * not_lie(i, j, k))
        })
    }
}

#[test]
fn an_antisymmetric_bracket_that_is_not_lie_is_rejected() {
    let report = laws::lie_algebra(&NotLie, &samples()).unwrap();
    assert!(report.residual("antisymmetry").unwrap() < TOLERANCE);
    assert!(report.residual("Jacobi").unwrap() > 1.0);
    // Fewer than three vectors cannot break the identity, but the basis does.
    for count in [1, 2] {
        let report = laws::lie_algebra(&NotLie, &samples()[..count]).unwrap();
        assert!(report.residual("Jacobi").unwrap() > 1.0);
    }
    let space = LiePoisson::minus(NotLie);
    let report = laws::poisson_space(&space, &samples()).unwrap();
    assert!(report.residual("Jacobi").unwrap() > 1e-2);
    // The size does not matter: products of the constants overflow for one, and underflow for another.
    for size in [1.0, 1e160, 1e307, 1e-170, 1e-320] {
        assert!(matches!(
            StructureConstants::<5>::new(|i, j, k| size * not_lie(i, j, k)),
            Err(StructureError::Jacobi { residual, .. }) if residual > 0.1
        ));
        let rotations = |i: usize, j: usize, k: usize| {
            size * So3.bracket::<f64>(&Vector3::basis(i), &Vector3::basis(j))[k]
        };
        assert!(StructureConstants::<3>::new(rotations).is_ok());
    }
}

#[test]
fn structure_constants_are_those_of_the_table() {
    let table = |i: usize, j: usize, k: usize| {
        So3.bracket::<f64>(&Vector3::basis(i), &Vector3::basis(j))[k] * 2.5
    };
    let algebra = StructureConstants::<3>::new(table).unwrap();
    for (i, j, k) in (0..64).map(|n| (n / 16, n / 4 % 4, n % 4)) {
        let expected = if i.max(j).max(k) < 3 { table(i, j, k) } else { 0.0 };
        assert_eq!(algebra.constant(i, j, k), expected, "c[{i}][{j}][{k}]");
    }
}

#[test]
fn many_structure_constants_stay_off_the_stack() {
    // 200³ numbers are 64 MB, more than any thread's stack.
    let abelian = StructureConstants::<200>::new(|_, _, _| 0.0).unwrap();
    assert_eq!(abelian.constant(0, 200, 0), 0.0);
    let zero = SVector::<f64, 200>::zeros();
    assert_eq!(abelian.bracket(&zero, &zero), zero);
}

/// Rotations of the plane by twice the angle, with the derivative of rotations by the angle.
#[derive(Clone)]
struct WrongDerivative;

impl Representation for WrongDerivative {
    type Algebra = So2;
    type Space<T: Real> = Vector2<T>;
    fn algebra(&self) -> So2 {
        So2
    }
    fn act<T: Real>(&self, xi: &nalgebra::Vector1<T>, v: &Vector2<T>) -> Vector2<T> {
        SO2OnR2.act(xi, v)
    }
}

impl GroupRepresentation for WrongDerivative {
    type Group = SO2;
    fn group(&self) -> SO2 {
        SO2
    }
    fn transform<T: Real>(&self, g: &nalgebra::Matrix2<T>, v: &Vector2<T>) -> Vector2<T> {
        g * (g * v)
    }
}

#[test]
fn a_wrong_derivative_of_a_representation_is_rejected() {
    let report = laws::group_representation(&WrongDerivative, &samples(), &samples()).unwrap();
    assert!(report.residual("homomorphism").unwrap() < TOLERANCE);
    assert!(report.residual("derivative").unwrap() > 0.1);
    assert!(report.residual("exp integral").unwrap() > 0.01);
}

#[test]
fn no_samples_no_report() {
    assert!(laws::lie_algebra(&So3, &[]).is_err());
    assert!(laws::lie_group(&SO3, &[]).is_err());
    assert!(laws::representation(&SO3OnR3, &[], &samples()).is_err());
    assert!(laws::representation(&SO3OnR3, &samples(), &[]).is_err());
    assert!(laws::cayley(&SO3, &[]).is_err());
}

#[test]
fn nan_breaks_every_law() {
    let broken = [Vector3::new(f64::NAN, 0.0, 0.0)];
    assert!(laws::lie_algebra(&So3, &broken).unwrap().check(f64::INFINITY).is_err());
    assert!(laws::cayley(&SO3, &broken).unwrap().check(f64::INFINITY).is_err());
}
