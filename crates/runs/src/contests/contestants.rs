//! The integrators that are timed.

use super::clock::{TimedRun, measure};
use super::problem::TimedProblem;
use crate::error::RunFailure;
use crate::models::top_in_axes::TopInAxes;
use collective_integrators::{
    AlternatingSubsteps, AnyIntegrator, AnyState, BatchIntegrator, Chunk, Collective, Ensemble,
    Integrator, Laned, LiftFree, RungeKutta, SchemeError, Splitting, StagesInLanes, Start,
    Substeps,
};
use heavytop::methods::{Formulation, Method, MethodError, SchemeName};
use heavytop::{
    GaussBatch, MidpointBatch, ReducedMidpoint, SpinorRealisation, SymmetricTopBatch,
    SymmetricTopSplitting, TopMidpoint,
};
use lie_poisson::{InstructionSet, Se3Dual};
use momentum_map::DualQuaternions;
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// The number of tops of an ensemble that the integrators for any system follow.
const FEW: usize = 1000;

/// The number of coordinates of (Π, Γ).
const DIMENSION: usize = 6;

/// The task of timing the integrators that suit a problem.
pub struct Contest<'a> {
    /// The tops and their references.
    pub problem: &'a TimedProblem,
    /// A part of the names of the integrators to time; `None` times all of them.
    pub only: Option<&'a str>,
    /// The names of the integrators that are not timed.
    pub others: &'a mut BTreeSet<String>,
    /// The function that receives each result.
    pub done: &'a mut dyn FnMut(TimedRun),
}

impl Contest<'_> {
    /// Times the integrators that suit the problem.
    ///
    /// # Errors
    /// If a step of an integrator fails.
    ///
    /// # Example
    /// The error of the classical Runge–Kutta method with steps of 0.01 s, after 20 s:
    /// ```
    /// use heavytop::HeavyTop;
    /// use lie_poisson::{InstructionSet, Se3Dual};
    /// use lie_poisson_runs::contests::{Contest, TimedProblem, TimedRun};
    /// use nalgebra::Vector3;
    /// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::z());
    /// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    /// let problem = TimedProblem::with_references(top, 20.0, vec![start])?;
    /// let (mut runs, mut others) = (Vec::new(), Default::default());
    /// let mut done = |run: TimedRun| runs.push(run);
    /// Contest { problem: &problem, only: Some("RK4"), others: &mut others, done: &mut done }.run()?;
    /// assert!(runs.len() == 1 && runs[0].steps == 2000);
    /// assert!(runs[0].relative_error_end > 1e-12 && runs[0].relative_error_end < 1e-5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run(&mut self) -> Result<(), RunFailure> {
        if self.problem.tops == 1 { one_top(self) } else { many_tops(self) }
    }

    fn wants(&mut self, name: &str) -> bool {
        let wanted = self.only.is_none_or(|part| name.contains(part));
        if !wanted {
            self.others.insert(name.into());
        }
        wanted
    }

    fn single(
        &mut self,
        name: &str,
        step: f64,
        integrator: &AnyIntegrator,
    ) -> Result<(), RunFailure> {
        if !self.wants(name) {
            return Ok(());
        }
        let problem = self.problem;
        let run = measure(name, step, problem, &mut |steps| {
            let mut state = integrator.start(&AnyState::of(&problem.start(0)))?;
            let mut workspace = Integrator::<f64>::workspace(integrator);
            integrator
                .advance(&mut state, step, 0..steps, &mut workspace)
                .map_err(|reason| RunFailure::Timed { name: name.to_owned(), reason })?;
            Ok(vec![TopInAxes::state(integrator.momentum(&state).as_slice())])
        })?;
        (self.done)(run);
        Ok(())
    }

    fn many<B: BatchIntegrator>(
        &mut self,
        name: &str,
        step: f64,
        integrator: B,
        member: impl Fn(Se3Dual) -> B::Member + Sync,
        state: impl Fn(&B::Member) -> Se3Dual + Sync,
    ) -> Result<(), RunFailure> {
        if !self.wants(name) {
            return Ok(());
        }
        let (problem, ensemble) = (self.problem, Ensemble::new(integrator));
        let run = measure(name, step, problem, &mut |steps| {
            let results = Mutex::new((problem.starts.clone(), None));
            let start = |index| member(problem.start(index));
            ensemble.stream(problem.tops, start, step, steps, |chunk: Chunk<'_, B::Member>| {
                let mut results = results.lock().unwrap_or_else(PoisonError::into_inner);
                let wanted = results.0.iter_mut().skip(chunk.first as usize);
                wanted.zip(chunk.members).for_each(|(mu, member)| *mu = state(member));
                results.1 = results.1.or(chunk.failures.first().copied());
            });
            let (states, failure) = results.into_inner().unwrap_or_else(PoisonError::into_inner);
            failure.map_or(Ok(states), |failure| {
                Err(RunFailure::Timed { name: name.to_owned(), reason: failure.source })
            })
        })?;
        (self.done)(run);
        Ok(())
    }
}

