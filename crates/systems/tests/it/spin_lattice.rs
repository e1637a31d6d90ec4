//! Spins on a vibrating lattice: what a collective Gauss method conserves, and which parameters are refused.

use crate::drifts::{ROUND_OFF, drifts, energy_bound, schemes};
use crate::spin_chain::spins;
use collective_integrators::Collective;
use lie_poisson::{Automatic, Covector, Energy, Pair, Power, RealSpace, larger};
use lie_poisson_systems::{SpinLattice, SystemError};
use momentum_map::{
    Cotangent, CotangentBundle, Identity, PowerMap, ProductMap, QuadraticMomentumMap, Side, So3OnC2,
};
use nalgebra::{SVector, Vector2, Vector3};

#[test]
fn the_spin_lattice_conserves_both_momenta() {
    const N: usize = 6;
    let lattice = SpinLattice::<N>::new(1.0, 2.0, 1.0, 0.5).unwrap();
    let map = ProductMap(
        PowerMap::<_, N>(QuadraticMomentumMap::new(So3OnC2, Side::Left)),
        Identity(CotangentBundle(RealSpace::<N>)),
    );
    let q = SVector::from_fn(|i, _| 0.1 * (i as f64).cos());
    let p = SVector::from_fn(|i, _| 0.2 * (2.0 * i as f64).sin());
    let start = Pair(spins(), Cotangent::new(q, Covector(p)));
    for scheme in schemes() {
        let gauss = Collective::new(scheme.clone(), map, Automatic(lattice));
        let [energy, x, y, z, p] = drifts(&gauss, &start, (0.05, 200), |state| {
            let sum: Vector3<f64> = state.0.0.0.iter().sum();
            [lattice.energy(state), sum.x, sum.y, sum.z, state.1.p.0.sum()]
        });
        assert!(larger(larger(x, y), larger(z, p)) < ROUND_OFF, "{x:e} {y:e} {z:e} {p:e}");
        assert!(energy < energy_bound(&scheme, 0.05), "{energy:e}");
    }
}

/// Two cells, of which each is the neighbour of the other on both sides.
#[test]
fn the_energy_is_that_of_the_formula() {
    let (mass, stiffness, exchange, coupling) = (0.7, 3.0, 1.1, 0.4);
    let lattice = SpinLattice::<2>::new(mass, stiffness, exchange, coupling).unwrap();
    let spins = [Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.0, 0.28, 0.96)];
    let (q, p) = (Vector2::new(0.3, -0.2), Vector2::new(0.5, 0.9));
    let state = Pair(Covector(Power(spins)), Cotangent::new(q, Covector(p)));
    let (stretch, overlap) = (q.y - q.x, spins[0].dot(&spins[1]));
    let springs = stiffness * stretch * stretch;
    // The exchange falls with the distance on one side as it rises on the other.
    let expected = p.norm_squared() / (2.0 * mass) + springs - 2.0 * exchange * overlap;
    assert!((lattice.energy(&state) - expected).abs() < 1e-15 * 8.0);
    let bent = SpinLattice::<2>::new(mass, stiffness, exchange, 0.0).unwrap();
    assert!((lattice.energy(&state) - bent.energy(&state)).abs() < 1e-15);
}

#[test]
fn the_parameters_are_checked() {
    let [massless, soft] = [(0.0, 1.0), (1.0, -1.0)]
        .map(|(mass, stiffness)| SpinLattice::<2>::new(mass, stiffness, 1.0, 1.0));
    assert_eq!(massless, Err(SystemError::NotPositive { name: "mass", value: 0.0 }));
    assert_eq!(soft, Err(SystemError::Negative { name: "stiffness", value: -1.0 }));
    assert!(SpinLattice::<2>::new(1.0, 1.0, f64::NAN, 1.0).is_err());
}
