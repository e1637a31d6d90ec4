//! The law suites of spins: in a row, on atoms in motion, and on a lattice.

use super::field_laws::{differences, sites_field};
use super::suites_with_controls::{holds, obeys};
use crate::law_samples::{
    ENERGY_OF_ORDER_FOUR, ENERGY_OF_ORDER_TWO, ROUND_OFF, ROUND_OFF_OF_RUNS, SHORT_STEP, STEP,
    Spins as Lattice, samples, spiral,
};
use lie_poisson_systems::collective_integrators::{
    BrownianPaths, Collective, Integrator, PathAndTime, RungeKutta, SphericalMidpoint, Start, laws,
};
use lie_poisson_systems::lie_poisson::laws::{hamiltonian, poisson_space, sites_hamiltonian};
use lie_poisson_systems::lie_poisson::{
    Automatic, Covector, Energy, Hamiltonian, LiePoisson, Pair, PathNumber, Point, PowerAlgebra,
    ProductSpace, RealSpace, Sign, SitesHamiltonian, So3, Time,
};
use lie_poisson_systems::momentum_map::laws::{lift, poisson_map};
use lie_poisson_systems::momentum_map::{
    CotangentBundle, Identity, PowerMap, ProductMap, QuadraticMomentumMap, Side, So3OnC2,
};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{
    HeisenbergChain, HeisenbergLattice, LangevinSpins, LatticeMidpoint, SpinDamping, SpinLattice,
    SpinLatticeSpace, SpinSpace, Spins,
};

/// The map onto N spins with the plus bracket.
type SpinMap<const N: usize> = PowerMap<QuadraticMomentumMap<So3OnC2>, N>;

fn map<const N: usize>() -> SpinMap<N> {
    PowerMap(QuadraticMomentumMap::new(So3OnC2, Side::Left))
}

fn chain<const N: usize>() -> HeisenbergChain<N> {
    HeisenbergChain::new(0.8, Vector3::new(0.0, 0.0, 0.4)).unwrap()
}

#[test]
fn spin_space_laws() {
    let space: SpinSpace<2> = LiePoisson::plus(PowerAlgebra(So3));
    for sign in [Sign::Plus, Sign::Minus] {
        obeys(space.algebra(), ("coadjoint", 4), ROUND_OFF, |algebra| {
            poisson_space(&LiePoisson::new(algebra.clone(), sign), &samples())
        });
    }
}

#[test]
fn heisenberg_chain_laws() {
    obeys(&chain::<1>(), ("differential", 0), ROUND_OFF, |h| {
        hamiltonian::<SpinSpace<1>, _>(h, &samples())
    });
    obeys(&chain::<2>(), ("differential", 3), ROUND_OFF, |h| {
        hamiltonian::<SpinSpace<2>, _>(h, &samples())
    });
    obeys(&chain::<3>(), ("differential", 8), ROUND_OFF, |h| {
        hamiltonian::<SpinSpace<3>, _>(h, &samples())
    });
    obeys(&chain::<12>(), ("differential", 35), ROUND_OFF, |h| {
        hamiltonian::<SpinSpace<12>, _>(h, &samples())
    });
    let (chain, momenta) = (chain::<3>(), [samples::<Spins<3>>()[0]]);
    let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), map::<3>(), chain);
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta, STEP));
    let states = momenta.map(|mu| gauss.start(&mu).unwrap());
    let along_the_field = |s: &Spins<3>| s.0.0.iter().map(|s| s.z).sum::<f64>();
    let length = |s: &Spins<3>| s.0.0[2].norm();
    obeys(&gauss, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&along_the_field, &length])
    });
    holds(&gauss, ENERGY_OF_ORDER_FOUR, |i| {
        laws::invariants(i, &states, STEP, &[&|s: &_| chain.value(s)])
    });
}

fn lattice<const N: usize>() -> SpinLattice<N> {
    SpinLattice::new(1.2, 2.0, 0.8, 0.5).unwrap()
}

/// Runs the suites of the Hamiltonian of spins on N atoms.
fn obeys_on_atoms<const N: usize>() {
    let h = Automatic(lattice::<N>());
    obeys(&h, ("differential", 0), ROUND_OFF, |h| {
        hamiltonian::<SpinLatticeSpace<N>, _>(h, &samples())
    });
    obeys(&h, ("differential", 0), DIFFERENCES, |h| {
        differences::<SpinLatticeSpace<N>, _>(h, &samples())
    });
}

/// The error of a central difference of numbers of size 1.
const DIFFERENCES: f64 = 1e-9;

#[test]
fn spin_lattice_space_laws() {
    let bundle = CotangentBundle(RealSpace::<2>);
    let space: SpinLatticeSpace<2> = ProductSpace(LiePoisson::plus(PowerAlgebra(So3)), bundle);
    obeys(space.0.algebra(), ("coadjoint", 4), ROUND_OFF, |algebra| {
        poisson_space(&ProductSpace(LiePoisson::plus(algebra.clone()), bundle), &samples())
    });
}

#[test]
fn spin_lattice_laws() {
    obeys_on_atoms::<1>();
    obeys_on_atoms::<2>();
    obeys_on_atoms::<3>();
    obeys_on_atoms::<6>();
}

