//! The law suites of vortices: on the sphere, few and many, and the elliptical one.

use super::field_laws::sites_field;
use super::suites_with_controls::{holds, obeys};
use crate::law_samples::{
    ENERGY_OF_ORDER_FOUR, ENERGY_OF_ORDER_TWO, ROUND_OFF, ROUND_OFF_OF_RUNS, SHORT_STEP, STEP,
    Spins, samples, spiral,
};
use lie_poisson_systems::collective_integrators::{
    Collective, LiftFree, RungeKutta, SphericalMidpoint, Start, laws,
};
use lie_poisson_systems::lie_poisson::laws::{
    casimirs, hamiltonian, lie_algebra, poisson_space, sites_hamiltonian,
};
use lie_poisson_systems::lie_poisson::{
    Casimirs, Covector, Hamiltonian, InfinitesimalAdjoint, LiePoisson, SitesHamiltonian, So3,
};
use lie_poisson_systems::momentum_map::laws::{lift, poisson_map};
use lie_poisson_systems::momentum_map::{PowerMultipliers, Quaternions, Side, clebsch_realisation};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{KidaVortex, ManyVortices, PointVortices, So21, SpinSpace};

/// Returns a strength of either sign.
fn strength(i: usize) -> f64 {
    if i.is_multiple_of(3) { -0.5 } else { 1.0 + 0.01 * i as f64 }
}

fn few<const N: usize>() -> (PointVortices<N>, lie_poisson_systems::Spins<N>) {
    let vortices = PointVortices::new(core::array::from_fn(strength)).unwrap();
    let positions: Vec<_> = spiral(N).collect();
    (vortices, vortices.momentum(&core::array::from_fn(|i| positions[i])))
}

#[test]
fn point_vortices_laws() {
    let ((one, alone), (vortices, m)) = (few::<1>(), few::<4>());
    // A single vortex has the energy 0, in which no fault can be seen.
    holds(&one, ROUND_OFF, |h| hamiltonian::<SpinSpace<1>, _>(h, &[alone]));
    obeys(&vortices, ("differential", 3), ROUND_OFF, |h| hamiltonian::<SpinSpace<4>, _>(h, &[m]));
    let multipliers = PowerMultipliers::<_, 4>(Quaternions);
    let gauss = LiftFree::new(RungeKutta::gauss(2).unwrap(), multipliers, vortices);
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &[m], STEP));
    let states = [gauss.start(&m).unwrap()];
    let moment = |axis: usize| {
        move |m: &lie_poisson_systems::Spins<4>| m.0.0.iter().map(|m| m[axis]).sum::<f64>()
    };
    let length = |m: &lie_poisson_systems::Spins<4>| m.0.0[3].norm();
    obeys(&gauss, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&moment(0), &moment(1), &moment(2), &length])
    });
    holds(&gauss, ENERGY_OF_ORDER_FOUR, |i| {
        laws::invariants(i, &states, STEP, &[&|m: &_| vortices.value(m)])
    });
}

/// The numbers of vortices: from 32 on, the differential is computed on SIMD lanes.
const VORTICES: [usize; 4] = [1, 2, 3, 40];

#[test]
fn many_vortices_laws() {
    for count in VORTICES {
        let vortices = ManyVortices::new((0..count).map(strength).collect()).unwrap();
        let m = [vortices.momentum(spiral(count)).unwrap()];
        let check = |method, suite: &dyn Fn(&_) -> _| match count {
            // A single vortex has the energy 0, in which no fault can be seen.
            1 => holds(&vortices, ROUND_OFF, suite),
            _ => obeys(&vortices, (method, 3 * count - 1), ROUND_OFF, suite),
        };
        check("differential_into", &|h| sites_hamiltonian::<So3, _>(h, &m));
        check("at", &|h| sites_field(h, LiePoisson::minus(So3), &m));
        let midpoint = SphericalMidpoint::new(vortices.clone());
        // The suite takes more than a thousand steps, and one from each state with a coordinate that is not a number.
        if count < 10 {
            obeys(&midpoint, ("step", 0), ROUND_OFF, |i| laws::integrator(i, &m, SHORT_STEP));
        }
        let moment = |axis: usize| move |m: &Spins| m.0.iter().map(|m| m[axis]).sum::<f64>();
        let length = |m: &Spins| m.0[0].norm();
        obeys(&midpoint, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
            laws::invariants(i, &m, SHORT_STEP, &[&moment(0), &moment(1), &moment(2), &length])
        });
        // The suite of invariants doubles coordinates, which must not take the vortices off the sphere.
        let energy = |m: &Spins| {
            let lengths = m.0.iter().zip(vortices.strengths());
            let m = Covector(lengths.map(|(m, k)| m.normalize() * k.abs()).collect());
            SitesHamiltonian::value(&vortices, &m)
        };
        if count > 1 {
            holds(&midpoint, ENERGY_OF_ORDER_TWO, |i| {
                laws::invariants(i, &m, SHORT_STEP, &[&energy])
            });
        }
    }
}

/// Returns ellipses that are so round that a coordinate of their points can be doubled, as the suite of invariants does.
fn ellipses() -> Vec<Covector<Vector3<f64>>> {
    let ellipse = |(a, b, angle)| KidaVortex::momentum(a, b, angle).unwrap();
    [(1.5, 1.0, 0.3), (1.0, 1.0, 0.0), (0.7, 0.5, -1.1)].map(ellipse).to_vec()
}

#[test]
fn so21_laws() {
    obeys(&So21, ("bracket", 0), ROUND_OFF, |algebra| lie_algebra(algebra, &samples()));
    obeys(&So21, ("casimir_differential", 0), ROUND_OFF, |algebra| casimirs(algebra, &samples()));
    obeys(&So21, ("coadjoint", 0), ROUND_OFF, |algebra| {
        poisson_space(&LiePoisson::plus(algebra.clone()), &samples())
    });
    let map = clebsch_realisation(InfinitesimalAdjoint(So21), Side::Left).unwrap();
    obeys(&map, ("apply", 0), ROUND_OFF, |map| poisson_map(map, &samples()));
    obeys(&map, ("lift", 0), ROUND_OFF, |map| lift(map, &ellipses()));
}

#[test]
fn kida_vortex_laws() {
    let vortex = KidaVortex::new(1.3, 0.1, 0.05).unwrap();
    obeys(&vortex, ("differential", 2), ROUND_OFF, |h| {
        hamiltonian::<LiePoisson<So21>, _>(h, &ellipses())
    });
    let map = clebsch_realisation(InfinitesimalAdjoint(So21), Side::Left).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), map, vortex);
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &ellipses()[..1], STEP));
    let states = [gauss.start(&ellipses()[0]).unwrap()];
    let area = |mu: &Covector<Vector3<f64>>| So21.casimir(0, mu);
    obeys(&gauss, ("step", 0), ROUND_OFF_OF_RUNS, |i| laws::invariants(i, &states, STEP, &[&area]));
    holds(&gauss, ENERGY_OF_ORDER_FOUR, |i| {
        laws::invariants(i, &states, STEP, &[&|mu: &_| vortex.value(mu)])
    });
}
