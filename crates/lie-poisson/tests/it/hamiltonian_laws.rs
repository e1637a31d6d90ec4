//! The law suites of Hamiltonians: Hamiltonians of all kinds obey them, and each law rejects something that breaks it.

use crate::support::{TOLERANCE, holds, laws, samples};
use lie_poisson::*;
use nalgebra::Vector3;

energy!(Bodies {} on LiePoisson<ProductAlgebra<So3, Se3>>: |_body, Covector(Pair(pi, Pair(l, p)))| {
    (pi.dot(pi) + 1.0).ln() + l.x * l.y * l.z + pi.dot(p) * p.z
});

energy!(Logarithm3 {} on LiePoisson<So3>: |_body, Covector(pi)| pi.dot(pi).ln());

#[test]
fn automatic_hamiltonians() {
    let samples = samples();
    let report = laws::hamiltonian(&Automatic(Bodies {}), &samples).unwrap();
    assert!(report.residual("second derivative").is_some());
    holds(report);
    // The logarithm is −∞ at 0, which is left out, and known near it.
    let points: Vec<Covector<Vector3<f64>>> = crate::support::samples();
    holds(laws::hamiltonian(&Automatic(Logarithm3 {}), &points).unwrap());
    let outside = [Covector(Vector3::zeros())];
    let report = laws::hamiltonian(&Automatic(Logarithm3 {}), &outside).unwrap();
    assert!(report.check(f64::INFINITY).is_err());
}

/// The free rigid body h(Π) = ½Π₁² + Π₂² + ³⁄₂Π₃², with one thing wrong.
#[derive(Clone, Copy, PartialEq)]
enum Body {
    Sound,
    Sign,
    SecondDerivative,
    StaleStorage,
    AnyNumber,
}

impl Body {
    const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];

    fn slope<T: Real>(self, pi: &Vector3<T>) -> Vector3<T> {
        let sign = if self == Self::Sign { -1.0 } else { 1.0 };
        Vector3::from_fn(|i, _| pi[i] * (sign * Self::MOMENTS[i]))
    }
}

impl<T: Real> Hamiltonian<LiePoisson<So3>, T> for Body {
    fn value(&self, Covector(pi): &Covector<Vector3<T>>) -> T {
        Self::Sound.slope(pi).dot(pi) * 0.5
    }

    fn differential(&self, Covector(pi): &Covector<Vector3<T>>) -> Vector3<T> {
        self.slope(pi)
    }

    fn hessian(&self, _: &Covector<Vector3<T>>, v: &Covector<Vector3<T>>) -> Option<Vector3<T>> {
        let twice = if *self == Self::SecondDerivative { 2.0 } else { 1.0 };
        Some(self.slope(&v.0).scaled(T::from_f64(twice)))
    }
}

/// Four bodies.
impl<T: Real> SitesHamiltonian<Vector3<T>> for Body {
    fn value(&self, mu: &Covector<Sites<Vector3<T>>>) -> T {
        if mu.0.len() != 4 && *self != Self::AnyNumber {
            return T::from_f64(f64::NAN);
        }
        let bodies = mu.0.iter().take(4);
        bodies.fold(T::zero(), |sum, pi| sum + Self::Sound.slope(pi).dot(pi) * 0.5)
    }

    fn differential_into(&self, mu: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
        if mu.0.len() != 4 {
            return dh.set_coordinates(|_| T::from_f64(f64::NAN));
        }
        for (dh, pi) in dh.iter_mut().zip(mu.0.iter()) {
            let before = if *self == Self::StaleStorage { *dh } else { Vector3::zeros() };
            *dh = before + self.slope(pi);
        }
    }
}

/// Closures over numbers and over dual numbers, and a reference, are the Hamiltonian that they state.
#[test]
fn closures_and_references() {
    type Space = LiePoisson<So3>;
    let sound = Body::Sound;
    let by_formula =
        from_closure::<Space, _>(|mu| Hamiltonian::<Space, DualNumber>::value(&sound, mu));
    let by_hand = from_closures::<Space, _, _>(
        |mu| Hamiltonian::<Space>::value(&sound, mu),
        |mu| Hamiltonian::<Space>::differential(&sound, mu),
    );
    let of = |h: &dyn Hamiltonian<Space>, mu: &_, v: &_| {
        (h.value(mu), h.differential(mu), h.hessian(mu, v))
    };
    let points: Vec<Covector<Vector3<f64>>> = samples();
    for (mu, v) in points.iter().zip(points.iter().skip(1)) {
        let (value, slope, second) = of(&sound, mu, v);
        assert_eq!(of(&by_formula, mu, v), (value, slope, None));
        assert_eq!(of(&by_hand, mu, v), (value, slope, None));
        assert_eq!(of(&&sound, mu, v), (value, slope, second));
        assert!(second.is_some());
        assert_ne!(of(&Body::Sign, mu, v), (value, slope, second));
    }
    holds(laws::hamiltonian(&&sound, &samples()).unwrap());
    holds(laws::sites_hamiltonian::<So3, _>(&&sound, &[sites(4)]).unwrap());
}

/// Returns the laws that do not hold.
fn broken(report: &laws::Report) -> Vec<&'static str> {
    let residuals = report.residuals().iter();
    residuals.filter(|(_, x)| x.is_nan() || *x > TOLERANCE).map(|(law, _)| *law).collect()
}

#[test]
fn laws_of_hamiltonians_reject_what_breaks_them() {
    let cases: [(Body, &[&str]); 3] = [
        (Body::Sound, &[]),
        (Body::Sign, &["differential"]),
        (Body::SecondDerivative, &["second derivative"]),
    ];
    for (body, expected) in cases {
        assert_eq!(broken(&laws::hamiltonian(&body, &samples()).unwrap()), expected);
    }
}

fn sites(count: usize) -> Covector<Sites<Vector3<f64>>> {
    Covector(samples::<Vector3<f64>>().into_iter().cycle().take(count).collect())
}

#[test]
fn laws_of_hamiltonians_of_sites_reject_what_breaks_them() {
    let cases: [(Body, &[&str]); 4] = [
        (Body::Sound, &[]),
        (Body::Sign, &["differential"]),
        (Body::StaleStorage, &["differential"]),
        (Body::AnyNumber, &["number of sites"]),
    ];
    for (body, expected) in cases {
        let report = laws::sites_hamiltonian::<So3, _>(&body, &[sites(4)]).unwrap();
        assert_eq!(broken(&report), expected);
    }
    let other = laws::sites_hamiltonian::<So3, _>(&Body::Sound, &[sites(3)]).unwrap();
    assert_eq!(broken(&other), ["differential"]);
}

#[test]
fn no_samples_no_report() {
    assert!(laws::hamiltonian(&Body::Sound, &[]).is_err());
    assert!(laws::sites_hamiltonian::<So3, _>(&Body::Sound, &[]).is_err());
}
