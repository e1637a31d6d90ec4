//! Spins at a temperature: their lengths, the energies of chains and rings, magnetisations, and all units.

use collective_integrators::{
    BrownianPaths, Driven, Integrator, PathAndTime, RungeKutta, Start, StepError,
};
use lie_poisson::{
    Autonomous, Covector, DoubleBracket, GilbertDamping, InnerProduct, LiePoisson, OrbitField,
    Pair, PathNumber, Power, PowerAlgebra, Sites, SitesHamiltonian, So3, Time,
};
use lie_poisson_systems::{
    HeisenbergChain, HeisenbergLattice, LangevinSpins, SpinDamping, SpinSpace, SystemError,
};
use momentum_map::{PowerMap, QuadraticMomentumMap, Side, So3OnC2};
use nalgebra::Vector3;

type Spins = Covector<Sites<Vector3<f64>>>;

fn on_path(spins: Spins, path: u64) -> Pair<Spins, PathAndTime<f64>> {
    Pair(spins, Pair(PathNumber(path as f64), Time(0.0)))
}

fn ring(sites: usize) -> HeisenbergLattice {
    HeisenbergLattice::new([sites, 1, 1]).unwrap().with_exchange([1, 0, 0], 1.0).unwrap()
}

/// Returns the state of a ring of spins of length 1 along e₃, or of an open chain, which is a ring with a further site of
/// length 0.
fn aligned(sites: usize, open: bool) -> (HeisenbergLattice, Spins) {
    let lattice = ring(sites + usize::from(open));
    let spins = lattice.state(|[x, _, _]| if x < sites { Vector3::z() } else { Vector3::zeros() });
    (lattice, spins)
}

/// Returns the energy per bond for J = 1 of a ring of n spins at kT = 1/K: −d ln Z/dK / n with the eigenvalues i_l(K) of the
/// transfer operator, the modified spherical functions of Bessel, each 2l + 1 times.
fn energy_of_ring(k: f64, n: i32) -> f64 {
    let (mut sum, mut change) = (0.0, 0.0);
    for l in 0..25 {
        // i_l(K) = Σ_m K^(l+2m) / (2^m m! (2l + 2m + 1)!!), and its derivative.
        let mut term = (0..l).fold(1.0, |term, j| term * k / f64::from(2 * j + 3));
        let (mut value, mut slope) = (0.0, 0.0);
        for m in 0..60 {
            value += term;
            slope += term * f64::from(l + 2 * m) / k;
            term *= k * k / f64::from(2 * (m + 1) * (2 * l + 2 * m + 3));
        }
        let power = value.powi(n - 1) * f64::from(2 * l + 1);
        sum += power * value;
        change += power * slope;
    }
    -change / sum
}

/// Returns the energy per bond of an open chain, −(coth K − 1/K).
fn energy_of_chain(k: f64) -> f64 {
    k.recip() - k.tanh().recip()
}

#[test]
fn the_transfer_operator_is_that_of_the_chain() {
    for k in [0.5, 1.0, 2.0, 4.0] {
        // 3 (coth K − 1/K)^64 is below 1e-7.
        assert!((energy_of_ring(k, 64) - energy_of_chain(k)).abs() < 1e-6);
        // In a ring of four spins the other eigenvalues matter.
        assert!((energy_of_ring(k, 4) - energy_of_chain(k)).abs() > 1e-3);
    }
    // A ring of two spins is one bond, twice: the mean of x in exp(2Kx) dx.
    assert!((energy_of_ring(0.7, 2) - energy_of_chain(1.4)).abs() < 1e-14);
}

const STEP: f64 = 0.05;

type State = Pair<Spins, PathAndTime<f64>>;

fn noise(step: f64) -> BrownianPaths {
    BrownianPaths::new(3, step).unwrap()
}

/// Returns the mean energy per bond of spins that begin aligned, over the last five sixths of paths, and its standard error
/// from the differences of the paths. `stepper` returns what makes the steps of a path.
fn mean_energy<F: FnMut(&mut State)>(
    (lattice, start): &(HeisenbergLattice, Spins),
    bonds: usize,
    (paths, steps): (u64, u64),
    stepper: impl Fn() -> F + Sync,
) -> (f64, f64) {
    let mean = |path: u64| {
        let (mut state, mut make, mut sum) = (on_path(start.clone(), path), stepper(), 0.0);
        for n in 0..steps {
            make(&mut state);
            if n >= steps / 6 {
                sum += lattice.value(&state.0);
            }
        }
        sum / (steps - steps / 6) as f64 / bonds as f64
    };
    let middle = paths / 2;
    let means: Vec<f64> = std::thread::scope(|scope| {
        let both = [0..middle, middle..paths]
            .map(|some| scope.spawn(|| some.map(&mean).collect::<Vec<_>>()));
        both.into_iter().flat_map(|one| one.join().unwrap()).collect()
    });
    let count = paths as f64;
    let average = means.iter().sum::<f64>() / count;
    let squares = means.iter().map(|mean| (mean - average).powi(2)).sum::<f64>();
    (average, (squares / (count * (count - 1.0))).sqrt())
}

