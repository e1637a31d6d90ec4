//! Casimirs along paths with noise.

use super::support::{isotropic, on_path};
use collective_integrators::{BrownianPaths, Direct, NoiseRule, Noisy, RungeKutta, Start, from_fn};
use lie_poisson::Automatic;
use lie_poisson::{
    Autonomous, Casimirs, Covector, DoubleBracket, Energy, InnerProduct, LieAlgebra, LiePoisson,
    Momentum, Pair, Point, PoissonSpace, Power, PowerAlgebra, Real, Se3, So3, State,
    UnitaryAlgebra, Vector,
};
use momentum_map::{HOPF, Lift, PARTICLE, PoissonMap, PowerMap, unitary_realisation};
use nalgebra::Vector3;
use num_complex::Complex;

/// A quadratic and cubic energy on the dual of any algebra.
#[derive(Clone, Copy)]
struct Generic<A>(A);

impl<A: LieAlgebra> Energy for Generic<A> {
    type Space = LiePoisson<A>;

    fn energy<T: Real>(&self, mu: &Point<Self::Space, T>) -> T {
        let count = <Momentum<A, T> as Vector>::DIM;
        (0..count).fold(T::zero(), |sum, i| {
            let (x, y) = (mu.coordinate(i), mu.coordinate((i + 1) % count));
            sum + x * x * (0.3 + 0.1 * i as f64) + x * x * y * 0.05
        })
    }
}

/// Returns the largest deviation of the Casimirs over a path of n steps; their terms are of the order of 1.
fn deviation<M, A>(map: M, start: &Momentum<A, f64>, rule: NoiseRule, steps: usize) -> f64
where
    M: Lift<Target = LiePoisson<A>>,
    A: Casimirs,
{
    let (space, algebra) = (map.target(), map.target().algebra().clone());
    let values = |mu: &Momentum<A, f64>| -> Vec<f64> {
        (0..A::COUNT).map(|index| algebra.casimir(index, mu)).collect()
    };
    let first = values(start);
    let field = Autonomous(Automatic(Generic(algebra.clone())));
    let inner_product = InnerProduct::euclidean();
    let field = DoubleBracket::new(space, field, 0.1, inner_product).unwrap();
    let noise = isotropic(0.3);
    let paths = BrownianPaths::new(4, 0.05).unwrap();
    let noisy = Noisy::new(RungeKutta::implicit_midpoint(), map, field, noise, paths);
    let noisy = noisy.with_rule(rule);
    let mut largest = 0.0_f64;
    let run = noisy.trajectory(&on_path(*start, 11), 0.05).unwrap();
    for sample in run.take(steps + 1).step_by(97) {
        let found = values(&sample.unwrap().momentum.0);
        for (found, first) in found.iter().zip(&first) {
            largest = largest.max((found - first).abs());
        }
    }
    largest
}

/// Returns the largest deviations on so(3)∗, se(3)∗, u(3)∗ and so(4)∗ = so(3)∗ × so(3)∗.
fn deviations(rule: NoiseRule, steps: usize) -> [f64; 4] {
    let spin = Covector(Vector3::new(0.6, 0.0, 0.8));
    let top = Covector(Pair(Vector3::new(0.4, 1.2, -0.3), Vector3::new(0.6, 0.0, 0.8)));
    let two = Covector(Power([spin.0, Vector3::new(0.1, 0.5, -0.4)]));
    let c = Complex::new;
    let z = Vector3::new(c(0.5, 0.1), c(0.2, -0.5), c(0.3, 0.2));
    let coherent = unitary_realisation::<3>().apply(&z);
    [
        deviation::<_, So3>(HOPF, &spin, rule, steps),
        deviation::<_, Se3>(PARTICLE, &top, rule, steps),
        deviation::<_, UnitaryAlgebra<3>>(unitary_realisation::<3>(), &coherent, rule, steps),
        deviation::<_, PowerAlgebra<So3, 2>>(PowerMap::<_, 2>(HOPF), &two, rule, steps),
    ]
}

fn require_casimirs(steps: usize) {
    for rule in [NoiseRule::Together, NoiseRule::Alternating] {
        let found = deviations(rule, steps);
        // Sums of at most a few thousand roundings.
        assert!(found.iter().all(|deviation| *deviation < 1e-12), "{rule:?} {found:?}");
    }
}

#[test]
fn noise_keeps_the_casimirs_of_each_path() {
    require_casimirs(300);
}

#[test]
#[ignore = "long"]
fn noise_keeps_the_casimirs_of_each_path_in_long_runs() {
    require_casimirs(1000);
}

/// Control: an explicit step, which converges to the same process, leaves the sphere.
#[test]
fn an_explicit_step_does_not() {
    let paths = BrownianPaths::new(4, 0.05).unwrap();
    let mut s = Covector(Vector3::new(0.6, 0.0, 0.8));
    for n in 0..1000 {
        let mut noise = [0.0; 3];
        paths.write_increments(11, n as f64, n as f64 + 1.0, &mut noise);
        let xi = Vector3::from(noise) * (0.3 / 0.05);
        let space = LiePoisson::minus(So3);
        let field =
            from_fn(move |s: &Covector<Vector3<f64>>| space.hamiltonian_vector::<f64>(s, &xi));
        s = Direct::new(RungeKutta::explicit_midpoint(), field)
            .after(&s, 0.05, 1)
            .unwrap()
            .momentum;
    }
    assert!((s.0.norm() - 1.0).abs() > 1e-4);
}

/// Rounding errors are unbiased: they grow as the root of the number of steps.
#[test]
#[ignore = "takes minutes"]
fn noise_keeps_the_casimirs_of_each_path_many_times() {
    let found = deviations(NoiseRule::Together, 1_000_000);
    assert!(found.iter().all(|deviation| *deviation < 1e-12), "{found:?}");
}

/// In a step of this rule each field of the noise acts by itself, so that there are more stages and more roundings.
#[test]
#[ignore = "takes minutes"]
fn alternating_noise_keeps_the_casimirs_of_each_path_many_times() {
    let found = deviations(NoiseRule::Alternating, 1_000_000);
    println!("{found:?}");
    assert!(found.iter().all(|deviation| *deviation < 1e-12), "{found:?}");
}
