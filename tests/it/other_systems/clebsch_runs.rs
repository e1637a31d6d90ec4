//! Long runs by Clebsch maps: each is right to the order of its method, or ends with an error.

use collective_integrators::{
    AnyState, Collective, Direct, HamiltonianField, Integrator, RungeKutta, StageSolver, Start,
};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::{
    Automatic, Covector, Energy, LiePoisson, Real, Representation, StructureConstants, Vector,
    larger,
};
use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
use lie_poisson_formulas::{Coordinates, Parameters, StructureEntry};
use momentum_map::{Lift, PoissonMap, Side, clebsch_realisation};
use nalgebra::SVector;
use workspace_tests::low_dimensional::{
    Check, Entry, FIVE, THREE, WITHOUT_DERIVATION, coextended, every_algebra, extended, samples,
    table,
};

/// The energy ½|μ|². It bounds every motion.
#[derive(Clone, Copy)]
struct Round<const N: usize>;

impl<const N: usize> Energy for Round<N> {
    type Space = LiePoisson<StructureConstants<N>>;

    fn energy<T: Real>(&self, mu: &Covector<SVector<T, N>>) -> T {
        (0..N).fold(T::zero(), |sum, i| sum + mu.0[i] * mu.0[i] * 0.5)
    }
}

/// The time between two samples.
const INTERVAL: f64 = 0.2;

/// The change of the start by whose growth a motion is judged.
const NEARBY: f64 = 1e-8;

/// The relative error beyond which a motion is not followed. Where the growth of errors allows more, only the energy is
/// compared.
const PREDICTABLE: f64 = 1e-2;

/// A momentum of an algebra of dimension N.
type Momentum<const N: usize> = Covector<SVector<f64, N>>;

/// The momenta of a motion at multiples of [`INTERVAL`], and the largest growth of a change of the start up to each.
struct Reference<const N: usize>(Vec<(Momentum<N>, f64)>);

impl<const N: usize> Reference<N> {
    /// Computes the motion by the method DOP853 on the equations.
    fn new(space: LiePoisson<StructureConstants<N>>, start: &Momentum<N>, samples: usize) -> Self {
        let field = HamiltonianField { space, hamiltonian: Automatic(Round::<N>) };
        let exact = Direct::new(RungeKutta::dop853(), field);
        let run = |start: &Momentum<N>| {
            let run = exact.trajectory(start, INTERVAL / 8.0).unwrap().step_by(8);
            run.take(samples).map(|sample| sample.unwrap().momentum).collect::<Vec<_>>()
        };
        let moved = Covector(start.0.map(|x| x + NEARBY * (1.0 + 0.3 * x)));
        let (here, near) = (run(start), run(&moved));
        let mut growth = 1.0;
        let growths = here.iter().zip(near).map(|(a, b)| {
            growth = larger(growth, (b - *a).max_abs() / NEARBY);
            (*a, growth)
        });
        Self(growths.collect())
    }
}

/// The runs of all algebras that have been made.
struct Runs {
    starts: usize,
    samples: usize,
    steps: &'static [f64],
    made: usize,
    failed: usize,
    /// The number of samples that have been compared.
    compared: usize,
    /// The largest error of a run, as a multiple of the bound for its step.
    worst: f64,
}

/// Returns the largest error of a run by Gauss's method of order 8 that is right to its order, in units of the growth of a
/// change of the start. The rates of the motions are of size 1, and lifted ones are some ten times as fast.
fn bound(step: f64) -> f64 {
    1e-10 + 100.0 * step.powi(8)
}

impl Runs {
    fn new(starts: usize, end: f64, steps: &'static [f64]) -> Self {
        let samples = (end / INTERVAL).round() as usize + 1;
        Self { starts, samples, steps, made: 0, failed: 0, compared: 0, worst: 0.0 }
    }

