//! Compensated summation: what round-off does to f₁ and f₂ with and without it.

use collective_integrators::{
    Collective, Composition, Direct, HamiltonianField, Increments, Integrator, LiftFree,
    RungeKutta, StageSolver, Start, Step, StepError, Substeps, VectorField, compensated_sum,
};
use heavytop::{HeavyTop, SpinorPoint, SpinorRealisation};
use lie_poisson::{DualNumber, LiePoisson, Pair, Se3, Se3Dual, Vector, derivative_part, seed};
use momentum_map::{DualQuaternions, Lift, LiftError, PoissonMap};
use nalgebra::Vector3;
use std::error::Error;
use workspace_tests::tops;

const STEPS: usize = 8_000;

/// Returns starts of the generic top whose coordinates are no short binary fractions.
fn starts() -> impl Iterator<Item = Se3Dual> {
    (0..7).map(|n| {
        let turn = 0.7 * f64::from(n);
        let gamma = Vector3::new(turn.cos(), (1.3 * turn).sin(), 0.4 + turn.sin()).normalize();
        Se3Dual::new(Vector3::new(0.3, -0.4, 2.0 + 0.1 * turn.cos()), gamma)
    })
}

/// Returns the medians over the starts of the largest |Δf₁| and |Δf₂| in a run.
fn deviations(
    integrator: &impl Start<Momentum = Se3Dual>,
    step: f64,
) -> Result<[f64; 2], Box<dyn Error>> {
    let values = |mu: &Se3Dual| [mu.0.1.dot(&mu.0.1), mu.0.0.dot(&mu.0.1)];
    let mut worst = [Vec::new(), Vec::new()];
    for start in starts() {
        let (first, mut most) = (values(&start), [0.0_f64; 2]);
        for sample in integrator.trajectory(&start, step)?.take(STEPS + 1) {
            let now = values(&sample?.momentum);
            for k in 0..2 {
                most[k] = lie_poisson::larger(most[k], (now[k] - first[k]).abs());
            }
        }
        worst[0].push(most[0]);
        worst[1].push(most[1]);
    }
    Ok(worst.map(|mut worst| {
        worst.sort_by(f64::total_cmp);
        worst[worst.len() / 2]
    }))
}

/// Checks that compensation makes both deviations smaller by this factor at least.
fn gains(
    name: &str,
    plain: &impl Start<Momentum = Se3Dual>,
    compensated: &impl Start<Momentum = Se3Dual>,
    factor: f64,
) -> Result<(), Box<dyn Error>> {
    let (plain, compensated) = (deviations(plain, 0.01)?, deviations(compensated, 0.01)?);
    for k in 0..2 {
        assert!(compensated[k] * factor < plain[k], "{name}: {plain:?} {compensated:?}");
    }
    Ok(())
}

#[test]
#[ignore = "long"]
fn compensation_makes_round_off_smaller_in_every_formulation() -> Result<(), Box<dyn Error>> {
    let top = tops::generic()?;
    for scheme in [RungeKutta::implicit_midpoint(), RungeKutta::gauss(2)?] {
        let collective = Collective::new(scheme.clone(), SpinorRealisation, top);
        gains("collective", &collective, &collective.clone().compensated(), 5.0)?;
        let field = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
        let direct = Direct::new(scheme.clone(), field);
        gains("direct", &direct, &direct.clone().compensated(), 5.0)?;
        let free = LiftFree::new(scheme, DualQuaternions, top);
        gains("lift-free", &free, &free.clone().compensated(), 5.0)?;
    }
    let composed = Composition::new(RungeKutta::implicit_midpoint(), Substeps::yoshida4());
    let collective = Collective::new(composed, SpinorRealisation, top);
    gains("composition", &collective, &collective.clone().compensated(), 5.0)
}

/// The collective midpoint rule with compensated summation of unrefined increments: h k for stages that are iterated
/// to the round-off floor and no further. `Compensated` refines them.
struct Coarse(Collective<RungeKutta, SpinorRealisation, HeavyTop>);

impl Integrator for Coarse {
    type State = Pair<SpinorPoint, SpinorPoint>;
    type Momentum = Se3Dual;
    type Workspace = <Collective<RungeKutta, SpinorRealisation, HeavyTop> as Integrator>::Workspace;

