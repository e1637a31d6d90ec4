//! Spins in a field that depends on the time: the motion of one spin, orders, jumps, lengths, and the balance of energy.

use collective_integrators::{
    BrownianPaths, Driven, Integrator, RungeKutta, Start, StepError, fitted_order,
};
use lie_poisson::*;
use lie_poisson_systems::{FieldInTime, HeisenbergLattice, LangevinSpins, SpinDamping};
use momentum_map::{QuadraticMomentumMap, Side, So3OnC2};
use nalgebra::Vector3;

const STILL: SpinDamping = SpinDamping::LandauLifshitz(0.0);

/// A field that turns about an axis between e₁ and e₃, with a part along e₃.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Turning {
    rate: f64,
    size: f64,
}

impl FieldInTime for Turning {
    fn at(&self, time: f64) -> Vector3<f64> {
        let (sine, cosine) = (self.rate * time).sin_cos();
        Vector3::new(cosine, sine, 0.5 + 0.3 * sine) * self.size
    }
}

/// As an element of the algebra of one spin in the plus bracket, ξ = −B(t).
impl OrbitField<LiePoisson<So3>> for Turning {
    fn element(&self, _: &Covector<Vector3<f64>>, time: f64) -> Vector3<f64> {
        -self.at(time)
    }
}

/// A field whose jumps nobody is told.
struct Unannounced<F>(F);

impl<F: FieldInTime> FieldInTime for Unannounced<F> {
    fn at(&self, time: f64) -> Vector3<f64> {
        self.0.at(time)
    }
}

/// As −B(t) for one spin, with its breakpoints.
struct OfSpin<F>(F);

impl<F: FieldInTime> OrbitField<LiePoisson<So3>> for OfSpin<F> {
    fn element(&self, _: &Covector<Vector3<f64>>, time: f64) -> Vector3<f64> {
        -self.0.at(time)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.0.next_break(time, forward)
    }
}

type State = Pair<Covector<Sites<Vector3<f64>>>, Pair<PathNumber, Time>>;

fn from(spins: &[Vector3<f64>], time: f64) -> State {
    let spins = Covector(spins.iter().copied().collect());
    Pair(spins, Pair(PathNumber(0.0), Time(time)))
}

/// Returns spins without bonds.
fn free(count: usize) -> HeisenbergLattice {
    HeisenbergLattice::new([count, 1, 1]).unwrap()
}

fn in_field<F: FieldInTime>(
    lattice: HeisenbergLattice,
    damping: SpinDamping,
    field: F,
    step: f64,
) -> LangevinSpins<HeisenbergLattice, F> {
    let paths = BrownianPaths::new(1, step).unwrap();
    LangevinSpins::new(lattice, damping, 0.0, paths).unwrap().with_field(field)
}

/// Returns a spin at the end of steps with a field, by Gauss's method of order 12 for one spin.
fn exact<X: OrbitField<LiePoisson<So3>>>(field: X, start: Vector3<f64>, end: f64) -> Vector3<f64> {
    let map = QuadraticMomentumMap::new(So3OnC2, Side::Left);
    let spin = Driven::new(RungeKutta::gauss(6).unwrap(), map, field);
    let start = Pair(Covector(start), Time(0.0));
    spin.after(&start, end / 200.0, 200).unwrap().momentum.0.0
}

const STARTS: [Vector3<f64>; 3] =
    [Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.0, 2.0, 0.0), Vector3::new(0.1, -0.2, 0.05)];

/// Returns the largest distance of spins without bonds from the exact ones, relative to their lengths, after so many steps.
fn error<F: FieldInTime>(
    (field, damping): (F, SpinDamping),
    exact: &[Vector3<f64>],
    (end, steps): (f64, u64),
) -> (f64, f64) {
    let step = end / steps as f64;
    let spins = in_field(free(3), damping, field, step);
    let ends = spins.after(&from(&STARTS, 0.0), step, steps).unwrap().momentum.0.0;
    let distances = ends.iter().zip(exact).map(|(a, b)| (a - b).norm() / b.norm());
    (step, distances.fold(0.0, f64::max))
}

