//! Trajectories with an attitude: it is a rotation, and turns the vertical to Γ.

use super::kinds::Kind;
use super::schemes::{scheme, steps_hold};
use crate::input::Input;
use crate::targets::conservation::{LARGEST_TURN, SAFE, TOLERANCE, turn_of_top};
use crate::targets::one_step::top;
use collective_integrators::{
    Collective, Composition, LiftFree, Splitting, StagesInLanes, Start, Substeps,
};
use heavytop::{
    CollectiveGauss, HeavyTop, ReducedMidpoint, RotorSplitting, SpinorRealisation,
    SymmetricTopSplitting, TopMidpoint, Turning, WithAttitude,
};
use lie_poisson::{Covector, Pair, Se3Dual};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

pub(super) const KINDS: &[Kind] = &[
    ("WithAttitude<Collective>", |input| {
        let (scheme, conserves) = scheme(input);
        holds(input, conserves, |top| Some(Collective::new(scheme, SpinorRealisation, top)))
    }),
    ("WithAttitude<Compensated<Collective>>", |input| {
        let (scheme, conserves) = scheme(input);
        holds(input, conserves, |top| {
            Some(Collective::new(scheme, SpinorRealisation, top).compensated())
        })
    }),
    ("WithAttitude<LiftFree>", |input| {
        let (scheme, conserves) = scheme(input);
        holds(input, conserves, |top| Some(LiftFree::new(scheme, DualQuaternions, top)))
    }),
    ("WithAttitude<Compensated<LiftFree>>", |input| {
        let (scheme, conserves) = scheme(input);
        holds(input, conserves, |top| {
            Some(LiftFree::new(scheme, DualQuaternions, top).compensated())
        })
    }),
    ("WithAttitude<StagesInLanes>", |input| {
        let (scheme, conserves) = scheme(input);
        let collective = |top| Collective::new(scheme, SpinorRealisation, top);
        holds(input, conserves, |top| Some(StagesInLanes::widest(collective(top))))
    }),
    ("WithAttitude<CollectiveGauss>", |input| {
        let stages = 1 + input.choice(8);
        holds(input, true, |top| CollectiveGauss::new(stages, top).ok())
    }),
    ("WithAttitude<TopMidpoint>", |input| holds(input, true, |top| Some(TopMidpoint::new(top)))),
    ("WithAttitude<ReducedMidpoint>", |input| {
        holds(input, true, |top| Some(ReducedMidpoint::new(top)))
    }),
    ("WithAttitude<Composition<TopMidpoint>>", |input| {
        holds(input, true, |top| Some(Composition::new(TopMidpoint::new(top), Substeps::suzuki4())))
    }),
    ("WithAttitude<Splitting<RotorSplitting>>", |input| {
        holds(input, true, |top| Some(Splitting::strang(RotorSplitting(top))))
    }),
    ("WithAttitude<Splitting<SymmetricTopSplitting>>", |input| {
        holds(input, true, |top| Some(Splitting::strang(SymmetricTopSplitting::new(top).ok()?)))
    }),
];

/// The rounding errors of a quaternion that is divided by its norm.
const ROUND_OFF: f64 = 8.0 * f64::EPSILON;

/// Asserts that the attitude of each step is a unit quaternion that turns the vertical to Γ.
fn holds<I: Turning + Start<Momentum = Se3Dual>>(
    input: &mut Input<'_>,
    conserves: bool,
    integrator: impl FnOnce(HeavyTop) -> Option<I>,
) -> bool {
    let symmetric = input.choice(2) == 1;
    let Some(top) = top(input, symmetric) else { return false };
    let Some(integrator) = integrator(top) else { return false };
    let start = Se3Dual::new(input.vector(), input.vector());
    let step = input.number();
    let mut turned = 0.0;
    steps_hold(&WithAttitude(integrator), &start, step, |before, after| {
        let (attitude, Covector(Pair(_, gamma))) = (after.state.1, after.momentum);
        let said = || format!("{step:e}: {top:?} {start:?} {attitude:?} {after:?}");
        assert!((attitude.norm_squared() - 1.0).abs() < ROUND_OFF, "{}", said());
        // The multipliers of an explicit method are no rotations.
        if !conserves {
            return false;
        }
        // The rotations of all steps have rounding errors, in proportion to the angles by which the body turns.
        let (turn, sizes) = turn_of_top(&top, [before, &after.momentum], step);
        turned = f64::max(turned, turn);
        if turned >= LARGEST_TURN || !sizes.iter().all(|size| SAFE.contains(size)) {
            return false;
        }
        let vertical = attitude.conjugate().rotate(&Vector3::z());
        let gap = (vertical - (gamma / gamma.amax()).normalize()).amax();
        assert!(gap < TOLERANCE, "{gap:e}, {turned:e} {}", said());
        true
    })
}
