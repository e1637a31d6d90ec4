//! Casimirs of driven motions, whose field is the differential of nothing.

use collective_integrators::{Direct, Driven, DrivenField, Integrator, RungeKutta, Start};
use core::marker::PhantomData;
use lie_poisson::{
    Automatic, Autonomous, Casimirs, Controlled, Covector, Diagonal, DoubleBracket, Energy,
    GilbertDamping, InfinitesimalAdjoint, InnerProduct, InputTable, Inputs, Interpolation,
    LieAlgebra, LiePoisson, Momentum, OrbitField, Pair, PoissonSpace, Power, PowerAlgebra, Real,
    Se3, So3, State, Time, UnitaryAlgebra, Vector,
};
use momentum_map::{
    ClebschRealisation, HOPF, Lift, PARTICLE, PoissonMap, PowerMap, Side, clebsch_realisation,
    unitary_realisation,
};
use nalgebra::Vector3;
use num_complex::Complex;

/// A field whose coordinates are sines of the momentum times those of the time, none of them a gradient. It is as smooth for
/// large momenta, which orbits of se(3)∗ have, as for small ones; and the momentum keeps its digits at late times, which it
/// would lose in a sine of both together.
#[derive(Clone, Copy)]
struct Sines;

impl<A: LieAlgebra, T: Real> OrbitField<LiePoisson<A>, T> for Sines {
    fn element(&self, mu: &Momentum<A, T>, time: T) -> A::Element<T> {
        let mut xi: A::Element<T> = Vector::zero();
        let count = <Momentum<A, T> as Vector>::DIM;
        let squares = (0..count).map(|i| State::coordinate(mu, i));
        let length = squares.fold(T::one(), |sum, x| sum + x * x).sqrt();
        State::set_coordinates(&mut xi, |i| {
            let other = State::coordinate(mu, (i + 1) % count);
            let angle = time * (0.7 + 0.2 * i as f64);
            (other / length * 1.3 + i as f64).sin() * angle.cos()
        });
        xi
    }
}

/// Returns the largest deviation of the Casimirs over a run of n steps from a time, relative to their sizes and to the
/// largest momentum, which are 1 or more.
fn deviation<M, A, X>(
    (map, field): (M, X),
    start: &Momentum<A, f64>,
    (time, steps): (f64, usize),
) -> f64
where
    M: Lift<Target = LiePoisson<A>>,
    A: Casimirs,
    X: OrbitField<LiePoisson<A>>,
{
    let algebra = map.target().algebra().clone();
    let values = |mu: &Momentum<A, f64>| -> Vec<f64> {
        (0..A::COUNT).map(|index| algebra.casimir(index, mu)).collect()
    };
    let first = values(start);
    let driven = Driven::new(RungeKutta::gauss(3).unwrap(), map, field).compensated();
    let (mut largest, mut size) = (0.0_f64, 1.0_f64);
    let run = driven.trajectory(&Pair(*start, Time(time)), 0.2).unwrap();
    for sample in run.take(steps + 1).step_by(97) {
        let mu = sample.unwrap().momentum.0;
        size = size.max(Vector::max_abs(&mu));
        let found = values(&mu);
        for (found, first) in found.iter().zip(&first) {
            largest = largest.max((found - first).abs() / first.abs().max(1.0));
        }
    }
    largest / size
}

fn spin() -> Covector<Vector3<f64>> {
    Covector(Vector3::new(0.6, 0.0, 0.8))
}

fn top() -> Covector<Pair<Vector3<f64>, Vector3<f64>>> {
    Covector(Pair(Vector3::new(0.4, 1.2, -0.3), Vector3::new(0.6, 0.0, 0.8)))
}

fn two() -> Covector<Power<Vector3<f64>, 2>> {
    Covector(Power([spin().0, Vector3::new(0.1, 0.5, -0.4)]))
}

fn coherent() -> Momentum<UnitaryAlgebra<3>, f64> {
    let c = Complex::new;
    let z = Vector3::new(c(1.0, 0.2), c(0.3, -1.0), c(0.5, 0.4));
    unitary_realisation::<3>().apply(&z)
}

