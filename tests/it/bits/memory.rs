//! Stages that are guessed from the steps before: fewer iterations, the same steps, and runs that resume.

use collective_integrators::{
    Alternating, CHECKPOINT, Collective, Composition, Direct, HamiltonianField, Integrator,
    LiftFree, PartitionedRungeKutta, RungeKutta, Start, Substeps, VariationalFlow, from_fn,
};
use heavytop::{HeavyTop, ReducedMidpoint, SpinorRealisation, WithAttitude};
use lie_poisson::{
    Differential, LiePoisson, Pair, Power, Quaternion, Se3, Se3Dual, SkewHermitian, Vector,
};
use lie_poisson_systems::Kirchhoff;
use momentum_map::{
    ComplexMatrices, DualQuaternions, Multiplier, Multipliers, PowerMultipliers,
    ProductMultipliers, Quaternions,
};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use num_complex::Complex;
use workspace_tests::tops;

fn top() -> HeavyTop {
    tops::paper().unwrap()
}

fn lifted(s: usize) -> Collective<RungeKutta, SpinorRealisation, HeavyTop> {
    Collective::new(RungeKutta::gauss(s).unwrap(), SpinorRealisation, top())
}

fn lift_free(s: usize) -> LiftFree<RungeKutta, DualQuaternions, HeavyTop> {
    LiftFree::new(RungeKutta::gauss(s).unwrap(), DualQuaternions, top())
}

/// Returns the closed midpoint rule of a body that is no top: it solves for velocities by iteration.
fn closed() -> ReducedMidpoint<Kirchhoff> {
    let diagonal = |x, y, z| Matrix3::from_diagonal(&Vector3::new(x, y, z));
    let coupling = diagonal(0.1, 0.05, -0.05);
    let (a, c) = (diagonal(0.9, 0.6, 0.4), diagonal(0.5, 0.7, 0.3));
    ReducedMidpoint::new(Kirchhoff::new(a, coupling, c).unwrap())
}

type Field = HamiltonianField<LiePoisson<Se3>, HeavyTop>;

fn direct(s: usize) -> Direct<RungeKutta, Field> {
    let field = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top() };
    Direct::new(RungeKutta::gauss(s).unwrap(), field)
}

/// Returns the number of iterations of some steps, and the last momentum.
fn run<I>(integrator: &I, h: f64, steps: usize, forget: bool) -> (f64, Se3Dual)
where
    I: Start<f64, State: Vector, Momentum = Se3Dual>,
{
    let mut workspace = integrator.workspace();
    let mut state = integrator.start(&tops::paper_start()).unwrap();
    let mut iterations = 0;
    for _ in 0..steps {
        if forget {
            integrator.forget(&mut workspace);
        }
        let next = integrator.step(&state, h, &mut workspace).unwrap();
        iterations += next.iterations;
        state = next.point;
    }
    (iterations as f64, integrator.momentum(&state))
}

/// Returns the iterations with guesses, divided by those without; the runs agree up to the growth of round-off.
fn ratio<I: Start<f64, State: Vector, Momentum = Se3Dual>>(integrator: &I, h: f64) -> f64 {
    let ((warm, a), (cold, b)) = (run(integrator, h, 500, false), run(integrator, h, 500, true));
    assert!((a - b).max_abs() < 1e-11, "{:e}", (a - b).max_abs());
    warm / cold
}

