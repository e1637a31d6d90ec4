//! The lattice of spins: its equations, exact spin waves, the chain as a special case, and what is conserved.

use lie_poisson_systems::collective_integrators::{
    Direct, Integrator, RungeKutta, SphericalMidpoint, Start, VectorField, fitted_order,
};
use lie_poisson_systems::lie_poisson::{
    Covector, Hamiltonian, Power, Sites, SitesHamiltonian, State, larger,
};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{HeisenbergChain, HeisenbergLattice, SystemError};

type Spins = Covector<Sites<Vector3<f64>>>;

/// A lattice with all interactions, whose offsets have every sign.
fn generic(cells: [usize; 3]) -> HeisenbergLattice {
    HeisenbergLattice::new(cells)
        .and_then(|lattice| lattice.with_exchange([1, 0, 0], 1.0))
        .and_then(|lattice| lattice.with_exchange([0, -1, 0], 0.7))
        .and_then(|lattice| lattice.with_exchange([2, 1, -1], -0.4))
        .and_then(|lattice| lattice.with_anisotropy(Vector3::new(0.0, 3.0, 4.0), 0.3))
        .and_then(|lattice| lattice.with_field(Vector3::new(0.1, -0.2, 0.5)))
        .unwrap()
}

fn spin(i: usize) -> Vector3<f64> {
    let x = i as f64;
    Vector3::new((2.3 * x).sin(), (1.7 * x).cos(), (0.9 * x + 0.2).sin()).normalize()
}

fn spins(lattice: &HeisenbergLattice) -> Spins {
    Covector((0..lattice.count()).map(spin).collect())
}

/// ds/dt = s × (−∂h/∂s), with the derivative of h by central differences.
#[test]
fn rates_follow_from_the_energy() {
    for cells in [[4, 3, 5], [1, 1, 1], [2, 1, 3], [7, 1, 1], [3, 4, 1]] {
        let lattice = generic(cells);
        let (s, width) = (spins(&lattice), 1e-4);
        let rate = lattice.at(&s);
        for i in 0..lattice.count() {
            let slope = |axis: usize| {
                let value = |shift: f64| {
                    let mut moved = s.clone();
                    moved.0[i][axis] += shift;
                    lattice.value(&moved)
                };
                (value(width) - value(-width)) / (2.0 * width)
            };
            let field = -Vector3::new(slope(0), slope(1), slope(2));
            // h is quadratic: the difference is exact up to round-off.
            let error = (rate.0[i] - s.0[i].cross(&field)).norm();
            assert!(error < 1e-10, "{cells:?} {i} {error:e}");
        }
    }
}

#[test]
fn cells_are_numbered_row_by_row() {
    let lattice = generic([2, 3, 4]);
    let state = lattice.state(|cell| Vector3::from(cell.map(|i| i as f64)));
    for (i, cell) in state.0.iter().enumerate() {
        let expected = [i % 2, i / 2 % 3, i / 6].map(|x| x as f64);
        assert_eq!(cell, &Vector3::from(expected), "{i}");
    }
}

/// A lattice that is shared by threads has the rates of its unit cell, which one thread computes.
#[test]
fn a_periodic_state_has_periodic_rates() {
    let (cell, copies) = (generic([32, 16, 4]), generic([32, 16, 64]));
    let small = spins(&cell);
    let repeated = (0..copies.count()).map(|i| small.0[i % cell.count()]);
    let (rate, rates) = (cell.at(&small), copies.at(&Covector(repeated.collect())));
    for (i, found) in rates.0.iter().enumerate() {
        assert_eq!(found, &rate.0[i % cell.count()], "{i}");
    }
}

#[test]
fn a_row_is_the_heisenberg_chain() {
    const N: usize = 6;
    let field = Vector3::new(0.2, 0.1, -0.4);
    let chain = HeisenbergChain::<N>::new(0.8, field).unwrap();
    let row = HeisenbergLattice::new([N, 1, 1]).unwrap().with_exchange([1, 0, 0], 0.8).unwrap();
    let row = row.with_field(field).unwrap();
    let s = Covector(Power(core::array::from_fn::<_, N, _>(spin)));
    let large = Covector(Sites::new(s.0.0.to_vec()));
    assert!((row.value(&large) - chain.value(&s)).abs() < 1e-14);
    let differential = chain.differential(&s);
    for (i, rate) in row.at(&large).0.iter().enumerate() {
        assert!((differential.0[i].cross(&s.0.0[i]) - rate).norm() < 1e-15);
    }
}

