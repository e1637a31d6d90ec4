//! Driven motions in lanes and ensembles, in compositions, with tangent vectors, events and dense output; and splittings of
//! fields that depend on time.

use collective_integrators::diagnostics::fitted_order;
use collective_integrators::{
    Composition, DenseOutput, Direction, Driven, Ensemble, Events, ExactFlows, Integrator, Laned,
    RungeKutta, Splitting, Start, StepError, Substeps, VariationalFlow,
};
use lie_poisson::{
    Automatic, Covector, DefaultLanes, Energy, InTime, InputTable, Inputs, Interpolation, Lanes,
    LiePoisson, Pair, Point, Real, So3, State, Time, TimeAxis, TimeDependent, Vector,
};
use momentum_map::{HOPF, HopfRealisation, Identity, ProductMap, SourcePoint};
use nalgebra::{Rotation3, Vector3};
use std::sync::Mutex;

type Spin = Covector<Vector3<f64>>;

/// A spin in the static field e₃ and a field that rotates at the rate ω: h = −Π₃ − b (Π₁ cos ωt + Π₂ sin ωt) + c Π₁²/2.
#[derive(Clone, Copy)]
struct Rotating {
    strength: f64,
    rate: f64,
    anisotropy: f64,
}

impl Energy for Rotating {
    type Space = InTime<LiePoisson<So3>>;

    #[inline(always)]
    fn energy<T: Real>(&self, Pair(Covector(pi), Time(t)): &Point<Self::Space, T>) -> T {
        let angle = *t * self.rate;
        pi.x * pi.x * (0.5 * self.anisotropy)
            - pi.z
            - (pi.x * angle.cos() + pi.y * angle.sin()) * self.strength
    }
}

impl Rotating {
    /// Returns Π at time t from Π(s), without the anisotropy: in the frame that turns with the field, dΠ/dt = B × Π with B =
    /// (b, 0, 1 − ω).
    fn exact(&self, pi: &Vector3<f64>, (s, t): (f64, f64)) -> Vector3<f64> {
        let frame = |t: f64| Rotation3::new(Vector3::z() * (self.rate * t));
        let turn = Rotation3::new(Vector3::new(self.strength, 0.0, 1.0 - self.rate) * (t - s));
        frame(t) * (turn * (frame(-s) * pi))
    }
}

const FIELD: Rotating = Rotating { strength: 0.7, rate: 2.0, anisotropy: 0.0 };
const ANISOTROPIC: Rotating = Rotating { anisotropy: 0.8, ..FIELD };

/// The time at which runs begin.
const BEGIN: f64 = 0.6;

fn spin() -> Spin {
    Covector(Vector3::new(0.48, -0.6, 0.64))
}

type InField = Driven<RungeKutta, HopfRealisation, TimeDependent<Automatic<Rotating>>>;

fn driven(stages: usize, field: Rotating) -> InField {
    Driven::new(RungeKutta::gauss(stages).unwrap(), HOPF, TimeDependent(Automatic(field)))
}

/// Lanes begin at different times, so that each has a field of its own.
#[test]
fn members_in_lanes_and_on_threads_have_the_bits_of_single_runs() {
    let single = driven(2, ANISOTROPIC);
    let first = |member: u64| {
        let time = Time(BEGIN + 0.37 * member as f64);
        single.start(&Pair(spin(), time)).unwrap()
    };
    let ends = Mutex::new(vec![None; 19]);
    Ensemble::new(Laned::new(driven(2, ANISOTROPIC))).stream(19, first, 0.2, 20, |chunk| {
        assert!(chunk.failures.is_empty());
        for (member, end) in (chunk.first as usize..).zip(chunk.members) {
            ends.lock().unwrap()[member] = Some(*end);
        }
    });
    let ends: Vec<_> = ends.into_inner().unwrap().into_iter().map(Option::unwrap).collect();
    for (member, end) in (0..).zip(&ends) {
        let mut state = first(member);
        single.advance(&mut state, 0.2, 0..20, &mut single.workspace()).unwrap();
        assert_eq!(*end, state, "{member}");
    }
    // Control: the times of the members matter.
    let momenta: Vec<_> = ends.iter().map(|end| single.momentum(end).0.0).collect();
    assert!(momenta.windows(2).all(|two| (two[0] - two[1]).norm() > 0.01), "{momenta:?}");
}