    /// Makes the runs of one representation. A run ends with an error, or each of its samples is right.
    fn make<R: Representation<Algebra = StructureConstants<N>>, const N: usize>(
        &mut self,
        name: &str,
        r: R,
    ) {
        let map = clebsch_realisation(r, Side::Right).unwrap();
        let space = map.target();
        let gauss = Collective::new(RungeKutta::gauss(4).unwrap(), map, Automatic(Round::<N>));
        for (index, start) in samples::<Momentum<N>>(self.starts).iter().enumerate() {
            let Reference(exact) = Reference::new(space.clone(), start, self.samples);
            for &step in self.steps {
                let every = (INTERVAL / step).round() as usize;
                let run = gauss.trajectory(start, step).unwrap().step_by(every);
                self.made += 1;
                for (sample, (mu, growth)) in run.zip(&exact) {
                    let Ok(sample) = sample else {
                        self.failed += 1;
                        break;
                    };
                    let at = format!("{name}, start {index}, {step}, {}", sample.time);
                    let energy = |mu: &Momentum<N>| mu.0.norm_squared();
                    let change = energy(&sample.momentum) / energy(start) - 1.0;
                    assert!(change.abs() < PREDICTABLE, "{at}: {change:e}");
                    if growth * bound(step) > PREDICTABLE * larger(1.0, mu.max_abs()) {
                        continue;
                    }
                    let error = (sample.momentum - *mu).max_abs() / growth / bound(step);
                    assert!(error < 1.0, "{at}: {error:e}");
                    self.worst = larger(self.worst, error);
                    self.compared += 1;
                    assert!(
                        error < 1.0,
                        "{name}, start {index}, {step}, {}: {error:e}",
                        sample.time
                    );
                }
            }
        }
    }

    /// Makes the runs of one algebra by the map that programs choose.
    fn of<const N: usize>(&mut self, entry: &Entry) {
        let algebra = table::<N>(entry, 1.0).unwrap();
        if WITHOUT_DERIVATION.contains(&entry.name) {
            self.make(entry.name, coextended(&algebra).unwrap());
        } else {
            self.make(entry.name, extended(&algebra).unwrap());
        }
    }
}

impl Check for Runs {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        self.of::<N>(entry);
    }
}

/// No run stops, and all are right.
#[test]
#[ignore = "long"]
fn runs_on_every_algebra_are_right_to_their_order() {
    let mut runs = Runs::new(1, 10.0, &[0.2]);
    assert_eq!(every_algebra(&mut runs), 62);
    println!("worst of {} runs: {:e} of the bound", runs.made, runs.worst);
    assert_eq!((runs.made, runs.failed), (62, 0));
    assert!(runs.compared > 2500, "{}", runs.compared);
}

#[test]
#[ignore = "takes minutes"]
fn long_runs_on_every_algebra_are_right_or_stop() {
    let mut runs = Runs::new(20, 100.0, &[0.2, 0.1, 0.05]);
    assert_eq!(every_algebra(&mut runs), 62);
    println!("worst of {} runs: {:e} of the bound, {} stop", runs.made, runs.worst, runs.failed);
    // Three stopped after t = 80, on A5,32 and A5,35; which they are may depend on round-off.
    assert!(runs.made == 3720 && runs.failed < 10, "{}", runs.failed);
}

/// The runs of systems from formulas, whose steps are refused if they lose h or a Casimir.
struct Guarded;

impl Check for Guarded {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        let algebra = table::<N>(entry, 1.0).unwrap();
        let alone = clebsch_realisation(extended(&algebra).unwrap(), Side::Right).unwrap();
        let other = clebsch_realisation(coextended(&algebra).unwrap(), Side::Right).unwrap();
        let upper = (0..N * N * N).map(|n| (n / (N * N), n / N % N, n % N));
        let entries = upper.filter(|(i, j, _)| i < j).map(|(i, j, k)| StructureEntry {
            i,
            j,
            k,
            value: algebra.constant(i, j, k),
        });
        let entries = entries.filter(|entry| entry.value != 0.0).collect();
        let names = Coordinates::scalars(["a", "b", "c", "d", "e"].into_iter().take(N)).unwrap();
        let squares: Vec<_> = names.names().map(|name| format!("{name}^2")).collect();
        let algebra = SystemAlgebra::of_entries(names, entries).unwrap();
        let (collective, gauss) = (Formulation::Collective, SchemeName::Gauss(4));
        let method = algebra.method(collective, gauss, 0.0).unwrap();
        let hamiltonian = format!("({})/2", squares.join(" + "));
        let system = FormulaSystem::new(algebra, &hamiltonian, &Parameters::new()).unwrap();
        let system = system.with_found_casimirs().unwrap();
        for start in samples::<Momentum<N>>(3) {
            let is_reached = alone.lift(&start).is_ok();
            let [alone, other] =
                [alone.equivariant_maps_descend(), other.equivariant_maps_descend()];
            let descends = if is_reached { alone } else { other };
            let found = system.descends(&method, start.0.as_slice()).unwrap();
            assert_eq!(found, descends, "{}, {}", entry.name, start.0);
            let integrator = system.tangent_integrator(&method, start.0.as_slice()).unwrap();
            // z is moved back along its fibre, where it grows.
            let run = integrator.after(&AnyState::of(&start), 0.1, 400).map(drop);
            run.unwrap_or_else(|error| panic!("{}, {}: {error}", entry.name, start.0));
        }
    }
}

