//! Integrators and batches that break one law each, which the law suites reject.

use crate::laws::integrator_laws::{STEP, points};
use crate::support::{broken, laws};
use collective_integrators::*;
use core::ops::Range;
use lie_poisson::*;
use momentum_map::LiftError;
use nalgebra::Vector2;

/// Rotations of the plane by the angle h, with a fault.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FaultyIntegrator {
    None,
    MovesAtRest,
    Remembers,
    NeverForgets,
    ReturnsNaN,
    MiscountsSamples,
    StartsElsewhere,
    BeginsLater,
    StopsLater,
    StartsAnywhere,
    AdvancesElsewhere,
    SkipsASecondPart,
    RefusesALastStep,
}

impl Integrator for FaultyIntegrator {
    type State = Vector2<f64>;
    type Momentum = Vector2<f64>;
    /// The number of steps that were made one from the end of the other, and the last end.
    type Workspace = (u32, Vector2<f64>);

    fn workspace(&self) -> Self::Workspace {
        (0, Vector2::zeros())
    }

    fn step(
        &self,
        z: &Vector2<f64>,
        step: f64,
        (made, end): &mut Self::Workspace,
    ) -> Result<Step<Vector2<f64>>, StepError> {
        // From another state, and at checkpoints, it begins anew by itself.
        if *self == Self::NeverForgets && (end != z || u64::from(*made) >= CHECKPOINT) {
            *made = 0;
        }
        *made += 1;
        let angle = match self {
            Self::MovesAtRest => step + 1e-6,
            Self::Remembers | Self::NeverForgets => step * f64::from(*made),
            _ => step,
        };
        let (sin, cos) = angle.sin_cos();
        let point = Vector2::new(z.x * cos + z.y * sin, z.y * cos - z.x * sin);
        *end = point;
        let next = Step { point, iterations: 0 };
        if *self == Self::ReturnsNaN { Ok(next) } else { next.finite() }
    }

    fn step_in_place(
        &self,
        z: &mut Vector2<f64>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        let scale = if *self == Self::AdvancesElsewhere { 2.0 } else { 1.0 };
        let Step { point, iterations } = self.step(&(*z * scale), step, workspace)?;
        *z = point;
        // The suite makes twelve steps.
        let refused = *self == Self::RefusesALastStep && workspace.0 == 12;
        if refused { Err(StepError::NotFinite) } else { Ok(iterations) }
    }

    fn advance(
        &self,
        z: &mut Vector2<f64>,
        step: f64,
        steps: Range<u64>,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, IntegrationError> {
        StepError::check_start(z, step)
            .map_err(|refused| IntegrationError::after(steps.start, step, refused))?;
        let skipped = *self == Self::SkipsASecondPart && workspace.0 > 0;
        for n in steps.filter(|_| !skipped) {
            self.step_in_place(z, step, workspace)
                .map_err(|source| IntegrationError::after(n, step, source))?;
        }
        Ok(0)
    }

    fn forget(&self, _: &mut Self::Workspace) {}

    fn momentum(&self, z: &Vector2<f64>) -> Vector2<f64> {
        *z
    }

    fn trajectory_from(&self, z: Vector2<f64>, step: f64) -> Trajectory<'_, Self> {
        self.trajectory_resumed(z, u64::from(*self == Self::MiscountsSamples), step)
    }
}

impl Start for FaultyIntegrator {
    fn start(&self, mu: &Vector2<f64>) -> Result<Vector2<f64>, LiftError> {
        Ok(if *self == Self::StartsElsewhere { mu * 1.001 } else { *mu })
    }

    fn trajectory(&self, mu: &Vector2<f64>, step: f64) -> Result<Trajectory<'_, Self>, RunError> {
        if *self != Self::StartsAnywhere {
            let refused = |source| IntegrationError::after(0, step, source);
            StepError::check_start(mu, step).map_err(refused)?;
        }
        let start = if *self == Self::BeginsLater { mu * 2.0 } else { self.start(mu)? };
        Ok(self.trajectory_from(start, step))
    }

    fn after(&self, mu: &Vector2<f64>, step: f64, steps: u64) -> Result<SampleOf<Self>, RunError> {
        let place = if *self == Self::StopsLater { steps + 1 } else { steps };
        let sample = self.trajectory(mu, step)?.nth(place as usize);
        Ok(sample.unwrap_or(Err(IntegrationError::after(steps, step, StepError::Uncountable)))?)
    }
}

#[test]
fn laws_of_integrators_reject_what_breaks_them() {
    let cases: [(FaultyIntegrator, &[&str]); 13] = [
        (FaultyIntegrator::None, &[]),
        (FaultyIntegrator::MovesAtRest, &["step of size 0", "pinning"]),
        (FaultyIntegrator::Remembers, &["forgetting", "resumption"]),
        (FaultyIntegrator::NeverForgets, &["forgetting"]),
        (FaultyIntegrator::ReturnsNaN, &["refusal"]),
        (FaultyIntegrator::MiscountsSamples, &["first sample", "after", "samples"]),
        (FaultyIntegrator::StartsElsewhere, &["start"]),
        (FaultyIntegrator::BeginsLater, &["first sample"]),
        (FaultyIntegrator::StopsLater, &["after"]),
        (FaultyIntegrator::StartsAnywhere, &["refusal"]),
        (FaultyIntegrator::AdvancesElsewhere, &["step in place", "advance", "resumption"]),
        (FaultyIntegrator::SkipsASecondPart, &["advance"]),
        (FaultyIntegrator::RefusesALastStep, &["after", "step in place", "advance", "resumption"]),
    ];
    for (integrator, expected) in cases {
        let report = laws::start(&integrator, &points(), STEP).unwrap();
        assert_eq!(broken(&report), expected, "{integrator:?}");
    }
}

