//! Times every method over SIMD lanes (several trajectories in one register) against the same method over `f64`, top
//! by top, and fails if one is slower:
//!
//! ```text
//! cargo run --release -p measurements --bin lanes_pay
//! ```
//!
//! Every path runs once in each round, and its best time over the rounds counts. A machine with other work makes both
//! sides slower, and more rounds reduce its effect. Rounds are added until every path pays, [`MOST_ROUNDS`] at most.

use collective_integrators::{
    AlternatingSubsteps, BatchIntegrator, IntegrationError, Integrator, Laned, LiftFree,
    RungeKutta, Start, Substeps,
};
use heavytop::{
    CollectiveGauss, GaussBatch, HeavyTop, HeavyTopSpace, MidpointBatch, ReducedMidpoint,
    SymmetricTopBatch, SymmetricTopSplitting, TopMidpoint,
};
use lie_poisson::{
    Covector, Hamiltonian, InstructionSet, MissingInstructions, Pair, Real, Se3Dual, Width,
};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use std::error::Error;
use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// The ratio of the times over lanes and over `f64` from which on a path does not pay.
const MARGIN: f64 = 1.05;
/// The number of rounds before the first verdict.
const LEAST_ROUNDS: usize = 10;
/// The number of rounds after which the verdict is final.
const MOST_ROUNDS: usize = 40;
/// The number of members, which fills registers of every width.
const COUNT: u32 = 64;

/// A function that makes one run of a path.
type Run = Box<dyn FnMut() -> Result<(), IntegrationError>>;

/// A way to make the steps, with its best time so far.
struct Path {
    name: String,
    run: Run,
    best: Duration,
}

/// A method over `f64` and over lanes.
struct Method {
    name: String,
    single: Path,
    lanes: Vec<Path>,
}

impl Path {
    /// Creates a path that makes the same steps of the same members in each run.
    fn new<B>(name: String, batch: B, members: &[B::Member], step: f64, steps: u64) -> Self
    where
        B: BatchIntegrator<Member: 'static> + 'static,
    {
        let (members, mut workspace) = (members.to_vec(), batch.workspace());
        let run = move || {
            let (mut ends, mut failure) = (black_box(members.clone()), Ok(()));
            let mut failed = |_, error| failure = Err(error);
            batch.advance(&mut ends, step, 0..steps, &mut workspace, &mut failed);
            black_box(ends);
            failure
        };
        Self { name, run: Box::new(run), best: Duration::MAX }
    }

    /// Creates a path that makes the steps of one member after the other, over `f64`.
    fn one_by_one<I>(integrator: I, members: &[I::State], step: f64, steps: u64) -> Self
    where
        I: Integrator<f64, State: 'static, Workspace: 'static> + 'static,
    {
        let (members, mut workspace) = (members.to_vec(), integrator.workspace());
        let run = move || {
            let mut ends = black_box(members.clone());
            for end in &mut ends {
                integrator.advance(end, step, 0..steps, &mut workspace)?;
            }
            black_box(ends);
            Ok(())
        };
        Self { name: "f64".to_owned(), run: Box::new(run), best: Duration::MAX }
    }

    fn time(&mut self) -> Result<(), IntegrationError> {
        let clock = Instant::now();
        (self.run)()?;
        self.best = self.best.min(clock.elapsed());
        Ok(())
    }
}

impl Method {
    fn round(&mut self) -> Result<(), IntegrationError> {
        self.single.time()?;
        self.lanes.iter_mut().try_for_each(Path::time)
    }

    /// Returns the times of the paths over lanes, divided by that over `f64`.
    fn ratios(&self) -> impl Iterator<Item = (&Path, f64)> {
        let single = self.single.best.as_secs_f64();
        self.lanes.iter().map(move |path| (path, path.best.as_secs_f64() / single))
    }

    fn pays(&self) -> bool {
        self.ratios().all(|(_, ratio)| ratio <= MARGIN)
    }

    fn print(&self) {
        println!("{}: {:.2?} over f64", self.name, self.single.best);
        for (path, ratio) in self.ratios() {
            let verdict = if ratio <= MARGIN { "" } else { "  slower than f64" };
            println!("    {ratio:6.3}  {}{verdict}", path.name);
        }
    }
}