/// Makes steps of the midpoint rule at kT, with the friction θ = 1.
fn by_midpoint(
    lattice: &HeisenbergLattice,
    (temperature, step): (f64, f64),
) -> impl FnMut(&mut State) {
    let damping = SpinDamping::LandauLifshitz(1.0);
    let langevin = LangevinSpins::new(lattice.clone(), damping, temperature, noise(step)).unwrap();
    let mut workspace = langevin.workspace();
    move |state| {
        langevin.step_in_place(state, step, &mut workspace).unwrap();
    }
}

/// Makes explicit steps of Itô's equation by Euler and Maruyama, scaled back to the spheres.
fn by_euler(
    lattice: &HeisenbergLattice,
    (temperature, step): (f64, f64),
) -> impl FnMut(&mut State) {
    let (mut dh, mut increments) = (lattice.state(|_| Vector3::zeros()).0, Vec::new());
    move |state| {
        let Pair(spins, Pair(path, clock)) = state;
        increments.resize(3 * spins.0.len(), 0.0);
        noise(step).write_increments(path.0 as u64, clock.0, clock.0 + 1.0, &mut increments);
        lattice.differential_into(spins, &mut dh);
        for ((s, dh), noise) in spins.0.iter_mut().zip(dh.iter()).zip(increments.chunks(3)) {
            let (length, field) = (s.norm(), -dh);
            // Itô's drift of σ s × ∘dW is −σ² s, with σ² = 2kT.
            let drift = s.cross(&field) - s.cross(&s.cross(&field)) - *s * (2.0 * temperature);
            let noise = Vector3::from_column_slice(noise) * (2.0 * temperature).sqrt();
            *s += drift * step + s.cross(&noise);
            if length > 0.0 {
                *s *= length / s.norm();
            }
        }
        clock.0 += 1.0;
    }
}

