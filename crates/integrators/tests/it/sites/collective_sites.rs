//! The collective integrator for copies of a realisation, against that for a number which the compiler knows.

use crate::support::laws;
use collective_integrators::*;
use lie_poisson::*;
use momentum_map::{HOPF, PARTICLE, PoissonMap, PowerMap};
use nalgebra::Vector3;

pub const COUNT: usize = 3;

/// h(s) = −Σ s_i·s_(i+1) + Σ (e₃·s_i)² on a ring.
#[derive(Clone, Copy)]
pub struct Ring;

fn axis<T: Real>() -> Vector3<T> {
    Vector3::new(T::zero(), T::zero(), T::one())
}

fn slope<T: Real>(s: &[Vector3<T>], i: usize) -> Vector3<T> {
    let n = s.len();
    axis() * (s[i].z + s[i].z) - s[(i + n - 1) % n] - s[(i + 1) % n]
}

impl<T: Real> SitesHamiltonian<Vector3<T>> for Ring {
    fn value(&self, s: &Covector<Sites<Vector3<T>>>) -> T {
        let term = |i: usize| s.0[i].z * s.0[i].z - s.0[i].dot(&s.0[(i + 1) % s.0.len()]);
        (0..s.0.len()).fold(T::zero(), |sum, i| sum + term(i))
    }

    fn differential_into(&self, s: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
        (0..s.0.len()).for_each(|i| dh[i] = slope(&s.0, i));
    }
}

type SpinSpace = LiePoisson<PowerAlgebra<So3, COUNT>>;

impl<T: Real> Hamiltonian<SpinSpace, T> for Ring {
    fn value(&self, s: &Covector<Power<Vector3<T>, COUNT>>) -> T {
        let term = |i: usize| s.0.0[i].z * s.0.0[i].z - s.0.0[i].dot(&s.0.0[(i + 1) % COUNT]);
        (0..COUNT).fold(T::zero(), |sum, i| sum + term(i))
    }

    fn differential(&self, s: &Covector<Power<Vector3<T>, COUNT>>) -> Power<Vector3<T>, COUNT> {
        Power(core::array::from_fn(|i| slope(&s.0.0, i)))
    }
}

pub fn spin(i: usize) -> Vector3<f64> {
    let x = i as f64;
    Vector3::new((2.3 * x).sin(), (1.7 * x).cos(), 0.4 - 0.3 * x)
}

pub fn spins(count: usize) -> Covector<Sites<Vector3<f64>>> {
    Covector((0..count).map(spin).collect())
}

#[test]
fn a_number_at_run_time_changes_no_bit() {
    for stages in [1, 2, 3] {
        let scheme = || RungeKutta::gauss(stages).unwrap();
        let few = Collective::new(scheme(), PowerMap::<_, COUNT>(HOPF), Ring);
        let many = CollectiveSites::new(scheme(), HOPF, Ring);
        let mu = Covector(Power(core::array::from_fn(spin)));
        let a = few.trajectory(&mu, 0.1).unwrap().take(50);
        let b = many.trajectory(&spins(COUNT), 0.1).unwrap().take(50);
        for (a, b) in a.zip(b) {
            let (a, b) = (a.unwrap(), b.unwrap());
            assert_eq!(a.iterations, b.iterations);
            assert_eq!(a.momentum.0.0[..], b.momentum.0[..]);
        }
    }
}

/// The same for fibres that are lines: the gauge and the way back to the origin are those of one point.
#[test]
fn a_gauge_at_run_time_changes_no_bit() {
    a_gauge_changes_no_bit(400);
}

#[test]
#[ignore = "long"]
fn a_gauge_at_run_time_changes_no_bit_of_long_runs() {
    a_gauge_changes_no_bit(2000);
}

fn a_gauge_changes_no_bit(samples: usize) {
    #[derive(Clone, Copy)]
    struct Body;
    impl Hamiltonian<LiePoisson<Se3>, f64> for Body {
        fn value(&self, mu: &Se3Dual) -> f64 {
            Bodies.value(&Covector(Sites::new(vec![mu.0])))
        }
        fn differential(&self, mu: &Se3Dual) -> Wrench {
            let mut dh = Sites::new(vec![Pair::zero()]);
            Bodies.differential_into(&Covector(Sites::new(vec![mu.0])), &mut dh);
            dh[0]
        }
    }
    for distance in [0.0, 1.0, 1e6] {
        let one = Collective::new(RungeKutta::gauss(2).unwrap(), PARTICLE, Body);
        let many = CollectiveSites::new(RungeKutta::gauss(2).unwrap(), PARTICLE, Bodies);
        let (q, p) = (spin(1), spin(4));
        let z = momentum_map::Cotangent::new(q + p * distance, Covector(p));
        let a = one.trajectory_from(z, 0.1).take(samples).last().unwrap().unwrap();
        let b =
            many.trajectory_from(Sites::new(vec![z]), 0.1).take(samples).last().unwrap().unwrap();
        assert_eq!(a.state, b.state[0], "{distance}");
        assert!(a.state != z);
    }
}

