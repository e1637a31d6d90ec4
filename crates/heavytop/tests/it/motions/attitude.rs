//! The attitude along a motion, in every formulation that has one: vertical, order and the rotation of a step.

use collective_integrators::{
    AlternatingSubsteps, Collective, Composition, Direct, FirstHalf, Integrator, LiftFree,
    PartitionedRungeKutta, RungeKutta, Splitting, StagesInLanes, Start, Substeps, fitted_order,
    from_fn,
};
use heavytop::{
    HeavyTop, ReducedMidpoint, RotorSplitting, SpinorRealisation, SymmetricTopSplitting,
    TopMidpoint, Turning, WithAttitude, attitude_of_vertical,
};
use lie_poisson::{
    Hamiltonian, LiePoisson, Pair, PoissonSpace, Quaternion, Se3, Se3Dual, State, Vector,
};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(0.4, -0.8, 1.6), Vector3::new(0.6, 0.0, -0.8))
}

fn top() -> HeavyTop {
    HeavyTop::kovalevskaya(1.0, 1.0).unwrap()
}

/// A task to perform with an integrator that has an attitude.
trait Task {
    fn perform<I: Turning + Start<Momentum = Se3Dual>>(
        &self,
        name: &str,
        order: f64,
        integrator: I,
    );
}

/// Performs the task with every formulation that has an attitude.
fn every_formulation(task: &impl Task) {
    let (top, midpoint) = (top(), RungeKutta::implicit_midpoint());
    let gauss = |stages| RungeKutta::gauss(stages).unwrap();
    let yoshida = || Composition::new(midpoint.clone(), Substeps::yoshida4());
    let lift_free = |scheme| LiftFree::new(scheme, DualQuaternions, top);
    let collective = |scheme| Collective::new(scheme, SpinorRealisation, top);
    let rotors = || Splitting::strang(RotorSplitting(top));
    let symmetric = || Splitting::strang(SymmetricTopSplitting::new(top).unwrap());
    let verlet = PartitionedRungeKutta::<FirstHalf>::kick_drift_kick();

    task.perform("lift-free midpoint", 2.0, lift_free(midpoint.clone()));
    task.perform("lift-free Gauss", 4.0, lift_free(gauss(2)));
    task.perform("lift-free, compensated", 4.0, lift_free(gauss(2)).compensated());
    let composed = LiftFree::new(yoshida(), DualQuaternions, top);
    task.perform("lift-free composition", 4.0, composed);
    task.perform("collective midpoint", 2.0, collective(midpoint.clone()));
    task.perform("collective Gauss", 4.0, collective(gauss(2)));
    task.perform("collective, compensated", 4.0, collective(gauss(2)).compensated());
    let side_by_side = StagesInLanes::new(collective(gauss(2)));
    task.perform("collective, stages side by side", 4.0, side_by_side.clone());
    task.perform("stages side by side, compensated", 4.0, side_by_side.compensated());
    let composed = Collective::new(yoshida(), SpinorRealisation, top);
    task.perform("collective composition", 4.0, composed);
    task.perform(
        "Störmer–Verlet",
        2.0,
        Collective::that_does_not_descend(verlet, SpinorRealisation, top),
    );
    task.perform("closed form", 2.0, ReducedMidpoint::new(top));
    task.perform("closed form of tops", 2.0, TopMidpoint::new(top));
    let composed = Composition::new(TopMidpoint::new(top), Substeps::suzuki4());
    task.perform("closed form, composed", 4.0, composed);
    task.perform("rotors", 2.0, rotors());
    task.perform("rotors, Lie–Trotter", 1.0, Splitting::lie_trotter(RotorSplitting(top)));
    task.perform("rotors, composed", 4.0, Composition::new(rotors(), Substeps::suzuki4()));
    task.perform("symmetric top", 2.0, symmetric());
    task.perform("symmetric, composed", 4.0, Composition::new(symmetric(), Substeps::suzuki4()));
    let symmetric = SymmetricTopSplitting::new(top).unwrap();
    let alternating = Splitting::alternating(symmetric, AlternatingSubsteps::blanes_moan4());
    task.perform("symmetric, alternating", 4.0, alternating);
}

/// The task that compares Rᵀe₃ with Γ/|Γ| over 10⁴ steps, with the factors in the right and in the wrong order.
struct Vertical;