fn one_top(contest: &mut Contest<'_>) -> Result<(), RunFailure> {
    let top = contest.problem.top;
    for (stages, step) in [
        (8, 0.4),
        (8, 1.0 / 3.0),
        (8, 0.3125),
        (8, 10.0 / 33.0),
        (8, 2.0 / 7.0),
        (8, 0.25),
        (8, 0.2),
        (6, 0.125),
        (4, 0.0625),
        (4, 0.02),
    ] {
        let gauss = method(Formulation::Collective, SchemeName::Gauss(stages))?.integrator(&top)?;
        let name = format!("heavytop collective Gauss-{}", 2 * stages);
        contest.single(&name, step, &gauss)?;
    }
    // As a solver that stops its iteration early.
    for step in [0.4, 1.0 / 3.0, 0.3125, 0.25] {
        let early = Method::new(Formulation::Collective, SchemeName::Gauss(8), 5e-14)?;
        contest.single("heavytop Gauss-16 to 5e-14", step, &early.integrator(&top)?)?;
    }
    if let Ok(flows) = SymmetricTopSplitting::new(top) {
        for (name, step, substeps) in splittings() {
            let name = format!("heavytop {name}, one top");
            let splitting = Splitting::alternating(flows, substeps);
            contest.single(&name, step, &AnyIntegrator::new(splitting, DIMENSION))?;
        }
    }
    let midpoint = method(Formulation::Reduced, SchemeName::ImplicitMidpoint)?;
    contest.single("heavytop lift-free midpoint", 0.01, &midpoint.integrator(&top)?)?;

    // What has tangent maps is no kernel.
    let gauss = method(Formulation::Collective, SchemeName::Gauss(8))?.tangent_integrator(&top)?;
    let name = "heavytop any system: Gauss-16, one stage at a time";
    contest.single(name, 0.25, &gauss.without_tangents())?;
    let gauss = RungeKutta::gauss(8).map_err(refused)?;
    let side_by_side = StagesInLanes::new(Collective::new(gauss, SpinorRealisation, top));
    let widest = InstructionSet::detected();
    let side_by_side = side_by_side.with_instructions(widest).map_err(MethodError::from)?;
    let integrator = AnyIntegrator::new(side_by_side.clone(), DIMENSION);
    contest.single("heavytop any system: Gauss-16", 0.25, &integrator)?;
    let compensated = AnyIntegrator::new(side_by_side.compensated(), DIMENSION);
    contest.single("heavytop any system: Gauss-16, compensated", 0.25, &compensated)?;
    let general = midpoint.tangent_integrator(&top)?.without_tangents();
    contest.single("heavytop any system: lift-free midpoint", 0.01, &general)?;
    let closed = AnyIntegrator::new(ReducedMidpoint::new(top), DIMENSION);
    contest.single("heavytop any Hamiltonian: midpoint", 0.01, &closed)?;
    let direct = method(Formulation::Direct, SchemeName::Rk4)?.integrator(&top)?;
    contest.single("heavytop any system: RK4, direct", 0.01, &direct)?;
    Ok(())
}

fn many_tops(contest: &mut Contest<'_>) -> Result<(), RunFailure> {
    let top = contest.problem.top;
    for step in [0.4, 1.0 / 3.0, 0.25] {
        let gauss = GaussBatch::<8>::new().map_err(refused)?;
        let member = |mu| (top, mu);
        contest.many("heavytop Gauss-16", step, gauss, member, |(_, mu)| *mu)?;
    }
    if let Ok(flows) = SymmetricTopSplitting::new(top) {
        for (name, step, substeps) in splittings() {
            let splitting = SymmetricTopBatch::new(substeps);
            let (name, member) = (format!("heavytop {name}"), |mu| (flows, mu));
            contest.many(&name, step, splitting, member, |(_, mu)| *mu)?;
        }
    }
    let (name, midpoint) = ("heavytop lift-free midpoint", TopMidpoint::new(top));
    contest.many(name, 0.01, midpoint, |mu| mu, |mu| *mu)?;
    let (name, sweep) = ("heavytop lift-free midpoint, separate parameters", MidpointBatch::new());
    contest.many(name, 0.01, sweep, |mu| (top, mu), |(_, mu)| *mu)?;

    // These integrators are much slower. The time for a top does not depend on the number of tops.
    let few = contest.problem.first(FEW);
    let Contest { only, others, done, .. } = contest;
    let mut contest = Contest { problem: &few, only: *only, others, done: &mut **done };
    let gauss = RungeKutta::gauss(8).map_err(refused)?;
    let general = Laned::widest(LiftFree::new(gauss, DualQuaternions, top));
    let name = "heavytop any system: Gauss-16";
    contest.many(name, 1.0 / 3.0, general, |mu| mu, |mu| *mu)?;
    let midpoint = LiftFree::new(RungeKutta::implicit_midpoint(), DualQuaternions, top);
    let (name, general) = ("heavytop any system: lift-free midpoint", Laned::widest(midpoint));
    contest.many(name, 0.01, general, |mu| mu, |mu| *mu)?;
    let closed = Laned::widest(ReducedMidpoint::new(top));
    contest.many("heavytop any Hamiltonian: midpoint", 0.01, closed, |mu| mu, |mu| *mu)?;
    Ok(())
}

/// Returns the splittings of symmetric tops into drift and kick, with steps that divide 10 s.
fn splittings() -> [(&'static str, f64, AlternatingSubsteps); 8] {
    let sofroniou = AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10());
    let (six, four) = (AlternatingSubsteps::blanes_moan6(), AlternatingSubsteps::blanes_moan4());
    [
        ("splitting of order 10", 10.0 / 75.0, sofroniou.clone()),
        ("splitting of order 10", 10.0 / 76.0, sofroniou.clone()),
        ("splitting of order 10", 0.125, sofroniou),
        ("splitting of order 6", 0.25, six.clone()),
        ("splitting of order 6", 10.0 / 44.0, six.clone()),
        ("splitting of order 6", 0.2, six),
        ("splitting of order 4", 0.2, four.clone()),
        ("splitting of order 4", 0.05, four),
    ]
}

/// Returns the method of a formulation and a scheme, whose stages are solved to the round-off floor.
fn method(formulation: Formulation, scheme: SchemeName) -> Result<Method, MethodError> {
    Method::new(formulation, scheme, 0.0)
}

fn refused(reason: SchemeError) -> RunFailure {
    MethodError::Scheme { scheme: SchemeName::Gauss(8), reason }.into()
}