/// Returns a start near the paper's start.
fn start(i: u32) -> Se3Dual {
    let x = f64::from(i) / f64::from(COUNT) - 0.5;
    let vertical = Vector3::new(0.5 + 0.1 * x, 0.2 * x, 0.75_f64.sqrt()).normalize();
    Se3Dual::new(Vector3::new(2.0 + 0.2 * x, 3.0 - 0.1 * x, 4.0), vertical)
}

fn members<P: Copy>(parameters: P) -> Vec<(P, Se3Dual)> {
    (0..COUNT).map(|i| (parameters, start(i))).collect()
}

/// Returns a kernel that takes any lanes: on one lane, on one full register and on two.
fn kernel<B, E>(
    name: &str,
    on: impl Fn(InstructionSet, Width) -> Result<B, E>,
    members: &[B::Member],
    step: f64,
    steps: u64,
) -> Result<Method, E>
where
    B: BatchIntegrator<Member: 'static> + 'static,
{
    let path = |set: InstructionSet, width| {
        Ok(Path::new(format!("{set}, {width:?}"), on(set, width)?, members, step, steps))
    };
    let widths = [Width::Register, Width::TwoRegisters];
    let places = InstructionSet::available().flat_map(|set| widths.map(|width| (set, width)));
    Ok(Method {
        name: name.to_owned(),
        single: path(InstructionSet::Portable, Width::Single)?,
        lanes: places.map(|(set, width)| path(set, width)).collect::<Result<_, E>>()?,
    })
}

/// Returns the midpoint rule: top by top over `f64`, and for many tops with a choice of instructions alone.
fn midpoint(top: HeavyTop) -> Result<[Method; 2], Box<dyn Error>> {
    let (step, steps) = (0.01, 1000);
    let states: Vec<_> = (0..COUNT).map(start).collect();
    let rule = |set| TopMidpoint::new(top).with_instructions(set);
    let single = || -> Result<Path, Box<dyn Error>> {
        Ok(Path::one_by_one(rule(InstructionSet::Portable)?, &states, step, steps))
    };
    let mut one_system =
        Method { name: "TopMidpoint".to_owned(), single: single()?, lanes: vec![] };
    let mut sweep = Method { name: "MidpointBatch".to_owned(), single: single()?, lanes: vec![] };
    for set in InstructionSet::available() {
        let name = format!("{set}, {:?}", Width::TwoRegisters);
        one_system.lanes.push(Path::new(name.clone(), rule(set)?, &states, step, steps));
        let many = MidpointBatch::new().on(set, Width::TwoRegisters)?;
        sweep.lanes.push(Path::new(name, many, &members(top), step, steps));
    }
    Ok([one_system, sweep])
}

/// Returns the method for one top with its stages in the lanes, and the general integrator.
fn stages(top: HeavyTop) -> Result<Method, Box<dyn Error>> {
    let (step, steps) = (0.25, 1000);
    let gauss = CollectiveGauss::new(8, top)?;
    let state = [gauss.start(&start(0))?];
    let path = |set: InstructionSet| -> Result<Path, Box<dyn Error>> {
        let path = Path::one_by_one(gauss.clone().with_instructions(set)?, &state, step, steps);
        Ok(Path { name: set.to_string(), ..path })
    };
    Ok(Method {
        name: "CollectiveGauss, 8 stages, one top".to_owned(),
        single: Path::one_by_one(gauss.general().clone(), &state, step, steps),
        lanes: InstructionSet::available().map(path).collect::<Result<_, _>>()?,
    })
}