/// Runs that follow the motion lose neither h nor a Casimir.
#[test]
#[ignore = "long"]
fn runs_that_are_right_are_not_refused() {
    assert_eq!(every_algebra(&mut Guarded), 62);
}

/// The affine algebra of the plane, with coordinates (a b; c d) and (x, y). z grows exponentially along the fibres of
/// its Clebsch map, whose steps do not descend.
const AFFINE: Entry = Entry {
    name: "aff(2)",
    brackets: &[
        (1, 2, &[(1.0, 2)]),
        (1, 3, &[(-1.0, 3)]),
        (2, 3, &[(1.0, 1), (-1.0, 4)]),
        (2, 4, &[(1.0, 2)]),
        (3, 4, &[(-1.0, 3)]),
        (1, 5, &[(1.0, 5)]),
        (2, 6, &[(1.0, 5)]),
        (3, 5, &[(1.0, 6)]),
        (4, 6, &[(1.0, 6)]),
    ],
};

#[test]
#[ignore = "long"]
fn z_does_not_grow_along_fibres_that_are_not_compact() {
    let mut runs = Runs::new(3, 40.0, &[0.1]);
    // Solvable algebras on which z grew to 10²⁰ within this time, and the affine algebra.
    for name in ["A5,12", "A5,38"] {
        runs.of::<5>(FIVE.iter().find(|entry| entry.name == name).unwrap());
    }
    runs.of::<6>(&AFFINE);
    println!("worst of {} runs: {:e} of the bound", runs.made, runs.worst);
    assert_eq!((runs.made, runs.failed), (9, 0));
}

/// After t = 30 some coordinates of z are round-off, each alone in its block. Newton's iterations go a thousand times their
/// sizes to solutions that are those of short steps in all that matters.
#[test]
#[ignore = "long"]
fn coordinates_that_are_round_off_do_not_stop_a_run() {
    let mut runs = Runs::new(3, 60.0, &[0.2, 0.1]);
    runs.of::<3>(THREE.iter().find(|entry| entry.name == "A3,2").unwrap());
    assert_eq!((runs.made, runs.failed), (6, 0));
}

/// The collective integrator on aff(2) whose start makes x and y decay to round-off, and this start.
fn decaying(gauss: RungeKutta) -> (impl Start<Momentum = Momentum<6>, State: Vector>, Momentum<6>) {
    let map = extended(&table::<6>(&AFFINE, 1.0).unwrap()).unwrap();
    let map = clebsch_realisation(map, Side::Right).unwrap();
    let start = Covector(SVector::<f64, 6>::new(0.2, 0.5, 0.0, -0.2, -0.6, -1.3));
    (Collective::new(gauss, map, Automatic(Round::<6>)), start)
}

/// With x and y a block of z decays to round-off, which begins each step at zero. Sweeps compare it with its terms once
/// Newton's iteration has been needed for that: 12 iterations a step, 33 with Newton's in each. The workspace that has met
/// such blocks serves a method without Newton's iteration, and another state, as a new one does.
#[test]
#[ignore = "long"]
fn blocks_that_are_round_off_cost_few_iterations() {
    let gauss = RungeKutta::gauss(4).unwrap();
    let (with_newton, start) = decaying(gauss.clone());
    let (mut z, mut used) = (with_newton.start(&start).unwrap(), with_newton.workspace());
    with_newton.advance(&mut z, 0.1, 0..600, &mut used).unwrap();
    let mut iterations = 0;
    for made in 600..900 {
        iterations += with_newton.advance(&mut z, 0.1, made..made + 1, &mut used).unwrap();
        let mu = with_newton.momentum(&z);
        let change = mu.0.norm_squared() / start.0.norm_squared() - 1.0;
        assert!(change.abs() < 1e-12 && mu.0[4].abs() < 1e-12, "{made}");
    }
    assert!(iterations < 15 * 300, "{iterations}");

    let sweeps = StageSolver { newton: false, ..StageSolver::default() };
    let (alone, start) = decaying(gauss.with_solver(sweeps));
    let z = alone.start(&start).unwrap();
    let [again, fresh] =
        [&mut used, &mut alone.workspace()].map(|space| alone.step(&z, 0.1, space).unwrap());
    assert_eq!(again.point, fresh.point);
}

