//! Systems of the catalogue, against the same systems of the gallery.

use collective_integrators::{HamiltonianField, VectorField};
use lie_poisson::{Covector, LiePoisson, Pair, Se3, Se3Dual};
use lie_poisson_formula_systems::SystemKind;
use lie_poisson_formulas::Parameters;
use lie_poisson_systems::Gyrostat;
use nalgebra::Vector3;
use proptest::prelude::*;

/// A rounding error of some dozen operations, relative to the largest term of a rate.
const ROUND_OFF: f64 = 64.0 * f64::EPSILON;

/// Returns dΠ/dt of a gyrostat without weight, whose rotor has the angular momentum ℓ.
fn gyrostat(inertia: Vector3<f64>, pi: Vector3<f64>, rotor: Vector3<f64>) -> Vector3<f64> {
    let hamiltonian = Gyrostat::new(inertia, 0.0, Vector3::z(), rotor).unwrap();
    let space = LiePoisson::minus(Se3::default());
    let field = HamiltonianField { space, hamiltonian };
    let Covector(Pair(rate, _)) = field.at(&Se3Dual::new(pi, Vector3::z()));
    rate
}

proptest! {
    /// Free rotors keep their angular momenta, so that the body moves as a gyrostat.
    #[test]
    fn a_body_with_rotors_moves_as_a_gyrostat(
        pi in prop::array::uniform3(-2.0..2.0),
        l in prop::array::uniform2(-2.0..2.0),
        spin in prop::array::uniform2(0.1..2.0),
    ) {
        let inertia = [2.0, 3.0, 4.0];
        let parameters = Parameters::new().vector("I", &inertia).unwrap().vector("J", &spin).unwrap();
        let body = SystemKind::named("body-with-rotors").unwrap().system(&parameters).unwrap();
        let rate = body.rate(&[pi[0], pi[1], pi[2], l[0], l[1]]).unwrap();
        let of = |l: [f64; 2]| gyrostat(inertia.into(), pi.into(), Vector3::new(l[0], l[1], 0.0));
        let (expected, size) = (of(l), 16.0);
        for (x, y) in rate.iter().zip(&expected) {
            prop_assert!((x - y).abs() <= ROUND_OFF * size, "{rate:?} {expected:?}");
        }
        prop_assert_eq!(&rate[3..], &[0.0, 0.0]);
        // Control: rotors at rest make another motion.
        let at_rest = of([0.0; 2]);
        let turns = (l[0] * pi[2]).abs() > 0.1;
        prop_assert!(!turns || (at_rest - expected).amax() > 1e-3, "{at_rest:?}");
    }
}

/// Every system of the catalogue has a name of its own and all of its Casimirs, and says what its parameters are.
#[test]
fn systems_of_the_catalogue_are_what_they_say() {
    for kind in SystemKind::ALL {
        let parameters = kind.parameters.iter().try_fold(Parameters::new(), |all, parameter| {
            match parameter.components {
                Some(count) => all.vector(parameter.name, &vec![1.5; count]),
                None => all.number(parameter.name, 1.5),
            }
        });
        let system = kind.system(&parameters.unwrap()).unwrap();
        assert_eq!(SystemKind::named(kind.name).unwrap(), kind);
        assert_eq!(system.missing_casimirs(), Some(0), "{}", kind.name);
        let error = kind.system(&Parameters::new()).unwrap_err().to_string();
        assert!(kind.parameters.iter().all(|own| error.contains(own.about)), "{error}");
        let extra = Parameters::new().number("extra", 1.0).unwrap();
        assert!(kind.system(&extra).is_err());
    }
}
