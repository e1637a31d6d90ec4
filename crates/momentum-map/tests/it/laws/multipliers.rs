//! The law suite of multipliers: every algebra of multipliers obeys its laws, and each law rejects something that
//! breaks it.

use crate::support::{TOLERANCE, holds, laws, samples};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::{Matrix2, Vector3};
use num_complex::Complex;

#[test]
fn multipliers() {
    fn check<M: Multipliers>(multipliers: &M) {
        holds(laws::multipliers(multipliers, &samples(), &samples(), &samples()).unwrap());
    }
    check(&Quaternions);
    check(&DualQuaternions);
    check(&ComplexMatrices::<1>);
    check(&ComplexMatrices::<2>);
    check(&ComplexMatrices::<3>);
    check(&ComplexMatrices::<6>);
    check(&PowerMultipliers::<_, 1>(Quaternions));
    check(&PowerMultipliers::<_, 2>(Quaternions));
    check(&PowerMultipliers::<_, 9>(Quaternions));
    check(&ProductMultipliers(Quaternions, DualQuaternions));
}

/// Returns the size of B⁻¹B − 1.
fn inverse_error<M: Multipliers>(multipliers: &M, b: &Multiplier<M>) -> f64 {
    let inverse = multipliers.inverse::<f64>(b);
    (multipliers.product::<f64>(&inverse, b) - multipliers.one::<f64>()).max_abs()
}

#[test]
fn inverses_where_quadratic_invariants_do_not_hold() {
    // The inverse is exact for quaternions: samples are far from |Q|² = 1 and x₀ = 0.
    assert!(samples().iter().all(|q| inverse_error(&Quaternions, q) < TOLERANCE));
    assert!(samples().iter().all(|q| inverse_error(&DualQuaternions, q) < TOLERANCE));
    let pairs = ProductMultipliers(Quaternions, DualQuaternions);
    assert!(samples().iter().all(|q| inverse_error(&pairs, q) < TOLERANCE));
    let powers = PowerMultipliers::<_, 2>(Quaternions);
    assert!(samples().iter().all(|q| inverse_error(&powers, q) < TOLERANCE));
    // The inverse is of second order for matrices: they are off by 1 − BB∗ ≈ 2ε, and the inverse by its square.
    for (xi, direction) in samples().iter().zip(samples::<Matrix2<Complex<f64>>>()) {
        let unitary = UnitaryGroup::<2>.exp::<f64>(xi);
        let near = |epsilon: f64| unitary + unitary * direction.scaled(epsilon);
        let error = |epsilon| inverse_error(&ComplexMatrices::<2>, &near(epsilon));
        assert!(error(0.0) < TOLERANCE && error(1e-4) > 1e-10);
        assert!((error(1e-3) / error(1e-4) - 100.0).abs() < 1.0);
    }
}

/// Returns the change of μ under the coadjoint motion exp(Λξ), by its series in small ξ.
fn coadjoint_series<P: PoissonSpace>(space: &P, xi: &Differential<P>, mu: &Point<P>) -> Point<P> {
    let mut term = *mu;
    let terms = (1..20).map(|k| {
        term = space.hamiltonian_vector::<f64>(&term, xi).scaled(1.0 / f64::from(k));
        term
    });
    // The sum starts from the smallest term.
    let terms: Vec<_> = terms.collect();
    terms.into_iter().rev().fold(Vector::zero(), |sum, term| sum + term)
}