impl Task for Vertical {
    fn perform<I: Turning + Start<Momentum = Se3Dual>>(&self, name: &str, _: f64, integrator: I) {
        const STEPS: usize = 10_000;
        // A step has a few unbiased rounding errors.
        let tolerance = 4.0 * f64::EPSILON * (STEPS as f64).sqrt();
        let gap = |attitude: &Quaternion, gamma: &Vector3<f64>| {
            (attitude.conjugate().rotate(&Vector3::z()) - gamma.normalize()).norm()
        };
        let mut wrong = attitude_of_vertical(&start().0.1);
        let (mut most, mut most_of_wrong) = (0.0, 0.0);
        let mut state = integrator.start(&start()).unwrap();
        let mut workspace = integrator.workspace();
        let integrator = WithAttitude(integrator);
        for sample in integrator.trajectory(&start(), 0.02).unwrap().take(STEPS) {
            let sample = sample.unwrap();
            let attitude = sample.state.1;
            assert!((attitude.norm_squared() - 1.0).abs() < 4.0 * f64::EPSILON, "{name}");
            most = f64::max(most, gap(&attitude, &sample.momentum.0.1));
            most_of_wrong = f64::max(most_of_wrong, gap(&wrong, &sample.momentum.0.1));
            integrator.0.forget(&mut workspace);
            let (next, turn) = integrator.0.turn(&state, 0.02, &mut workspace).unwrap();
            // The rotation belongs to this very step.
            integrator.0.forget(&mut workspace);
            let plain = integrator.0.step(&state, 0.02, &mut workspace).unwrap();
            assert_eq!((plain.point, plain.iterations), (next.point, next.iterations), "{name}");
            state = next.point;
            wrong = turn.conjugate() * wrong;
        }
        assert!(most < tolerance, "{name}: {most:e}");
        // The workspace is that of the last step.
        integrator.forget(&mut workspace);
        let next = |workspace: &mut _| {
            let next = integrator.step(&Pair(state, Quaternion::one()), 0.02, workspace).unwrap();
            (next.point, next.iterations)
        };
        assert_eq!(next(&mut workspace), next(&mut integrator.workspace()), "{name}");
        assert!(most_of_wrong > 0.1, "{name}: {most_of_wrong:e}");
    }
}

#[test]
#[ignore = "long"]
fn the_attitude_turns_the_vertical_to_gamma() {
    every_formulation(&Vertical);
}

/// Computes the attitude at t = 1 by the method of order 8 for Ȧ = ½ A Ω beside the six equations.
fn reference() -> Quaternion {
    let (top, space) = (top(), LiePoisson::minus(Se3::default()));
    let field = from_fn(move |Pair(mu, attitude): &Pair<Se3Dual, Quaternion>| {
        let dh = top.differential(mu);
        let spin = Quaternion { scalar: 0.0, vector: dh.0 * 0.5 };
        Pair(space.hamiltonian_vector::<f64>(mu, &dh), *attitude * spin)
    });
    let dop853 = Direct::new(RungeKutta::dop853(), field);
    let state = Pair(start(), attitude_of_vertical(&start().0.1));
    dop853.trajectory(&state, 0.005).unwrap().nth(200).unwrap().unwrap().state.1
}

/// The task that measures how the error of the attitude at t = 1 falls with the step: by the order of the method.
struct Order(Quaternion);

impl Task for Order {
    fn perform<I: Turning + Start<Momentum = Se3Dual>>(
        &self,
        name: &str,
        order: f64,
        integrator: I,
    ) {
        let integrator = WithAttitude(integrator);
        let errors = [16, 32, 64, 128].map(|count| {
            let step = 1.0 / count as f64;
            let mut run = integrator.trajectory(&start(), step).unwrap();
            let attitude = run.nth(count).unwrap().unwrap().state.1;
            // A quaternion and its negative are the same rotation, but here the signs agree: no factor is far from 1.
            (step, (attitude - self.0).max_abs())
        });
        let slope = fitted_order(&errors, 1e-13).unwrap();
        assert!((slope - order).abs() < 0.3, "{name}: {slope}");
    }
}

#[test]
fn the_attitude_is_of_the_order_of_the_method() {
    let reference = reference();
    every_formulation(&Order(reference));
    // Control: the motion in the space frame is another one.
    assert!((reference - reference.conjugate()).max_abs() > 0.1);
}

#[test]
fn every_vertical_has_an_attitude() {
    let mut verticals = vec![Vector3::z(), -Vector3::z(), Vector3::x(), -Vector3::y()];
    verticals.push(Vector3::new(1e-9, 0.0, -1.0).normalize());
    verticals.push(Vector3::new(0.0, 1e-9, 1.0).normalize());
    verticals.push(Vector3::new(0.36, 0.48, -0.8) * 3.0);
    // The square of the horizontal part underflows.
    verticals.push(Vector3::new(3e-200, -4e-200, -1.0));
    verticals.push(Vector3::new(3e-200, -4e-200, 1.0));
    for gamma in verticals {
        let attitude = attitude_of_vertical(&gamma);
        let seen = attitude.conjugate().rotate(&Vector3::z()) * gamma.norm();
        assert!((seen - gamma).norm() < 1e-15 * (1.0 + gamma.norm()), "{gamma} {seen}");
        assert!((attitude.norm_squared() - 1.0).abs() < 1e-15);
    }
    assert!(!attitude_of_vertical(&Vector3::<f64>::zeros()).is_finite());
}
