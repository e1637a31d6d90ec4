//! The law suite of [`Scheme`].

use super::differences::{NOT_FINITE, broken_unless, constant, different_bits, point_or_nan};
use super::{GenericSystem, MeasuredScheme, Report};
use crate::schemes::scheme::{Scheme, Step};
use crate::vector_field::from_fn;
use lie_poisson::{DefaultLanes, Lanes, Pair, Real, State, Vector, larger, map_coordinates};
use momentum_map::Cotangent;
use nalgebra::Vector2;

/// A point of the phase space of the generic system.
type PhasePoint<T = f64> = Cotangent<Vector2<T>>;

/// Evaluates the laws of a scheme on the [`GenericSystem`]:
///
/// * `step of size 0`: Φ₀ = id;
/// * `step and increment`: a step is bit-identical to z + increment;
/// * `step in place`: [`step_in_place`](Scheme::step_in_place) is bit-identical to the step, and a step that fails
///   changes nothing;
/// * `refined increment`: δz + δe is the increment, to round-off;
/// * `order`: the residual is the shortfall of the measured order from [`order`](Scheme::order), less 0.3 for the
///   accuracy of the fit (an order that [cannot be measured](MeasuredScheme::order) is not refuted);
/// * `symmetry`, `symplecticity` and `quadratic invariants`, each if the scheme claims it;
/// * `forgetting`: after [`forget`](Scheme::forget) a used workspace gives results bit-identical to those of a new one,
///   even if a step failed;
/// * `lanes`: each SIMD lane is bit-identical to the steps over `f64`;
/// * `refusal`: a field that is infinite or not a number gives an error.
///
/// # Example
/// ```
/// use collective_integrators::{Composition, RungeKutta, Substeps, laws};
/// let scheme = Composition::new(RungeKutta::implicit_midpoint(), Substeps::suzuki4());
/// let report = laws::scheme(&scheme);
/// report.check(1e-13)?;
/// assert_eq!(report.residual("lanes"), Some(0.0));
/// # Ok::<(), laws::BrokenLaw>(())
/// ```
pub fn scheme<S: Scheme>(scheme: &S) -> Report {
    let mut report = Report::default();
    single_steps(scheme, &mut report);
    claims(scheme, &mut report);
    forgetting(scheme, &mut report);
    lanes(scheme, &mut report);
    for bad in NOT_FINITE {
        let step = broken_step(scheme, bad, &mut scheme.workspace());
        report.note("refusal", broken_unless(step.is_none()), 1.0);
    }
    report
}

/// The size of the steps.
const STEP: f64 = 0.1;

/// The number of steps that fill the memory of a workspace.
const STEPS: usize = 12;

/// Returns the point after [`STEPS`] steps, or NaN if one failed.
fn steps<T: Real, S: Scheme>(
    scheme: &S,
    z: PhasePoint<T>,
    workspace: &mut S::Workspace<PhasePoint<T>>,
) -> PhasePoint<T> {
    counted_steps(scheme, z, workspace).0
}

/// Returns the point after [`STEPS`] steps, or NaN if one failed, and the number of iterations of each step.
fn counted_steps<T: Real, S: Scheme>(
    scheme: &S,
    mut z: PhasePoint<T>,
    workspace: &mut S::Workspace<PhasePoint<T>>,
) -> (PhasePoint<T>, [usize; STEPS]) {
    let field = GenericSystem::field();
    let counts = core::array::from_fn(|_| {
        let made = scheme.step(&field, &z, STEP, workspace);
        let iterations = made.as_ref().map_or(0, |made| made.iterations);
        z = point_or_nan(made, &z);
        iterations
    });
    (z, counts)
}

/// Returns the result of a step along the constant field `bad`, which must have none.
fn broken_step<S: Scheme>(
    scheme: &S,
    bad: f64,
    workspace: &mut S::Workspace<PhasePoint>,
) -> Option<Step<PhasePoint>> {
    let field = from_fn(|_: &PhasePoint| constant(&GenericSystem::start::<f64>(), bad));
    scheme.step(&field, &GenericSystem::start(), STEP, workspace).ok()
}

