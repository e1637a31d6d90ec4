//! Collective integrators along quadratic momenta: [`RealisedCollective`].

use super::quadratic_momenta::QuadraticMomenta;
use collective_integrators::{AnyState, Integrator, Scheme, Start, Step, StepError, VectorField};
use core::cell::RefCell;
use lie_poisson::{Real, State};
use lie_poisson_formulas::Formula;
use momentum_map::LiftError;
use std::sync::Arc;

/// A scheme applied to ż = X_(h∘J)(z), of which the momenta J(z) are read.
pub(crate) struct RealisedCollective<S> {
    pub(crate) scheme: S,
    pub(crate) momenta: Arc<QuadraticMomenta>,
    /// The Hamiltonian for the bracket of the momenta.
    pub(crate) hamiltonian: Formula,
}

/// The storage of a step.
pub(crate) struct RealisedWorkspace<W, T> {
    scheme: W,
    momentum: RefCell<Vec<T>>,
}

struct RealisedField<'a, T> {
    momenta: &'a QuadraticMomenta,
    hamiltonian: &'a Formula,
    momentum: &'a RefCell<Vec<T>>,
}

impl<T: Real> VectorField<T> for RealisedField<'_, T> {
    type Point = AnyState<T>;

    fn at(&self, z: &AnyState<T>) -> AnyState<T> {
        let mut value = z.zeros_like();
        self.at_into(z, &mut value);
        value
    }

    fn at_into(&self, z: &AnyState<T>, value: &mut AnyState<T>) {
        let mu = &mut *self.momentum.borrow_mut();
        self.momenta.values(z.as_slice(), mu);
        self.hamiltonian.with_differential(
            mu.len(),
            |i| mu[i],
            |xi| {
                self.momenta.generator(xi, z.as_slice(), value.as_mut_slice());
            },
        );
    }
}

impl<S> RealisedCollective<S> {
    fn momentum_of<T: Real>(&self, z: &AnyState<T>) -> AnyState<T> {
        let mut mu = vec![T::zero(); self.momenta.count()];
        self.momenta.values(z.as_slice(), &mut mu);
        AnyState::from_slice(&mu)
    }
}

impl<S: Scheme, T: Real> Integrator<T> for RealisedCollective<S> {
    type State = AnyState<T>;
    type Momentum = AnyState<T>;
    type Workspace = RealisedWorkspace<S::Workspace<AnyState<T>>, T>;

    fn workspace(&self) -> Self::Workspace {
        let momentum = RefCell::new(vec![T::zero(); self.momenta.count()]);
        RealisedWorkspace { scheme: self.scheme.workspace(), momentum }
    }

    fn step(
        &self,
        state: &AnyState<T>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<AnyState<T>>, StepError> {
        let RealisedWorkspace { scheme, momentum } = workspace;
        let field =
            RealisedField { momenta: &self.momenta, hamiltonian: &self.hamiltonian, momentum };
        let made = self.scheme.step(&field, state, step, scheme)?;
        match self.momentum_of(&made.point).is_finite() {
            true => Ok(made),
            false => Err(StepError::NotFinite),
        }
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        self.scheme.forget(&mut workspace.scheme);
    }

    fn momentum(&self, state: &AnyState<T>) -> AnyState<T> {
        self.momentum_of(state)
    }
}

impl<S: Scheme> Start for RealisedCollective<S> {
    fn start(&self, mu: &AnyState) -> Result<AnyState, LiftError> {
        Ok(AnyState::from_slice(&self.momenta.lift(mu.as_slice())?))
    }
}
