//! Splittings of tops: exact flows, order, Poisson property, symmetry, Casimirs.

use collective_integrators::*;
use heavytop::*;
use lie_poisson::*;
use nalgebra::Vector3;

fn top() -> HeavyTop {
    let body = Body {
        inertia: Vector3::new(1.0, 1.4, 0.8),
        mass: 1.0,
        gravity: 2.0,
        length: 0.7,
        center_of_mass: Vector3::new(0.6, 0.48, 0.64),
    };
    HeavyTop::new(&body).unwrap()
}

fn mu() -> Se3Dual {
    Se3Dual::new(Vector3::new(0.7, -0.4, 1.1), Vector3::new(0.6, 0.0, -0.8))
}

fn advance<I: Integrator>(integrator: &I, z: I::State, time: f64, n: usize) -> I::State {
    let mut workspace = integrator.workspace();
    (0..n).fold(z, |z, _| integrator.step(&z, time / n as f64, &mut workspace).unwrap().point)
}

/// Returns the exact solution at t = 1, by a Gauss method of order 16 applied directly.
fn exact<P: PoissonSpace, H: Hamiltonian<P>>(space: P, hamiltonian: H, z: Point<P>) -> Point<P> {
    let field = HamiltonianField { space, hamiltonian };
    advance(&Direct::new(RungeKutta::gauss(8).unwrap(), field), z, 1.0, 20)
}

/// Returns max |{F∘Φ, G∘Φ} − {F, G}∘Φ| over the coordinate functions, with the exact tangent map.
fn poisson_defect<P, I, J>(space: &P, z: Point<P>, step: f64, dual: &I, plain: &J) -> f64
where
    P: PoissonSpace,
    I: Integrator<DualNumber, State = Point<P, DualNumber>>,
    J: Integrator<State = Point<P>>,
{
    let after = advance(plain, z, step, 1);
    let n = <Point<P> as Vector>::DIM;
    let column = |i: usize| -> Point<P> {
        let mut workspace = dual.workspace();
        let seeded = seed(&z, &Point::<P>::basis(i));
        derivative_part(&dual.step(&seeded, step, &mut workspace).unwrap().point)
    };
    let columns: Vec<Point<P>> = (0..n).map(column).collect();
    let mut worst = 0.0;
    for row in 0..n {
        // The differential d(Φ_row), moved by Λ(z) and pushed forward by DΦ, is compared with Λ(Φ(z)).
        let covector = Differential::<P>::from_coordinates(|i| columns[i].coordinate(row));
        let vector = space.hamiltonian_vector::<f64>(&z, &covector);
        let mut pushed = Point::<P>::zero();
        for (i, column) in columns.iter().enumerate() {
            pushed.add_multiple(vector.coordinate(i), column);
        }
        let there = space.hamiltonian_vector::<f64>(&after, &Vector::basis(row));
        worst = larger(worst, (pushed - there).max_abs());
    }
    worst
}

fn measured_order<I: Integrator<State: Vector>>(
    scheme: &I,
    z: I::State,
    exact: I::State,
    counts: &[usize],
) -> f64 {
    let error = |n: usize| (advance(scheme, z, 1.0, n) - exact).max_abs();
    let errors: Vec<_> = counts.iter().map(|&n| (1.0 / n as f64, error(n))).collect();
    fitted_order(&errors, 1e-13).unwrap()
}

/// The round-off of a few dozen rotations of vectors of size 1.
const ROUND_OFF: f64 = 1e-13;

fn symmetric() -> SymmetricTopSplitting {
    SymmetricTopSplitting::new(HeavyTop::kovalevskaya(0.9, 1.3).unwrap()).unwrap()
}

/// Checks order, Poisson property and symmetry of the three compositions of some flows on se(3)*.
fn check<E>(flows: E, top: HeavyTop)
where
    E: ExactFlows<Point = Se3Dual> + ExactFlows<DualNumber, Point = Se3Dual<DualNumber>> + Copy,
{
    let space = LiePoisson::minus(Se3::default());
    let end = exact(space, top, mu());
    let (trotter, strang) = (Splitting::lie_trotter(flows), Splitting::strang(flows));
    let raised = Composition::new(strang, Substeps::kahan_li6());
    let orders = [
        measured_order(&trotter, mu(), end, &[100, 200, 400]),
        measured_order(&strang, mu(), end, &[20, 40, 80]),
        measured_order(&raised, mu(), end, &[8, 10, 12, 16, 20]),
    ];
    for (measured, order) in orders.into_iter().zip([1.0, 2.0, 6.0]) {
        assert!((measured - order).abs() < 0.3, "{measured} {order}");
    }
    let defects = [
        poisson_defect(&space, mu(), 0.1, &trotter, &trotter),
        poisson_defect(&space, mu(), 0.1, &strang, &strang),
        poisson_defect(&space, mu(), 0.1, &raised, &raised),
        (advance(&strang, advance(&strang, mu(), 0.1, 1), -0.1, 1) - mu()).max_abs(),
        (advance(&raised, advance(&raised, mu(), 0.1, 1), -0.1, 1) - mu()).max_abs(),
    ];
    for defect in defects {
        assert!(defect < ROUND_OFF, "{defects:?}");
    }
    // Negative control: Lie–Trotter is not symmetric.
    let back = advance(&trotter, advance(&trotter, mu(), 0.1, 1), -0.1, 1) - mu();
    assert!(back.max_abs() > 1e-4 && !trotter.is_symmetric());
    for sample in Start::<f64>::trajectory(&raised, &mu(), 0.1).unwrap().take(1001) {
        let end = sample.unwrap().momentum;
        for casimir in [Invariant::VerticalSquared, Invariant::VerticalMomentum] {
            let drift = (casimir.value(&top, &end) - casimir.value(&top, &mu())).abs();
            assert!(drift < 1e-12, "{drift:e}");
        }
    }
}

