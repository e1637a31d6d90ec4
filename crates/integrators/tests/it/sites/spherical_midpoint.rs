//! The spherical midpoint method: order, Poisson property, symmetry, and its collective origin.

use collective_integrators::*;
use lie_poisson::*;
use momentum_map::{HOPF, PowerMap};
use nalgebra::Vector3;

type Space = LiePoisson<PowerAlgebra<So3, 2>>;
type W<T = f64> = Covector<Power<Vector3<T>, 2>>;

/// A Hamiltonian that is constant on rays, h(w) = f(w₁/|w₁|, w₂/|w₂|).
#[derive(Clone, Copy)]
struct ConstantOnRays;

/// A homogeneous Hamiltonian that agrees with it on unit spheres only.
#[derive(Clone, Copy)]
struct Homogeneous;

fn f<T: Real>(x: &Vector3<T>, y: &Vector3<T>) -> T {
    x.dot(y) * 0.7 + x.x * x.x * 0.5 + y.y * y.z * 0.8 - x.z * y.x * y.x + x.y * 0.3
}

impl Energy for ConstantOnRays {
    type Space = Space;
    fn energy<T: Real>(&self, Covector(Power([x, y])): &W<T>) -> T {
        let unit = |v: &Vector3<T>| v.scaled(T::one() / v.dot(v).sqrt());
        f(&unit(x), &unit(y))
    }
}

impl Energy for Homogeneous {
    type Space = Space;
    fn energy<T: Real>(&self, Covector(Power([x, y])): &W<T>) -> T {
        f(x, y)
    }
}

fn space() -> Space {
    LiePoisson::minus(PowerAlgebra(So3))
}

fn spherical<E: Energy<Space = Space>>(
    energy: E,
) -> SphericalMidpoint<HamiltonianField<Space, Automatic<E>>> {
    SphericalMidpoint::new(HamiltonianField { space: space(), hamiltonian: Automatic(energy) })
}

fn start() -> W {
    Covector(Power([Vector3::new(0.6, 0.0, 0.8), Vector3::new(-0.48, 0.64, 0.6)]))
}

fn advance<I: Integrator>(integrator: &I, z: I::State, time: f64, n: usize) -> I::State {
    let mut workspace = integrator.workspace();
    (0..n).fold(z, |z, _| integrator.step(&z, time / n as f64, &mut workspace).unwrap().point)
}

#[test]
fn it_is_the_collective_midpoint_rule_of_a_hamiltonian_constant_on_rays() {
    let midpoint = RungeKutta::implicit_midpoint();
    let difference = |steps: usize, w: W, both: [bool; 2]| {
        let map = PowerMap::<_, 2>(HOPF);
        let on_rays = Collective::new(midpoint.clone(), map, Automatic(ConstantOnRays));
        let other = Collective::new(midpoint.clone(), map, Automatic(Homogeneous));
        let collective = |rays: bool| {
            let time = 0.2 * steps as f64;
            if rays {
                Integrator::<f64>::momentum(
                    &on_rays,
                    &advance(&on_rays, on_rays.start(&w).unwrap(), time, steps),
                )
            } else {
                Integrator::<f64>::momentum(
                    &other,
                    &advance(&other, other.start(&w).unwrap(), time, steps),
                )
            }
        };
        let time = 0.2 * steps as f64;
        let direct = if both[0] {
            advance(&spherical(ConstantOnRays), w, time, steps)
        } else {
            advance(&spherical(Homogeneous), w, time, steps)
        };
        (direct - collective(both[1])).max_abs()
    };
    // A step has an error of a few units of round-off.
    assert!(difference(1, start(), [true, true]) < 8.0 * f64::EPSILON);
    assert!(difference(20, start(), [true, true]) < 1e-13);
    // On unit spheres the method does not depend on how h is continued; the collective rule does.
    assert!(difference(1, start(), [false, true]) < 8.0 * f64::EPSILON);
    assert!(difference(1, start(), [true, false]) > 1e-6);
    // The spheres have other radii.
    let scaled = Covector(Power([start().0.0[0] * 2.0, start().0.0[1] * 0.5]));
    assert!(difference(1, scaled, [true, true]) < 32.0 * f64::EPSILON);
}

#[test]
fn it_is_a_symmetric_poisson_map_of_order_two() {
    let method = spherical(Homogeneous);
    let field = HamiltonianField { space: space(), hamiltonian: Automatic(Homogeneous) };
    let exact = advance(&Direct::new(RungeKutta::gauss(8).unwrap(), field), start(), 1.0, 20);
    let order = |method: &dyn Fn(usize) -> W, counts: &[usize]| {
        let error = |&n: &usize| (1.0 / n as f64, (method(n) - exact).max_abs());
        fitted_order(&counts.iter().map(error).collect::<Vec<_>>(), 1e-13).unwrap()
    };
    let measured = order(&|n| advance(&method, start(), 1.0, n), &[10, 20, 40, 80]);
    assert!((measured - 2.0).abs() < 0.1, "{measured}");
    let raised = Composition::new(method, Substeps::kahan_li6());
    let measured = order(&|n| advance(&raised, start(), 1.0, n), &[6, 8, 10, 12, 16]);
    assert!((measured - 6.0).abs() < 0.3, "{measured}");
    let back = advance(&method, advance(&method, start(), 0.2, 1), -0.2, 1) - start();
    assert!(back.max_abs() < 1e-14, "{back:?}");

    // The defect of {F∘Φ, G∘Φ} = {F, G}∘Φ over the coordinate functions.
    let defect = |step: &dyn Fn(&W<DualNumber>) -> W<DualNumber>, w: W| {
        let column = |i: usize| step(&seed(&w, &W::basis(i)));
        let columns: Vec<W> = (0..6).map(|i| derivative_part(&column(i))).collect();
        let after: W = map_coordinates(&column(0), |x: DualNumber| x.value_without_derivative());
        let mut worst = 0.0;
        for row in 0..6 {
            let covector = Vector::from_coordinates(|i| columns[i].coordinate(row));
            let vector = space().hamiltonian_vector::<f64>(&w, &covector);
            let mut pushed = W::zero();
            for (i, column) in columns.iter().enumerate() {
                pushed.add_multiple(vector.coordinate(i), column);
            }
            let there = space().hamiltonian_vector::<f64>(&after, &Vector::basis(row));
            worst = larger(worst, (pushed - there).max_abs());
        }
        worst
    };
    let general = Covector(Power([Vector3::new(1.1, -0.3, 0.4), Vector3::new(0.2, 0.7, -0.5)]));
    for w in [start(), general] {
        let poisson = defect(&|w| method.step(w, 0.2, &mut method.workspace()).unwrap().point, w);
        assert!(poisson < 1e-13, "{poisson:e}");
        // Negative control: the midpoint rule applied directly.
        let direct = Direct::new(RungeKutta::implicit_midpoint(), field);
        let control = defect(
            &|w| {
                direct
                    .step(w, 0.2, &mut Integrator::<DualNumber>::workspace(&direct))
                    .unwrap()
                    .point
            },
            w,
        );
        assert!(control > 1e-4, "{control:e}");
    }
}

#[test]
fn a_vanishing_spin_is_refused() {
    let method = spherical(Homogeneous);
    let zero: W = Covector(Power([Vector3::<f64>::zeros(), Vector3::x()]));
    assert!(matches!(
        method.step(&zero, 0.1, &mut method.workspace()),
        Err(StepError::NotConverged { .. })
    ));
}
