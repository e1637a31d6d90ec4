//! Casimirs: they are constant along every Hamiltonian flow, independent, and have the documented values.

use crate::support::{TOLERANCE, holds, laws, samples};
use lie_poisson::*;
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex;

#[test]
fn casimirs() {
    fn check<A: Casimirs>(algebra: &A) {
        assert!(A::COUNT > 0);
        holds(laws::casimirs(algebra, &samples()).unwrap());
    }
    check(&RealSpace::<2>);
    check(&So2);
    check(&So3);
    check(&Su2);
    check(&Sl2);
    check(&Se2::default());
    check(&Se3::default());
    check(&SemidirectAlgebra(SU2OnC2));
    check(&UnitaryAlgebra::<3>);
    check(&ProductAlgebra(So3, Se3::default()));
    check(&PowerAlgebra::<_, 3>(So3));
}

/// The values are checked, not only that these are Casimirs: tr H², …, tr Hᴺ⁺¹ are Casimirs, too.
#[test]
fn casimirs_of_the_unitary_group_are_power_sums_of_eigenvalues() {
    let eigenvalues = Vector3::new(0.7, -1.3, 2.1);
    let diagonal = Matrix3::from_diagonal(&eigenvalues.map(|x| Complex::new(x, 0.0)));
    for xi in samples::<SkewHermitian<f64, 3>>() {
        let u = UnitaryGroup.exp(&xi);
        let mu = UnitaryAlgebra.momentum(&(u * diagonal * UnitaryGroup.inverse(&u)));
        for index in 0..3 {
            let sum: f64 = eigenvalues.iter().map(|x| x.powi(index as i32 + 1)).sum();
            assert!((UnitaryAlgebra.casimir(index, &mu) - sum).abs() < 1e-13, "{index}");
        }
        assert_eq!(UnitaryAlgebra.casimir(3, &mu), 0.0);
    }
}

#[test]
fn casimirs_of_powers_and_products_are_those_of_their_factors() {
    for pair in samples::<Power<Pair<Vector3<f64>, Vector3<f64>>, 3>>() {
        let (power, se3) = (PowerAlgebra::<_, 3>(Se3::default()), Se3::default());
        let mu = Covector(pair);
        for (n, factor) in pair.0.iter().enumerate() {
            for index in 0..2 {
                let value = se3.casimir::<f64>(index, &Covector(*factor));
                assert_eq!(power.casimir::<f64>(2 * n + index, &mu), value);
            }
        }
        assert_eq!(power.casimir::<f64>(6, &mu), 0.0);
        let product = ProductAlgebra(se3, So3);
        let [first, Pair(second, _), _] = pair.0;
        let mu = Covector(Pair(first, second));
        let values = [0, 1, 2, 3].map(|index| product.casimir::<f64>(index, &mu));
        let [f1, f2] = [0, 1].map(|index| se3.casimir::<f64>(index, &Covector(first)));
        assert_eq!(values, [f1, f2, So3.casimir(0, &Covector(second)), 0.0]);
    }
}

/// The algebra so(3) with the Casimirs |Π|² and |Π|⁴, of which one is superfluous.
#[derive(Clone)]
struct Redundant;

impl LieAlgebra for Redundant {
    type Element<T: Real> = Vector3<T>;
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        xi.cross(eta)
    }
}

impl Casimirs for Redundant {
    const COUNT: usize = 2;
    fn casimir<T: Real>(&self, index: usize, mu: &Covector<Vector3<T>>) -> T {
        let square = mu.0.dot(&mu.0);
        if index == 0 { square } else { square * square }
    }
}

#[test]
fn dependent_casimirs_are_rejected() {
    let report = laws::casimirs(&Redundant, &samples()).unwrap();
    assert!(report.residual("Casimir").unwrap() < TOLERANCE);
    assert_eq!(report.residual("independence"), Some(0.5));
    // 0 is special for so(3): one sample needs to be generic, not every sample.
    let zero = Covector(Vector3::zeros());
    let generic = Covector(Vector3::new(1.0, 2.0, 3.0));
    holds(laws::casimirs(&So3, &[zero, generic]).unwrap());
    let special = laws::casimirs(&So3, &[zero]).unwrap();
    assert_eq!(special.residual("independence"), Some(1.0));
}

#[test]
fn no_samples_no_report() {
    assert!(laws::casimirs(&So3, &[]).is_err());
    let nan = Covector(Vector3::new(f64::NAN, 0.0, 0.0));
    let report = laws::casimirs(&So3, &[nan]).unwrap();
    assert!(report.check(f64::INFINITY).is_err());
    assert_eq!(report.residual("independence"), Some(1.0));
}
