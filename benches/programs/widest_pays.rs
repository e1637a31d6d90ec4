//! Times fields and maps as a stranger writes them, with nalgebra inside and no attribute anywhere, on the lanes that
//! every processor has and in the registers that `widest` chooses, and fails if these are slower:
//!
//! ```text
//! cargo run --release -p measurements --bin widest_pays
//! ```
//!
//! The best times of several rounds count. Rounds are added until every integrator pays, [`MOST_ROUNDS`] at most. Each line
//! has the ratio of the two times, the same ratio for the widest registers of the processor without a choice, and the
//! instruction set that was chosen. A top with friction or noise, in which nothing is by a stranger, has to pay in the widest
//! registers without a choice, too: otherwise something is called there that should have been inlined.

use collective_integrators::{
    BatchIntegrator, BrownianPaths, Collective, Direct, Driven, FieldInLanes, Integrator, Laned,
    Noisy, NoisyReduced, RungeKutta, StagesInLanes, Start, VectorField,
};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::{
    Automatic, Autonomous, Covector, DoubleBracket, Energy, InnerProduct, InstructionSet,
    IsotropicNoise, LieAlgebra, LieGroup, LiePoisson, MissingInstructions, Momentum, Pair,
    PathNumber, Real, RealSpace, Se3, Se3Dual, So3, Time,
};
use momentum_map::{Cotangent, DualQuaternions, GroupAction, HOPF, MomentumMap, PARTICLE, Side};
use nalgebra::{Complex, Matrix3, Vector2, Vector3};
use std::error::Error;
use std::hint::black_box;
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// The ratio of the times in wide registers and on the lanes of every processor from which on they do not pay.
const MARGIN: f64 = 1.05;
/// The number of rounds before the first verdict, and after which the verdict is final.
const LEAST_ROUNDS: usize = 10;
const MOST_ROUNDS: usize = 40;
/// The number of members of an ensemble, which fills registers of every width.
const COUNT: usize = 16;
/// The number of steps of a run.
const STEPS: u64 = 20;

/// A pendulum.
struct Pendulum;

impl<T: Real> VectorField<T> for Pendulum {
    type Point = Vector2<T>;
    fn at(&self, z: &Vector2<T>) -> Vector2<T> {
        Vector2::new(z.y, -z.x.sin())
    }
}

/// A free body with any axes: dΠ/dt = Π × A Π.
struct Body(Matrix3<f64>);

impl<T: Real> VectorField<T> for Body {
    type Point = Vector3<T>;
    fn at(&self, pi: &Vector3<T>) -> Vector3<T> {
        let omega = self.0.map(T::from_f64) * pi;
        pi.cross(&omega)
    }
}

/// The energy of a free body.
struct Kinetic(Matrix3<f64>);

impl Energy for Kinetic {
    type Space = LiePoisson<So3>;
    fn energy<T: Real>(&self, Covector(pi): &Momentum<So3, T>) -> T {
        let omega = self.0.map(T::from_f64) * pi;
        pi.dot(&omega) * 0.5
    }
}

/// The energy of a heavy top.
struct Top(Matrix3<f64>);

impl Energy for Top {
    type Space = LiePoisson<Se3>;
    fn energy<T: Real>(&self, Covector(Pair(pi, gamma)): &Momentum<Se3, T>) -> T {
        let omega = self.0.map(T::from_f64) * pi;
        pi.dot(&omega) * 0.5 + gamma.z
    }
}

/// The Poincaré group with one space dimension, of which only the action is known.
#[derive(Clone)]
struct Poincare;

impl LieAlgebra for Poincare {
    type Element<T: Real> = Vector3<T>;
    fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
        Vector3::new(T::zero(), xi.x * eta.z - eta.x * xi.z, xi.x * eta.y - eta.x * xi.y)
    }
}

fn boost<T: Real>(theta: T, v: Vector2<T>) -> Vector2<T> {
    let (cosh, sinh) = ((-theta * theta).stumpff(0), theta * (-theta * theta).stumpff(1));
    Vector2::new(v.x * cosh + v.y * sinh, v.x * sinh + v.y * cosh)
}

