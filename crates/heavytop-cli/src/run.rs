//! A run, sample by sample.

use crate::Error;
use crate::method::{Formulation, Scheme};
use crate::schedule::Schedule;
use collective_integrators::{Collective, Direct, HamiltonianField, Start};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::{LiePoisson, Se3, Se3Dual};

/// A top, its initial state, and how to follow it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Experiment {
    /// The top.
    pub top: HeavyTop,
    /// (Π(0), Γ(0))
    pub start: Se3Dual,
    /// Where the scheme is applied.
    pub formulation: Formulation,
    /// The scheme.
    pub scheme: Scheme,
    /// For the stage equations; 0 iterates to the round-off floor.
    pub tolerance: f64,
    /// The steps.
    pub schedule: Schedule,
    /// Every n-th step is written, and the last.
    pub every: u64,
}

impl Experiment {
    /// Hands step number, time (s) and (Π, Γ) of each sample to `visit`, the initial state first.
    ///
    /// # Errors
    /// If the initial state has no lift, a step fails, or `visit` does.
    pub fn run<V>(&self, visit: V) -> Result<(), Error>
    where
        V: FnMut(u64, f64, &Se3Dual) -> Result<(), Error>,
    {
        let scheme = self.scheme.method(self.tolerance);
        match self.formulation {
            Formulation::Collective => {
                self.follow(&Collective::new(scheme, SpinorRealisation, self.top), visit)
            }
            Formulation::Direct => {
                let space = LiePoisson::minus(Se3::default());
                let field = HamiltonianField { space, hamiltonian: self.top };
                self.follow(&Direct::new(scheme, field), visit)
            }
        }
    }

    /// Whether the sample after this step is written.
    #[must_use]
    pub fn keeps(&self, step: u64) -> bool {
        step.is_multiple_of(self.every) || step == self.schedule.steps
    }

    fn follow<I, V>(&self, integrator: &I, mut visit: V) -> Result<(), Error>
    where
        I: Start<Momentum = Se3Dual>,
        V: FnMut(u64, f64, &Se3Dual) -> Result<(), Error>,
    {
        for sample in integrator.trajectory(&self.start, self.schedule.step)? {
            let sample = sample.map_err(|source| Error::Integration {
                formulation: self.formulation.name(),
                scheme: self.scheme.name(),
                source,
            })?;
            // M of the lift of the start is the start up to rounding; say what was asked for.
            let mu = if sample.step == 0 { &self.start } else { &sample.momentum };
            visit(sample.step, sample.time, mu)?;
            if sample.step >= self.schedule.steps {
                break;
            }
        }
        Ok(())
    }
}