/// The field turns once in 0.63, in six to twenty-five steps.
#[test]
fn each_spin_is_the_one_driven_spin_to_the_order_of_the_method() {
    let field = Turning { rate: 10.0, size: 1.5 };
    let ends = STARTS.map(|start| exact(field, start, 2.0));
    let fitted = |field: Turning, ends: &[Vector3<f64>]| {
        let errors = [20, 40, 80].map(|steps| error((field, STILL), ends, (2.0, steps)));
        (fitted_order(&errors, 1e-13), errors[2].1)
    };
    let (order, smallest) = fitted(field, &ends);
    let order = order.unwrap();
    assert!((order - 2.0).abs() < 0.1 && smallest < 3e-3, "{order} {smallest}");
    // Control: the field of another size is another motion.
    assert!(fitted(Turning { size: 1.4, ..field }, &ends).1 > 0.05);
}

#[test]
fn a_damped_spin_in_the_field_is_the_driven_spin_with_gilberts_damping() {
    let field = Turning { rate: 3.0, size: 1.5 };
    let space = LiePoisson::plus(So3);
    let gilbert = |alpha| GilbertDamping::new(space, field, alpha).unwrap();
    let bracket =
        |friction| DoubleBracket::new(space, field, friction, InnerProduct::euclidean()).unwrap();
    for (damping, ends) in [
        (SpinDamping::Gilbert(0.4), STARTS.map(|start| exact(gilbert(0.4), start, 2.0))),
        (SpinDamping::LandauLifshitz(0.3), STARTS.map(|start| exact(bracket(0.3), start, 2.0))),
    ] {
        let errors = [40, 80, 160].map(|steps| error((field, damping), &ends, (2.0, steps)));
        let order = fitted_order(&errors, 1e-13).unwrap();
        assert!((order - 2.0).abs() < 0.1 && errors[2].1 < 1e-3, "{damping:?} {errors:?}");
    }
}

/// A held table jumps within steps, at times that no step meets.
#[test]
fn steps_are_divided_where_the_field_jumps() {
    let jumps = || {
        let times = vec![-1.0, 0.313, 1.171, 9.0];
        let table = InputTable::new(times, vec![3.0, -2.0, 5.0, 0.0], Interpolation::Constant);
        let constant = InputTable::new(vec![-1.0, 9.0], vec![1.0; 2], Interpolation::Linear);
        let tables = vec![(Vector3::x(), table.unwrap()), (Vector3::z(), constant.unwrap())];
        Inputs::new(tables).unwrap()
    };
    let ends = STARTS.map(|start| exact(OfSpin(jumps()), start, 2.0));
    let errors = [20, 40, 80].map(|steps| error((jumps(), STILL), &ends, (2.0, steps)));
    let order = fitted_order(&errors, 1e-13).unwrap();
    assert!((order - 2.0).abs() < 0.15, "{order} {errors:?}");
    // Control: without the division the error is of the order 1.
    let [divided, undivided] = [
        error((jumps(), STILL), &ends, (2.0, 640)).1,
        error((Unannounced(jumps()), STILL), &ends, (2.0, 640)).1,
    ];
    assert!(undivided > 20.0 * divided, "{undivided} {divided}");
    // There and back, over the jumps.
    let spins = in_field(free(3), STILL, jumps(), 0.1);
    let there = spins.after(&from(&STARTS, 0.0), 0.1, 20).unwrap();
    assert!((there.momentum.1.1.0 - 2.0).abs() < 1e-15);
    let back = spins.after_from(there.state, -0.1, 20).unwrap().momentum.0.0;
    assert!(back.iter().zip(STARTS).all(|(a, b)| (a - b).norm() < 1e-13));
    // One step over both jumps has three parts, of which the noise has the increments of the whole.
    let parts = spins.step(&spins.start(&from(&STARTS, 0.0)).unwrap(), 2.0, &mut spins.workspace());
    assert_eq!(parts.unwrap().point.1.1.0, 20.0);
}

