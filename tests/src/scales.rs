//! Every method for tops, by name, and one top in any units.

use collective_integrators::{
    AlternatingSubsteps, BatchIntegrator, Collective, Composition, Direct, Equivariant, FirstHalf,
    HamiltonianField, LiftFree, PartitionedRungeKutta, RungeKutta, SchemeError, Splitting, Start,
    Substeps,
};
use heavytop::{
    Body, CollectiveGauss, GaussBatch, HeavyTop, HeavyTopSpace, MidpointBatch, ReducedMidpoint,
    RotorSplitting, SpinorRealisation, SymmetricTopBatch, SymmetricTopSplitting, TopError,
    TopMidpoint,
};
use lie_poisson::{Covector, Differential, Hamiltonian, LiePoisson, Pair, Se3, Se3Dual, larger};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

/// Units of mass, length and time, and of Γ, which a user may give any length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// The unit of mass.
    pub mass: f64,
    /// The unit of length.
    pub length: f64,
    /// The unit of time.
    pub time: f64,
    /// The unit of Γ.
    pub vertical: f64,
}

impl Units {
    /// The units in which the numbers are those of a top of some kilograms.
    pub const ONE: Self = Self { mass: 1.0, length: 1.0, time: 1.0, vertical: 1.0 };

    /// The sizes of units that are tried.
    pub const SIZES: [f64; 6] = [1e-30, 1e-15, 1e-6, 1e6, 1e15, 1e30];

    /// Returns each unit of each size alone, and units of which several are far from 1.
    pub fn all() -> impl Iterator<Item = Self> {
        Self::SIZES.into_iter().flat_map(|s| {
            [
                Self { mass: s, ..Self::ONE },
                Self { length: s, ..Self::ONE },
                Self { time: s, ..Self::ONE },
                Self { vertical: s, ..Self::ONE },
                Self { mass: s, time: s.recip(), ..Self::ONE },
                Self { mass: s, length: s.recip(), vertical: s, ..Self::ONE },
            ]
        })
    }

    /// Returns the unit of Π.
    #[must_use]
    pub fn momentum(self) -> f64 {
        self.mass * self.length * self.length / self.time
    }

    /// Returns the unit of energy.
    #[must_use]
    pub fn energy(self) -> f64 {
        self.momentum() / self.time
    }
}

/// Returns a top and a state of it, with Π in units of s and Γ in units of λ: [`in_units`] with s as the unit of mass.
///
/// # Errors
/// If s or λ is not a positive number.
pub fn scaled(symmetric: bool, s: f64, lambda: f64) -> Result<(HeavyTop, Se3Dual), TopError> {
    in_units(symmetric, Units { mass: s, vertical: lambda, ..Units::ONE })
}

/// Returns a top and a state of it in units. In all of them it moves as before.
///
/// With `symmetric` it is a Lagrange top, else it has no symmetry.
///
/// # Errors
/// If a unit is not a positive number.
pub fn in_units(symmetric: bool, units: Units) -> Result<(HeavyTop, Se3Dual), TopError> {
    let Units { mass, length, time, vertical } = units;
    let (inertia, axis) = if symmetric {
        (Vector3::new(1.4, 1.4, 0.6), Vector3::z())
    } else {
        (Vector3::new(1.0, 1.4, 2.1), Vector3::new(2.0, -3.0, 6.0) / 7.0)
    };
    let top = HeavyTop::new(&Body {
        inertia: inertia * (mass * length * length),
        mass: 0.7 * mass / vertical,
        gravity: 9.81 * length / time / time,
        length: 0.2 * length,
        center_of_mass: axis,
    })?;
    let (pi, gamma) = (Vector3::new(1.2, -0.7, 2.3), Vector3::new(2.0, 6.0, -3.0) / 7.0);
    Ok((top, Se3Dual::new(pi * units.momentum(), gamma * vertical)))
}

/// The result of a run: its last momentum, iterations and deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// The momentum after the last step.
    pub last: Se3Dual,
    /// The number of iterations of all steps; 0 for many tops at once, which do not report it.
    pub iterations: usize,
    /// The largest |Δf₁|/|Γ|², |Δf₂|/(|Π||Γ|) and |Δh|/(|Π|²/min I + |γ||Γ|) over all steps, with Π and Γ at the start.
    pub deviations: [f64; 3],
}

/// A method by name, with the function that runs it.
pub struct Method {
    /// The formulation and the scheme.
    pub name: String,
    /// Whether its steps are Poisson maps, so that they conserve the Casimirs to round-off.
    pub is_poisson: bool,
    /// The function that makes a number of steps.
    pub run: Run,
}

/// A function that runs a top from a state, with a step size and a number of steps; `None` if a step fails.
pub type Run = Box<dyn Fn(&HeavyTop, &Se3Dual, f64, usize) -> Option<Outcome>>;

