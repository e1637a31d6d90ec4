//! Compensated summation: what round-off does to f₁ and f₂ with and without it.

use collective_integrators::{
    Collective, Composition, Direct, HamiltonianField, LiftFree, RungeKutta, Start, Substeps,
};
use heavytop::SpinorRealisation;
use lie_poisson::{LiePoisson, Se3, Se3Dual};
use momentum_map::DualQuaternions;
use nalgebra::Vector3;
use std::error::Error;
use workspace_tests::tops;

const STEPS: usize = 40_000;

/// Starts of the generic top whose coordinates are no short binary fractions.
fn starts() -> impl Iterator<Item = Se3Dual> {
    (0..7).map(|n| {
        let turn = 0.7 * f64::from(n);
        let gamma = Vector3::new(turn.cos(), (1.3 * turn).sin(), 0.4 + turn.sin()).normalize();
        Se3Dual::new(Vector3::new(0.3, -0.4, 2.0 + 0.1 * turn.cos()), gamma)
    })
}

/// The medians over the starts of the largest |Δf₁| and |Δf₂| in a run.
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

/// Compensation makes both deviations smaller by this factor at least.
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
