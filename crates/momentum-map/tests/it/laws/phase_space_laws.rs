//! The law suites of symplectic spaces, of representations that make them, and of the Hamiltonians on them that a map
//! gives.

use crate::support::{holds, laws, samples};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::Vector3;

/// Checks the laws of a symplectic space as one, and as a Poisson space.
fn symplectic_laws<P: SymplecticSpace>(space: &P) {
    holds(laws::symplectic_space(space, &samples()).unwrap());
    holds(lie_poisson::laws::poisson_space(space, &samples()).unwrap());
}

#[test]
fn symplectic_spaces() {
    symplectic_laws(&CotangentBundle(RealSpace::<1>));
    symplectic_laws(&CotangentBundle(RealSpace::<9>));
    symplectic_laws(&SymplecticComplexSpace::<2>);
    symplectic_laws(&SymplecticComplexSpace::<7>);
    symplectic_laws(&Symplectic(SL2OnR2));
    symplectic_laws(&Symplectic(So3OnC2));
    symplectic_laws(&Symplectic(UnitaryOnComplexSpace::<5>));
    symplectic_laws(&Symplectic(Sum(SL2OnR2, Reversed(SL2OnR2))));
    symplectic_laws(&Symplectic(Diagonal::<_, 3>(SU2OnC2)));
}

#[test]
fn symplectic_representations() {
    fn check<R: Representation>(r: &R) {
        holds(lie_poisson::laws::representation(r, &samples(), &samples()).unwrap());
    }
    check(&So3OnC2);
    check(&Reversed(SL2OnR2));
    check(&Reversed(UnitaryOnComplexSpace::<3>));
}

energy!(Body {} on LiePoisson<So3>: |_body, Covector(pi)| pi.x * pi.y + pi.z * pi.z * pi.z * 0.5);

/// Functions on the source of a map: h∘M for a Hamiltonian on its target, and the components ⟨J, ξ⟩.
#[test]
fn hamiltonians_by_maps() {
    let collective = CollectiveHamiltonian::new(HOPF, Automatic(Body {}));
    holds(lie_poisson::laws::hamiltonian(&collective, &samples()).unwrap());
    for xi in samples::<Vector3<f64>>() {
        let spin = NoetherQuantity::new(HOPF, xi);
        assert_eq!(*spin.map(), HOPF);
        holds(lie_poisson::laws::hamiltonian(&spin, &samples()).unwrap());
        let rotation = NoetherQuantity::new(MomentumMap(LinearAction(SO3OnR3)), xi);
        holds(lie_poisson::laws::hamiltonian(&rotation, &samples()).unwrap());
    }
    // control: the generator is right, and the map is not the one whose derivative is pulled back
    let wrong = laws::Faulty::new(&HOPF, "pull_back", 0);
    let wrong = CollectiveHamiltonian::new(wrong, Automatic(Body {}));
    let report = lie_poisson::laws::hamiltonian(&wrong, &samples()).unwrap();
    assert!(report.residual("differential").unwrap() > 0.1);
}
