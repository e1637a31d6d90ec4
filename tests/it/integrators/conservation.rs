//! §5.2: the invariants that each scheme conserves, as numbers; the figures are drawn from the same runs.

use collective_integrators::{Collective, Direct, HamiltonianField, Integrator, RungeKutta, Start};
use heavytop::{HeavyTop, HeavyTopSpace, Invariant, SpinorPoint, SpinorRealisation};
use lie_poisson::{LiePoisson, Se3, Se3Dual, larger};
use momentum_map::FibreSymmetry;
use std::error::Error;
use workspace_tests::{assert_close, largest_deviation, tops};

type Outcome = Result<(), Box<dyn Error>>;

const INVARIANTS: [Invariant; 4] = [
    Invariant::Energy,
    Invariant::VerticalSquared,
    Invariant::VerticalMomentum,
    Invariant::Kovalevskaya,
];

fn collective(
    scheme: RungeKutta,
) -> Result<Collective<RungeKutta, SpinorRealisation, HeavyTop>, Box<dyn Error>> {
    Ok(Collective::new(scheme, SpinorRealisation, tops::paper()?))
}

fn direct(
    scheme: RungeKutta,
) -> Result<Direct<RungeKutta, HamiltonianField<HeavyTopSpace, HeavyTop>>, Box<dyn Error>> {
    let space = LiePoisson::minus(Se3::default());
    Ok(Direct::new(scheme, HamiltonianField { space, hamiltonian: tops::paper()? }))
}

/// Returns max |deviation| of h, f₁, f₂, K from the paper's start.
fn deviations<I: Start<Momentum = Se3Dual>>(
    integrator: &I,
    step: f64,
    steps: usize,
) -> Result<[f64; 4], Box<dyn Error>> {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let initial = INVARIANTS.map(|i| i.value(&top, &start));
    let mut largest = [0.0; 4];
    for sample in integrator.trajectory(&start, step)?.take(steps + 1) {
        let mu = sample?.momentum;
        for (i, invariant) in INVARIANTS.iter().enumerate() {
            largest[i] = larger(largest[i], (invariant.value(&top, &mu) - initial[i]).abs());
        }
    }
    Ok(largest)
}

/// The bound for "0" in the table: round-off of K, the largest of the four at 193, over 5000 steps.
const ZERO: f64 = 1e-12;

/// Checks each number to half a unit in the last digit given, or to round-off where 0 is given.
fn check(computed: &[f64; 4], expected: &[f64; 4], digits: i32) {
    for (computed, &expected) in computed.iter().zip(expected) {
        if expected == 0.0 {
            assert!(*computed < ZERO, "{computed:e} is not round-off");
        } else {
            let unit = 10.0_f64.powi(1 - digits);
            assert_close(computed / expected, 1.0, unit);
        }
    }
}

/// Figures 1 and 2: the paper's experiment to t = 100 with steps of 1/50.
#[test]
fn the_experiment_of_the_paper() -> Outcome {
    let run = |scheme: RungeKutta| deviations(&collective(scheme)?, 0.02, 5000);
    let table = [9.091e-4, 0.0, 0.0, 6.344e-2];
    check(&run(RungeKutta::implicit_midpoint())?, &table, 4);
    let table = [0.31584, 2.3770e-2, 0.10625, 5.3352];
    check(&run(RungeKutta::explicit_midpoint())?, &table, 4);

    let run = |scheme: RungeKutta| deviations(&direct(scheme)?, 0.02, 5000);
    let table = [1.2766e-2, 3.0957e-2, 9.784e-3, 1.4383];
    check(&run(RungeKutta::explicit_midpoint())?, &table, 4);
    let table = [0.0, 0.0, 0.0, 0.35420];
    check(&run(RungeKutta::implicit_midpoint())?, &table, 4);
    Ok(())
}

/// The drift of h under the collective midpoint rule does not grow: the second half of the run
/// looks like the first. Under the explicit rule it does.
#[test]
fn the_energy_oscillates_without_drift() -> Outcome {
    let run = |scheme: RungeKutta, steps| -> Result<f64, Box<dyn Error>> {
        Ok(deviations(&collective(scheme)?, 0.02, steps)?[0])
    };
    let implicit = RungeKutta::implicit_midpoint;
    assert!(run(implicit(), 5000)? < 1.05 * run(implicit(), 1000)?);
    let explicit = RungeKutta::explicit_midpoint;
    assert!(run(explicit(), 5000)? > 3.0 * run(explicit(), 1000)?);
    Ok(())
}

/// Every Gauss method conserves f₁ and f₂ to round-off over 1000 steps of 1/20, for a generic top, and J₁ and J₂ on
/// T*C².
#[test]
fn gauss_methods_conserve_the_casimirs() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    let casimirs = [Invariant::VerticalSquared, Invariant::VerticalMomentum];
    for stages in 1..=8 {
        let gauss = Collective::new(RungeKutta::gauss(stages)?, SpinorRealisation, top);
        for invariant in casimirs {
            let value = |mu: &Se3Dual| invariant.value(&top, mu);
            let drift = largest_deviation(&gauss, &start, 0.05, 1000, value)?;
            // The bound is a random walk of 1000 rounding errors of numbers of size 10: √1000 · 10 · 2e-16.
            assert!(drift < 1e-13, "{stages} stages, {invariant}: {drift:e}");
        }
        let mut largest = 0.0;
        let z = gauss.start(&start)?;
        let momenta = |z: &SpinorPoint| [0, 1].map(|i| SpinorRealisation.momentum::<f64>(i, z));
        let before = momenta(&z);
        for sample in gauss.trajectory_from(z, 0.05).take(1001) {
            for (now, before) in momenta(&sample?.state).iter().zip(before) {
                largest = larger(largest, (now - before).abs());
            }
        }
        assert!(largest < 1e-13, "{stages} stages: {largest:e}");
    }
    Ok(())
}

/// Negative control: explicit methods of any order do not conserve the Casimirs in the same run, and Gauss methods do
/// not conserve what is not quadratic.
#[test]
fn other_methods_and_other_quantities_are_not_conserved() -> Outcome {
    let (top, start) = (tops::generic()?, tops::generic_start());
    for scheme in [RungeKutta::explicit_midpoint(), RungeKutta::rk4()] {
        let method = Collective::new(scheme, SpinorRealisation, top);
        for invariant in [Invariant::VerticalSquared, Invariant::VerticalMomentum] {
            let value = |mu: &Se3Dual| invariant.value(&top, mu);
            assert!(largest_deviation(&method, &start, 0.05, 1000, value)? > 1e-8);
        }
    }
    let gauss = Collective::new(RungeKutta::gauss(2)?, SpinorRealisation, top);
    let energy = |mu: &Se3Dual| Invariant::Energy.value(&top, mu);
    assert!(largest_deviation(&gauss, &start, 0.05, 1000, energy)? > 1e-8);
    Ok(())
}