/// Driven motions along tables of inputs.
type Pulsed = Driven<RungeKutta, HopfRealisation, Inputs<Vector3<f64>>>;

/// A spin in the field e₃, with pulses along e₁ that begin and end within steps.
fn pulsed(stages: usize) -> Pulsed {
    let table = |times, values| InputTable::new(times, values, Interpolation::Constant).unwrap();
    let steady = table(vec![0.0, 20.0], vec![1.0, 1.0]);
    let pulses = table(vec![0.0, 0.31, 1.13, 1.77, 20.0], vec![0.0, 2.0, -1.0, 0.5, 0.5]);
    let inputs = vec![(Vector3::z(), steady), (Vector3::x(), pulses)];
    Driven::new(RungeKutta::gauss(stages).unwrap(), HOPF, Inputs::new(inputs).unwrap())
}

/// Members whose breakpoints come at different times are advanced one by one, since no division of a step is that of each.
#[test]
fn members_with_breakpoints_have_the_bits_of_single_runs() {
    let single = pulsed(1);
    let spins = [spin().0, Vector3::x(), -Vector3::z(), Vector3::new(0.6, 0.8, 0.0)];
    let starts = |times: [f64; 6]| {
        let starts = spins.iter().cycle().zip(times);
        let starts = starts.map(|(pi, t)| single.start(&Pair(Covector(*pi), Time(t))).unwrap());
        starts.collect::<Vec<_>>()
    };
    let apart = [0.0, 0.05, 0.1, 0.15, 0.23, 0.29];
    for times in [[0.0; 6], apart] {
        let mut members = starts(times);
        let laned = Ensemble::new(Laned::new(pulsed(1)));
        assert!(laned.advance(&mut members, 0.2, 0..10).is_empty());
        let alone = starts(times).into_iter().map(|mut state| {
            single.advance(&mut state, 0.2, 0..10, &mut single.workspace()).unwrap();
            state
        });
        assert_eq!(members, alone.collect::<Vec<_>>(), "{times:?}");
    }
    // Control: the lanes of a register refuse the step across the first breakpoint, and not the one before.
    let members = starts(apart);
    let lanes = <SourcePoint<ProductMap<HopfRealisation, Identity<TimeAxis>>, DefaultLanes>>::from_coordinates(|i| {
        DefaultLanes::from_lanes(|lane| members[lane].coordinate(i))
    });
    let step = |size| {
        let mut workspace = Integrator::<DefaultLanes>::workspace(&single);
        Integrator::<DefaultLanes>::step(&single, &lanes, size, &mut workspace).map(drop)
    };
    assert_eq!(step(0.1), Ok(()));
    let refused = step(0.2);
    assert!(
        matches!(refused, Err(StepError::BreakpointsApart { first, last }) if first < last),
        "{refused:?}"
    );
}

/// Returns the errors of runs from `BEGIN` for a time of 4.
fn errors<I>(integrator: &I, counts: [u64; 3]) -> Vec<(f64, f64)>
where
    I: Start<Momentum = Pair<Spin, Time>>,
{
    let exact = FIELD.exact(&spin().0, (BEGIN, BEGIN + 4.0));
    let error = |count: u64| {
        let step = 4.0 / count as f64;
        let end = integrator.after(&Pair(spin(), Time(BEGIN)), step, count).unwrap().momentum;
        (step, (end.0.0 - exact).norm())
    };
    counts.map(error).into()
}

#[test]
fn compositions_of_driven_steps_are_those_of_composed_schemes() {
    for (substeps, order, counts) in
        [(Substeps::suzuki4(), 4.0, [24, 40, 60]), (Substeps::yoshida6(), 6.0, [60, 90, 120])]
    {
        let of_steps = Composition::new(driven(1, FIELD), substeps.clone());
        let found = errors(&of_steps, counts);
        let fitted = fitted_order(&found, 1e-14).unwrap();
        assert!((fitted - order).abs() < 0.05 * order, "{fitted} {found:?}");
        let scheme = Composition::new(RungeKutta::implicit_midpoint(), substeps);
        let of_scheme = Driven::new(scheme, HOPF, TimeDependent(Automatic(FIELD)));
        for ((_, one), (_, other)) in found.iter().zip(&errors(&of_scheme, counts)) {
            // Sums of a few thousand roundings, of which 6e-14 is left; the time is summed in another order.
            assert!((one - other).abs() < 1e-12, "{one:e} {other:e}");
        }
    }
    // Control: the midpoint rule itself has the order 2.
    let found = errors(&driven(1, FIELD), [40, 80, 160]);
    assert!((fitted_order(&found, 1e-14).unwrap() - 2.0).abs() < 0.1, "{found:?}");
}

