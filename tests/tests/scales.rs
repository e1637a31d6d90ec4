//! No result depends on the units of mass, length and time.
//!
//! A top with the moments I and the weight moment mgl multiplied by s moves as before, with Π multiplied by s. A
//! vertical Γ of length λ with mgl divided by λ moves as before, too. Where s is a power of two and λ one of four, these
//! factors pass through products, sums and square roots without rounding. A method that compares numbers of one unit
//! only must therefore find the same bits.
#![allow(clippy::unwrap_used)]

use collective_integrators::{
    AlternatingSubsteps, BatchIntegrator, Collective, Composition, Direct, Equivariant, FirstHalf,
    HamiltonianField, LiftFree, PartitionedRungeKutta, RungeKutta, Splitting, Start, Substeps,
};
use heavytop::{
    Body, CollectiveGauss, GaussEnsemble, HeavyTop, HeavyTopSpace, MidpointSweep, ReducedMidpoint,
    RotorSplitting, SpinorRealisation, SymmetricTopEnsemble, SymmetricTopSplitting,
};
use lie_poisson::{Covector, Differential, Hamiltonian, LiePoisson, Pair, Se3, Se3Dual};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;

/// Binary exponents of s and λ. 2¹⁰⁰ = 1.3e30.
const SCALES: [(i32, i32); 8] =
    [(100, 0), (-100, 0), (0, 100), (0, -100), (-27, 0), (-40, 100), (100, -100), (-100, 100)];

/// What a run of some steps of a size comes to: the last momentum and the iterations of all steps, or nothing
/// where a step fails.
type Outcome = Option<(Se3Dual, usize)>;

/// A run of a method for a top.
type Run = Box<dyn Fn(&HeavyTop, &Se3Dual, f64) -> Outcome>;

/// The top with moments s I and weight moment (s/λ) mgl.
fn scaled_top(symmetric: bool, s: f64, lambda: f64) -> HeavyTop {
    let inertia = if symmetric { Vector3::new(1.4, 1.4, 0.6) } else { Vector3::new(1.0, 1.4, 2.1) };
    let axis = if symmetric { Vector3::z() } else { Vector3::new(2.0, -3.0, 6.0) / 7.0 };
    HeavyTop::new(&Body {
        inertia: inertia * s,
        mass: 0.7 * s / lambda,
        gravity: 9.81,
        length: 0.2,
        center_of_mass: axis,
    })
    .unwrap()
}

fn scaled_state(s: f64, lambda: f64) -> Se3Dual {
    let (pi, gamma) = (Vector3::new(1.2, -0.7, 2.3), Vector3::new(2.0, 6.0, -3.0) / 7.0);
    Se3Dual::new(pi * s, gamma * lambda)
}

const STEPS: usize = 40;

fn run<I: Start<Momentum = Se3Dual>>(integrator: &I, start: &Se3Dual, step: f64) -> Outcome {
    let mut outcome = (*start, 0);
    for sample in integrator.trajectory(start, step).ok()?.take(STEPS + 1) {
        let sample = sample.ok()?;
        outcome = (sample.momentum, outcome.1 + sample.iterations);
    }
    Some(outcome)
}

/// A top whose kind no integrator can see; without second derivatives if `Q` is true.
#[derive(Clone, Copy)]
struct Hidden<const Q: bool>(HeavyTop);

impl<const Q: bool> Hamiltonian<HeavyTopSpace> for Hidden<Q> {
    fn value(&self, mu: &Se3Dual) -> f64 {
        self.0.value(mu)
    }

    fn differential(&self, mu: &Se3Dual) -> Differential<HeavyTopSpace> {
        self.0.differential(mu)
    }

    fn hessian(&self, mu: &Se3Dual, v: &Se3Dual) -> Option<Differential<HeavyTopSpace>> {
        if Q { None } else { Hamiltonian::<HeavyTopSpace>::hessian(&self.0, mu, v) }
    }
}