fn single_steps<S: Scheme>(scheme: &S, report: &mut Report) {
    let (field, z) = (GenericSystem::field(), GenericSystem::start::<f64>());
    let step = |size| point_or_nan(scheme.step(&field, &z, size, &mut scheme.workspace()), &z);
    report.note("step of size 0", (step(0.0) - z).max_abs(), 1.0);
    let increment = point_or_nan(scheme.increment(&field, &z, STEP, &mut scheme.workspace()), &z);
    report.note("step and increment", different_bits(&step(STEP), &(z + increment)), 1.0);
    in_place(scheme, report);
    let refined = point_or_nan(
        scheme.refined_increment(&field, (&z, &Vector::zero()), STEP, &mut scheme.workspace()),
        &Pair(z, z),
    );
    let difference = refined.0 + refined.1 - increment;
    report.note("refined increment", difference.max_abs(), increment.max_abs());
}

fn in_place<S: Scheme>(scheme: &S, report: &mut Report) {
    let (field, start) = (GenericSystem::field(), GenericSystem::start::<f64>());
    let nan = from_fn(|_: &PhasePoint| constant(&GenericSystem::start::<f64>(), f64::NAN));
    let (mut z, workspace) = (start, &mut scheme.workspace());
    let made = (0..STEPS).all(|_| scheme.step_in_place(&field, &mut z, STEP, workspace).is_ok());
    let end = steps(scheme, start, &mut scheme.workspace());
    report.note("step in place", different_bits(&z, &end) + broken_unless(made), 1.0);
    let mut kept = z;
    let refused = scheme.step_in_place(&nan, &mut kept, STEP, workspace).is_err();
    report.note("step in place", different_bits(&kept, &z) + broken_unless(refused), 1.0);
}

/// The accuracy of a fitted order.
const ORDER_ACCURACY: f64 = 0.3;

fn claims<S: Scheme>(scheme: &S, report: &mut Report) {
    let measured = MeasuredScheme::of(scheme);
    let missing = scheme.order() as f64 - ORDER_ACCURACY - measured.order;
    report.note("order", larger(missing, 0.0), 1.0);
    let claims = [
        ("symmetry", scheme.is_symmetric(), measured.symmetry),
        ("symplecticity", scheme.is_symplectic(), measured.symplecticity),
        (
            "quadratic invariants",
            scheme.preserves_quadratic_invariants(),
            measured.quadratic_invariants,
        ),
    ];
    for (law, _, defect) in claims.into_iter().filter(|(_, claimed, _)| *claimed) {
        report.note(law, defect, 1.0);
    }
}

fn forgetting<S: Scheme>(scheme: &S, report: &mut Report) {
    let z = GenericSystem::start::<f64>();
    let anew = |z| counted_steps(scheme, z, &mut scheme.workspace());
    let mut used = scheme.workspace();
    steps(scheme, z.scaled(0.7), &mut used);
    broken_step(scheme, f64::NAN, &mut used);
    let (first, iterations) = anew(z);
    // The second run would continue from what the first one left in the workspace.
    for (start, expected) in [(z, (first, iterations)), (first, anew(first))] {
        scheme.forget(&mut used);
        let again = counted_steps(scheme, start, &mut used);
        report.note("forgetting", different_bits(&again.0, &expected.0), 1.0);
        // What is remembered saves iterations, even where it leaves no trace in the bits.
        report.note("forgetting", broken_unless(again.1 == expected.1), 1.0);
    }
}

fn lanes<S: Scheme>(scheme: &S, report: &mut Report) {
    // Lanes of different sizes need different numbers of iterations.
    let z = |lane: usize| GenericSystem::start::<f64>().scaled(1.0 / (1 + lane) as f64);
    let side_by_side: PhasePoint<DefaultLanes> =
        Vector::from_coordinates(|i| DefaultLanes::from_lanes(|lane| z(lane).coordinate(i)));
    let ends = steps(scheme, side_by_side, &mut scheme.workspace());
    for lane in 0..DefaultLanes::COUNT {
        let end: PhasePoint = map_coordinates(&ends, |x: DefaultLanes| x.lane(lane));
        let alone = steps(scheme, z(lane), &mut scheme.workspace());
        report.note("lanes", different_bits(&end, &alone), 1.0);
    }
}