/// The motion in the field as three exact flows of (Π, t): the turn about e₃, that about the rotating field with the time held, and
/// the time. Without the last one the field stands still.
struct Turns {
    time_passes: bool,
}

impl ExactFlows for Turns {
    type Point = Pair<Spin, Time>;
    const COUNT: usize = 3;

    fn flow(&self, index: usize, h: f64, z: &Self::Point) -> Self::Point {
        let Pair(Covector(pi), Time(t)) = *z;
        let about = |axis: Vector3<f64>| Covector(Rotation3::new(axis * h) * pi);
        let (sine, cosine) = (FIELD.rate * t).sin_cos();
        match index {
            0 => Pair(about(Vector3::z()), Time(t)),
            1 => Pair(about(Vector3::new(cosine, sine, 0.0) * FIELD.strength), Time(t)),
            2 if self.time_passes => Pair(Covector(pi), Time(t + h)),
            _ => *z,
        }
    }
}

#[test]
fn splittings_with_the_time_as_a_flow_have_their_orders() {
    let strang = |time_passes| Splitting::strang(Turns { time_passes });
    let found = errors(&strang(true), [80, 160, 320]);
    let order = fitted_order(&found, 1e-14).unwrap();
    assert!((order - 2.0).abs() < 0.1, "{order} {found:?}");
    let found = errors(&Composition::new(strang(true), Substeps::suzuki4()), [40, 80, 160]);
    let order = fitted_order(&found, 1e-14).unwrap();
    assert!((order - 4.0).abs() < 0.2, "{order} {found:?}");
    // Control: with the time held the error does not fall.
    let found = errors(&strang(false), [80, 160, 320]);
    assert!(found.iter().all(|(_, error)| *error > 0.1), "{found:?}");
}

/// Tangent vectors of (z, t), which have a component along the time, are the limits of differences of runs from nearby states.
#[test]
fn tangent_vectors_are_those_of_difference_quotients() {
    const STEPS: u64 = 40;
    let gauss = driven(3, ANISOTROPIC);
    let start = gauss.start(&Pair(spin(), Time(BEGIN))).unwrap();
    let basis = [0, 3, 4].map(Vector::basis);
    let mut flow = VariationalFlow::new(&gauss, start, basis, 0.2);
    for _ in 0..STEPS {
        flow.advance().unwrap();
    }
    let after = |z| {
        let (mut state, mut workspace) = (z, gauss.workspace());
        gauss.pin(&mut workspace);
        gauss.advance(&mut state, 0.2, 0..STEPS, &mut workspace).unwrap();
        state
    };
    assert_eq!(after(start), *flow.state());
    let nearby = 1e-5;
    for (v, tangent) in basis.iter().zip(flow.tangents()) {
        let difference = after(start + v.scaled(nearby)) - after(start - v.scaled(nearby));
        let quotient = difference.scaled(0.5 / nearby);
        // The quotient has an error of 1e-10 times the third derivative, and of rounding, 1e-15/1e-5.
        let error = (quotient - *tangent).max_abs();
        assert!(error < 1e-7, "{error:e}");
        // Control: another tangent vector
        assert!((quotient - *v).max_abs() > 0.1);
    }
    // A later start of a field that depends on time is another motion, whose time stays later.
    let [_, _, later] = flow.tangents();
    assert_eq!(later.1.0, 1.0);
    assert!(later.0.max_abs() > 0.1);
}

/// Returns the time of a zero between two times at which a function has different signs.
fn zero(g: impl Fn(f64) -> f64, (mut below, mut above): (f64, f64)) -> f64 {
    let sign = g(above) > 0.0;
    for _ in 0..60 {
        let middle = 0.5 * (below + above);
        if (g(middle) > 0.0) == sign { above = middle } else { below = middle }
    }
    above
}