/// Every formulation that takes a Runge–Kutta method or a composition of them.
fn equivariant<S: Equivariant + Send + 'static>(
    name: &str,
    scheme: S,
    runs: &mut Vec<(String, Run)>,
) {
    let mut add = |formulation: &str, run: Run| runs.push((format!("{formulation} {name}"), run));
    let of = scheme.clone();
    add(
        "collective",
        Box::new(move |top, mu, h| {
            run(&Collective::new(of.clone(), SpinorRealisation, *top), mu, h)
        }),
    );
    let of = scheme.clone();
    add(
        "collective, compensated",
        Box::new(move |top, mu, h| {
            run(&Collective::new(of.clone(), SpinorRealisation, *top).compensated(), mu, h)
        }),
    );
    let of = scheme.clone();
    add(
        "collective, by difference quotients",
        Box::new(move |top, mu, h| {
            run(&Collective::new(of.clone(), SpinorRealisation, Hidden::<true>(*top)), mu, h)
        }),
    );
    let of = scheme.clone();
    add(
        "reduced",
        Box::new(move |top, mu, h| run(&LiftFree::new(of.clone(), DualQuaternions, *top), mu, h)),
    );
    let of = scheme.clone();
    add(
        "reduced, compensated",
        Box::new(move |top, mu, h| {
            run(&LiftFree::new(of.clone(), DualQuaternions, *top).compensated(), mu, h)
        }),
    );
    add(
        "direct",
        Box::new(move |top, mu, h| run(&Direct::new(scheme.clone(), direct_field(top)), mu, h)),
    );
}

fn direct_field(top: &HeavyTop) -> HamiltonianField<LiePoisson<Se3>, HeavyTop> {
    HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: *top }
}

fn partitioned(
    name: &str,
    scheme: PartitionedRungeKutta<FirstHalf>,
    runs: &mut Vec<(String, Run)>,
) {
    let run: Run = Box::new(move |top, mu, h| {
        run(&Collective::that_does_not_descend(scheme.clone(), SpinorRealisation, *top), mu, h)
    });
    runs.push((format!("collective {name}"), run));
}

/// Many tops at once: one of them, and as many of its neighbours as fill the lanes.
fn batch<B: BatchIntegrator<Member = (HeavyTop, Se3Dual)>>(
    integrator: &B,
    top: &HeavyTop,
    mu: &Se3Dual,
    h: f64,
) -> Outcome {
    let mut members = [(*top, *mu); 11];
    let mut failed = false;
    let mut fail = |_, _| failed = true;
    integrator.advance(&mut members, h, 0..STEPS as u64, &mut integrator.workspace(), &mut fail);
    (!failed).then_some((members[10].1, 0))
}

fn methods(symmetric: bool) -> Vec<(String, Run)> {
    let mut runs = Vec::new();
    equivariant("implicit midpoint", RungeKutta::implicit_midpoint(), &mut runs);
    for stages in [2, 3, 4, 5, 6, 8] {
        let gauss = RungeKutta::gauss(stages).unwrap();
        equivariant(&format!("Gauss-{}", 2 * stages), gauss, &mut runs);
    }
    equivariant("explicit midpoint", RungeKutta::explicit_midpoint(), &mut runs);
    equivariant("RK4", RungeKutta::rk4(), &mut runs);
    equivariant("DOP853", RungeKutta::dop853(), &mut runs);
    equivariant("Qin–Zhang", RungeKutta::qin_zhang(), &mut runs);
    for (name, substeps) in substeps() {
        let midpoint = RungeKutta::implicit_midpoint();
        equivariant(name, Composition::new(midpoint, substeps), &mut runs);
    }
    let euler = PartitionedRungeKutta::symplectic_euler_implicit_in_p();
    partitioned("symplectic Euler", euler, &mut runs);
    partitioned("Störmer–Verlet", PartitionedRungeKutta::kick_drift_kick(), &mut runs);
    let lobatto = PartitionedRungeKutta::lobatto_iiia_iiib(3).unwrap();
    partitioned("Lobatto IIIA–IIIB", lobatto, &mut runs);
    fast_paths(&mut runs);
    splittings(symmetric, &mut runs);
    runs
}

fn substeps() -> Vec<(&'static str, Substeps)> {
    vec![
        ("Strang", Substeps::new(&[1.0]).unwrap()),
        ("Yoshida-4", Substeps::yoshida4()),
        ("Suzuki-4", Substeps::suzuki4()),
        ("Yoshida-6", Substeps::yoshida6()),
        ("Kahan–Li-6", Substeps::kahan_li6()),
        ("Kahan–Li-8", Substeps::kahan_li8()),
    ]
}

