//! The Heisenberg spin chain: precession in a field, and what a collective Gauss method conserves.

use crate::all_systems::drifts::{ROUND_OFF, drifts, energy_bound, schemes};
use collective_integrators::{Collective, RungeKutta};
use core::array::from_fn;
use lie_poisson::{
    Covector, Hamiltonian, LiePoisson, PoissonSpace, Power, PowerAlgebra, So3, larger,
};
use lie_poisson_systems::{HeisenbergChain, Spins};
use momentum_map::{PowerMap, QuadraticMomentumMap, Side, So3OnC2};
use nalgebra::Vector3;

/// Returns N unit vectors in general position.
pub fn spins<const N: usize>() -> Spins<N> {
    Covector(Power(from_fn(|i| {
        let i = i as f64;
        Vector3::new((1.3 * i).cos(), (2.1 * i + 0.4).sin(), (0.7 * i).sin() - 0.3).normalize()
    })))
}

#[test]
fn the_chain_conserves_the_total_spin_where_it_is_isotropic() {
    let map = PowerMap::<_, 12>(QuadraticMomentumMap::new(So3OnC2, Side::Left));
    let drifts = |scheme: &RungeKutta, chain: HeisenbergChain<12>| {
        let gauss = Collective::new(scheme.clone(), map, chain);
        drifts(&gauss, &spins(), (0.05, 500), |s| {
            let sum: Vector3<f64> = s.0.0.iter().sum();
            [chain.value(s), sum.x, sum.y, sum.z]
        })
    };
    for scheme in schemes() {
        let isotropic = HeisenbergChain::new(1.0, Vector3::zeros()).unwrap();
        let [energy, x, y, z] = drifts(&scheme, isotropic);
        assert!(larger(larger(x, y), z) < ROUND_OFF, "{x:e} {y:e} {z:e}");
        assert!(energy < energy_bound(&scheme, 0.05), "{energy:e}");
        let field = HeisenbergChain::new(1.0, Vector3::z()).unwrap();
        let [energy, x, _, z] = drifts(&scheme, field);
        assert!(z < ROUND_OFF && x > 0.1, "only the component along the field is conserved");
        assert!(energy < energy_bound(&scheme, 0.05), "{energy:e}");
    }
}

#[test]
fn spins_precess_to_the_right_about_a_field() {
    // The bracket {s_a, s_b} = ε_abc s_c and h = −B·s give Larmor precession, ṡ = s × B.
    let chain = HeisenbergChain::<1>::new(0.0, Vector3::z()).unwrap();
    let space = LiePoisson::plus(PowerAlgebra::<_, 1>(So3));
    let s = Covector(Power([Vector3::<f64>::x()]));
    let rate = space.hamiltonian_vector(&s, &chain.differential(&s));
    assert_eq!(rate.0.0[0], Vector3::x().cross(&Vector3::z()));
}

#[test]
fn an_explicit_method_conserves_none_of_it() {
    let rk4 = RungeKutta::rk4();
    let isotropic = HeisenbergChain::<12>::new(1.0, Vector3::zeros()).unwrap();
    let map = PowerMap::<_, 12>(QuadraticMomentumMap::new(So3OnC2, Side::Left));
    let collective = Collective::new(rk4, map, isotropic);
    let [length] = drifts(&collective, &spins(), (0.1, 500), |s| [s.0.0[0].norm()]);
    assert!(length > 1e3 * ROUND_OFF, "{length:e}");
}