/// The bounds are those of docs/audit.md, rounded up.
#[test]
#[ignore = "long"]
fn guesses_save_iterations() {
    for (s, h, bound) in [
        (1, 0.02, 0.7),
        (2, 0.02, 0.6),
        (2, 0.1, 0.9),
        (3, 0.02, 0.6),
        (3, 0.1, 0.8),
        (4, 0.1, 0.9),
        (6, 0.1, 0.8),
        (8, 0.1, 0.7),
    ] {
        let ratios = [
            ratio(&lifted(s), h),
            ratio(&lift_free(s), h),
            ratio(&lift_free(s).compensated(), h),
            ratio(&WithAttitude(lift_free(s)), h),
            ratio(&direct(s), h),
        ];
        assert!(ratios.iter().all(|&x| x < bound), "{s}: {ratios:?}");
    }
    assert!(ratio(&closed(), 0.02) < 0.6);
    let lobatto = PartitionedRungeKutta::<Alternating>::lobatto_iiia_iiib(3).unwrap();
    let lobatto = Collective::that_does_not_descend(lobatto, SpinorRealisation, top());
    assert!(ratio(&lobatto, 0.02) < 0.95);
    // Substeps of equal size continue from each other, across the ends of steps too.
    let suzuki = Composition::new(RungeKutta::gauss(6).unwrap(), Substeps::suzuki(12).unwrap());
    assert!(ratio(&LiftFree::new(suzuki.clone(), DualQuaternions, top()), 0.2) < 0.95);
    assert!(ratio(&Collective::new(suzuki, SpinorRealisation, top()), 0.2) < 0.95);
    // Negative control: substeps of different sizes give no guesses.
    let uneven = Substeps::new(&[0.2, 0.5, 0.3]).unwrap();
    assert_eq!(ratio(&Composition::new(lift_free(4), uneven), 0.02), 1.0);
}

/// Steps that Newton's iteration has to solve are the same with a memory, and cost the same.
#[test]
fn large_steps_are_not_misled() {
    for s in [1, 2, 4] {
        for h in [0.5, 0.7, 1.0] {
            let (iterations, end) = run(&lift_free(s), h, 10, false);
            let (expected, same) = run(&lift_free(s), h, 10, true);
            assert!((end - same).max_abs() < 1e-10, "{s} {h}: {:e}", (end - same).max_abs());
            assert!(iterations <= 1.1 * expected, "{s} {h}: {iterations} {expected}");
        }
    }
}

/// A workspace may have served another field, another size or another method.
#[test]
fn a_wrong_memory_costs_iterations_and_no_digits() {
    let slow = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x));
    let fast = from_fn(|z: &Vector2<f64>| Vector2::new(-3.0 * z.y + 0.1, z.x * z.x));
    // The methods in the second line remember equally many stage derivatives.
    let methods =
        [(1, 2), (2, 3), (4, 4), (8, 1), (4, 2), (2, 4), (6, 3), (3, 6), (10, 1), (1, 10)];
    let histories = (0..12).flat_map(|before| [0.0, 1e-14, 1.0].map(|kick| (before, kick)));
    for ((s, other), (before, kick)) in
        methods.iter().flat_map(|pair| histories.clone().map(move |history| (*pair, history)))
    {
        let (a, b) = (RungeKutta::gauss(s).unwrap(), RungeKutta::gauss(other).unwrap());
        let (slow, fast) = (Direct::new(b, slow), Direct::new(a, fast));
        let mut workspace = slow.workspace();
        let mut z = Vector2::new(1.0, 0.5);
        for _ in 0..before {
            z = slow.step(&z, 0.1, &mut workspace).unwrap().point;
        }
        z.x += kick;
        for _ in 0..3 {
            let step = fast.step(&z, 0.1, &mut workspace).unwrap().point;
            let fresh = fast.step(&z, 0.1, &mut fast.workspace()).unwrap().point;
            assert!((step - fresh).amax() < 4.0 * f64::EPSILON, "{s} {other} {before} {kick}");
            z = step;
        }
    }
}

/// Returns whether the run that is resumed from the sample with this number continues bit for bit.
fn resumes<I: Start<f64, State: Vector, Momentum = Se3Dual>>(
    integrator: &I,
    h: f64,
    number: u64,
) -> bool {
    let whole = integrator.trajectory(&tops::paper_start(), h).unwrap();
    let mut whole = whole.skip(usize::try_from(number).unwrap());
    let saved = whole.next().unwrap().unwrap();
    let resumed = integrator.trajectory_resumed(saved.state, saved.step, h);
    resumed.skip(1).zip(whole).take(1100).all(|(a, b)| a.unwrap() == b.unwrap())
}