impl LieGroup for Poincare {
    type Algebra = Self;
    type Element<T: Real> = Vector3<T>;
    fn algebra(&self) -> Self {
        Poincare
    }
    fn identity<T: Real>(&self) -> Vector3<T> {
        Vector3::zeros()
    }
    fn compose<T: Real>(&self, g: &Vector3<T>, h: &Vector3<T>) -> Vector3<T> {
        let moved = boost(g.x, h.yz());
        Vector3::new(g.x + h.x, g.y + moved.x, g.z + moved.y)
    }
    fn inverse<T: Real>(&self, g: &Vector3<T>) -> Vector3<T> {
        let back = boost(-g.x, g.yz());
        Vector3::new(-g.x, -back.x, -back.y)
    }
    fn exp<T: Real>(&self, xi: &Vector3<T>) -> Vector3<T> {
        let x = -xi.x * xi.x;
        let (even, odd) = (x.stumpff(1), xi.x * x.stumpff(2));
        Vector3::new(xi.x, xi.y * even + xi.z * odd, xi.y * odd + xi.z * even)
    }
    fn adjoint<T: Real>(&self, g: &Vector3<T>, xi: &Vector3<T>) -> Vector3<T> {
        let moved = boost(g.x, xi.yz());
        Vector3::new(xi.x, moved.x - xi.x * g.z, moved.y - xi.x * g.y)
    }
}

impl GroupAction for Poincare {
    type Group = Self;
    type Space = RealSpace<2>;
    const SIDE: Side = Side::Right;
    fn group(&self) -> Self {
        Poincare
    }
    fn space(&self) -> RealSpace<2> {
        RealSpace
    }
    fn act<T: Real>(&self, g: &Vector3<T>, q: &Vector2<T>) -> Vector2<T> {
        boost(-g.x, q - g.yz())
    }
}

/// The energy of a relativistic rotor.
struct Rotor;

impl Energy for Rotor {
    type Space = LiePoisson<Poincare>;
    fn energy<T: Real>(&self, Covector(j): &Covector<Vector3<T>>) -> T {
        j.x * j.x * 0.5 + j.y * j.y + j.z * j.z * 0.5 + j.x * j.z * 0.3 + j.y
    }
}

/// An integrator on the lanes that every processor has, in the registers that `widest` chooses, and in the widest ones
/// without a choice.
struct Contest {
    name: String,
    /// The runs, which return the instruction set of their steps, and their best times so far.
    runs: [(Run, Duration); 3],
    /// The set that `widest` has chosen.
    chosen: InstructionSet,
    /// Whether nothing in it is by a stranger.
    is_own: bool,
}

/// A function that makes one run.
type Run = Box<dyn FnMut() -> InstructionSet>;

impl Contest {
    fn new(name: String, runs: [Run; 3]) -> Self {
        let runs = runs.map(|run| (run, Duration::MAX));
        Self { name, runs, chosen: InstructionSet::Portable, is_own: false }
    }

    fn round(&mut self) {
        let [_, chosen, _] = self.runs.each_mut().map(|(run, best)| {
            // The first run finds the caches as the one before it has left them.
            run();
            let clock = Instant::now();
            let set = run();
            *best = clock.elapsed().min(*best);
            set
        });
        self.chosen = chosen;
    }

    /// Returns the times in the registers that `widest` chooses and in the widest ones, divided by that on the lanes
    /// that every processor has.
    fn ratios(&self) -> [f64; 2] {
        let [narrow, chosen, widest] = self.runs.each_ref().map(|(_, best)| best.as_secs_f64());
        [chosen / narrow, widest / narrow]
    }

    fn pays(&self) -> bool {
        let [chosen, widest] = self.ratios();
        chosen <= MARGIN && (widest <= MARGIN || !self.is_own)
    }
}

/// Times the stages of one state side by side.
fn stages<I>(
    name: &str,
    make: impl Fn() -> I,
    start: &I::State,
    h: f64,
) -> Result<Contest, MissingInstructions>
where
    I: FieldInLanes<State: Clone + 'static, Workspace: 'static> + 'static,
{
    let widest = StagesInLanes::new(make()).with_instructions(InstructionSet::detected())?;
    let one = [StagesInLanes::new(make()), StagesInLanes::widest(make()), widest];
    let runs = one.map(|one| {
        let (start, mut workspace) = (start.clone(), one.workspace());
        let run = move || {
            let mut end = black_box(start.clone());
            for _ in 0..STEPS {
                if let Ok(made) = one.step(&end, h, &mut workspace) {
                    end = made.point;
                }
            }
            black_box(end);
            one.instructions()
        };
        Box::new(run) as Run
    });
    Ok(Contest::new(format!("{name}, stages side by side"), runs))
}