/// Changes are exact to a few rounding errors of their own size, however small they are, and do not depend on how
/// well the quadratic invariants of the multiplier hold.
#[test]
fn coadjoint_changes_are_accurate_whatever_their_size() {
    for (v, mu) in samples::<Vector3<f64>>().into_iter().zip(samples::<Se3Dual>()) {
        for size in [1e-12, 1e-6, 0.3] {
            // These vectors are parallel neither to each other nor to Π.
            let omega = Vector3::new(v.y, v.z, v.x) * size;
            let gamma = Vector3::new(v.z, v.x, v.y) * size;
            let pi = Covector(mu.0.0);
            // dQ/dt = −½ Ω Q, and dN/dt = −½ Ω N − 2γ Q is its derivative in the direction 4γ of Ω.
            let along: Vector3<DualNumber> = seed(&omega, &(gamma * 4.0));
            let both = SP1.exp::<DualNumber>(&-along);
            let q: Quaternion =
                map_coordinates(&both, |x: DualNumber| x.value_without_derivative());
            let n: Quaternion = derivative_part(&both);
            let turned = coadjoint_series(&Quaternions.space(), &omega, &pi);
            let moved = coadjoint_series(&DualQuaternions.space(), &Pair(omega, gamma), &mu);
            for scale in [1.0, 1.0 - 1e-12, 1.0 + 1e-9] {
                let change = Quaternions.coadjoint_change::<f64>(&q.scaled(scale), &pi);
                assert!((change - turned).max_abs() < 1e-15 * turned.max_abs(), "{size:e}");
                // The multiplier is scaled by a dual number, so that |Q|² ≠ 1 and x₀ ≠ 0.
                let multiplier = Pair(q.scaled(scale), n.scaled(scale) + q.scaled(1e-9));
                let change = DualQuaternions.coadjoint_change::<f64>(&multiplier, &mu);
                assert!((change - moved).max_abs() < 1e-15 * moved.max_abs(), "{size:e}");
            }
            // Control: a difference of momenta loses digits to cancellation, and all of them where the invariants do
            // not hold.
            let difference = |scale| Quaternions.transport::<f64>(&q.scaled(scale), &pi) - pi;
            let error = |scale: f64| (difference(scale) - turned).max_abs() / turned.max_abs();
            assert!(size > 1e-6 || (error(1.0) > 1e-12 && error(1.0 + 1e-9) > 1e-4));
        }
    }
}

/// Quaternions with one thing wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Wrong {
    One,
    HalfAngle,
    HalfAngleNearZero,
    Side,
    SideNearZero,
    Product,
    /// The product is ½(QB + BQ).
    Symmetric,
    /// The product is 2QB.
    Twice,
    Inverse,
    Change,
}

impl Multipliers for Wrong {
    type Space = LiePoisson<So3>;
    type Multiplier<T: Real> = Quaternion<T>;
    fn space(&self) -> LiePoisson<So3> {
        Quaternions.space()
    }
    fn one<T: Real>(&self) -> Quaternion<T> {
        let one = Quaternion::one();
        if *self == Self::One { one + one } else { one }
    }
    fn generate<T: Real>(&self, omega: &Vector3<T>, q: &Quaternion<T>) -> Quaternion<T> {
        let turned = Quaternions.generate(omega, q);
        let twice = match self {
            Self::HalfAngle => true,
            Self::HalfAngleNearZero => omega.iter().all(|x| x.all_below(1e-7)),
            _ => false,
        };
        if twice { turned + turned } else { turned }
    }
    fn transport<T: Real>(
        &self,
        q: &Quaternion<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        let other = match self {
            Self::Side => true,
            Self::SideNearZero => mu.0.iter().all(|x| x.all_below(1e-7)),
            _ => false,
        };
        let q = if other { q.conjugate() } else { *q };
        Quaternions.transport(&q, mu)
    }
    fn coadjoint_change<T: Real>(
        &self,
        q: &Quaternion<T>,
        mu: &Covector<Vector3<T>>,
    ) -> Covector<Vector3<T>> {
        if *self == Self::Change {
            return Quaternions.coadjoint_change(&q.conjugate(), mu);
        }
        self.transport(q, mu) - *mu
    }
    fn product<T: Real>(&self, q: &Quaternion<T>, b: &Quaternion<T>) -> Quaternion<T> {
        let (there, back) = (*q * *b, *b * *q);
        match self {
            Self::Product => back,
            Self::Symmetric => (there + back).scaled(T::from_f64(0.5)),
            Self::Twice => there + there,
            _ => there,
        }
    }
    fn inverse<T: Real>(&self, b: &Quaternion<T>) -> Quaternion<T> {
        if *self == Self::Inverse { *b } else { Quaternions.inverse(b) }
    }
}