/// Returns the largest deviations on so(3)∗, se(3)∗, u(3)∗ and so(4)∗ = so(3)∗ × so(3)∗.
fn deviations(time: f64, steps: usize) -> [f64; 4] {
    let (run, unitary) = ((time, steps), unitary_realisation::<3>());
    [
        deviation::<_, So3, _>((HOPF, Sines), &spin(), run),
        deviation::<_, Se3, _>((PARTICLE, Sines), &top(), run),
        deviation::<_, UnitaryAlgebra<3>, _>((unitary, Sines), &coherent(), run),
        deviation::<_, PowerAlgebra<So3, 2>, _>((PowerMap::<_, 2>(HOPF), Sines), &two(), run),
    ]
}

fn damped<P: PoissonSpace>(space: P) -> DoubleBracket<P, Sines> {
    DoubleBracket::new(space, Sines, 0.1, InnerProduct::euclidean()).unwrap()
}

/// Returns the largest deviations with a double bracket, in the order of [`deviations`].
fn deviations_with_double_brackets(steps: usize) -> [f64; 4] {
    let (run, unitary, pair) = ((0.0, steps), unitary_realisation::<3>(), PowerMap::<_, 2>(HOPF));
    let fields = (damped(HOPF.target()), damped(PARTICLE.target()));
    let others = (damped(unitary.target()), damped(pair.target()));
    [
        deviation::<_, So3, _>((HOPF, fields.0), &spin(), run),
        deviation::<_, Se3, _>((PARTICLE, fields.1), &top(), run),
        deviation::<_, UnitaryAlgebra<3>, _>((unitary, others.0), &coherent(), run),
        deviation::<_, PowerAlgebra<So3, 2>, _>((pair, others.1), &two(), run),
    ]
}

/// Returns inputs along three elements, which have a breakpoint in every third step of a run.
fn inputs<D: Vector<Scalar = f64>>(steps: usize) -> Inputs<D> {
    let kinds = [Interpolation::Constant, Interpolation::Linear, Interpolation::Cubic];
    let inputs = kinds.into_iter().zip([1.7, 1.9, 2.3]).enumerate();
    let inputs = inputs.map(|(n, (kind, spacing))| {
        let count = (steps as f64 * 0.2 / spacing).ceil() as usize + 2;
        let times = (0..count).map(|i| i as f64 * spacing).collect();
        let values = (0..count).map(|i| (i as f64 * 1.3 + n as f64).sin() * 1.5).collect();
        let element = D::from_coordinates(|i| if i % 3 == n { 1.0 } else { 0.2 });
        (element, InputTable::new(times, values, kind).unwrap())
    });
    Inputs::new(inputs.collect()).unwrap()
}

/// The quadratic energy k Σ (0.5 + 0.1 i) μᵢ² on the dual of any algebra.
struct Quadratic<A>(f64, PhantomData<A>);

impl<A: LieAlgebra> Energy for Quadratic<A> {
    type Space = LiePoisson<A>;

    fn energy<T: Real>(&self, mu: &Momentum<A, T>) -> T {
        (0..<Momentum<A, T> as Vector>::DIM).fold(T::zero(), |sum, i| {
            let x = mu.coordinate(i);
            sum + x * x * (self.0 * (0.5 + 0.1 * i as f64))
        })
    }
}

/// A body with the control law of [`Sines`], or along inputs, whose energy has a factor.
fn controlled<A: LieAlgebra, U>(
    factor: f64,
    control: U,
) -> Controlled<Autonomous<Automatic<Quadratic<A>>>, U> {
    Controlled { field: Autonomous(Automatic(Quadratic(factor, PhantomData))), control }
}