#[test]
fn the_laws_of_integrators_hold() {
    let length = |s: &Covector<Sites<Vector3<f64>>>| s.0[2].norm();
    let sum = |s: &Covector<Sites<Vector3<f64>>>| s.0.iter().sum::<Vector3<f64>>().z;
    let gauss = CollectiveSites::new(RungeKutta::gauss(2).unwrap(), HOPF, Ring);
    let other: Sites<_> = (5..9).map(spin).collect();
    let (momenta, step) = ([spins(4), Covector(other)], 0.1);
    laws::start(&gauss, &momenta, step).unwrap().check(1e-13).unwrap();
    let lifted = gauss.start(&momenta[0]).unwrap();
    let conserved =
        laws::invariants(&gauss, core::slice::from_ref(&lifted), step, &[&length, &sum]);
    conserved.unwrap().check(1e-13).unwrap();
    // control: a scheme that is not symplectic
    let rk4 = CollectiveSites::new(RungeKutta::rk4(), HOPF, Ring);
    let lost = laws::invariants(&rk4, &[lifted], step, &[&length]);
    assert!(lost.unwrap().check(1e-13).is_err());
}

/// A rigid motion of each site, with fibres that are lines: h(μ) = Σ (½|l_i|² + p_i·p_(i+1)).
#[derive(Clone, Copy)]
pub struct Bodies;

type Wrench = Pair<Vector3<f64>, Vector3<f64>>;

impl SitesHamiltonian<Wrench> for Bodies {
    fn value(&self, mu: &Covector<Sites<Wrench>>) -> f64 {
        let next = |i: usize| mu.0[(i + 1) % mu.0.len()].1;
        let term = |(i, mu): (usize, &Wrench)| 0.5 * mu.0.norm_squared() + mu.1.dot(&next(i));
        mu.0.iter().enumerate().map(term).sum()
    }

    fn differential_into(&self, mu: &Covector<Sites<Wrench>>, dh: &mut Sites<Wrench>) {
        let n = mu.0.len();
        for i in 0..n {
            dh[i] = Pair(mu.0[i].0, mu.0[(i + 1) % n].1 + mu.0[(i + n - 1) % n].1);
        }
    }
}

/// The points are kept near to the origins of their fibres, along which they would run away.
#[test]
#[ignore = "long"]
fn points_stay_near_the_origins_of_their_fibres() {
    let gauss = CollectiveSites::new(RungeKutta::gauss(2).unwrap(), PARTICLE, Bodies);
    let z: Sites<_> =
        (1..5).map(|i| momentum_map::Cotangent::new(spin(i), Covector(spin(i + 3)))).collect();
    fn near(z: &impl State<Scalar = f64>) -> f64 {
        (0..z.dimension()).map(|i| z.coordinate(i).abs()).fold(0.0, larger)
    }
    let (mut moved, mut workspace) = (z.clone(), gauss.workspace());
    let energy = Bodies.value(&gauss.momentum(&z));
    for _ in 0..20_000 {
        gauss.step_in_place(&mut moved, 0.05, &mut workspace).unwrap();
    }
    // Points move back when they have grown fourfold. Without this, they are 500 away after this time.
    assert!(near(&moved) < 4.0 * 10.0, "{}", near(&moved));
    let after = gauss.momentum(&moved);
    assert!((Bodies.value(&after) - energy).abs() < 1e-4 * energy.abs());
    for (a, b) in after.0.iter().zip(gauss.momentum(&z).0.iter()) {
        // |p|² and l·p are the Casimirs.
        assert!((a.1.norm() - b.1.norm()).abs() < 1e-11);
        assert!((a.0.dot(&a.1) - b.0.dot(&b.1)).abs() < 1e-11);
    }
    let point = PARTICLE.apply(&moved[0]);
    assert_eq!(point.0, after.0[0]);
}

#[test]
fn another_number_of_sites_is_an_error() {
    /// A Hamiltonian of three sites.
    struct Three;
    impl SitesHamiltonian<Vector3<f64>> for Three {
        fn value(&self, s: &Covector<Sites<Vector3<f64>>>) -> f64 {
            if s.0.len() == 3 { 0.0 } else { f64::NAN }
        }
        fn differential_into(
            &self,
            s: &Covector<Sites<Vector3<f64>>>,
            dh: &mut Sites<Vector3<f64>>,
        ) {
            let value = if s.0.len() == 3 { 0.0 } else { f64::NAN };
            dh.set_coordinates(|_| value);
        }
    }
    let midpoint = CollectiveSites::new(RungeKutta::implicit_midpoint(), HOPF, Three);
    assert!(midpoint.after(&spins(3), 0.1, 2).is_ok());
    assert!(midpoint.after(&spins(4), 0.1, 2).is_err());
    let none = CollectiveSites::new(RungeKutta::implicit_midpoint(), HOPF, Ring);
    assert!(none.after(&spins(0), 0.1, 2).is_ok());
}