/// Returns every formulation with every scheme, and every fast path; those for symmetric tops if asked for.
///
/// # Errors
/// There is none with these coefficients.
pub fn methods(symmetric: bool) -> Result<Vec<Method>, SchemeError> {
    let mut list = Vec::new();
    equivariant("implicit midpoint", RungeKutta::implicit_midpoint(), &mut list);
    for stages in [2, 3, 4, 5, 6, 8] {
        let name = format!("Gauss {}", 2 * stages);
        equivariant(&name, RungeKutta::gauss(stages)?, &mut list);
    }
    equivariant("explicit midpoint", RungeKutta::explicit_midpoint(), &mut list);
    equivariant("RK4", RungeKutta::rk4(), &mut list);
    equivariant("DOP853", RungeKutta::dop853(), &mut list);
    equivariant("Qin–Zhang", RungeKutta::qin_zhang(), &mut list);
    for (name, substeps) in substeps()? {
        let midpoint = RungeKutta::implicit_midpoint();
        equivariant(name, Composition::new(midpoint, substeps), &mut list);
    }
    let euler = PartitionedRungeKutta::symplectic_euler_implicit_in_p();
    partitioned("symplectic Euler", euler, &mut list);
    partitioned("Störmer–Verlet", PartitionedRungeKutta::kick_drift_kick(), &mut list);
    let lobatto = PartitionedRungeKutta::lobatto_iiia_iiib(3)?;
    partitioned("Lobatto IIIA–IIIB, 3 stages", lobatto, &mut list);
    fast_paths(&mut list);
    splittings(symmetric, &mut list)?;
    Ok(list)
}

/// Parts of the names of methods whose steps are not Poisson maps: of those on the six equations, of explicit methods, and
/// of pairs of methods, which do not descend.
const NOT_POISSON: [&str; 7] = [
    "direct",
    "explicit midpoint",
    "RK4",
    "DOP853",
    "symplectic Euler",
    "Störmer–Verlet",
    "Lobatto IIIA–IIIB",
];

fn add(
    list: &mut Vec<Method>,
    name: impl Into<String>,
    run: impl Fn(&HeavyTop, &Se3Dual, f64, usize) -> Option<Outcome> + 'static,
) {
    let name = name.into();
    let is_poisson = !NOT_POISSON.iter().any(|part| name.contains(part));
    list.push(Method { name, is_poisson, run: Box::new(run) });
}

/// The largest deviations seen so far.
struct Watch {
    start: [f64; 3],
    units: [f64; 3],
    largest: [f64; 3],
}

fn values(top: &HeavyTop, mu: &Se3Dual) -> [f64; 3] {
    let Covector(Pair(pi, gamma)) = mu;
    [gamma.norm_squared(), pi.dot(gamma), top.value(mu)]
}

impl Watch {
    fn new(top: &HeavyTop, mu: &Se3Dual) -> Self {
        let Covector(Pair(pi, gamma)) = mu;
        let (pi, gamma) = (pi.norm(), gamma.norm());
        let energy = pi * (pi / top.inertia().min()) + top.weight_moment() * gamma;
        let units = [gamma * gamma, pi * gamma, energy];
        Self { start: values(top, mu), units, largest: [0.0; 3] }
    }

    fn see(&mut self, top: &HeavyTop, mu: &Se3Dual) {
        let now = values(top, mu);
        for (i, most) in self.largest.iter_mut().enumerate() {
            *most = larger(*most, (now[i] - self.start[i]).abs() / self.units[i]);
        }
    }
}

fn run<I: Start<Momentum = Se3Dual>>(
    integrator: &I,
    top: &HeavyTop,
    mu: &Se3Dual,
    step: f64,
    steps: usize,
) -> Option<Outcome> {
    let (mut watch, mut last, mut iterations) = (Watch::new(top, mu), *mu, 0);
    for sample in integrator.trajectory(mu, step).ok()?.take(steps + 1) {
        let sample = sample.ok()?;
        watch.see(top, &sample.momentum);
        (last, iterations) = (sample.momentum, iterations + sample.iterations);
    }
    Some(Outcome { last, iterations, deviations: watch.largest })
}

/// Runs many equal tops at once: enough to fill several registers and a part of one.
fn run_many<B: BatchIntegrator>(
    integrator: &B,
    member: B::Member,
    momentum: impl Fn(&B::Member) -> Se3Dual,
    top: &HeavyTop,
    step: f64,
    steps: usize,
) -> Option<Outcome>
where
    B::Member: Copy,
{
    let (mut members, mut failed) = ([member; 19], false);
    let mut watch = Watch::new(top, &momentum(&member));
    let mut fail = |_, _| failed = true;
    let mut workspace = integrator.workspace();
    integrator.advance(&mut members, step, 0..steps as u64, &mut workspace, &mut fail);
    let last = momentum(&members[18]);
    watch.see(top, &last);
    (!failed).then_some(Outcome { last, iterations: 0, deviations: watch.largest })
}

/// A top without second derivatives that no integrator can recognise as a top.
#[derive(Clone, Copy)]
struct Unknown(HeavyTop);