/// An integrator that contains another one, and passes on neither the call to forget nor that to pin.
pub(super) struct Deaf<I>(pub(super) I);

impl<I: Integrator> Integrator for Deaf<I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> I::Workspace {
        self.0.workspace()
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        self.0.step(state, step, workspace)
    }

    fn forget(&self, _: &mut I::Workspace) {}

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.0.momentum(state)
    }
}

/// What an implicit method remembers leaves no trace in the bits of most steps, but it saves iterations.
#[test]
#[ignore = "long"]
fn an_integrator_that_does_not_forget_is_seen_at_every_step() {
    for stages in 1..=4 {
        let gauss = || {
            let pendulum = from_fn(|z: &Vector2<f64>| Vector2::new(z.y, -z.x.sin()));
            Direct::new(RungeKutta::gauss(stages).unwrap(), pendulum)
        };
        for step in [1e-3, 0.01, 0.1, 0.3, 1.0, -0.3] {
            let law = |report: laws::Report| report.residual("forgetting").unwrap();
            let deaf = laws::integrator(&Deaf(gauss()), &points(), step).unwrap();
            assert!(law(deaf) >= 1.0, "{stages} {step}");
            // Control: the integrator itself forgets.
            assert_eq!(law(laws::integrator(&gauss(), &points(), step).unwrap()), 0.0);
        }
    }
}

/// The map x ↦ (1 + h) x for many x, with a fault.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FaultyBatch {
    None,
    CountsMembers,
    CountsPlaces,
    LooksAtNeighbours,
    Remembers,
    ReportsTwice,
    ReportsNothing,
    ReportsAnotherStep,
    StopsForAll,
    StopsThoseBehind,
    StopsThoseBefore,
}

impl BatchIntegrator for FaultyBatch {
    type Member = f64;
    type Workspace = u32;

    fn workspace(&self) -> u32 {
        0
    }

    fn advance(
        &self,
        members: &mut [f64],
        step: f64,
        steps: Range<u64>,
        calls: &mut u32,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        *calls += 1;
        let (count, largest) = (members.len(), members.iter().fold(0.0, |a: f64, b| a.max(*b)));
        if *self == Self::StopsForAll && members.iter().any(|x| !x.is_finite()) {
            return failed(members.iter().position(|x| !x.is_finite()).unwrap(), at(1, step));
        }
        let fails = members.iter().position(|x| !x.is_finite());
        for (place, x) in members.iter_mut().enumerate() {
            let stops = fails.is_some_and(|fails| match self {
                Self::StopsThoseBehind => place > fails,
                Self::StopsThoseBefore => place < fails,
                _ => false,
            });
            if stops {
                continue;
            }
            let little = match self {
                Self::CountsMembers => count as f64,
                Self::CountsPlaces => place as f64,
                Self::LooksAtNeighbours => largest,
                Self::Remembers => f64::from(*calls),
                _ => 0.0,
            };
            if x.is_finite() {
                steps.clone().for_each(|_| *x *= 1.0 + step * (1.0 + 1e-6 * little));
                continue;
            }
            match self {
                Self::ReportsNothing => {}
                Self::ReportsAnotherStep => failed(place, at(1 + count as u64, step)),
                _ => failed(place, at(1, step)),
            }
            if *self == Self::ReportsTwice {
                failed(place, at(1, step));
            }
        }
    }
}

/// Returns the error of the step with this number.
fn at(number: u64, step: f64) -> IntegrationError {
    IntegrationError::after(number - 1, step, StepError::NotFinite)
}

#[test]
fn laws_of_batches_reject_what_breaks_them() {
    let cases: [(FaultyBatch, &[&str]); 11] = [
        (FaultyBatch::None, &[]),
        (FaultyBatch::CountsMembers, &["number", "neighbours", "isolation"]),
        (FaultyBatch::CountsPlaces, &["place", "neighbours", "isolation"]),
        (FaultyBatch::LooksAtNeighbours, &["neighbours", "isolation", "resumption"]),
        (FaultyBatch::Remembers, &["resumption"]),
        (FaultyBatch::ReportsTwice, &["report"]),
        (FaultyBatch::ReportsNothing, &["report"]),
        (FaultyBatch::ReportsAnotherStep, &["report"]),
        (FaultyBatch::StopsForAll, &["isolation"]),
        (FaultyBatch::StopsThoseBehind, &["isolation"]),
        (FaultyBatch::StopsThoseBefore, &["isolation"]),
    ];
    for (batch, expected) in cases {
        let report = laws::batch(&batch, &[1.0, 0.5, -0.7], &f64::NAN, 1e-3).unwrap();
        let found = broken(&report);
        assert!(found.len() == expected.len(), "{batch:?}: {found:?}");
        assert!(expected.iter().all(|law| found.contains(law)), "{batch:?}: {found:?}");
    }
}

#[test]
fn no_samples_no_report() {
    let sound = FaultyIntegrator::None;
    assert!(laws::integrator(&sound, &[], STEP).is_err());
    assert!(laws::start(&sound, &[], STEP).is_err());
    assert!(laws::invariants(&sound, &[], STEP, &[&|z| z.x]).is_err());
    assert!(laws::invariants(&sound, &points(), STEP, &[]).is_err());
    assert!(laws::batch(&FaultyBatch::None, &[], &f64::NAN, STEP).is_err());
}
