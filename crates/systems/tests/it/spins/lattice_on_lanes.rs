//! The spherical midpoint method for the lattice on SIMD lanes and threads, against the general method.

use lie_poisson_systems::collective_integrators::{
    Integrator, SphericalMidpoint, StageSolver, Start, StepError,
};
use lie_poisson_systems::lie_poisson::{
    Covector, InstructionSet, MissingInstructions, Sites, SitesHamiltonian, larger,
};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{HeisenbergLattice, LatticeMidpoint};

type Spins = Covector<Sites<Vector3<f64>>>;

/// A lattice with all interactions, whose offsets have every sign.
fn generic(cells: [usize; 3]) -> HeisenbergLattice {
    HeisenbergLattice::new(cells)
        .and_then(|lattice| lattice.with_exchange([1, 0, 0], 1.0))
        .and_then(|lattice| lattice.with_exchange([0, -1, 0], 0.7))
        .and_then(|lattice| lattice.with_exchange([2, 1, -1], -0.4))
        .and_then(|lattice| lattice.with_exchange([0, 0, 2], 0.2))
        .and_then(|lattice| lattice.with_anisotropy(Vector3::new(0.0, 3.0, 4.0), 0.3))
        .and_then(|lattice| lattice.with_field(Vector3::new(0.1, -0.2, 0.5)))
        .unwrap()
}

/// Spins of different lengths.
fn spins(lattice: &HeisenbergLattice) -> Spins {
    let spin = |i: usize| {
        let x = i as f64;
        let direction = Vector3::new((2.3 * x).sin(), (1.7 * x).cos(), (0.9 * x + 0.2).sin());
        direction.normalize() * (1.0 + 0.1 * x.cos())
    };
    Covector((0..lattice.count()).map(spin).collect())
}

fn largest_difference(a: &Spins, b: &Spins) -> f64 {
    a.0.iter().zip(b.0.iter()).map(|(a, b)| (a - b).amax()).fold(0.0, larger)
}

/// Rows shorter than a block, whole blocks and incomplete ones; one, two and three dimensions; bonds around the whole
/// lattice, and beyond all blocks of a row; 41 rows, of which the cache takes a part at a time.
#[test]
fn it_is_the_spherical_midpoint_method() {
    let shapes = [
        [1, 1, 1],
        [2, 1, 1],
        [3, 2, 1],
        [16, 1, 1],
        [17, 3, 1],
        [5, 4, 3],
        [8, 3, 2],
        [9, 41, 7],
        [15, 2, 2],
        [32, 3, 5],
        [33, 1, 4],
        [50, 7, 6],
        [1, 9, 1],
        [1, 1, 7],
    ];
    for cells in shapes {
        let lattice = generic(cells);
        let start = spins(&lattice);
        let general = SphericalMidpoint::new(lattice.clone());
        let fast = LatticeMidpoint::new(lattice);
        let expected = Start::<f64>::after(&general, &start, 0.05, 5).unwrap().state;
        let end = fast.after(&start, 0.05, 5).unwrap().state;
        // Five steps that differ by a few roundings of spins of size 1.
        assert!(largest_difference(&end, &expected) < 64.0 * f64::EPSILON, "{cells:?}");
        // Control: the spins move.
        assert!(largest_difference(&end, &start) > 1e-3, "{cells:?}");
    }
}

/// Bonds that reach half of the lattice pass several times through all blocks of a row.
#[test]
fn bonds_may_reach_half_of_a_row() {
    for nx in [7_i64, 16, 19, 24] {
        for reach in [nx / 2 - 1, nx / 2] {
            let lattice = HeisenbergLattice::new([nx as usize, 5, 1]).unwrap();
            let lattice = lattice.with_exchange([reach, 2, 0], 1.0).unwrap();
            let start = spins(&lattice);
            let expected = SphericalMidpoint::new(lattice.clone()).after(&start, 0.05, 5).unwrap();
            let end = LatticeMidpoint::new(lattice).after(&start, 0.05, 5).unwrap();
            assert!(largest_difference(&end.state, &expected.state) < 64.0 * f64::EPSILON);
            // Control: the spins move.
            assert!(largest_difference(&end.state, &start) > 1e-3, "{nx} {reach}");
        }
    }
}

/// Bonds that reach several rows or planes, of which the method keeps as many as it needs.
#[test]
fn bonds_may_reach_several_rows_and_planes() {
    let along = |axis: usize, reach: i64| match axis {
        1 => [1, reach, 0],
        _ => [1, 0, reach],
    };
    for (axis, reach) in [1, 2].into_iter().flat_map(|axis| (1..=4).map(move |n| (axis, n))) {
        for count in [7, 9, 12] {
            let cells = [5, count, count];
            let lattice = HeisenbergLattice::new(cells).unwrap();
            let lattice = lattice.with_exchange(along(axis, reach), 1.0).unwrap();
            let start = spins(&lattice);
            let expected = SphericalMidpoint::new(lattice.clone()).after(&start, 0.05, 5).unwrap();
            let end = LatticeMidpoint::new(lattice).after(&start, 0.05, 5).unwrap();
            assert!(largest_difference(&end.state, &expected.state) < 64.0 * f64::EPSILON);
            assert!(largest_difference(&end.state, &start) > 1e-3, "{axis} {reach} {count}");
        }
    }
}