/// Spins on a cone about the axis of B and a turn at the same rate: an exact solution in each dimension.
#[test]
fn spin_waves_turn_at_the_exact_rate() {
    let (cells, wave) = ([6, 4, 3], [1.0 / 6.0, 2.0 / 4.0, 1.0 / 3.0]);
    let offsets = [([1, 0, 0], 1.0), ([0, 1, 0], -0.3), ([1, -1, 1], 0.5)];
    let (k, b, height) = (0.4, 0.7, 0.6_f64);
    let mut lattice = HeisenbergLattice::new(cells).unwrap();
    for (offset, constant) in offsets {
        lattice = lattice.with_exchange(offset, constant).unwrap();
    }
    let lattice = lattice.with_anisotropy(Vector3::z(), k).unwrap();
    let lattice = lattice.with_field(Vector3::z() * b).unwrap();
    let phase = |r: [f64; 3]| core::f64::consts::TAU * (0..3).map(|i| wave[i] * r[i]).sum::<f64>();
    let sums = offsets.map(|(o, j)| 2.0 * j * (1.0 - phase(o.map(|x| x as f64)).cos()));
    let omega = height * (sums.iter().sum::<f64>() + 2.0 * k) + b;
    let exact = |t: f64| {
        lattice.state(|cell| {
            let angle = phase(cell.map(|x| x as f64)) - omega * t;
            Vector3::new(0.8 * angle.cos(), 0.8 * angle.sin(), height)
        })
    };
    let midpoint = SphericalMidpoint::new(lattice.clone());
    let errors = [40, 80, 160].map(|steps| {
        let h = 2.0 / steps as f64;
        let end = Start::<f64>::after(&midpoint, &exact(0.0), h, steps).unwrap().state;
        let error = |(a, b): (&Vector3<f64>, &Vector3<f64>)| (a - b).norm();
        (h, end.0.iter().zip(exact(2.0).0.iter()).map(error).fold(0.0, larger))
    });
    let order = fitted_order(&errors, 1e-12).unwrap();
    assert!((order - 2.0).abs() < 0.1 && errors[2].1 < 1e-2, "{order} {errors:?}");
}

#[test]
fn energies_and_lengths_are_conserved() {
    let lattice = generic([5, 4, 3]);
    let start = spins(&lattice);
    let drift = |end: &Spins| {
        let length = |(a, b): (&Vector3<f64>, &Vector3<f64>)| (a.norm() - b.norm()).abs();
        let lengths = start.0.iter().zip(end.0.iter()).map(length).fold(0.0, larger);
        (lengths, (lattice.value(end) - lattice.value(&start)).abs())
    };
    let midpoint = SphericalMidpoint::new(lattice.clone());
    let [coarse, fine] = [250, 500].map(|steps| {
        let h = 5.0 / steps as f64;
        drift(&Start::<f64>::after(&midpoint, &start, h, steps).unwrap().state)
    });
    // 500 roundings of a length of 1, and an energy error of order 2
    assert!(coarse.0 < 500.0 * f64::EPSILON && fine.0 < 500.0 * f64::EPSILON);
    let ratio = coarse.1 / fine.1;
    assert!((3.5..4.5).contains(&ratio), "{:e} {:e}", coarse.1, fine.1);
    let direct = Direct::new(RungeKutta::rk4(), lattice.clone());
    let (lengths, _) = drift(&Start::<f64>::after(&direct, &start, 0.05, 500).unwrap().state);
    assert!(lengths > 1e-9, "the control conserves lengths: {lengths:e}");
}

/// More than one task, on one and on two threads.
#[test]
fn numbers_of_threads_do_not_change_bits() {
    let lattice = generic([33, 20, 17]);
    let start = spins(&lattice);
    let midpoint = SphericalMidpoint::new(lattice.clone());
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Start::<f64>::after(&midpoint, &start, 0.05, 3).unwrap().state)
    };
    let one = run(1);
    assert!(run(2) == one && run(5) == one && one != start);
}

#[test]
fn parameters_are_checked() {
    assert!(matches!(HeisenbergLattice::new([3, 0, 1]), Err(SystemError::Zero { .. })));
    let huge = HeisenbergLattice::new([usize::MAX, 2, 1]);
    assert!(matches!(huge, Err(SystemError::TooMany { .. })));
    let lattice = || HeisenbergLattice::new([2, 2, 2]).unwrap();
    assert!(lattice().with_exchange([1, 0, 0], f64::NAN).is_err());
    assert!(lattice().with_exchange([i64::MIN, i64::MAX, -1], 1.0).is_ok());
    assert!(lattice().with_field(Vector3::new(0.0, f64::INFINITY, 0.0)).is_err());
    let no_axis = lattice().with_anisotropy(Vector3::zeros(), 1.0);
    assert!(matches!(no_axis, Err(SystemError::Zero { .. })));
    assert!(lattice().with_anisotropy(Vector3::new(0.0, 1e-300, 0.0), 1.0).is_ok());
    let other = Covector(Sites::new(vec![Vector3::x(); 7]));
    assert!(
        SitesHamiltonian::<Vector3<f64>>::value(&lattice(), &other).is_nan()
            && !lattice().at(&other).is_finite()
    );
    assert_eq!(lattice().cells(), [2; 3]);
    // Each of the two has another number of spins once.
    for [spins, rates] in [[7, 8], [8, 7]] {
        let s = Covector(Sites::new(vec![Vector3::x(); spins]));
        let mut dh = Sites::new(vec![Vector3::<f64>::x(); rates]);
        lattice().differential_into(&s, &mut dh);
        assert!(dh.iter().all(|dh| dh.iter().all(|x| x.is_nan())));
    }
    let midpoint = SphericalMidpoint::new(lattice());
    assert!(
        Integrator::<f64>::step(
            &midpoint,
            &other,
            0.1,
            &mut Integrator::<f64>::workspace(&midpoint)
        )
        .is_err()
    );
}
