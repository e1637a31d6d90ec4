//! Collective integrators along quadratic momenta: [`RealisedCollective`].

use super::quadratic_momenta::QuadraticMomenta;
use collective_integrators::{AnyState, Integrator, Start, Step, StepError, VectorField};
use lie_poisson::{Real, State};
use lie_poisson_formulas::Formula;
use momentum_map::LiftError;
use smallvec::{SmallVec, smallvec};
use std::sync::Arc;

/// The number of momenta that need no storage on the heap.
const FEW: usize = 64;

/// The field ż = X_(h∘J)(z).
pub(crate) struct RealisedField {
    pub(crate) momenta: Arc<QuadraticMomenta>,
    /// The Hamiltonian for the bracket of the momenta.
    pub(crate) hamiltonian: Formula,
}

impl<T: Real> VectorField<T> for RealisedField {
    type Point = AnyState<T>;

    fn at(&self, z: &AnyState<T>) -> AnyState<T> {
        let mut value = z.zeros_like();
        self.at_into(z, &mut value);
        value
    }

    #[cfg_attr(optimised, inline(always))]
    fn at_into(&self, z: &AnyState<T>, value: &mut AnyState<T>) {
        let mut mu: SmallVec<[T; FEW]> = smallvec![T::zero(); self.momenta.count()];
        self.momenta.values(z.as_slice(), &mut mu);
        self.hamiltonian.with_differential(
            mu.len(),
            |i| mu[i],
            |xi| {
                self.momenta.generator(xi, z.as_slice(), value.as_mut_slice());
            },
        );
    }
}

/// An integrator of the [field](RealisedField), of which the momenta J(z) are read.
pub(crate) struct RealisedCollective<I> {
    pub(crate) motion: I,
    pub(crate) momenta: Arc<QuadraticMomenta>,
}

impl<I> RealisedCollective<I> {
    fn momentum_of<T: Real>(&self, z: &AnyState<T>) -> AnyState<T> {
        let mut mu: SmallVec<[T; FEW]> = smallvec![T::zero(); self.momenta.count()];
        self.momenta.values(z.as_slice(), &mut mu);
        AnyState::from_slice(&mu)
    }
}

impl<I: Integrator<T, State = AnyState<T>>, T: Real> Integrator<T> for RealisedCollective<I> {
    type State = AnyState<T>;
    type Momentum = AnyState<T>;
    type Workspace = I::Workspace;

    fn workspace(&self) -> I::Workspace {
        self.motion.workspace()
    }

    fn step(
        &self,
        state: &AnyState<T>,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<AnyState<T>>, StepError> {
        let made = self.motion.step(state, step, workspace)?;
        match self.momentum_of(&made.point).is_finite() {
            true => Ok(made),
            false => Err(StepError::NotFinite),
        }
    }

    fn forget(&self, workspace: &mut I::Workspace) {
        self.motion.forget(workspace);
    }

    fn momentum(&self, state: &AnyState<T>) -> AnyState<T> {
        self.momentum_of(state)
    }
}

impl<I: Integrator<State = AnyState>> Start for RealisedCollective<I> {
    fn start(&self, mu: &AnyState) -> Result<AnyState, LiftError> {
        Ok(AnyState::from_slice(&self.momenta.lift(mu.as_slice())?))
    }
}