/// Returns the largest deviations along inputs, in the order of [`deviations`], then by a control law, and with Gilbert's damping.
fn deviations_of_others(steps: usize) -> [f64; 9] {
    let (run, pair, unitary) = ((0.0, steps), || PowerMap::<_, 2>(HOPF), unitary_realisation::<3>);
    let gilbert = GilbertDamping::new(HOPF.target(), Sines, 0.3).unwrap();
    // Orbits of se(3)∗ are not bounded, so that a quadratic energy would need ever smaller steps. The coherent state of u(3) has
    // larger momenta than the spins, and the same steps must turn it as little.
    let both = Controlled { field: inputs(steps), control: Sines };
    [
        deviation::<_, So3, _>((HOPF, inputs(steps)), &spin(), run),
        deviation::<_, Se3, _>((PARTICLE, inputs(steps)), &top(), run),
        deviation::<_, UnitaryAlgebra<3>, _>(
            (unitary(), controlled(0.1, inputs(steps))),
            &coherent(),
            run,
        ),
        deviation::<_, PowerAlgebra<So3, 2>, _>(
            (pair(), controlled(1.0, inputs(steps))),
            &two(),
            run,
        ),
        deviation::<_, So3, _>((HOPF, controlled(1.0, Sines)), &spin(), run),
        deviation::<_, Se3, _>((PARTICLE, both), &top(), run),
        deviation::<_, UnitaryAlgebra<3>, _>((unitary(), controlled(0.1, Sines)), &coherent(), run),
        deviation::<_, PowerAlgebra<So3, 2>, _>((pair(), controlled(1.0, Sines)), &two(), run),
        deviation::<_, So3, _>((HOPF, gilbert), &spin(), run),
    ]
}

/// Checks that steps of RK4 on the equations themselves do not keep the length of a spin.
fn require_loss_without_a_lift<X: OrbitField<LiePoisson<So3>>>(field: X) {
    let direct =
        Direct::new(RungeKutta::rk4(), DrivenField { space: LiePoisson::minus(So3), field });
    let last = direct.after(&Pair(spin(), Time(0.0)), 0.2, 300).unwrap();
    let lost = (last.momentum.0.0.norm() - 1.0).abs();
    assert!(lost > 1e-6, "{lost:e}");
}

#[test]
fn damped_and_controlled_fields_keep_the_casimirs() {
    let [damping, others] =
        [deviations_with_double_brackets(98).to_vec(), deviations_of_others(98).to_vec()];
    let found = [damping, others].concat();
    // Sums of some hundred roundings, of numbers up to ten.
    assert!(found.iter().all(|deviation| *deviation < 1e-13), "{found:?}");
    require_loss_without_a_lift(damped(HOPF.target()));
    require_loss_without_a_lift(GilbertDamping::new(HOPF.target(), Sines, 0.3).unwrap());
    require_loss_without_a_lift(inputs::<Vector3<f64>>(300));
    require_loss_without_a_lift(controlled::<So3, _>(1.0, Sines));
}

/// The Clebsch map of two copies of the adjoint representation of se(3).
type TwoCopies = ClebschRealisation<Diagonal<InfinitesimalAdjoint<Se3>, 2>>;

fn two_copies() -> TwoCopies {
    clebsch_realisation(Diagonal(InfinitesimalAdjoint(Se3::default())), Side::Right).unwrap()
}

/// A momentum with Π·Γ = 0.84, over which a particle has no states.
fn spinning_top() -> Covector<Pair<Vector3<f64>, Vector3<f64>>> {
    Covector(Pair(Vector3::new(0.4, 1.2, 0.75), top().0.1))
}

/// Returns the largest deviations on the orbit of a spinning top, with a field of sines and with its double bracket.
fn deviations_of_tops_that_spin(steps: usize) -> [f64; 2] {
    let (run, damped, start) = ((0.0, steps), damped(two_copies().target()), spinning_top());
    [
        deviation::<_, Se3, _>((two_copies(), Sines), &start, run),
        deviation::<_, Se3, _>((two_copies(), damped), &start, run),
    ]
}