/// Compares the energies of an open chain and of a ring with the exact ones; those of Euler's step are others.
fn chains_and_rings(couplings: &[(f64, f64)], sites: usize, sample: (u64, u64)) {
    let mut wrong = Vec::new();
    for (&(k, step), open) in couplings.iter().flat_map(|k| [(k, true), (k, false)]) {
        let (bonds, exact) = match open {
            true => (sites - 1, energy_of_chain(k)),
            false => (sites, energy_of_ring(k, sites as i32)),
        };
        let chain = aligned(sites, open);
        let (mean, error) =
            mean_energy(&chain, bonds, sample, || by_midpoint(&chain.0, (k.recip(), step)));
        let euler = mean_energy(&chain, bonds, sample, || by_euler(&chain.0, (k.recip(), step)));
        let is_right = (mean - exact).abs() < 4.0 * error;
        if !is_right || (euler.0 - exact).abs() < 4.0 * euler.1 {
            wrong.push((k, open, (mean, error), exact, euler));
        }
        println!("K = {k}, open: {open}: {mean} ± {error}, exact {exact}, Euler {euler:?}");
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
#[ignore = "long"]
fn chains_and_rings_have_the_energy_of_the_transfer_operator() {
    chains_and_rings(&[(1.0, 0.05), (4.0, 0.05)], 64, (8, 500));
}

#[test]
#[ignore = "takes a minute in a release"]
fn paths_taken_many_times_as_long_have_the_energy_of_the_transfer_operator() {
    // The errors of the midpoint rule, which are proportional to the step, are below three standard errors here, and
    // those of Euler's are above eight.
    let couplings = [(0.5, 0.02), (1.0, 0.02), (2.0, 0.05), (4.0, 0.05)];
    chains_and_rings(&couplings, 64, (16, 2000));
}

#[test]
fn a_ring_of_four_has_its_own_energy() {
    let four = aligned(4, false);
    let mean = mean_energy(&four, 4, (16, 3000), || by_midpoint(&four.0, (0.5, STEP)));
    let (ring, chain) = (energy_of_ring(2.0, 4), energy_of_chain(2.0));
    assert!(
        (mean.0 - ring).abs() < 4.0 * mean.1 && (mean.0 - chain).abs() > 4.0 * mean.1,
        "{mean:?} {ring} {chain}"
    );
}

/// Spins of two lengths in a field have Langevin's magnetisation, by both forms of the damping: the noise has the right power
/// of the length.
#[test]
fn spins_of_two_lengths_have_the_magnetisation_of_langevin() {
    let count = 600;
    let lattice = HeisenbergLattice::new([count, 1, 1]).unwrap();
    let lattice = lattice.with_field(Vector3::z()).unwrap();
    let length = |site: usize| if site.is_multiple_of(2) { 0.6 } else { 2.5 };
    for damping in [SpinDamping::LandauLifshitz(0.7), SpinDamping::Gilbert(0.5)] {
        let paths = BrownianPaths::new(1, STEP).unwrap();
        let langevin = LangevinSpins::new(&lattice, damping, 1.0, paths).unwrap();
        let start = on_path(lattice.state(|[x, _, _]| Vector3::x() * length(x)), 0);
        let spins = langevin.after(&start, STEP, 150).unwrap().momentum.0.0;
        for (first, other) in [(0, 1), (1, 0)] {
            let langevin = |x: f64| x.tanh().recip() - x.recip();
            let heights: Vec<_> =
                (first..count).step_by(2).map(|i| spins[i].z / length(i)).collect();
            let mean = heights.iter().sum::<f64>() / heights.len() as f64;
            let square = heights.iter().map(|z| (z - mean).powi(2)).sum::<f64>();
            let error = square.sqrt() / heights.len() as f64;
            let (exact, wrong) = (langevin(length(first)), langevin(length(other)));
            assert!((mean - exact).abs() < 4.0 * error, "{damping:?} {mean} ± {error}, {exact}");
            assert!((mean - wrong).abs() > 4.0 * error);
        }
    }
}

#[test]
fn lengths_stay_for_any_noise_and_sites_without_a_spin_stay_empty() {
    let (lattice, mut spins) = aligned(40, true);
    spins.0[3] *= 7.0;
    let before: Vec<f64> = spins.0.iter().map(|s| s.norm()).collect();
    for temperature in [0.5, 1e6] {
        for damping in [SpinDamping::LandauLifshitz(0.3), SpinDamping::Gilbert(0.3)] {
            let paths = BrownianPaths::new(1, 0.02).unwrap();
            let langevin = LangevinSpins::new(&lattice, damping, temperature, paths).unwrap();
            let end = langevin.after(&on_path(spins.clone(), 0), 0.02, 500).unwrap().momentum.0;
            for ((end, start), length) in end.0.iter().zip(spins.0.iter()).zip(&before) {
                // Roundings of 500 steps.
                assert!((end.norm() - length).abs() <= 1e-13 * length, "{damping:?} {temperature}");
                assert!(*length == 0.0 || (end - start).norm() > 1e-3);
            }
        }
    }
}

/// At the temperature 0 the motions are those of double brackets and of Gilbert's equation, which other integrators follow.
#[test]
fn without_a_temperature_the_motions_are_those_of_damped_spins() {
    let start = [Vector3::x(), Vector3::new(0.0, 1.2, 0.9), Vector3::new(0.3, -0.4, 0.0)];
    let (lattice, chain) = (ring(3), HeisenbergChain::<3>::new(1.0, Vector3::zeros()).unwrap());
    let space = LiePoisson::plus(PowerAlgebra::<_, 3>(So3));
    let end_of = |field: &dyn OrbitField<SpinSpace<3>>| {
        let map = PowerMap::<_, 3>(QuadraticMomentumMap::new(So3OnC2, Side::Left));
        let gauss = Driven::new(RungeKutta::gauss(3).unwrap(), map, field);
        let start = Pair(Covector(Power(start)), Time(0.0));
        gauss.after(&start, 0.05, 40).unwrap().momentum.0.0.0
    };
    let euclidean = InnerProduct::euclidean();
    let bracket = DoubleBracket::new(space, Autonomous(chain), 0.3, euclidean).unwrap();
    let gilbert = GilbertDamping::new(space, Autonomous(chain), 0.3).unwrap();
    for (damping, exact) in [
        (SpinDamping::LandauLifshitz(0.3), end_of(&bracket)),
        (SpinDamping::Gilbert(0.3), end_of(&gilbert)),
    ] {
        let distance = |step: f64, steps| {
            let paths = BrownianPaths::new(1, step).unwrap();
            let langevin = LangevinSpins::new(&lattice, damping, 0.0, paths).unwrap();
            let spins = Covector(start.into_iter().collect());
            let end = langevin.after(&on_path(spins, 0), step, steps).unwrap().momentum.0;
            let differences = end.0.iter().zip(exact).map(|(a, b)| (a - b).norm());
            differences.fold(0.0, f64::max)
        };
        let (coarse, fine) = (distance(0.02, 100), distance(0.01, 200));
        assert!(fine < 1e-3 && (3.5..4.5).contains(&(coarse / fine)), "{coarse} {fine}");
    }
}

/// In units in which a spin is u and a second τ times as large, J is 1/(uτ), kT is u/τ and θ is 1/u of what they were.
#[test]
fn units_do_not_matter() {
    let end = |(u, tau): (f64, f64), gilbert: bool| {
        let lattice = HeisenbergLattice::new([8, 1, 1]).unwrap();
        let lattice = lattice.with_exchange([1, 0, 0], 1.0 / u / tau).unwrap();
        let damping = match gilbert {
            true => SpinDamping::Gilbert(0.4),
            false => SpinDamping::LandauLifshitz(0.4 / u),
        };
        let paths = BrownianPaths::new(1, STEP * tau).unwrap();
        let langevin = LangevinSpins::new(&lattice, damping, 0.7 * u / tau, paths).unwrap();
        let start = on_path(lattice.state(|_| Vector3::new(0.6, 0.0, 0.8) * u), 5);
        let Pair(spins, Pair(_, time)) = langevin.after(&start, STEP * tau, 50).unwrap().momentum;
        assert!((time.0 / tau - 50.0 * STEP).abs() < 1e-12);
        spins.0.iter().map(|s| s / u).collect::<Vec<_>>()
    };
    for gilbert in [false, true] {
        let one = end((1.0, 1.0), gilbert);
        assert!((one[0] - Vector3::new(0.6, 0.0, 0.8)).norm() > 0.1);
        for units in [(1e30, 1.0), (1e-30, 1.0), (1.0, 1e30), (1.0, 1e-30), (1e-30, 1e30)] {
            let other = end(units, gilbert);
            // Fifty steps of some ten roundings.
            assert!(one.iter().zip(&other).all(|(a, b)| (a - b).norm() < 1e-12), "{units:?}");
        }
    }
}

#[test]
fn what_is_no_temperature_or_damping_is_refused() {
    let new = |damping, temperature| {
        LangevinSpins::new(ring(8), damping, temperature, BrownianPaths::new(1, STEP).unwrap())
    };
    for wrong in [-0.1, f64::NAN, f64::INFINITY] {
        for result in [
            new(SpinDamping::LandauLifshitz(wrong), 1.0),
            new(SpinDamping::Gilbert(wrong), 1.0),
            new(SpinDamping::Gilbert(0.1), wrong),
        ] {
            assert!(matches!(
                result,
                Err(SystemError::Negative { .. } | SystemError::NotFinite { .. })
            ));
        }
    }
    // A state that the lattice does not have, and a step that is too long for its exchange, fail and change nothing.
    let langevin = new(SpinDamping::Gilbert(0.1), 1.0).unwrap();
    for (sites, step) in [(7, STEP), (8, 20.0)] {
        let mut state = on_path(ring(sites).state(|[x, _, _]| Vector3::new(1.0, x as f64, 0.5)), 0);
        let before = state.clone();
        let made = langevin.step_in_place(&mut state, step, &mut langevin.workspace());
        assert!(matches!(made, Err(StepError::NotConverged { .. })), "{made:?}");
        assert_eq!(state, before);
    }
}

/// The rates are those of Landau and Lifshitz and of Gilbert, whose equation has the rate on both sides.
#[test]
fn the_drift_is_that_of_the_damping() {
    let (s, field) = (Vector3::new(0.3, -1.1, 0.8), Vector3::new(0.5, 0.2, -0.7));
    let rate = SpinDamping::LandauLifshitz(0.4).rate(&s, &field);
    let torque = s.cross(&field);
    assert!((rate - (torque - s.cross(&torque) * 0.4)).norm() < 1e-15);
    let rate = SpinDamping::Gilbert(0.4).rate(&s, &field);
    let residual = |alpha: f64| (rate - torque + s.cross(&rate) * (alpha / s.norm())).norm();
    assert!(residual(0.4) < 1e-15 && residual(0.5) > 1e-2, "control: another α");
    assert!((SpinDamping::Gilbert(0.4).friction(2.0) - 0.2 / 1.16).abs() < 1e-15);
    assert_eq!(SpinDamping::LandauLifshitz(0.4).friction(2.0), 0.4);
    assert_eq!(SpinDamping::Gilbert(0.4).rate(&Vector3::zeros(), &field), Vector3::zeros());
}
