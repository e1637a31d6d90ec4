//! Systems of arrays: their equations are those of the library and of the literature.

use collective_integrators::diagnostics::{SystemScales, fitted_order};
use collective_integrators::{AnyIntegrator, AnyState, Collective, RungeKutta, Start};
use heavytop::methods::{Formulation, SchemeName};
use lie_poisson::{Automatic, Covector, Energy, Hamiltonian, Pair, Power, RealSpace, State};
use lie_poisson_formula_systems::SystemKind;
use lie_poisson_formulas::Parameters;
use lie_poisson_runs::{Arguments, ArrayKind, ArraySystem, Model};
use lie_poisson_systems::isospectral_flows::{GaussMagnus, LargeSkewHermitian};
use lie_poisson_systems::num_complex::Complex;
use lie_poisson_systems::{SpinLattice, VorticityCoefficients, Zeitlin};
use momentum_map::{
    Cotangent, CotangentBundle, Identity, PowerMap, ProductMap, QuadraticMomentumMap, Side, So3OnC2,
};
use nalgebra::{SVector, Vector3};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

pub fn system(kind: &str, parameters: &Arguments) -> ArraySystem {
    ArrayKind::named(kind).unwrap().system(parameters).unwrap()
}

/// A lattice with this shape and one exchange constant.
pub fn lattice(shape: &[f64], exchange: f64) -> ArraySystem {
    let given = Arguments::new().list("shape", shape.to_vec()).number("exchange", exchange);
    system("spin-lattice", &given)
}

/// Returns the state after so many steps, as users read it.
pub fn after(
    model: &ArraySystem,
    given: &[f64],
    (formulation, scheme): (Option<Formulation>, SchemeName),
    (step, steps): (f64, u64),
) -> Vec<f64> {
    let start = Model::start(model, given).unwrap();
    let method = model.method(formulation, scheme, 0.0).unwrap();
    let integrator = model.integrator(&method, &start).unwrap();
    let end = integrator.after(&AnyState::from_slice(&start), step, steps).unwrap();
    let mut end = end.momentum.as_slice().to_vec();
    model.present(&mut end);
    end
}

fn largest(one: &[f64], other: &[f64]) -> f64 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, lie_poisson::larger)
}

fn numbers() -> impl Strategy<Value = Vec<f64>> {
    proptest::collection::vec(-2.0..2.0, 18)
}

