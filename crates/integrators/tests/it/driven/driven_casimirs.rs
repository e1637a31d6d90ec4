//! Casimirs of driven motions, whose field is the differential of nothing.

use collective_integrators::{Direct, Driven, DrivenField, Integrator, RungeKutta, Start};
use lie_poisson::{
    Casimirs, Covector, LiePoisson, Momentum, OrbitField, Pair, Power, PowerAlgebra, Real, Se3,
    So3, Time, UnitaryAlgebra, Vector,
};
use momentum_map::{HOPF, Lift, PARTICLE, PoissonMap, PowerMap, unitary_realisation};
use nalgebra::Vector3;
use num_complex::Complex;

/// A field whose coordinates are sines of the momentum times those of the time, none of them a gradient. It is as smooth for
/// large momenta, which orbits of se(3)∗ have, as for small ones; and the momentum keeps its digits at late times, which it
/// would lose in a sine of both together.
#[derive(Clone, Copy)]
struct Sines;

impl<A: lie_poisson::LieAlgebra, T: Real> OrbitField<LiePoisson<A>, T> for Sines {
    fn element(&self, mu: &Momentum<A, T>, time: T) -> A::Element<T> {
        let mut xi: A::Element<T> = Vector::zero();
        let count = <Momentum<A, T> as Vector>::DIM;
        let squares = (0..count).map(|i| lie_poisson::State::coordinate(mu, i));
        let length = squares.fold(T::one(), |sum, x| sum + x * x).sqrt();
        lie_poisson::State::set_coordinates(&mut xi, |i| {
            let other = lie_poisson::State::coordinate(mu, (i + 1) % count);
            let angle = time * (0.7 + 0.2 * i as f64);
            (other / length * 1.3 + i as f64).sin() * angle.cos()
        });
        xi
    }
}

/// Returns the largest deviation of the Casimirs over a run of n steps from a time, relative to their sizes and to the
/// largest momentum, which are 1 or more.
fn deviation<M, A>(map: M, start: &Momentum<A, f64>, (time, steps): (f64, usize)) -> f64
where
    M: Lift<Target = LiePoisson<A>>,
    A: Casimirs,
{
    let algebra = map.target().algebra().clone();
    let values = |mu: &Momentum<A, f64>| -> Vec<f64> {
        (0..A::COUNT).map(|index| algebra.casimir(index, mu)).collect()
    };
    let first = values(start);
    let driven = Driven::new(RungeKutta::gauss(3).unwrap(), map, Sines).compensated();
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

/// Returns the largest deviations on so(3)∗, se(3)∗, u(3)∗ and so(4)∗ = so(3)∗ × so(3)∗.
fn deviations(time: f64, steps: usize) -> [f64; 4] {
    let run = (time, steps);
    let spin = Covector(Vector3::new(0.6, 0.0, 0.8));
    let top = Covector(Pair(Vector3::new(0.4, 1.2, -0.3), Vector3::new(0.6, 0.0, 0.8)));
    let two = Covector(Power([spin.0, Vector3::new(0.1, 0.5, -0.4)]));
    let c = Complex::new;
    let z = Vector3::new(c(1.0, 0.2), c(0.3, -1.0), c(0.5, 0.4));
    let coherent = unitary_realisation::<3>().apply(&z);
    [
        deviation::<_, So3>(HOPF, &spin, run),
        deviation::<_, Se3>(PARTICLE, &top, run),
        deviation::<_, UnitaryAlgebra<3>>(unitary_realisation::<3>(), &coherent, run),
        deviation::<_, PowerAlgebra<So3, 2>>(PowerMap::<_, 2>(HOPF), &two, run),
    ]
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