#[test]
fn splittings_of_the_heavy_top_are_poisson() {
    check(RotorSplitting(top()), top());
    check(symmetric(), *symmetric().top());
}

/// Negative control of the Poisson defect: Gauss methods applied directly are not Poisson.
#[test]
fn the_poisson_defect_can_fail() {
    let space = LiePoisson::minus(Se3::default());
    let field = HamiltonianField { space, hamiltonian: top() };
    let direct = Direct::new(RungeKutta::implicit_midpoint(), field);
    let defect = poisson_defect(&space, mu(), 0.1, &direct, &direct);
    assert!(defect > 1e-5, "{defect:e}");
}

#[test]
fn three_rotors_make_the_free_body() {
    let body = RigidBody::new(Vector3::new(1.0, 1.4, 0.8)).unwrap();
    let space = LiePoisson::minus(So3);
    let pi = Covector(Vector3::new(0.7, -0.4, 1.1));
    let strang = Splitting::strang(RotorSplitting(body));
    let end = exact(space, body, pi);
    let measured = measured_order(&strang, pi, end, &[10, 20, 40]);
    assert!((measured - 2.0).abs() < 0.3, "{measured}");
    let raised = Composition::new(strang, Substeps::kahan_li8());
    let measured = measured_order(&raised, pi, end, &[3, 4, 5, 6]);
    assert!((measured - 8.0).abs() < 0.5, "{measured}");
    assert!(poisson_defect(&space, pi, 0.3, &raised, &raised) < ROUND_OFF);
    let end = advance(&strang, pi, 1000.0, 10_000);
    assert!((end.0.norm() - pi.0.norm()).abs() < 1e-12);
}

/// Each part is the exact flow of its Hamiltonian: without weight, the splitting of a symmetric top is exact.
#[test]
fn free_motion_of_a_symmetric_top_is_exact() {
    let free = HeavyTop::free_rigid_body(Vector3::new(1.2, 1.2, 0.7)).unwrap();
    let strang = Splitting::strang(SymmetricTopSplitting::new(free).unwrap());
    let end = advance(&strang, mu(), 1.0, 1);
    assert!((end - exact(LiePoisson::minus(Se3::default()), free, mu())).max_abs() < ROUND_OFF);
    let flows = RotorSplitting(top());
    let group = flows.flow(0, 0.3, &flows.flow(0, 0.4, &mu()));
    assert!((group - flows.flow(0, 0.7, &mu())).max_abs() < ROUND_OFF);
    assert_eq!(flows.flow(4, 1.0, &mu()), mu());
    assert!(matches!(SymmetricTopSplitting::new(top()), Err(TopError::NotSymmetricTop { .. })));
}

/// Lagrange's top turns about its axis by the same angle in all steps. The rounding errors of that turn must not add up.
#[test]
fn the_vertical_of_a_lagrange_top_keeps_its_length() {
    let flows = SymmetricTopSplitting::new(HeavyTop::lagrange(2.0, 1.0, 1.0).unwrap()).unwrap();
    let (steps, step) = (100_000, 0.02);
    for spin in [1.0, 4.0, 17.0, 60.0, 100.0] {
        let start = Se3Dual::new(Vector3::new(0.1, 0.3, spin), Vector3::new(0.6, 0.0, 0.8));
        let end = advance(&Splitting::strang(flows), start, step * steps as f64, steps);
        let stretch = |gamma: &Vector3<f64>| (gamma.norm_squared() - 1.0).abs();
        // 10⁵ steps of three flows with some roundings of 1e-16 each, at random: 1e-13.
        assert!(stretch(&end.0.1) < 6e-13, "{spin}: {:e}", stretch(&end.0.1));
    }
    // Negative control: a matrix of the rounded cosine and sine stretches by much more.
    let angle = 0.02_f64;
    let (cosine, sine) = (angle.cos(), angle.sin());
    let turned = |v: Vector3<f64>, _| {
        Vector3::new(cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z)
    };
    let end = (0..2 * steps).fold(Vector3::new(0.6, 0.0, 0.8), turned);
    assert!((end.norm_squared() - 1.0).abs() > 3e-12, "{:e}", end.norm_squared() - 1.0);
}