proptest! {
    /// A chain as a lattice with one axis has the rates of its formula, and those of a lattice whose bonds are rows.
    #[test]
    fn a_chain_has_the_rates_of_its_formula(s in numbers(), j in -2.0..2.0, k in -1.0..1.0, b in -1.0..1.0) {
        let parameters = Parameters::new().number("spins", 6.0).unwrap().number("exchange", j).unwrap();
        let parameters = parameters.number("anisotropy", k).unwrap().vector("field", &[0.3, 0.0, b]).unwrap();
        let formula = SystemKind::named("spin-chain").unwrap().system(&parameters).unwrap();
        let given = Arguments::new().list("shape", vec![6.0]).number("anisotropy", k);
        let given = given.list("field", vec![0.3, 0.0, b]);
        let chain = system("spin-lattice", &given.clone().number("exchange", j));
        let by_rows = system("spin-lattice", &given.list("bonds", vec![-1.0, 0.0, 0.0, j]));
        let expected = formula.rate(&s).unwrap();
        for chain in [chain, by_rows] {
            // Sums of some ten products of numbers below 8.
            prop_assert!(largest(&chain.rate(&s).unwrap(), &expected) < 1e-13);
            prop_assert!(largest(&chain.differential(&s), &SystemScales::differential(&formula, &s)) < 1e-13);
            let fastest = (SystemScales::fastest_rate(&chain, &s), formula.fastest_rate(&s));
            prop_assert!((fastest.0 - fastest.1).abs() < 1e-2 * fastest.1);
        }
    }

    /// A chain with open ends is that of the formula, also with bonds beyond neighbours and along one of two axes.
    #[test]
    fn an_open_chain_has_the_rates_of_its_formula(s in numbers(), j in 0.5..2.0, k in -1.0..1.0) {
        let parameters = Parameters::new().number("spins", 6.0).unwrap().number("exchange", j).unwrap();
        let parameters = parameters.number("anisotropy", k).unwrap().number("periodic", 0.0).unwrap();
        let formula = SystemKind::named("spin-chain").unwrap().system(&parameters).unwrap();
        let expected = (formula.rate(&s).unwrap(), SystemScales::differential(&formula, &s));
        let given = Arguments::new().number("anisotropy", k).number("exchange", j);
        let open = given.clone().list("shape", vec![6.0]).number("periodic", 0.0);
        let back = Arguments::new().number("anisotropy", k).list("bonds", vec![-1.0, 0.0, 0.0, j]);
        // The other axis has one spin, and is no ring with itself.
        let flat = given.list("shape", vec![6.0, 1.0]).list("periodic", vec![0.0, 0.0]);
        for given in [open, back.list("shape", vec![6.0]).number("periodic", 0.0), flat] {
            let chain = system("spin-lattice", &given);
            prop_assert!(largest(&chain.rate(&s).unwrap(), &expected.0) < 1e-13);
            prop_assert!(largest(&chain.differential(&s), &expected.1) < 1e-13);
            let h = chain.conserved(&s).values(0.0, &s).unwrap()[0];
            prop_assert!((h - formula.hamiltonian().value_at(&s)).abs() < 1e-12);
        }
        // Control: a ring has another rate.
        prop_assert!(largest(&lattice(&[6.0], j).rate(&s).unwrap(), &expected.0) > 1e-9);
    }

    /// On a lattice of 3 by 4 with an open axis, the bonds are those between cells that are inside.
    #[test]
    fn bonds_beyond_an_open_end_are_no_bonds(s in proptest::collection::vec(-2.0..2.0, 36), open in 0..2_usize) {
        let periodic: Vec<f64> = (0..2).map(|axis| if axis == open { 0.0 } else { 1.0 }).collect();
        let given = Arguments::new().list("shape", vec![3.0, 4.0]).list("periodic", periodic.clone());
        let bonds = [[1.0, -2.0, 0.0, 0.7], [0.0, 3.0, 0.0, -0.4], [2.0, 1.0, 0.0, 0.9]];
        let model = system("spin-lattice", &given.list("exchange", vec![1.0, 0.5]).list("bonds", bonds.concat()));
        let at = |cell: [i64; 2]| {
            let inside = [3, 4].iter().zip(cell).zip(&periodic).all(|((n, c), p)| *p == 1.0 || (0..*n).contains(&c));
            let i = (cell[0].rem_euclid(3) * 4 + cell[1].rem_euclid(4)) as usize;
            inside.then(|| Vector3::from_row_slice(&s[3 * i..3 * i + 3]))
        };
        let all = [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.5]].into_iter().chain(bonds);
        let bond = |[d, e, _, j]: [f64; 4]| {
            let cells = (0..3).flat_map(|x| (0..4).map(move |y| [x, y]));
            let ends = cells.filter_map(|[x, y]| Some((at([x, y])?, at([x + d as i64, y + e as i64])?)));
            -j * ends.map(|(a, b)| a.dot(&b)).sum::<f64>()
        };
        let h = model.conserved(&s).values(0.0, &s).unwrap()[0];
        prop_assert!((h - all.map(bond).sum::<f64>()).abs() < 1e-11);
        // The total spin and the Casimir stay, in a step of each formulation and of the spherical midpoint.
        for method in [(Some(Formulation::Collective), SchemeName::Gauss(4)), (Some(Formulation::Reduced), SchemeName::SphericalMidpoint)] {
            let end = after(&model, &s, method, (0.01, 5));
            let [before, later] = [&s, &end].map(|state| model.conserved(state).values(0.0, state).unwrap());
            prop_assert!(largest(&before[1..], &later[1..]) < 1e-10, "{before:?} {later:?}");
            prop_assert!(largest(&s, &end) > 1e-4);
        }
    }

    /// Vortices have the rates of their formula, on the sphere and off it.
    #[test]
    fn vortices_have_the_rates_of_their_formula(seed in 0..1000_u32, k in proptest::collection::vec(0.5..2.0, 6)) {
        let parameters = Parameters::new().vector("strengths", &k).unwrap();
        let formula = SystemKind::named("vortices").unwrap().system(&parameters).unwrap();
        let vortices = system("vortices", &Arguments::new().list("strengths", k));
        let m = vortices.start_of(&Arguments::new().number("seed", seed.into())).unwrap();
        let (rate, expected) = (vortices.rate(&m).unwrap(), formula.rate(&m).unwrap());
        let size = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        prop_assert!(largest(&rate, &expected) < 1e-12 * size);
        let conserved = vortices.conserved(&m);
        prop_assert!((conserved.values(0.0, &m).unwrap()[0] - formula.invariants(&m).unwrap()[0]).abs() < 1e-12);
    }

    /// The differential is that of dual numbers, and the rate ds/dt = dh/ds × s, dq/dt = dh/dp, dp/dt = −dh/dq of it.
    #[test]
    fn a_vibrating_lattice_has_the_equations_of_the_gallery(z in proptest::collection::vec(-2.0..2.0, 20)) {
        let lattice = SpinLattice::<4>::new(1.5, 2.0, 1.0, 0.5).unwrap();
        let point = point(&z);
        let dh = Automatic(lattice).differential(&point);
        let own = vibrating();
        let differential = own.differential(&z);
        for i in 0..4 {
            let (of_spin, at) = (dh.0.0.0.0[i], 3 * i..3 * i + 3);
            prop_assert!(largest(&differential[at.clone()], of_spin.as_slice()) < 1e-13);
            let turned = of_spin.cross(&Vector3::from_row_slice(&z[at.clone()]));
            prop_assert!(largest(&own.rate(&z).unwrap()[at], turned.as_slice()) < 1e-13);
        }
        prop_assert!(largest(&differential[12..16], dh.0.1.q.as_slice()) < 1e-13);
        prop_assert!(largest(&differential[16..], dh.0.1.p.0.as_slice()) < 1e-13);
        let energy = own.conserved(&z).values(0.0, &z).unwrap()[0];
        prop_assert!((energy - lattice.energy(&point)).abs() < 1e-12);
    }

    /// What is read of a fluid is what was given, and its rate is the derivative of its motion.
    #[test]
    fn coefficients_of_a_fluid_are_read_as_they_are_given(omega in proptest::collection::vec(-1.0..1.0, 36)) {
        let fluid = system("sphere-fluid", &Arguments::new().number("size", 6.0).number("rotation", 0.3));
        let mut state = Model::start(&fluid, &omega).unwrap();
        let matrix = state.clone();
        fluid.present(&mut state);
        prop_assert!(largest(&state, &omega) < 1e-13 && largest(&matrix, &omega) > 1e-3);
        let h = 1e-3;
        let [forth, back] = [h, -h].map(|step| {
            after(&fluid, &omega, (None, SchemeName::Gauss(3)), (step, 1))
        });
        let difference: Vec<f64> = forth.iter().zip(&back).map(|(a, b)| (a - b) / (2.0 * h)).collect();
        prop_assert!(largest(&difference, &fluid.rate(&omega).unwrap()) < 1e-4);
    }
}