#[test]
fn spin_lattice_map_and_integrator_laws() {
    type State = Point<SpinLatticeSpace<2>>;
    let (lattice, momenta) = (lattice::<2>(), [samples::<State>()[0]]);
    let map = ProductMap(map::<2>(), Identity(CotangentBundle(RealSpace::<2>)));
    obeys(&map, ("apply", 0), ROUND_OFF, |map| poisson_map(map, &samples()));
    obeys(&map, ("lift", 0), ROUND_OFF, |map| lift(map, &samples()));
    let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), map, Automatic(lattice));
    obeys(&gauss, ("step", 0), ROUND_OFF, |i| laws::start(i, &momenta, STEP));
    let states = momenta.map(|mu| gauss.start(&mu).unwrap());
    let total = |axis: usize| move |z: &State| z.0.0.0.iter().map(|s| s[axis]).sum::<f64>();
    let momentum = |z: &State| z.1.p.0.sum();
    obeys(&gauss, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, &states, STEP, &[&total(0), &total(1), &total(2), &momentum])
    });
    holds(&gauss, ENERGY_OF_ORDER_FOUR, |i| {
        laws::invariants(i, &states, STEP, &[&|z: &State| lattice.energy(z)])
    });
}

/// The numbers of cells: the smallest lattices, rows shorter and longer than the registers, one to three dimensions.
const CELLS: [[usize; 3]; 5] = [[1, 1, 1], [2, 1, 1], [3, 1, 1], [3, 2, 1], [17, 2, 1]];

/// Returns a lattice with all interactions, which conserves the spin along the field, and spins of different lengths.
fn large(cells: [usize; 3]) -> (HeisenbergLattice, Lattice) {
    let lattice = HeisenbergLattice::new(cells)
        .and_then(|lattice| lattice.with_exchange([1, 0, 0], 1.0))
        .and_then(|lattice| lattice.with_exchange([0, -1, 0], 0.7))
        .and_then(|lattice| lattice.with_exchange([2, 1, -1], -0.4))
        .and_then(|lattice| lattice.with_anisotropy(Vector3::new(0.0, 3.0, 4.0), 0.3))
        .and_then(|lattice| lattice.with_field(Vector3::new(0.0, 0.3, 0.4)))
        .unwrap();
    let count = lattice.count();
    let spins = spiral(count).zip(0..).map(|(s, i)| s * (1.0 + 0.1 * f64::from(i).cos()));
    (lattice, Covector(spins.collect()))
}

#[test]
fn heisenberg_lattice_laws() {
    for cells in CELLS {
        let (lattice, s) = large(cells);
        let (last, spins) = (s.0.len() * 3 - 1, [s]);
        obeys(&lattice, ("differential_into", last), ROUND_OFF, |h| {
            sites_hamiltonian::<So3, _>(h, &spins)
        });
        obeys(&lattice, ("at", last), ROUND_OFF, |h| sites_field(h, LiePoisson::plus(So3), &spins));
        obeys_as_midpoint(SphericalMidpoint::new(lattice.clone()), &lattice, &spins);
    }
}

#[test]
fn lattice_midpoint_laws() {
    for cells in CELLS {
        let (lattice, s) = large(cells);
        obeys_as_midpoint(LatticeMidpoint::new(lattice.clone()), &lattice, &[s]);
    }
}

#[test]
fn langevin_spins_laws() {
    for cells in [[1, 1, 1], [3, 2, 1]] {
        let (lattice, s) = large(cells);
        let paths = BrownianPaths::new(3, SHORT_STEP).unwrap();
        let damping = SpinDamping::LandauLifshitz(0.4);
        let langevin = LangevinSpins::new(lattice, damping, 0.3, paths).unwrap();
        let starts = [Pair(s, Pair(PathNumber(5.0), Time(0.0)))];
        obeys(&langevin, ("step", 0), ROUND_OFF, |i| laws::integrator(i, &starts, SHORT_STEP));
        let length = |Pair(s, _): &Pair<Lattice, PathAndTime<f64>>| s.0[0].norm();
        obeys(&langevin, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
            laws::invariants(i, &starts, SHORT_STEP, &[&length])
        });
    }
}

/// Runs the suites of an integrator of the lattice.
fn obeys_as_midpoint<I>(midpoint: I, lattice: &HeisenbergLattice, spins: &[Lattice])
where
    I: Integrator<State = Lattice, Momentum = Lattice> + Clone,
{
    // The suite takes more than a thousand steps, and one from each state with a coordinate that is not a number.
    if lattice.count() < 10 {
        obeys(&midpoint, ("step", 0), ROUND_OFF, |i| laws::integrator(i, spins, SHORT_STEP));
    }
    let along_the_field = |s: &Lattice| s.0.iter().map(|s| 0.6 * s.y + 0.8 * s.z).sum::<f64>();
    let length = |s: &Lattice| s.0[0].norm();
    obeys(&midpoint, ("step", 0), ROUND_OFF_OF_RUNS, |i| {
        laws::invariants(i, spins, SHORT_STEP, &[&along_the_field, &length])
    });
    holds(&midpoint, ENERGY_OF_ORDER_TWO, |i| {
        laws::invariants(
            i,
            spins,
            SHORT_STEP,
            &[&|s: &Lattice| SitesHamiltonian::value(lattice, s)],
        )
    });
}
