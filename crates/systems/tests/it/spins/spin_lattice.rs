//! Spins on a vibrating lattice: what a collective Gauss method conserves, and which parameters are refused.

use crate::all_systems::drifts::{ROUND_OFF, drifts, energy_bound, schemes};
use crate::spins::spin_chain::spins;
use collective_integrators::Collective;
use lie_poisson::{Automatic, Covector, Energy, Pair, Power, RealSpace, larger};
use lie_poisson_systems::{SpinLattice, SystemError};
use momentum_map::{
    Cotangent, CotangentBundle, Identity, PowerMap, ProductMap, QuadraticMomentumMap, Side, So3OnC2,
};
use nalgebra::{SVector, Vector3};

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

#[test]
fn the_energy_is_that_of_the_formula() {
    let lattice = SpinLattice::<3>::new(0.7, 3.0, 1.1, 0.4).unwrap();
    let spins = [[0.6, 0.0, 0.8], [0.0, 0.28, 0.96], [0.48, 0.6, 0.64]].map(Vector3::from);
    let (q, p) = (Vector3::new(0.3, -0.2, 0.6), Vector3::new(0.5, 0.9, -0.4));
    let state = Pair(Covector(Power(spins)), Cotangent::new(q, Covector(p)));
    // q₂ − q₁, q₃ − q₂, q₁ − q₃, and the products of neighbouring spins
    let (stretches, overlaps) = ([-0.5, 0.8, -0.3], [0.768, 0.7824, 0.8]);
    // 1.22/(2m), ½ κ times the squares of the stretches, (a stretch − J) times the products
    let (kinetic, springs) = (1.22 / 1.4, 1.5 * 0.98);
    let exchange: f64 = stretches.iter().zip(overlaps).map(|(x, s)| (0.4 * x - 1.1) * s).sum();
    let expected = kinetic + springs + exchange;
    // Some twenty roundings of numbers below 4.
    assert!((lattice.energy(&state) - expected).abs() < 40.0 * f64::EPSILON);
}

#[test]
fn the_parameters_are_checked() {
    let [massless, soft] = [(0.0, 1.0), (1.0, -1.0)]
        .map(|(mass, stiffness)| SpinLattice::<2>::new(mass, stiffness, 1.0, 1.0));
    assert_eq!(massless, Err(SystemError::NotPositive { name: "mass", value: 0.0 }));
    assert_eq!(soft, Err(SystemError::Negative { name: "stiffness", value: -1.0 }));
    assert!(SpinLattice::<2>::new(1.0, 1.0, f64::NAN, 1.0).is_err());
}