#[test]
fn events_see_the_momentum_and_the_time() {
    let gauss = driven(6, FIELD);
    let run = || gauss.trajectory(&Pair(spin(), Time(BEGIN)), 0.2).unwrap().take(41);
    let along = |t: f64| FIELD.exact(&spin().0, (BEGIN, t)).x;
    let g = |mu: &Pair<Spin, Time>| mu.0.0.x;
    let events: Vec<_> =
        Events::new(&gauss, run(), g, Direction::Both).map(|event| event.unwrap()).collect();
    let grid: Vec<_> = (0..=800).map(|n| BEGIN + 0.01 * f64::from(n)).collect();
    let crossed = grid.windows(2).filter(|ends| along(ends[0]) * along(ends[1]) < 0.0);
    let expected: Vec<_> = crossed.map(|ends| zero(along, (ends[0], ends[1]))).collect();
    assert!(expected.len() == 2 && events.len() == expected.len(), "{events:?} {expected:?}");
    for (event, time) in events.iter().zip(expected) {
        // Gauss's method of order 12 has an error of 1e-13 at these steps.
        assert!((event.momentum.1.0 - time).abs() < 1e-11, "{event:?} {time}");
        assert!((event.momentum.1.0 - BEGIN - event.time).abs() < 1e-14);
    }
    // The time of the state, and not that of the run, is what a function of the time sees.
    let mut alarms = Events::new(&gauss, run(), |mu| mu.1.0 - 3.0, Direction::Up);
    let alarm = alarms.next().unwrap().unwrap();
    assert!((alarm.momentum.1.0 - 3.0).abs() < 1e-14 && (alarm.time - 3.0 + BEGIN).abs() < 1e-14);
    assert!(alarms.next().is_none());
    assert!((alarm.momentum.0.0 - FIELD.exact(&spin().0, (BEGIN, 3.0))).norm() < 1e-11);
    // Control: a run that begins at another time has other events.
    let anew = gauss.trajectory(&Pair(spin(), Time(0.0)), 0.2).unwrap().take(41);
    let first = Events::new(&gauss, anew, g, Direction::Both).next().unwrap().unwrap();
    assert!((first.time - events[0].time).abs() > 0.01);
}

#[test]
fn dense_output_sees_the_time_and_the_breakpoints() {
    let gauss = driven(6, FIELD);
    let start = Pair(spin(), Time(BEGIN));
    let mut dense = DenseOutput::new(&gauss, gauss.trajectory(&start, 0.2).unwrap());
    for t in [0.0, 0.07, 0.5, 0.53, 3.99] {
        let found = dense.at(t).unwrap().momentum;
        let exact = FIELD.exact(&spin().0, (BEGIN, BEGIN + t));
        assert!((found.0.0 - exact).norm() < 1e-11 && (found.1.0 - BEGIN - t).abs() < 1e-14);
        // Control: the time of the run is not that of the field.
        assert!(t == 0.0 || (found.0.0 - FIELD.exact(&spin().0, (0.0, t))).norm() > 0.01);
    }
    // Inputs are held between breakpoints, some of which lie in the steps before the times that are sought.
    let pulsed = pulsed(6);
    let start = Pair(spin(), Time(0.0));
    let mut dense = DenseOutput::new(&pulsed, pulsed.trajectory(&start, 0.2).unwrap());
    let pieces = [(0.0_f64, 0.0), (0.31, 2.0), (1.13, -1.0), (1.77, 0.5)];
    for t in [0.29_f64, 0.33, 1.1, 1.19, 1.75, 1.78, 2.5] {
        let ends = pieces[1..].iter().map(|piece| piece.0).chain([20.0]);
        let exact = pieces.iter().zip(ends).fold(spin().0, |pi, (&(begin, input), end)| {
            let length = (end.min(t) - begin).max(0.0);
            Rotation3::new(-Vector3::new(input, 0.0, 1.0) * length) * pi
        });
        let found = dense.at(t).unwrap().momentum.0.0;
        assert!((found - exact).norm() < 1e-12, "{t} {}", (found - exact).norm());
    }
}