fn vibrating() -> ArraySystem {
    let given = Arguments::new().number("atoms", 4.0).number("mass", 1.5).number("stiffness", 2.0);
    system("vibrating-lattice", &given.number("exchange", 1.0).number("coupling", 0.5))
}

type Atoms = lie_poisson::Point<lie_poisson_systems::SpinLatticeSpace<4>, f64>;

fn point(z: &[f64]) -> Atoms {
    let spins = core::array::from_fn(|i| Vector3::from_row_slice(&z[3 * i..3 * i + 3]));
    let [q, p] = [12, 16].map(|from| SVector::<f64, 4>::from_row_slice(&z[from..from + 4]));
    Pair(Covector(Power(spins)), Cotangent::new(q, Covector(p)))
}

/// The lift of any number of spins makes the steps of the integrator for four.
#[test]
fn a_vibrating_lattice_steps_as_that_of_the_gallery() {
    let own = vibrating();
    let given = Arguments::new().list("waves", vec![1.0]).number("cone", 0.7).number("tilt", 0.4);
    let start = own.start_of(&given.list("p", vec![0.1, -0.2, 0.3, 0.0])).unwrap();
    let map = ProductMap(
        PowerMap::<_, 4>(QuadraticMomentumMap::new(So3OnC2, Side::Left)),
        Identity(CotangentBundle(RealSpace::<4>)),
    );
    let lattice = Automatic(SpinLattice::<4>::new(1.5, 2.0, 1.0, 0.5).unwrap());
    let gauss = Collective::new(RungeKutta::gauss(3).unwrap(), map, lattice);
    let expected = gauss.after(&point(&start), 0.1, 100).unwrap().momentum;
    let end = after(&own, &start, (None, SchemeName::Gauss(3)), (0.1, 100));
    for i in 0..4 {
        // A thousand sums of ten terms.
        assert!(largest(&end[3 * i..3 * i + 3], expected.0.0.0[i].as_slice()) < 1e-12);
    }
    assert!(largest(&end[12..16], expected.1.q.as_slice()) < 1e-12);
    assert!(largest(&end[16..], expected.1.p.0.as_slice()) < 1e-12);
    let [before, later] =
        [&start, &end].map(|state| own.conserved(state).values(0.0, state).unwrap());
    // All but h are conserved to round-off; h by a method of order 6 to its error.
    assert!(
        largest(&before[1..], &later[1..]) < 1e-12 && largest(&before[..1], &later[..1]) < 1e-6
    );
    // Control: an explicit method conserves the lengths of the spins to its order alone.
    let rk4 = (Some(Formulation::Direct), SchemeName::Rk4);
    let drifting = after(&own, &start, rk4, (0.1, 100));
    assert!((own.conserved(&drifting).values(0.0, &drifting).unwrap()[5] - before[5]).abs() > 1e-8);
}