/// Control: without moves along the fibres z grows until nothing is left of M(z).
#[test]
#[ignore = "long"]
fn z_grows_where_it_is_not_moved() {
    let entry = FIVE.iter().find(|entry| entry.name == "A5,12").unwrap();
    let map = clebsch_realisation(extended(&table::<5>(entry, 1.0).unwrap()).unwrap(), Side::Right);
    let (map, gauss) = (map.unwrap(), RungeKutta::gauss(4).unwrap());
    let start = samples::<Momentum<5>>(1)[0];
    fn length<I: Start<State: Vector<Scalar = f64>>>(run: &I, start: &I::Momentum) -> f64 {
        let run = run.trajectory(start, 0.1).unwrap().take(401);
        run.map_while(Result::ok).fold(0.0, |most, sample| larger(most, sample.state.max_abs()))
    }
    let moved = Collective::new(gauss.clone(), map.clone(), Automatic(Round::<5>));
    let left = Collective::that_does_not_descend(gauss, map, Automatic(Round::<5>));
    let (moved, left) = (length(&moved, &start), length(&left, &start));
    assert!(moved < 100.0 && left > 1e6, "{moved:e} {left:e}");
}

/// The energy ½α² + 0.3 βγ + 0.1 β² on sl(2)∗.
#[derive(Clone, Copy)]
struct Unbounded;

impl Energy for Unbounded {
    type Space = LiePoisson<StructureConstants<3>>;

    fn energy<T: Real>(&self, mu: &Covector<SVector<T, 3>>) -> T {
        let [a, b, c] = [mu.0[0], mu.0[1], mu.0[2]];
        a * a * 0.5 + b * c * 0.3 + b * b * 0.1
    }
}

/// γ grows to 10¹² while β decays to 10⁻¹⁴. The Casimir α² + 4βγ keeps its digits only if the small coordinates of z
/// keep theirs, and z is not moved where nothing is lost.
#[test]
fn coordinates_that_decay_while_others_grow_keep_their_digits() {
    let algebra = StructureConstants::<3>::new(|i, j, k| {
        let upper = |i, j, k| match (i, j, k) {
            (0, 1, 1) => 2.0,
            (0, 2, 2) => -2.0,
            (1, 2, 0) => 1.0,
            _ => 0.0,
        };
        upper(i, j, k) - upper(j, i, k)
    });
    let map = clebsch_realisation(extended(&algebra.unwrap()).unwrap(), Side::Right).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(4).unwrap(), map, Automatic(Unbounded));
    let start = Covector(SVector::<f64, 3>::new(0.3, 0.5, -0.2));
    let casimir = |mu: &Momentum<3>| mu.0[0] * mu.0[0] + 4.0 * mu.0[1] * mu.0[2];
    for sample in gauss.trajectory(&start, 0.05).unwrap().take(1001) {
        let sample = sample.unwrap();
        // a hundred rounding errors of 4βγ = 0.46
        let change = casimir(&sample.momentum) - casimir(&start);
        assert!(change.abs() < 1e-14, "{}: {change:e}", sample.time);
    }
}

/// On the affine algebra of the line, [X, Y] = Y, the energy ½(X² + Y²) = ½c² has the motions
///
/// ```text
/// X = −c tanh(c(t − t₀)),   Y = c sech(c(t − t₀))
/// ```
///
/// Y keeps its digits until it underflows, while z stays of the size of √c: the map does not depend on some of its
/// coordinates, which would grow as 1/√Y.
#[test]
#[ignore = "long"]
fn a_coordinate_decays_through_all_numbers() {
    let algebra = StructureConstants::<2>::new(|i, j, k| match (i, j, k) {
        (0, 1, 1) => 1.0,
        (1, 0, 1) => -1.0,
        _ => 0.0,
    });
    let map = clebsch_realisation(extended(&algebra.unwrap()).unwrap(), Side::Right).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(4).unwrap(), map, Automatic(Round::<2>));
    let start = Covector(SVector::<f64, 2>::new(0.3, 0.5));
    let c = start.0.norm();
    let beginning = (start.0[0] / c).atanh() / c;
    let mut last = start;
    for sample in gauss.trajectory(&start, 0.1).unwrap().take(13_001) {
        let sample = sample.unwrap();
        let exponent = c * (sample.time - beginning);
        let exact = SVector::<f64, 2>::new(-c * exponent.tanh(), c / exponent.cosh());
        // The rate of Y is known to the round-off of a run of 10⁴ steps.
        let error = (sample.momentum.0 - exact).component_div(&exact).abs();
        let known = exact[1] > 1e-300;
        assert!(error[0] < 1e-10 && (!known || error[1] < 1e-8), "{}: {error}", sample.time);
        assert!(sample.state.max_abs() < 50.0, "{}: {:?}", sample.time, sample.state);
        last = sample.momentum;
    }
    assert!(last.0[1] == 0.0);
}