impl Hamiltonian<HeavyTopSpace> for Unknown {
    fn value(&self, mu: &Se3Dual) -> f64 {
        self.0.value(mu)
    }

    fn differential(&self, mu: &Se3Dual) -> Differential<HeavyTopSpace> {
        self.0.differential(mu)
    }
}

/// Adds every formulation that takes a Runge–Kutta method or a composition of such methods.
fn equivariant<S: Equivariant + 'static>(name: &str, scheme: S, list: &mut Vec<Method>) {
    let of = scheme.clone();
    add(list, format!("collective {name}"), move |top, mu, h, n| {
        run(&Collective::new(of.clone(), SpinorRealisation, *top), top, mu, h, n)
    });
    let of = scheme.clone();
    add(list, format!("collective {name}, compensated"), move |top, mu, h, n| {
        run(&Collective::new(of.clone(), SpinorRealisation, *top).compensated(), top, mu, h, n)
    });
    let of = scheme.clone();
    add(list, format!("collective {name}, unknown derivatives"), move |top, mu, h, n| {
        run(&Collective::new(of.clone(), SpinorRealisation, Unknown(*top)), top, mu, h, n)
    });
    let of = scheme.clone();
    add(list, format!("reduced {name}"), move |top, mu, h, n| {
        run(&LiftFree::new(of.clone(), DualQuaternions, *top), top, mu, h, n)
    });
    let of = scheme.clone();
    add(list, format!("reduced {name}, compensated"), move |top, mu, h, n| {
        run(&LiftFree::new(of.clone(), DualQuaternions, *top).compensated(), top, mu, h, n)
    });
    add(list, format!("direct {name}"), move |top, mu, h, n| {
        let space = LiePoisson::minus(Se3::default());
        let field = HamiltonianField { space, hamiltonian: *top };
        run(&Direct::new(scheme.clone(), field), top, mu, h, n)
    });
}

fn partitioned(name: &str, scheme: PartitionedRungeKutta<FirstHalf>, list: &mut Vec<Method>) {
    add(list, format!("collective {name}"), move |top, mu, h, n| {
        let scheme = scheme.clone();
        let map = SpinorRealisation;
        run(&Collective::that_does_not_descend(scheme, map, *top), top, mu, h, n)
    });
}

fn substeps() -> Result<Vec<(&'static str, Substeps)>, SchemeError> {
    Ok(vec![
        ("Strang", Substeps::new(&[1.0])?),
        ("Yoshida 4", Substeps::yoshida4()),
        ("Suzuki 4", Substeps::suzuki4()),
        ("Yoshida 6", Substeps::yoshida6()),
        ("Kahan–Li 6", Substeps::kahan_li6()),
        ("Kahan–Li 8", Substeps::kahan_li8()),
    ])
}

/// Adds the integrators that are made for tops.
fn fast_paths(list: &mut Vec<Method>) {
    for stages in 1..=8 {
        add(list, format!("CollectiveGauss, {stages} stages"), move |top, mu, h, n| {
            run(&CollectiveGauss::new(stages, *top).ok()?, top, mu, h, n)
        });
    }
    add(list, "TopMidpoint", |top, mu, h, n| run(&TopMidpoint::new(*top), top, mu, h, n));
    add(list, "ReducedMidpoint", |top, mu, h, n| {
        run(&ReducedMidpoint::new(Unknown(*top)), top, mu, h, n)
    });
    add(list, "MidpointBatch", |top, mu, h, n| {
        run_many(&MidpointBatch::new(), (*top, *mu), |m| m.1, top, h, n)
    });
    add(list, "GaussBatch, 3 stages", |top, mu, h, n| {
        run_many(&GaussBatch::<3>::new().ok()?, (*top, *mu), |m| m.1, top, h, n)
    });
    add(list, "GaussBatch, 8 stages", |top, mu, h, n| {
        run_many(&GaussBatch::<8>::new().ok()?, (*top, *mu), |m| m.1, top, h, n)
    });
}

fn splittings(symmetric: bool, list: &mut Vec<Method>) -> Result<(), SchemeError> {
    for (name, substeps) in substeps()? {
        let of = substeps.clone();
        add(list, format!("splitting, rotors, {name}"), move |top, mu, h, n| {
            let strang = Splitting::strang(RotorSplitting(*top));
            run(&Composition::new(strang, of.clone()), top, mu, h, n)
        });
        if symmetric {
            add(list, format!("splitting, symmetric top, {name}"), move |top, mu, h, n| {
                let strang = Splitting::strang(SymmetricTopSplitting::new(*top).ok()?);
                run(&Composition::new(strang, substeps.clone()), top, mu, h, n)
            });
        }
    }
    if symmetric {
        add(list, "SymmetricTopBatch", |top, mu, h, n| {
            let substeps = AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10());
            let member = (SymmetricTopSplitting::new(*top).ok()?, *mu);
            run_many(&SymmetricTopBatch::new(substeps), member, |m| m.1, top, h, n)
        });
    }
    Ok(())
}