/// Returns a method without a kernel.
fn without_kernel<I>(
    name: &str,
    integrator: I,
    step: f64,
    steps: u64,
) -> Result<Method, MissingInstructions>
where
    I: Integrator<f64, State = Se3Dual> + Clone + Sync + 'static,
    Laned<I>: BatchIntegrator<Member = Se3Dual>,
{
    let states: Vec<_> = (0..COUNT).map(start).collect();
    let path = |set: InstructionSet| {
        let lanes = Laned::new(integrator.clone()).with_instructions(set)?;
        Ok(Path::new(set.to_string(), lanes, &states, step, steps))
    };
    Ok(Method {
        name: format!("Laned, {name}"),
        single: Path::one_by_one(integrator.clone(), &states, step, steps),
        lanes: InstructionSet::available().map(path).collect::<Result<_, _>>()?,
    })
}

/// A body in an ideal fluid, h(L, P) = ½L·AL + L·BP + ½P·CP with diagonal A, B, C, for which there is no kernel.
#[derive(Clone, Copy)]
struct FluidBody;

impl<T: Real> Hamiltonian<HeavyTopSpace, T> for FluidBody {
    fn value(&self, mu: &Se3Dual<T>) -> T {
        let (Pair(l, p), Pair(velocity, slip)) = (mu.0, self.differential(mu));
        (l.dot(&velocity) + p.dot(&slip)) * 0.5
    }

    fn differential(&self, Covector(Pair(l, p)): &Se3Dual<T>) -> Pair<Vector3<T>, Vector3<T>> {
        Pair(
            Vector3::new(l.x * 0.5 + p.x * 0.1, l.y * 0.4, l.z * 0.9 - p.z * 0.1),
            Vector3::new(l.x * 0.1 + p.x * 0.3, p.y * 0.6, p.z * 0.4 - l.z * 0.1),
        )
    }
}

/// Returns the negative control: a path that makes every step twice, which must fail.
fn control(top: HeavyTop) -> Result<Method, Box<dyn Error>> {
    let states: Vec<_> = (0..COUNT).map(start).collect();
    let path = |name: &str, steps| -> Result<Path, Box<dyn Error>> {
        let rule = TopMidpoint::new(top).with_instructions(InstructionSet::Portable)?;
        Ok(Path::new(name.to_owned(), rule, &states, 0.01, steps))
    };
    let lanes = vec![path("twice the steps", 2000)?];
    Ok(Method { name: "Control".to_owned(), single: path("once", 1000)?, lanes })
}

fn methods() -> Result<Vec<Method>, Box<dyn Error>> {
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    let gauss = GaussBatch::<8>::new()?;
    let substeps = AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10());
    let splitting = SymmetricTopBatch::new(substeps);
    let symmetric = members(SymmetricTopSplitting::new(top)?);
    let on = |set, width| gauss.clone().on(set, width);
    let mut methods = vec![kernel("GaussBatch, 8 stages", on, &members(top), 0.25, 40)?];
    let on = |set, width| splitting.clone().on(set, width);
    methods.push(kernel("SymmetricTopBatch, order 10", on, &symmetric, 0.125, 80)?);
    methods.extend(midpoint(top)?);
    methods.push(stages(top)?);
    let free = |scheme| LiftFree::new(scheme, DualQuaternions, top);
    let (four, one) = (free(RungeKutta::gauss(4)?), free(RungeKutta::implicit_midpoint()));
    methods.push(without_kernel("LiftFree, Gauss, 4 stages", four, 0.1, 20)?);
    methods.push(without_kernel("LiftFree, midpoint", one, 0.01, 200)?);
    methods.push(without_kernel("ReducedMidpoint", ReducedMidpoint::new(FluidBody), 0.01, 200)?);
    Ok(methods)
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut methods = methods()?;
    let mut control = control(HeavyTop::kovalevskaya(1.0, 1.0)?)?;
    let mut rounds = 0;
    while rounds < LEAST_ROUNDS || (rounds < MOST_ROUNDS && !methods.iter().all(Method::pays)) {
        methods.iter_mut().chain([&mut control]).try_for_each(Method::round)?;
        rounds += 1;
    }
    println!("Time in that of f64, the best of {rounds} rounds each; more than {MARGIN} fails.");
    methods.iter().for_each(Method::print);
    if control.pays() {
        control.print();
        return Err("twice the steps passed for as fast: these times mean nothing".into());
    }
    let all_pay = methods.iter().all(Method::pays);
    Ok(if all_pay { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
