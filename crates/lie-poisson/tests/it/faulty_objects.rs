//! [`Faulty`] objects: each law suite refuses the fault of each method that enters its laws, and no other is made.

use crate::support::{TOLERANCE, laws, samples};
use laws::{Faulty, NoSamples, Report};
use lie_poisson::*;

/// Returns the laws that fail clearly.
fn broken(report: Result<Report, NoSamples>) -> Vec<&'static str> {
    let laws = report.unwrap().residuals().to_vec();
    laws.into_iter().filter(|(_, residual)| *residual > 0.01).map(|(law, _)| law).collect()
}

#[test]
fn faults_of_each_method_are_refused() {
    let algebra = |method| broken(laws::lie_algebra(&Faulty::new(&So3, method, 1), &samples()));
    // Half a coordinate of the cross product is the bracket of another Lie algebra, with another ad∗.
    assert_eq!(algebra("bracket"), ["pairing"]);
    assert_eq!(algebra("coadjoint"), ["pairing"]);
    let casimirs = Faulty::new(&So3, "casimir_differential", 2);
    assert_eq!(broken(laws::casimirs(&casimirs, &samples())), ["Casimir"]);
    energy!(Body {} on LiePoisson<So3>: |_body, Covector(pi)| pi.x * pi.x + pi.y * pi.z);
    let body = Automatic(Body {});
    let faulty = Faulty::new(&body, "differential", 0);
    let report = laws::hamiltonian::<LiePoisson<So3>, _>(&faulty, &samples());
    assert_eq!(broken(report), ["differential", "second derivative"]);
    let (space, plain) = (LiePoisson::minus(So3), InnerProduct::euclidean());
    let field = Autonomous(&body);
    let faulty = |_| Faulty::new(&field, "element", 0);
    let report = laws::double_bracket(&space, &body, &plain, faulty, 0.0, &samples());
    assert_eq!(broken(report), ["loss of energy", "linear in the friction"]);
}

/// A fault is in the method with its name, and in a coordinate that the result has.
#[test]
fn without_a_fault_the_object_is_as_it_is() {
    let mut faulty = vec![Faulty::without_fault(&So3)];
    for (method, coordinate) in [("brackets", 0), ("bracket", 3), ("differential", 1)] {
        faulty.push(Faulty::new(&So3, method, coordinate));
    }
    for faulty in faulty {
        laws::lie_algebra(&faulty, &samples()).unwrap().check(TOLERANCE).unwrap();
    }
    assert!(Faulty::new(&So3, "bracket", 3).has_fault_in("bracket"));
    assert!(!Faulty::without_fault(&So3).has_fault_in("bracket"));
}

/// Half of zero is zero: where the coordinate vanishes in all samples the suite cannot see the fault.
#[test]
fn a_coordinate_that_is_zero_hides_its_fault() {
    let casimirs = Faulty::new(&So3, "casimir_differential", 2);
    let flat = samples::<Momentum<So3>>()
        .into_iter()
        .map(|Covector(pi)| Covector(nalgebra::Vector3::new(pi.x, pi.y, 0.0)));
    assert!(broken(laws::casimirs(&casimirs, &flat.collect::<Vec<_>>())).is_empty());
}