#[test]
fn laws_of_multipliers_reject_what_breaks_them() {
    let broken = |wrong: Wrong| -> Vec<&'static str> {
        let report = laws::multipliers(&wrong, &samples(), &samples(), &samples()).unwrap();
        let laws = report.residuals().iter();
        laws.filter(|(_, residual)| *residual > 0.1).map(|(law, _)| *law).collect()
    };
    assert_eq!(broken(Wrong::One), ["identity", "motion", "inverse"]);
    assert_eq!(broken(Wrong::HalfAngle), ["motion"]);
    assert_eq!(broken(Wrong::HalfAngleNearZero), ["motion"]);
    assert_eq!(broken(Wrong::Side), ["action", "motion"]);
    assert_eq!(broken(Wrong::SideNearZero), ["action", "motion"]);
    assert_eq!(broken(Wrong::Product), ["left multiplication", "action"]);
    assert_eq!(broken(Wrong::Symmetric), ["associativity", "left multiplication", "action"]);
    assert_eq!(broken(Wrong::Twice), ["identity", "action", "inverse"]);
    assert_eq!(broken(Wrong::Inverse), ["inverse"]);
    assert_eq!(broken(Wrong::Change), ["coadjoint change"]);
}

/// Residuals are relative to what enters a law, so that the size of the samples does not matter.
#[test]
fn faults_of_any_size_are_seen() {
    let sizes = [1e-30, 1.0, 1e30];
    let scaled = |size| samples::<Quaternion<f64>>().iter().map(|q| q.scaled(size)).collect();
    for size in sizes {
        let (q, xi): (Vec<_>, Vec<Vector3<f64>>) = (scaled(size), samples());
        let mu: Vec<_> = xi.iter().map(|mu| Covector(mu * size)).collect();
        let is_broken = |law: &str, report: &laws::Report| report.residual(law).unwrap() > 0.1;
        let report = laws::multipliers(&Wrong::Symmetric, &q, &xi, &samples()).unwrap();
        for law in ["associativity", "left multiplication", "action"] {
            assert!(is_broken(law, &report), "{size:e} {report:?}");
        }
        let report = laws::multipliers(&Wrong::Twice, &q, &xi, &samples()).unwrap();
        assert!(is_broken("identity", &report), "{size:e} {report:?}");
        let report = laws::multipliers(&Wrong::Side, &samples(), &xi, &mu).unwrap();
        for law in ["action", "motion"] {
            assert!(is_broken(law, &report), "{size:e} {report:?}");
        }
        let report = laws::multipliers(&Wrong::Change, &samples(), &xi, &mu).unwrap();
        assert!(is_broken("coadjoint change", &report), "{size:e} {report:?}");
    }
    // ξ(QB) and (ξQ)B differ, and so do the motion and the Hamiltonian vector, also for small ξ.
    let small: Vec<_> = samples::<Vector3<f64>>().iter().map(|xi| xi * 1e-30).collect();
    for (wrong, law) in [(Wrong::Symmetric, "left multiplication"), (Wrong::HalfAngle, "motion")] {
        let report = laws::multipliers(&wrong, &samples(), &small, &samples()).unwrap();
        assert!(report.residual(law).unwrap() > 0.1, "{law} {report:?}");
    }
}

/// Translations have no bound, and rounding errors grow with their square.
#[test]
fn round_off_of_large_multipliers_is_allowed() {
    let far = |Pair(omega, gamma): Pair<Vector3<f64>, Vector3<f64>>| Pair(omega, gamma * 1e6);
    let differentials: Vec<_> = samples().into_iter().map(far).collect();
    holds(laws::multipliers(&DualQuaternions, &samples(), &differentials, &samples()).unwrap());
}

#[test]
fn no_samples_no_report() {
    assert!(laws::multipliers(&Quaternions, &[], &samples(), &samples()).is_err());
    assert!(laws::multipliers(&Quaternions, &samples(), &[], &samples()).is_err());
    assert!(laws::multipliers(&Quaternions, &samples(), &samples(), &[]).is_err());
}