#[test]
#[ignore = "long"]
fn a_run_resumes_bit_for_bit() {
    let mut elsewhere = Vec::new();
    for (s, h) in [(1, 0.02), (4, 0.1), (8, 0.1)] {
        for n in [0, 1] {
            assert!(resumes(&lifted(s), h, n * CHECKPOINT), "lifted {s} {n}");
            assert!(resumes(&lift_free(s), h, n * CHECKPOINT), "lift-free {s} {n}");
            assert!(resumes(&lift_free(s).compensated(), h, n * CHECKPOINT), "compensated {s}");
            assert!(resumes(&WithAttitude(lift_free(s)), h, n * CHECKPOINT), "attitude {s}");
            assert!(resumes(&direct(s), h, n * CHECKPOINT), "direct {s} {n}");
        }
        assert!(resumes(&closed(), 0.02, CHECKPOINT));
        elsewhere.push(resumes(&closed(), 0.02, 700));
        elsewhere.push(resumes(&lifted(s), h, 700));
        elsewhere.push(resumes(&lift_free(s), h, 700));
    }
    // Negative control: at another number the last bits show that the memory is gone.
    assert!(elsewhere.contains(&false));
}

/// Without a trajectory a workspace makes its own checkpoints, where the product of all multipliers
/// begins anew at 1.
#[test]
fn steps_beyond_a_checkpoint_are_those_of_a_trajectory() {
    let (free, h) = (lift_free(1), 0.02);
    let mut workspace = Integrator::<f64>::workspace(&free);
    let mut mu = tops::paper_start();
    for sample in free.trajectory(&mu, h).unwrap().take(2 * CHECKPOINT as usize + 100) {
        assert_eq!(sample.unwrap().state, mu);
        mu = free.step(&mu, h, &mut workspace).unwrap().point;
    }
}

/// The state of a variational flow equals the trajectory's beyond a checkpoint, and where the tangents are renewed
/// now and then.
#[test]
fn the_state_of_a_variational_flow_is_that_of_the_trajectory() {
    let start = tops::paper_start();
    let free = lift_free(2);
    let tangents = [Se3Dual::basis(0), Se3Dual::basis(4)];
    let mut flow = VariationalFlow::new(&free, start, tangents, 0.02);
    for sample in free.trajectory(&start, 0.02).unwrap().take(1200) {
        assert_eq!(sample.unwrap().state, *flow.state());
        if flow.steps().is_multiple_of(100) {
            flow.orthonormalise().unwrap();
        }
        flow.advance().unwrap();
    }
}

/// Checks that (ξB)B⁻¹ = ξ, and that another B does not give ξ.
fn undoes<M: Multipliers>(
    multipliers: &M,
    xi: &Differential<M::Space>,
    b: &Multiplier<M>,
    other: &Multiplier<M>,
) {
    let one = multipliers.one::<f64>();
    let (expected, product) =
        (multipliers.generate::<f64>(xi, &one), multipliers.generate::<f64>(xi, b));
    let gap = |by| {
        let inverse = multipliers.inverse::<f64>(by);
        (multipliers.product::<f64>(&product, &inverse) - expected).max_abs()
    };
    assert!(gap(b) < 1e-14 && gap(other) > 0.1, "{:e} {:e}", gap(b), gap(other));
}

#[test]
fn inverses_undo_products() {
    let quaternion = |x: f64| Quaternion { scalar: 0.8, vector: Vector3::new(0.3, -0.4 * x, x) };
    let (b, other) = (quaternion(0.5), quaternion(-0.7));
    let (u, v) = (Vector3::new(1.0, 2.0, -0.5), Vector3::new(0.3, -1.0, 2.0));
    undoes(&Quaternions, &u, &b, &other);
    let (dual, other_dual) = (Pair(b, quaternion(1.5)), Pair(b, quaternion(0.2)));
    undoes(&DualQuaternions, &Pair(u, v), &dual, &other_dual);
    let power = PowerMultipliers::<_, 2>(Quaternions);
    undoes(&power, &Power([u, v]), &Power([b, other]), &Power([b, b]));
    let product = ProductMultipliers(Quaternions, DualQuaternions);
    let xi = Vector::from_coordinates(|i| 1.0 - 0.3 * i as f64);
    undoes(&product, &xi, &Pair(b, dual), &Pair(b, other_dual));
    let turn = |c: f64, s: f64| {
        Matrix2::new(Complex::from(c), Complex::new(0.0, s), Complex::new(0.0, s), c.into())
    };
    let xi = SkewHermitian::from_coordinates(|i| 0.5 + 0.2 * i as f64);
    undoes(&ComplexMatrices::<2>, &xi, &turn(0.6, 0.8), &turn(0.8, -0.6));
}