/// Magnons on lattices of one to three dimensions: spins on a cone of the angle θ about z turn at
/// ω = 2 J cos θ Σ (1 − cos k_i), to six digits.
#[test]
fn spin_waves_have_the_frequencies_of_the_literature() {
    for (shape, waves) in [(vec![12.0], vec![1.0]), (vec![4.0, 3.0, 4.0], vec![1.0, -1.0, 1.0])] {
        let (exchange, cone, end): (f64, f64, f64) = (0.7, 0.4, 2.0);
        let model = lattice(&shape, exchange);
        let given = Arguments::new().list("waves", waves.clone()).number("cone", cone);
        let start = model.start_of(&given).unwrap();
        let phases = shape.iter().zip(&waves).map(|(n, wave)| 1.0 - (TAU * wave / n).cos());
        let expected = 2.0 * exchange * cone.cos() * phases.sum::<f64>();
        for method in [
            (None, SchemeName::Gauss(4)),
            (Some(Formulation::Reduced), "kahan-li-6".parse().unwrap()),
        ] {
            let state = after(&model, &start, method, (0.05, 40));
            let phase = |state: &[f64]| state[1].atan2(state[0]);
            let turned = (phase(&start) - phase(&state)).rem_euclid(TAU);
            assert!(
                (turned - (expected * end).rem_euclid(TAU)).abs() < 1e-6 * expected,
                "{shape:?}"
            );
        }
    }
}

