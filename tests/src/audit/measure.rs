//! The measurement of the numbers in one row.

use super::{Drifts, Failure, SHORT, STEP};
use crate::tops;
use collective_integrators::diagnostics::{Drift, fibre_defects, step_poisson_defect};
use collective_integrators::{Scheme, Start, fitted_order};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::{DualNumber, Hamiltonian, LiePoisson, Se3, Se3Dual, Vector, larger};
use momentum_map::{CollectiveHamiltonian, Lift};

/// The largest error that may be round-off, also that of the exact values.
const PLATEAU: f64 = 1e-12;

/// Measures the slope of the error at t = 1 against the step.
pub(super) fn order<I>(integrator: &I) -> Result<Option<f64>, Failure>
where
    I: Start<f64, Momentum = Se3Dual>,
{
    let mut points = Vec::new();
    for count in [1_usize, 2, 3, 4, 5, 6, 8, 12, 16, 24, 32, 48, 64, 96] {
        let step = 1.0 / count as f64;
        let mut run = integrator.trajectory(&tops::paper_start(), step)?;
        if let Some(Ok(sample)) = run.nth(count) {
            points.push((step, (sample.momentum - tops::paper_exact()).max_abs()));
        }
    }
    // Large steps are not in the asymptotic regime: the finest six above the plateau count.
    points.retain(|(_, error)| *error > PLATEAU);
    Ok(fitted_order(&points[points.len().saturating_sub(6)..], PLATEAU).ok())
}

/// Measures ‖DφΛDφᵀ − Λ∘φ‖ for one step of 1/10.
pub(super) fn poisson_defect<I>(integrator: &I) -> Result<f64, Failure>
where
    I: Start<f64, Momentum = Se3Dual> + Start<DualNumber, Momentum = Se3Dual<DualNumber>>,
{
    let space = LiePoisson::minus(Se3::default());
    Ok(step_poisson_defect(&space, integrator, &tops::paper_start(), 0.1)?)
}

/// Measures |M(Φ(z′)) − M(Φ(z))| of a scheme on T*C².
pub(super) fn descent_defect<S: Scheme>(scheme: &S, top: HeavyTop) -> Result<f64, Failure> {
    let system = CollectiveHamiltonian::new(SpinorRealisation, top);
    let z = SpinorRealisation.lift::<f64>(&tops::paper_start())?;
    Ok(fibre_defects(scheme, &system, &z, 0.7, STEP)?.descent)
}

/// Measures the drifts over [`SHORT`] and over all steps, and the step at which the run has failed.
pub(super) fn drifts<I>(
    integrator: &I,
    top: &HeavyTop,
    steps: u64,
) -> Result<([Drifts; 2], Option<u64>), Failure>
where
    I: Start<f64, Momentum = Se3Dual>,
{
    let start = tops::paper_start();
    let values = |mu: &Se3Dual| [mu.0.1.dot(&mu.0.1), mu.0.0.dot(&mu.0.1), top.value(mu)];
    let (first, mut largest, mut energies) = (values(&start), [0.0; 3], Vec::new());
    let seen = |largest: [f64; 3], energies: &[(f64, f64)]| -> Result<Drifts, Failure> {
        let [f1, f2, energy] = largest;
        let slope = Drift::of(energies.iter().copied())?.slope;
        Ok(Drifts { casimirs: [f1, f2], energy, slope })
    };
    let (mut short, mut failed) = (None, None);
    for sample in integrator.trajectory(&start, STEP)?.take(steps as usize + 1) {
        let sample = match sample {
            Ok(sample) => sample,
            Err(error) => {
                failed = Some(error.step);
                break;
            }
        };
        let now = values(&sample.momentum);
        largest = [0, 1, 2].map(|k| larger(largest[k], (now[k] - first[k]).abs()));
        if sample.step % 100 == 0 {
            energies.push((sample.time, now[2]));
        }
        if sample.step == SHORT {
            short = Some(seen(largest, &energies)?);
        }
    }
    let long = seen(largest, &energies)?;
    Ok(([short.unwrap_or(long), long], failed))
}