    fn workspace(&self) -> Self::Workspace {
        self.0.workspace()
    }

    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        let (field, z) = (self.0.system(), state.0);
        let mut k = [Vector::zero()];
        let middle = |_, k: &[SpinorPoint]| field.at(&(z + k[0].scaled(0.5 * step)));
        let iterations = StageSolver::default().solve(field.at(&z), &mut k, middle)?;
        let sum = compensated_sum(state, &Pair(k[0].scaled(step), Vector::zero()));
        let point = self.0.gauged(sum, workspace);
        Ok(Step { point, iterations })
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        Integrator::<f64>::forget(&self.0, workspace);
    }

    fn momentum(&self, state: &Self::State) -> Se3Dual {
        self.0.momentum(&state.0)
    }
}

impl Start for Coarse {
    fn start(&self, mu: &Se3Dual) -> Result<Self::State, LiftError> {
        Ok(Pair(self.0.start(mu)?, Vector::zero()))
    }
}

/// Returns the sums of Δf₁ and Δf₂ at the ends of runs of 131 072 steps of 1/20 from three starts.
fn drifts(integrator: &impl Start<Momentum = Se3Dual>) -> Result<[f64; 2], Box<dyn Error>> {
    let values = |mu: &Se3Dual| [mu.0.1.dot(&mu.0.1), mu.0.0.dot(&mu.0.1)];
    let mut sums = [0.0; 2];
    for start in starts().take(3) {
        let (mut state, mut workspace) = (integrator.start(&start)?, integrator.workspace());
        for _ in 0..131_072 {
            state = integrator.step(&state, 0.05, &mut workspace)?.point;
        }
        let (first, last) = (values(&start), values(&integrator.momentum(&state)));
        for (sum, k) in sums.iter_mut().zip(0..) {
            *sum += last[k] - first[k];
        }
    }
    Ok(sums)
}

/// Rounding errors of stages and of products by h are biased by some hundredths of a rounding error, which is a
/// drift.
///
/// The sums of three random walks of this length are 4e-15 and 6e-15 long (root mean squares over 48 starts); the
/// bounds are three times as much.
#[test]
#[ignore = "long"]
fn compensated_steps_at_long_steps_do_not_drift() -> Result<(), Box<dyn Error>> {
    let midpoint = RungeKutta::implicit_midpoint();
    let collective = Collective::new(midpoint, SpinorRealisation, tops::generic()?);
    let refined = drifts(&collective.clone().compensated())?;
    assert!(refined[0].abs() < 1.3e-14 && refined[1].abs() < 1.7e-14, "{refined:?}");
    let coarse = drifts(&Coarse(collective))?;
    assert!(coarse[0].abs() > 2e-14 && coarse[1].abs() > 1.7e-14, "{coarse:?}");
    Ok(())
}

/// A slide of z along its fibre conserves the momentum of z + e, in which the part of e is DM(z) e.
#[test]
fn a_slide_along_the_fibre_takes_the_carry_along() -> Result<(), Box<dyn Error>> {
    let collective =
        Collective::new(RungeKutta::implicit_midpoint(), SpinorRealisation, tops::generic()?);
    let workspace = Integrator::<f64>::workspace(&collective);
    let carried = |z: &SpinorPoint, e: &SpinorPoint| -> Se3Dual {
        derivative_part(&SpinorRealisation.apply::<DualNumber>(&seed(z, e)))
    };
    for (n, start) in (0_u32..).zip(starts()) {
        let mut z = SpinorRealisation.lift::<f64>(&start)?;
        z.q += z.p.0.map(|x| x.scale(if n % 2 == 0 { 9.3 } else { -17.7 }));
        // e is as large as z, which is a harder test than the rounding errors that it stands for.
        let e = SpinorPoint::from_coordinates(|i| (f64::from(n) + 0.7 * i as f64).sin());
        let Pair(slid, carry) = Increments::<f64>::gauged(&collective, Pair(z, e), &workspace);
        assert!(slid.q.norm() < 0.9 * z.q.norm(), "start {n} has not slid");
        let (momentum, change) = (SpinorRealisation.apply(&z), carried(&z, &e));
        let kept = SpinorRealisation.apply(&slid) - momentum;
        // The tolerance is that of rounding errors of products of χ and ψ.
        let tolerance = 4.0 * f64::EPSILON * z.q.norm() * z.p.0.norm();
        assert!(kept.max_abs() < tolerance, "{:e}", kept.max_abs());
        let gap = (carried(&slid, &carry) - change).max_abs();
        assert!(gap < 4.0 * tolerance, "{gap:e}");
        // Control: e would have another momentum if it did not move.
        assert!((carried(&slid, &e) - change).max_abs() > 0.1);
    }
    Ok(())
}