#[test]
fn fields_keep_the_casimirs_of_tops_that_spin() {
    let found = deviations_of_tops_that_spin(98);
    // Sums of some hundred roundings, of numbers up to ten.
    assert!(found.iter().all(|deviation| *deviation < 1e-13), "{found:?}");
    assert!(PARTICLE.lift(&spinning_top()).is_err());
    // Control: an explicit method on the same space does not.
    let explicit = Driven::new(RungeKutta::rk4(), two_copies(), Sines);
    let last = explicit.after(&Pair(spinning_top(), Time(0.0)), 0.2, 98).unwrap().momentum;
    let Covector(Pair(pi, gamma)) = last.0;
    let lost = (pi.dot(&gamma) - 0.84).abs();
    assert!(lost > 1e-6, "{lost:e}");
}

#[test]
#[ignore = "takes minutes"]
fn fields_keep_the_casimirs_of_tops_that_spin_many_times() {
    let found = deviations_of_tops_that_spin(1_000_000);
    println!("{found:?}");
    assert!(found.iter().all(|deviation| *deviation < 1e-12), "{found:?}");
}

#[test]
#[ignore = "takes minutes"]
fn double_brackets_keep_the_casimirs_many_times() {
    let found = deviations_with_double_brackets(1_000_000);
    println!("{found:?}");
    assert!(found.iter().all(|deviation| *deviation < 1e-12), "{found:?}");
}

#[test]
#[ignore = "takes minutes"]
fn inputs_controls_and_gilberts_damping_keep_the_casimirs_many_times() {
    let found = deviations_of_others(1_000_000);
    println!("{found:?}");
    assert!(found.iter().all(|deviation| *deviation < 1e-12), "{found:?}");
}

#[test]
fn fields_of_any_kind_keep_the_casimirs() {
    let found = deviations(0.0, 1500);
    // Steps of a fifth of a radian; sums of a few thousand roundings.
    assert!(found.iter().all(|deviation| *deviation < 1e-12), "{found:?}");
    // Control: RK4 on the equations themselves does not.
    let field = DrivenField { space: LiePoisson::minus(So3), field: Sines };
    let start = Pair(Covector(Vector3::new(0.6, 0.0, 0.8)), Time(0.0));
    let last = Direct::new(RungeKutta::rk4(), field).after(&start, 0.2, 1500).unwrap();
    assert!((last.momentum.0.0.norm() - 1.0).abs() > 1e-6);
}

/// The time of a stage has the rounding errors of a large number, here of 1e-8. It is another field that is seen then, which
/// keeps the Casimirs as well.
#[test]
fn at_late_times_the_casimirs_are_kept() {
    let found = deviations(1e8, 300);
    assert!(found.iter().all(|deviation| *deviation < 1e-13), "{found:?}");
}

/// Stages are left with errors below 2⁻⁵ ε of their size, which have one sign.
#[test]
#[ignore = "takes a minute"]
fn fields_of_any_kind_keep_the_casimirs_many_times() {
    let found = deviations(0.0, 1_000_000);
    println!("{found:?}");
    assert!(found.iter().all(|deviation| *deviation < 1e-12), "{found:?}");
}

#[test]
fn steps_do_not_depend_on_the_lift() {
    let driven = Driven::new(RungeKutta::gauss(3).unwrap(), PARTICLE, Sines);
    let mu = Covector(Pair(Vector3::new(0.4, 1.2, -0.3), Vector3::new(0.6, 0.0, 0.8)));
    let z = PARTICLE.lift(&mu).unwrap();
    let mut other = z;
    // Along the fibre of Π = q × p, Γ = p: q may be moved by a multiple of p.
    other.q += z.p.0 * 1.7;
    assert!(Vector::max_abs(&(PARTICLE.apply(&other) - PARTICLE.apply(&z))) < 1e-15);
    let ends = [z, other].map(|z| {
        let run = driven.trajectory_from(Pair(z, Time(0.0)), 0.2);
        run.take(101).last().unwrap().unwrap().momentum.0
    });
    let difference = Vector::max_abs(&(ends[0] - ends[1]));
    assert!(difference < 1e-12, "{difference}");
}