/// The kernel in lanes, the method without lanes and the collective midpoint rule of the Hamiltonian that is constant on
/// rays have order 2; the first two make the same steps.
#[test]
fn the_spherical_midpoint_method_has_one_map_and_order_two() {
    let given = Arguments::new().list("shape", vec![6.0, 5.0, 4.0]).number("exchange", 1.0);
    let model =
        system("spin-lattice", &given.number("anisotropy", 0.3).list("field", vec![0.0, 0.2, 0.1]));
    let start = model.start_of(&Arguments::new().number("tilt", PI).number("seed", 5.0)).unwrap();
    let spherical = (Some(Formulation::Reduced), SchemeName::SphericalMidpoint);
    let reference = after(&model, &start, (None, SchemeName::Gauss(4)), (0.02, 50));
    let errors = [10, 20, 40].map(|steps| {
        let end = after(&model, &start, spherical, (1.0 / steps as f64, steps));
        (1.0 / steps as f64, largest(&end, &reference))
    });
    let order = fitted_order(&errors, 1e-12).unwrap();
    assert!((order - 2.0).abs() < 0.1, "{order}");
    let method = model.method(spherical.0, spherical.1, 0.0).unwrap();
    let state = AnyState::from_slice(&start);
    let slow = model.tangent_integrator(&method, &start).unwrap().without_tangents();
    let slow: AnyIntegrator = slow;
    let slow = slow.after(&state, 0.1, 10).unwrap().momentum;
    let fast = after(&model, &start, spherical, (0.1, 10));
    assert!(largest(slow.as_slice(), &fast) < 1e-13);
    // All lengths are 1, and stay so.
    assert!(fast.as_chunks::<3>().0.iter().all(|s| (Vector3::from(*s).norm() - 1.0).abs() < 1e-13));
}

/// A Rossby–Haurwitz wave, an exact solution for every N: ω_lm turns by mσt, σ = (c + 2Ω)/(l(l + 1)) − c/2.
#[test]
fn a_rossby_haurwitz_wave_turns_as_it_should() {
    let (c, rotation, l, m) = (1.0, 0.5, 4, 3);
    let fluid =
        system("sphere-fluid", &Arguments::new().number("size", 16.0).number("rotation", rotation));
    let zonal = (c + 2.0 * rotation) * (4.0 * PI / 3.0).sqrt();
    let rows = vec![1.0, 0.0, zonal, 0.0, l as f64, m as f64, 0.3, 0.0];
    let start = fluid.start_of(&Arguments::new().list("coefficients", rows)).unwrap();
    let end = after(&fluid, &start, (None, SchemeName::Gauss(4)), (0.05, 40));
    let sigma = (c + 2.0 * rotation) / (l * (l + 1)) as f64 - c / 2.0;
    let exact = Complex::from_polar(0.3, m as f64 * sigma * 2.0);
    let found = Complex::new(end[16 * l + m], end[16 * (m - 1) + l]);
    assert!((found - exact).norm() < 1e-9, "{found} {exact}");
    let values = |state: &[f64]| {
        let state = Model::start(&fluid, state).unwrap();
        fluid.conserved(&state).values(0.0, &state).unwrap()
    };
    assert!(largest(&values(&start), &values(&end)) < 1e-11);
}