/// Slabs of several sizes: more planes than threads, and fewer.
#[test]
fn numbers_of_threads_do_not_change_bits() {
    for cells in [[33, 20, 37], [64, 128, 1], [70, 40, 9]] {
        let lattice = generic(cells);
        let start = spins(&lattice);
        let midpoint = LatticeMidpoint::new(lattice);
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| midpoint.after(&start, 0.05, 2).unwrap().state)
        };
        let one = run(1);
        assert!(run(2) == one && run(5) == one && one != start, "{cells:?}");
    }
}

#[test]
fn energies_and_lengths_are_conserved() {
    let lattice = generic([18, 4, 3]);
    let start = spins(&lattice);
    let drift = |steps: u64| {
        let midpoint = LatticeMidpoint::new(lattice.clone());
        let end = midpoint.after(&start, 5.0 / steps as f64, steps).unwrap().state;
        let length = |(a, b): (&Vector3<f64>, &Vector3<f64>)| (a.norm() - b.norm()).abs();
        let lengths = start.0.iter().zip(end.0.iter()).map(length).fold(0.0, larger);
        (lengths, (lattice.value(&end) - lattice.value(&start)).abs())
    };
    let [coarse, fine] = [250, 500].map(drift);
    // 500 roundings of a length of about 1, and an energy error of order 2
    assert!(coarse.0 < 500.0 * f64::EPSILON && fine.0 < 500.0 * f64::EPSILON);
    assert!((3.0..5.0).contains(&(coarse.1 / fine.1)), "{:e} {:e}", coarse.1, fine.1);
}

/// Spins and exchange constants in other units: h J s stays the same.
#[test]
fn units_do_not_matter() {
    let end = |unit: f64| {
        let lattice = HeisenbergLattice::new([20, 3, 2]).unwrap();
        let lattice = lattice.with_exchange([1, 1, 0], 1.0 / unit).unwrap();
        let mut s = spins(&lattice);
        s.0.iter_mut().for_each(|s| *s *= unit);
        let midpoint = LatticeMidpoint::new(lattice);
        midpoint.after(&s, 0.1, 3).unwrap().state
    };
    let plain = end(1.0);
    for unit in [2.0_f64.powi(100), 2.0_f64.powi(-100)] {
        let scaled = end(unit);
        assert!(scaled.0.iter().zip(plain.0.iter()).all(|(a, b)| *a == b * unit));
    }
}

/// One workspace serves lattices of different size, and steps that failed leave the spins as they are.
#[test]
fn failures_change_nothing() {
    let mut space = LatticeMidpoint::new(generic([3, 3, 3])).workspace();
    for cells in [[20, 3, 4], [3, 3, 3], [40, 5, 4], [20, 3, 4]] {
        let midpoint = LatticeMidpoint::new(generic(cells));
        let start = spins(midpoint.lattice());
        let (mut used, mut fresh) = (start.clone(), start.clone());
        midpoint.step_in_place(&mut used, 0.05, &mut space).unwrap();
        midpoint.step_in_place(&mut fresh, 0.05, &mut midpoint.workspace()).unwrap();
        assert_eq!(used, fresh);
        // a step beyond convergence, a step that is no number, a spin that is zero, another number of spins
        let mut kept = start.clone();
        for step in [1e3, f64::NAN, f64::INFINITY] {
            let failed = midpoint.step_in_place(&mut kept, step, &mut space);
            assert!(failed.is_err() && kept == start, "{step}");
        }
        let mut zero = start.clone();
        zero.0[7] = Vector3::zeros();
        let failed = midpoint.step(&zero, 0.05, &mut space);
        assert!(matches!(failed, Err(StepError::NotConverged { .. })));
        let other = Covector(Sites::new(vec![Vector3::x(); 7]));
        let failed = midpoint.step(&other, 0.05, &mut space);
        assert!(matches!(failed, Err(StepError::Dimension { .. })));
        let few = StageSolver { max_iterations: 2, ..StageSolver::default() };
        let failed = midpoint.clone().with_solver(few).step(&start, 0.05, &mut space);
        assert!(matches!(failed, Err(StepError::NotConverged { iterations: 2, .. })));
    }
}

/// The portable instructions round products, and the others do not.
#[test]
fn every_instruction_set_makes_the_same_step() {
    let lattice = generic([21, 4, 3]);
    let start = spins(&lattice);
    let end = |set: InstructionSet| {
        let midpoint = LatticeMidpoint::new(lattice.clone()).with_instructions(set).unwrap();
        midpoint.step(&start, 0.1, &mut midpoint.workspace()).unwrap().point
    };
    let ends: Vec<_> = InstructionSet::available().map(end).collect();
    // A few roundings of numbers near 1 in the last sweep; the others are contracted.
    let bound = 16.0 * f64::EPSILON;
    assert!(ends.iter().all(|end| largest_difference(end, &ends[0]) < bound));
    // Those that fuse products and sums have the same bits.
    assert!(ends.iter().skip(2).all(|end| *end == ends[1]));
    // Control: the step moves the spins.
    assert!(largest_difference(&start, &ends[0]) > bound);
    let missing = InstructionSet::ALL.into_iter().find(|set| !set.is_available());
    if let Some(set) = missing {
        let refused = LatticeMidpoint::new(lattice).with_instructions(set);
        assert_eq!(refused.err(), Some(MissingInstructions { set }));
    }
}
