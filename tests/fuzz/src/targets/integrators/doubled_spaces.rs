//! Tao's method in a doubled space: the flows are undone by those back in time, and the coupling keeps the distance of
//! the two copies.

use super::kinds::Kind;
use super::schemes::steps_hold;
use crate::input::Input;
use collective_integrators::{
    Alternating, Composition, ExactFlows, FirstHalf, Polarisation, Splitting, Substeps, TaoFlows,
    VectorField, from_fn,
};
use lie_poisson::{Pair, Vector, larger};
use nalgebra::Vector4;

pub(super) const KINDS: &[Kind] = &[
    ("TaoFlows<_, FirstHalf>", strang::<FirstHalf>),
    ("TaoFlows<_, Alternating>", strang::<Alternating>),
    ("TaoFlows, composed", composed::<FirstHalf>),
];

/// The rounding errors of a few sums and products, in units of the largest of them.
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// Returns the field of h = ½ Σ (a q² + 1)(b p² + 1), which does not separate.
fn field<P: Polarisation>([a, b]: [f64; 2]) -> impl VectorField<Point = Vector4<f64>> {
    from_fn(move |z: &Vector4<f64>| {
        Vector4::from_fn(|i, _| {
            let other = z[P::conjugate(i, 4)];
            if P::is_position(i, 4) {
                (a * z[i] * z[i] + 1.0) * b * other
            } else {
                -a * other * (b * z[i] * z[i] + 1.0)
            }
        })
    })
}

type Copies = Pair<Vector4<f64>, Vector4<f64>>;

/// Returns a point with its copy, or two points.
fn copies(input: &mut Input<'_>) -> Copies {
    let z = Vector4::from(input.numbers());
    if input.choice(2) == 0 { TaoFlows::copied(z) } else { Pair(z, input.numbers().into()) }
}

/// Asserts that each flow and the one back in time lead to the start. Returns whether their numbers are finite.
fn flows_are_undone<E: ExactFlows<Point = Copies>>(flows: &E, start: &Copies, time: f64) -> bool {
    (0..E::COUNT).fold(true, |finite, index| {
        let end = flows.flow(index, time, start);
        let back = flows.flow(index, -time, &end);
        // Sums may overflow, before they are halved, where the end does not.
        let size = larger(start.max_abs(), end.max_abs());
        if !back.max_abs().is_finite() || !(4.0 * size).is_finite() {
            return false;
        }
        let error = (back - *start).max_abs();
        let allowed = ROUND_OFF * size + f64::MIN_POSITIVE;
        assert!(error <= allowed, "{index}, {time:e}: {start:?} {end:?} {back:?}");
        if index == 2 {
            let distance = |Pair(a, b): &Copies| (a / size - b / size).norm();
            let change = (distance(&end) - distance(start)).abs();
            assert!(change <= ROUND_OFF || size == 0.0, "{time:e}: {start:?} {end:?}");
        }
        finite
    })
}

fn strang<P: Polarisation>(input: &mut Input<'_>) -> bool {
    let flows = TaoFlows::<_, P>::new(field::<P>(input.numbers()), input.number());
    let (start, step) = (copies(input), input.number());
    let undone = flows_are_undone(&flows, &start, step);
    steps_hold(&Splitting::strang(flows), &start, step, |_, _| undone)
}

fn composed<P: Polarisation>(input: &mut Input<'_>) -> bool {
    let flows = TaoFlows::<_, P>::new(field::<P>(input.numbers()), input.number());
    let (start, step) = (copies(input), input.number());
    let raised = Composition::new(Splitting::strang(flows), Substeps::yoshida4());
    steps_hold(&raised, &start, step, |_, _| true)
}