/// A random flow by the Poisson maps of the door and by the Gauss–Magnus method of the library.
#[test]
fn a_flow_is_that_of_another_method() {
    let fluid = system("sphere-fluid", &Arguments::new().number("size", 12.0));
    let given =
        Arguments::new().list("degrees", vec![2.0, 5.0]).number("rms", 0.5).number("seed", 3.0);
    let start = fluid.start_of(&given).unwrap();
    let end = after(&fluid, &start, (None, SchemeName::Gauss(4)), (0.05, 40));
    let zeitlin = Zeitlin::new(12).unwrap();
    let omega = VorticityCoefficients::from_fn(12, |l, m| {
        Complex::new(start[12 * l + m], if m > 0 { start[12 * (m - 1) + l] } else { 0.0 })
    });
    let w = zeitlin.vorticity(&omega);
    assert!(((zeitlin.enstrophy(&w) / (4.0 * PI)).sqrt() - 0.5).abs() < 1e-13);
    let magnus = GaussMagnus::new(3, zeitlin.clone()).unwrap();
    let other = zeitlin.coefficients(&magnus.after(&w, 0.05, 40).unwrap().state);
    let mut most = 0.0_f64;
    for (l, m) in (0..12).flat_map(|l| (0..=l).map(move |m| (l, m))) {
        most = most.max((other.at(l, m).re - end[12 * l + m]).abs());
    }
    assert!(most < 1e-7, "{most}");
    // Control: the flow has moved.
    assert!(largest(&start, &end) > 1e-2);
}

/// The vorticity matrix of `generic` after four steps of 1/20 of the isospectral midpoint rule, row by row from the diagonal on, from quflow at
/// commit b42eede (`isomp_fixedpoint` with `tol=1e-16, maxit=200`).
const QUFLOW_END: [(f64, f64); 15] = [
    (0.0, -0.6448881338490655),
    (0.7393152156599897, 0.9729312261922215),
    (0.9712660826814719, -0.8604027586578806),
    (1.0048509288308303, 0.6459175016539476),
    (0.9427372540742804, -0.17415835039973382),
    (0.0, 0.9389127858857825),
    (-0.22169492974654947, -0.9797442410735534),
    (-0.5289480372006302, 0.9668058105694594),
    (-0.8824139903537553, -0.642074879554785),
    (0.0, -0.6616883670750696),
    (-0.38910244645063435, 0.976623478579892),
    (-0.006654093153389329, -0.8957698332340446),
    (0.0, 0.850562830579308),
    (0.8509802571719943, -0.9402486360404678),
    (0.0, -0.482899115540955),
];

/// Returns a matrix without trace whose entries look random.
fn generic(size: usize) -> LargeSkewHermitian {
    let entry = |j: usize, k: usize| {
        let x = (j * size + k) as f64 + 1.0;
        Complex::new((12.9898 * x).sin(), (12.9898 * 2.7 * x + 0.3).sin())
    };
    let mean = (0..size).map(|j| entry(j, j).im).sum::<f64>() / size as f64;
    LargeSkewHermitian::from_upper(size, |j, k| {
        entry(j, k) - if j == k { Complex::new(0.0, mean) } else { Complex::ZERO }
    })
}

/// A fluid of a configuration makes the steps of quflow.
#[test]
fn a_fluid_makes_the_steps_of_quflow() {
    let model = system("sphere-fluid", &Arguments::new().number("size", 5.0));
    // What users read of a matrix, and the matrix of what they read.
    let given = |w: &LargeSkewHermitian| {
        let mut state: Vec<f64> = (0..25).map(|i| w.coordinate(i)).collect();
        model.present(&mut state);
        state
    };
    let matrix = |state: &[f64]| {
        let (state, mut w) = (Model::start(&model, state).unwrap(), LargeSkewHermitian::zeros(5));
        w.set_coordinates(|i| state[i]);
        w
    };
    let start = given(&generic(5));
    assert!(largest(&given(&matrix(&start)), &start) < 1e-14);
    let end = |scheme| {
        let end = matrix(&after(&model, &start, (Some(Formulation::Reduced), scheme), (0.05, 4)));
        let places = (0..5).flat_map(|j| (j..5).map(move |k| (j, k)));
        let errors = places
            .zip(QUFLOW_END)
            .map(|((j, k), (re, im))| (end.at(j, k) - Complex::new(re, im)).norm());
        errors.fold(0.0, f64::max)
    };
    // The change to harmonics and back has some more rounding than the steps alone.
    assert!(end(SchemeName::ImplicitMidpoint) < 2e-14, "{:e}", end(SchemeName::ImplicitMidpoint));
    assert!(end(SchemeName::Gauss(4)) > 1e-6);
}