/// In a step with the field B(tₘ) the quadratic energy with this field is kept, so that
/// h(s′, t′) − h(s, t) = −(B(t′) − B(tₘ))·M(s′) − (B(tₘ) − B(t))·M(s), the balance dh/dt = −Ḃ·M of a step.
#[test]
fn the_energy_changes_by_the_work_of_the_field_and_lengths_are_kept() {
    let (step, field) = (0.1, Turning { rate: 8.0, size: 0.7 });
    let lattice = HeisenbergLattice::new([4, 3, 1]).unwrap();
    let lattice = lattice.with_exchange([1, 0, 0], 1.0).unwrap().with_exchange([0, 1, 0], -0.4);
    let lattice = lattice.unwrap().with_anisotropy(Vector3::new(0.0, 0.6, 0.8), 0.3).unwrap();
    let lattice = lattice.with_field(Vector3::new(0.2, 0.0, -0.1)).unwrap();
    let start = lattice.state(|[x, y, _]| {
        let (x, y) = (x as f64, y as f64);
        Vector3::new((1.3 * x + y).sin(), (2.1 * y).cos(), 0.4 * x) * (1.0 + y)
    });
    let spins = in_field(lattice.clone(), STILL, field, step);
    let integrator = spins.trajectory(&Pair(start.clone(), Pair(PathNumber(0.0), Time(0.0))), step);
    let total = |s: &Covector<Sites<Vector3<f64>>>| s.0.iter().sum::<Vector3<f64>>();
    let energy =
        |s: &Covector<Sites<Vector3<f64>>>, time| lattice.value(s) - field.at(time).dot(&total(s));
    let (mut before, mut worked, mut largest) = (start.clone(), 0.0, 0.0_f64);
    for (n, sample) in integrator.unwrap().skip(1).take(300).enumerate() {
        let after = sample.unwrap().momentum.0;
        let [t, middle, next] = [0.0, 0.5, 1.0].map(|part| (n as f64 + part) * step);
        let (b, m, e) = (field.at(t), field.at(middle), field.at(next));
        let work = -(e - m).dot(&total(&after)) - (m - b).dot(&total(&before));
        worked += work;
        let change = energy(&after, next) - energy(&before, t);
        // Stages are solved to round-off of spins of size 3 and fields of size 10.
        assert!((change - work).abs() < 1e-12, "{n}: {change} {work}");
        largest = largest.max((lattice.value(&after) - lattice.value(&before)).abs());
        before = after;
    }
    let change = energy(&before, 30.0) - energy(&start, 0.0);
    assert!((change - worked).abs() < 1e-11, "{change} {worked}");
    assert!(largest > 0.05, "control: the energy without the field changes");
    for (end, start) in before.0.iter().zip(start.0.iter()) {
        assert!((end.norm() - start.norm()).abs() <= 1e-13 * start.norm());
    }
}

/// In units in which a spin is u and a second τ times as large, B is 1/τ, and J is 1/(uτ), of what they were.
#[test]
fn units_of_a_driven_lattice_do_not_matter() {
    let end = |u: f64, tau: f64| {
        let lattice = free(3).with_exchange([1, 0, 0], 1.0 / u / tau).unwrap();
        let field = Turning { rate: 5.0 / tau, size: 1.5 / tau };
        let spins = in_field(lattice, SpinDamping::Gilbert(0.2), field, 0.1 * tau);
        let end = spins.after(&from(&STARTS.map(|s| s * u), 0.0), 0.1 * tau, 40).unwrap();
        end.momentum.0.0.iter().map(|s| s / u).collect::<Vec<_>>()
    };
    let one = end(1.0, 1.0);
    for (u, tau) in [(1e30, 1.0), (1e-30, 1e30), (1.0, 1e-30)] {
        // Forty steps of some ten roundings.
        assert!(one.iter().zip(end(u, tau)).all(|(a, b)| (a - b).norm() < 1e-12), "{u} {tau}");
    }
}

/// Beyond the end of a table a step fails, and leaves the state as it was, also after its first part.
#[test]
fn a_field_without_a_value_fails_a_step() {
    let table = InputTable::new(vec![0.0, 0.25, 0.5], vec![1.0; 3], Interpolation::Linear).unwrap();
    let field = Inputs::new(vec![(Vector3::x(), table)]).unwrap();
    let spins = in_field(free(3), STILL, Some(field), 0.1);
    let mut state = spins.start(&from(&STARTS, 0.0)).unwrap();
    let before = state.clone();
    let failed = spins.step_in_place(&mut state, 1.2, &mut spins.workspace());
    assert_eq!(failed, Err(StepError::NotFinite));
    assert_eq!(state, before);
    assert!(
        spins.step_in_place(&mut state, 0.5, &mut spins.workspace()).is_ok() && state != before
    );
    // Without a field there is none.
    let none = in_field(free(3), STILL, None::<Turning>, 0.1);
    let still = none.after(&from(&STARTS, 0.0), 0.1, 3).unwrap().momentum.0.0;
    assert!(still.iter().zip(STARTS).all(|(a, b)| *a == b));
}