/// Times many states side by side.
fn members<I, M>(
    name: &str,
    make: impl Fn() -> I,
    start: &M,
    h: f64,
) -> Result<Contest, MissingInstructions>
where
    Laned<I>: BatchIntegrator<Member = M, Workspace: 'static> + 'static,
    M: Copy + 'static,
{
    let widest = Laned::new(make()).with_instructions(InstructionSet::detected())?;
    let many = [Laned::new(make()), Laned::widest(make()), widest];
    let runs = many.map(|many| {
        let (start, mut workspace) = ([*start; COUNT], many.workspace());
        let run = move || {
            let mut ends = black_box(start);
            many.advance(&mut ends, h, 0..STEPS, &mut workspace, &mut |_, _| ());
            black_box(ends);
            many.instructions()
        };
        Box::new(run) as Run
    });
    Ok(Contest::new(format!("{name}, members side by side"), runs))
}

fn contests() -> Result<Vec<Contest>, Box<dyn Error>> {
    let inverse = Matrix3::new(1.0, 0.1, 0.0, 0.1, 0.5, 0.05, 0.0, 0.05, 0.3);
    let (four, eight) = (RungeKutta::gauss(4)?, RungeKutta::gauss(8)?);
    let mut all = Vec::new();
    macro_rules! contest {
        ($name:literal, $start:expr, |$gauss:ident| $integrator:expr) => {
            for (gauss, h) in [(&four, 0.1), (&eight, 0.25)] {
                let make = || {
                    let $gauss = gauss.clone();
                    $integrator
                };
                let name = format!("{}, {} stages", $name, if h < 0.2 { 4 } else { 8 });
                all.push(stages(&name, make, &$start, h)?);
                all.push(members(&name, make, &$start, h)?);
            }
        };
    }
    contest!("pendulum", Vector2::new(1.0, 0.0), |gauss| Direct::new(gauss, Pendulum));
    contest!("body", Vector3::new(1.0, 0.5, -2.0), |gauss| Direct::new(gauss, Body(inverse)));
    let z = Vector2::new(Complex::new(1.0, 0.5), Complex::new(-2.0, 0.3));
    contest!("body by the Hopf map", z, |gauss| Collective::new(
        gauss,
        HOPF,
        Automatic(Kinetic(inverse))
    ));
    let z = Cotangent::new(Vector3::new(0.3, 1.0, 0.2), Covector(Vector3::new(0.5, 0.1, 0.8)));
    contest!("top by a particle", z, |gauss| Collective::new(
        gauss,
        PARTICLE,
        Automatic(Top(inverse))
    ));
    let z = Cotangent::new(Vector2::new(0.4, -0.2), Covector(Vector2::new(0.3, 0.8)));
    contest!("rotor by its action", z, |gauss| Collective::new(
        gauss,
        MomentumMap(Poincare),
        Automatic(Rotor)
    ));
    all.extend(open_systems()?.map(|contest| Contest { is_own: true, ..contest }));
    Ok(all)
}

/// A top with friction, and at a temperature by both rules.
fn open_systems() -> Result<[Contest; 3], Box<dyn Error>> {
    let (h, midpoint) = (0.05, RungeKutta::implicit_midpoint);
    let (top, paths) = (HeavyTop::kovalevskaya(1.0, 1.0)?, BrownianPaths::new(1, h)?);
    let product = InnerProduct::euclidean;
    let space = LiePoisson::minus(Se3::default());
    let damped = DoubleBracket::new(space, Autonomous(top), 0.1, product())?;
    let noise = IsotropicNoise::thermal(product(), (0.1, 0.5))?;
    let driven = || Driven::new(midpoint(), SpinorRealisation, damped.clone());
    let noisy = || Noisy::new(midpoint(), SpinorRealisation, damped.clone(), noise.clone(), paths);
    let reduced = || NoisyReduced::new(DualQuaternions, damped.clone(), noise.clone(), paths);
    let mu = Se3Dual::new(Vector3::new(2.0, 3.0, 1.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
    let (in_time, on_path) = (Pair(mu, Time(0.0)), Pair(mu, Pair(PathNumber(3.0), Time(0.0))));
    Ok([
        members("top with friction", driven, &driven().start(&in_time)?, h)?,
        members("top at a temperature", noisy, &noisy().start(&on_path)?, h)?,
        members("top at a temperature, without a lift", reduced, &on_path, h)?,
    ])
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut all = contests()?;
    for round in 0..MOST_ROUNDS {
        if round >= LEAST_ROUNDS && all.iter().all(Contest::pays) {
            break;
        }
        all.iter_mut().for_each(Contest::round);
    }
    println!("chosen  widest");
    for contest in &all {
        let ([chosen, widest], pays) = (contest.ratios(), contest.pays());
        let verdict = if pays { "" } else { ": slower" };
        println!("{chosen:6.3} {widest:7.3}  {}, {}{verdict}", contest.name, contest.chosen);
    }
    Ok(if all.iter().all(Contest::pays) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