/// The integrators that are made for tops.
fn fast_paths(runs: &mut Vec<(String, Run)>) {
    let mut add = |name: String, run: Run| runs.push((name, run));
    for stages in [1, 2, 3, 4, 5, 6, 7, 8, 9] {
        add(
            format!("CollectiveGauss, {stages} stages"),
            Box::new(move |top, mu, h| run(&CollectiveGauss::new(stages, *top).unwrap(), mu, h)),
        );
    }
    add("ReducedMidpoint".into(), Box::new(|top, mu, h| run(&ReducedMidpoint::new(*top), mu, h)));
    add(
        "ReducedMidpoint of any system".into(),
        Box::new(|top, mu, h| run(&ReducedMidpoint::new(Hidden::<false>(*top)), mu, h)),
    );
    add("MidpointSweep".into(), Box::new(|top, mu, h| batch(&MidpointSweep::new(), top, mu, h)));
    add(
        "GaussEnsemble, 3 stages".into(),
        Box::new(|top, mu, h| batch(&GaussEnsemble::<3>::new().unwrap(), top, mu, h)),
    );
    add(
        "GaussEnsemble, 8 stages".into(),
        Box::new(|top, mu, h| batch(&GaussEnsemble::<8>::new().unwrap(), top, mu, h)),
    );
}

fn splittings(symmetric: bool, runs: &mut Vec<(String, Run)>) {
    for (name, substeps) in substeps() {
        let of = substeps.clone();
        runs.push((
            format!("rotors, {name}"),
            Box::new(move |top, mu, h| {
                let strang = Splitting::strang(RotorSplitting(*top));
                run(&Composition::new(strang, of.clone()), mu, h)
            }),
        ));
        if symmetric {
            runs.push((
                format!("symmetric splitting, {name}"),
                Box::new(move |top, mu, h| {
                    let strang = Splitting::strang(SymmetricTopSplitting::new(*top).ok()?);
                    run(&Composition::new(strang, substeps.clone()), mu, h)
                }),
            ));
        }
    }
    if symmetric {
        runs.push((
            "SymmetricTopEnsemble".into(),
            Box::new(|top, mu, h| {
                let top = SymmetricTopSplitting::new(*top).ok()?;
                let substeps = AlternatingSubsteps::composed(&Substeps::sofroniou_spaletta10());
                let ensemble = SymmetricTopEnsemble::new(substeps);
                let mut members = [(top, *mu); 11];
                let mut failed = false;
                let mut fail = |_, _| failed = true;
                let steps = 0..STEPS as u64;
                ensemble.advance(&mut members, h, steps, &mut ensemble.workspace(), &mut fail);
                (!failed).then_some((members[10].1, 0))
            }),
        ));
    }
}

/// The methods whose outcome depends on the scales, with the worst relative difference of each.
fn dependent(symmetric: bool, step: f64) -> Vec<String> {
    let mut found = Vec::new();
    for (name, run) in methods(symmetric) {
        let at = |s, lambda| run(&scaled_top(symmetric, s, lambda), &scaled_state(s, lambda), step);
        let reference = at(1.0, 1.0);
        for (s, lambda) in SCALES.map(|(s, l)| (2.0_f64.powi(s), 2.0_f64.powi(l))) {
            let undone = at(s, lambda).map(|(Covector(Pair(pi, gamma)), iterations)| {
                (Se3Dual::new(pi / s, gamma / lambda), iterations)
            });
            // Where sweeps diverge, how many it takes to overflow depends on where they began.
            let same = if step < 0.5 {
                undone == reference
            } else {
                undone.map(|(mu, _)| mu) == reference.map(|(mu, _)| mu)
            };
            if !same {
                found.push(format!(
                    "{name}, h = {step}, s = {s:e}, λ = {lambda:e}: {undone:?} for {reference:?}"
                ));
                break;
            }
        }
    }
    found
}

#[test]
fn every_method_finds_the_same_bits_at_all_scales() {
    let mut found = Vec::new();
    for symmetric in [false, true] {
        for step in [0.02, 0.25, 0.9] {
            found.extend(dependent(symmetric, step));
        }
    }
    assert!(found.is_empty(), "{} depend on units:\n{}", found.len(), found.join("\n"));
}
