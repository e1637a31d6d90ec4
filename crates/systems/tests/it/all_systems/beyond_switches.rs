//! Sizes beyond the switches in the code: more spins than one task or slab has (4096), more vortices than one task has (224
//! of 300), and matrices whose products take other kernels and several panels (N = 33, with panels of 24 columns).
//!
//! One step of each method conserves what it should, on any number of threads with the same bits. An explicit method is
//! the control: it is refused.

use lie_poisson_systems::collective_integrators::{
    Direct, Integrator, RungeKutta, SphericalMidpoint, Start,
};
use lie_poisson_systems::isospectral_flows::{
    CommutatorField, ExponentialMidpoint, GaussMagnus, IsospectralRungeKutta, LargeSkewHermitian,
};
use lie_poisson_systems::lie_poisson::{Covector, Sites, State, larger};
use lie_poisson_systems::nalgebra::Vector3;
use lie_poisson_systems::{
    HeisenbergLattice, LatticeMidpoint, ManyVortices, VorticityCoefficients, Zeitlin,
};

type Points = Covector<Sites<Vector3<f64>>>;

/// Returns the state after one step, which has the same bits on one, two and five threads.
fn step<I>(integrator: &I, start: &I::State, step: f64) -> I::State
where
    I: Start<State: PartialEq + Send + Sync, Momentum = <I as Integrator>::State> + Sync,
{
    let [one, two, five] = [1, 2, 5].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| integrator.after(start, step, 1).unwrap().state)
    });
    assert!(one == two && one == five && one != *start);
    one
}

/// Returns points on a spiral of the unit sphere, which are apart from each other.
fn spiral(count: usize) -> impl Iterator<Item = Vector3<f64>> {
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (2.399_963 * i as f64).sin_cos();
        Vector3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z)
    })
}

/// Returns the largest relative change of a length.
fn change_of_lengths(a: &Points, b: &Points) -> f64 {
    let change = |(a, b): (&Vector3<f64>, &Vector3<f64>)| (b.norm() / a.norm() - 1.0).abs();
    a.0.iter().zip(b.0.iter()).map(change).fold(0.0, larger)
}

/// Returns the change of the sum of all vectors along a direction, relative to the sum of their lengths.
fn change_of_sum(a: &Points, b: &Points, along: &Vector3<f64>) -> f64 {
    let sum = |m: &Points| m.0.iter().map(|m| m.dot(along)).sum::<f64>();
    (sum(b) - sum(a)).abs() / a.0.iter().map(|m| m.norm()).sum::<f64>()
}

/// Some ten roundings of a length in one step. A sum has those of its terms, which are smaller relative to all.
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// The stages are solved to a few units of round-off of each vector, which a sum does not lose.
const SOLVED: f64 = 1e-13;

#[test]
fn five_thousand_spins() {
    let along = Vector3::new(0.0, 0.6, 0.8);
    let lattice = HeisenbergLattice::new([25, 20, 10])
        .and_then(|lattice| lattice.with_exchange([1, 0, 0], 1.0))
        .and_then(|lattice| lattice.with_exchange([0, -1, 0], 0.7))
        .and_then(|lattice| lattice.with_exchange([2, 1, -1], -0.4))
        .and_then(|lattice| lattice.with_anisotropy(along, 0.3))
        .and_then(|lattice| lattice.with_field(along * 0.5))
        .unwrap();
    let spins = spiral(lattice.count()).zip(0..);
    let start = Covector(spins.map(|(s, i)| s * (1.0 + 0.1 * f64::from(i).cos())).collect());
    let general = step(&SphericalMidpoint::new(lattice.clone()), &start, 0.05);
    let fast = step(&LatticeMidpoint::new(lattice.clone()), &start, 0.05);
    for end in [&general, &fast] {
        assert!(change_of_lengths(&start, end) < ROUND_OFF);
        assert!(change_of_sum(&start, end, &along) < SOLVED);
    }
    let mut difference = fast;
    difference.subtract_in_place(&general);
    let apart = difference.0.iter().map(|s| s.amax()).fold(0.0, larger);
    assert!(apart < SOLVED, "{apart:e}");
    // Controls: an explicit method, and a direction along which the spin is not conserved.
    let explicit = step(&Direct::new(RungeKutta::rk4(), lattice), &start, 0.05);
    assert!(change_of_lengths(&start, &explicit) > ROUND_OFF);
    assert!(change_of_sum(&start, &general, &Vector3::x()) > SOLVED);
}

#[test]
fn three_hundred_vortices() {
    let strength = |i: usize| if i.is_multiple_of(3) { -0.5 } else { 1.0 + 0.01 * i as f64 };
    let vortices = ManyVortices::new((0..300).map(strength).collect()).unwrap();
    let start = vortices.momentum(spiral(300)).unwrap();
    let end = step(&SphericalMidpoint::new(vortices.clone()), &start, 1e-3);
    assert!(change_of_lengths(&start, &end) < ROUND_OFF);
    for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
        assert!(change_of_sum(&start, &end, &axis) < SOLVED);
    }
    // Controls: an explicit method, and a vortex that stays where it was.
    let explicit = step(&Direct::new(RungeKutta::explicit_midpoint(), vortices), &start, 1e-3);
    assert!(change_of_lengths(&start, &explicit) > ROUND_OFF);
    let mut still = end;
    still.0[271] = start.0[271];
    assert!(change_of_sum(&start, &still, &Vector3::x()) > SOLVED);
}

/// Returns the largest change of tr W², …, tr W⁵, relative to the enstrophy.
fn change_of_casimirs(fluid: &Zeitlin, a: &LargeSkewHermitian, b: &LargeSkewHermitian) -> f64 {
    let (before, after) = (fluid.casimirs(a, 5), fluid.casimirs(b, 5));
    let change = before.iter().zip(after).map(|(a, b)| (a - b).abs()).fold(0.0, larger);
    change / fluid.enstrophy(a)
}

#[test]
fn matrices_of_size_33() {
    let fluid = Zeitlin::new(33).unwrap();
    let start = fluid.vorticity(&VorticityCoefficients::from_fn(33, |l, m| {
        let x = (7 * l + m) as f64;
        let value =
            lie_poisson_systems::num_complex::Complex::new((3.1 * x).sin(), (5.3 * x).cos());
        if (1..=20).contains(&l) { value / l as f64 } else { 0.0.into() }
    }));
    // The bound of smaller matrices for each step: the degree of the Casimirs times N, of some roundings.
    let round_off = 16.0 * f64::EPSILON * (5 * 33) as f64;
    let size = 0.01;
    let ends = [
        step(&IsospectralRungeKutta::new(RungeKutta::gauss(2).unwrap(), &fluid), &start, size),
        step(&GaussMagnus::new(2, &fluid).unwrap(), &start, size),
        step(&ExponentialMidpoint::new(&fluid), &start, size),
    ];
    for end in &ends {
        let change = change_of_casimirs(&fluid, &start, end);
        assert!(change < round_off, "{change:e}");
    }
    // The two methods of order 4 end at the same point, up to their errors.
    let apart = |a: &LargeSkewHermitian, b: &LargeSkewHermitian| {
        let mut difference = a.clone();
        difference.subtract_in_place(b);
        difference.norm() / start.norm()
    };
    assert!(apart(&ends[0], &ends[1]) < 1e-2 * apart(&ends[0], &start));
    // Control: an explicit method.
    let field = CommutatorField::new(&fluid);
    let explicit = step(&Direct::new(RungeKutta::explicit_midpoint(), field), &start, size);
    assert!(change_of_casimirs(&fluid, &start, &explicit) > round_off);
}
