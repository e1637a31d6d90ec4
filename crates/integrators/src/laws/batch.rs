//! The law suite of [`BatchIntegrator`].

use super::differences::{at_least_one, broken_unless};
use super::{Faulty, NoSamples, Report};
use crate::batch::batch_integrator::BatchIntegrator;
use crate::error::IntegrationError;
use crate::stages::checkpoints::CHECKPOINT;
use core::ops::Range;

/// Evaluates the laws of a batch integrator on samples of members, for one step size:
///
/// * `number`: the result of a member does not depend on the number of members;
/// * `place`: the result does not depend on the place among the members;
/// * `neighbours`: the result does not depend on the other members;
/// * `resumption`: calls that meet at a [`CHECKPOINT`] are together bit-identical to one call, with a used workspace or
///   a new one;
/// * `report`: a member that cannot be advanced is reported once, by its index, with the step that fails when it is
///   alone, and no other member is reported;
/// * `isolation`: a member that cannot be advanced changes no other member.
///
/// `failing` is a member that cannot be advanced, such as one that is not finite. All comparisons are exact, so that
/// the residuals are numbers of members and the tolerance is 0.
///
/// # Errors
/// Returns [`NoSamples`] if there are no samples.
///
/// # Example
/// ```
/// use collective_integrators::{Direct, Laned, RungeKutta, laws};
/// use lie_poisson::Vector;
/// let (field, z) = (laws::GenericSystem::field(), laws::GenericSystem::start::<f64>());
/// let gauss = Laned::new(Direct::new(RungeKutta::gauss(2)?, field));
/// let members = [z, z.scaled(0.5), -z];
/// laws::batch(&gauss, &members, &z.scaled(f64::NAN), 0.1)?.check(0.0)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn batch<B: BatchIntegrator>(
    batch: &B,
    members: &[B::Member],
    failing: &B::Member,
    step: f64,
) -> Result<Report, NoSamples>
where
    B::Member: PartialEq,
{
    at_least_one("members", members)?;
    let mut report = Report::default();
    let run = |group: &[B::Member]| advanced(batch, group, step, 0..STEPS);
    let ends: Vec<_> = members.iter().map(|member| copies(&run, member, &mut report)).collect();
    let cycled =
        |members: &[B::Member]| -> Vec<_> { members.iter().copied().cycle().take(GROUP).collect() };
    let (group, expected) = (cycled(members), cycled(&ends));
    let (after, _) = run(&group);
    report.note("neighbours", different(&after, &expected), 1.0);
    failures(&run, &group, (failing, &expected), &mut report);
    resumption(batch, members, step, &mut report);
    Ok(report)
}

/// The number of members side by side: more than fit in two registers, and not a multiple of their lanes.
const GROUP: usize = 19;

/// The number of steps of each member.
const STEPS: u64 = 20;

/// The members after some steps, with those that failed.
type Advanced<M> = (Vec<M>, Vec<(usize, IntegrationError)>);

/// Advances members by steps with a new workspace.
fn advanced<B: BatchIntegrator>(
    batch: &B,
    members: &[B::Member],
    step: f64,
    steps: Range<u64>,
) -> Advanced<B::Member> {
    let (mut members, mut failures) = (members.to_vec(), Vec::new());
    let mut failed = |index, error| failures.push((index, error));
    batch.advance(&mut members, step, steps, &mut batch.workspace(), &mut failed);
    (members, failures)
}

/// Returns the number of members that differ.
fn different<M: PartialEq>(a: &[M], b: &[M]) -> f64 {
    a.iter().zip(b).filter(|(a, b)| a != b).count() as f64
}

/// Advances groups of copies of one member, and returns the result of the member.
fn copies<M: Copy + PartialEq>(
    run: &dyn Fn(&[M]) -> Advanced<M>,
    member: &M,
    report: &mut Report,
) -> M {
    let alone = run(&[*member]).0[0];
    for count in 1..=GROUP {
        let (copies, failures) = run(&vec![*member; count]);
        report.note("number", broken_unless(copies[0] == alone), 1.0);
        report.note("place", different(&copies, &vec![copies[0]; count]), 1.0);
        report.note("report", failures.len() as f64, 1.0);
    }
    alone
}

fn failures<M: Copy + PartialEq>(
    run: &dyn Fn(&[M]) -> Advanced<M>,
    group: &[M],
    (failing, expected): (&M, &[M]),
    report: &mut Report,
) {
    let fails_at = match run(&[*failing]).1[..] {
        [(0, error)] => Some(error.step),
        _ => None,
    };
    report.note("report", broken_unless(fails_at.is_some()), 1.0);
    for place in 0..group.len() {
        let mut group = group.to_vec();
        group[place] = *failing;
        let (after, failures) = run(&group);
        let reported: Vec<_> =
            failures.iter().map(|(index, error)| (*index, Some(error.step))).collect();
        report.note("report", broken_unless(reported == [(place, fails_at)]), 1.0);
        let before = different(&after[..place], &expected[..place]);
        let behind = different(&after[place + 1..], &expected[place + 1..]);
        report.note("isolation", before + behind, 1.0);
    }
}

fn resumption<B: BatchIntegrator>(batch: &B, members: &[B::Member], step: f64, report: &mut Report)
where
    B::Member: PartialEq,
{
    let end = CHECKPOINT + STEPS;
    let (at_once, _) = advanced(batch, members, step, 0..end);
    let mut workspace = batch.workspace();
    let mut in_two = members.to_vec();
    batch.advance(&mut in_two, step, 0..CHECKPOINT, &mut workspace, &mut |_, _| {});
    let (renewed, _) = advanced(batch, &in_two, step, CHECKPOINT..end);
    batch.advance(&mut in_two, step, CHECKPOINT..end, &mut workspace, &mut |_, _| {});
    report.note("resumption", different(&in_two, &at_once), 1.0);
    report.note("resumption", different(&renewed, &at_once), 1.0);
}

/// The method [`advance`](BatchIntegrator::advance) may have a fault: it leaves the last member where it was, unless it
/// is the only one. The coordinate of the fault does not matter.
impl<B: BatchIntegrator> BatchIntegrator for Faulty<'_, B> {
    type Member = B::Member;
    type Workspace = B::Workspace;

    fn workspace(&self) -> B::Workspace {
        self.object().workspace()
    }

    fn advance(
        &self,
        members: &mut [B::Member],
        step: f64,
        steps: Range<u64>,
        workspace: &mut B::Workspace,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let left = usize::from(self.has_fault_in("advance") && members.len() > 1);
        let moved = members.len() - left;
        self.object().advance(&mut members[..moved], step, steps, workspace, failed);
    }
}
