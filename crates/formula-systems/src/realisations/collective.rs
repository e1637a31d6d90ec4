//! Collective integrators along quadratic momenta: [`RealisedCollective`].

use super::quadratic_momenta::QuadraticMomenta;
use collective_integrators::{AnyState, Integrator, Start, Step, StepError, VectorField};
use lie_poisson::{Real, State};
use lie_poisson_formulas::Formula;
use momentum_map::LiftError;
use smallvec::SmallVec;
use std::sync::Arc;

/// The number of momenta that need no storage on the heap: those of an algebra of the largest dimension.
const MOST: usize = 256;

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
        let mut mu = SmallVec::<[T; MOST]>::new();
        mu.resize(self.momenta.count(), T::zero());
        self.momenta.values(z.as_slice(), &mut mu);
        self.hamiltonian.with_differential(
            mu.len(),
            |i| mu[i],
            #[cfg_attr(optimised, inline(always))]
            |xi| self.momenta.generator(xi, z.as_slice(), value.as_mut_slice()),
        );
    }
}

/// An integrator of the [field](RealisedField), of which the momenta J(z) are read.
pub(crate) struct RealisedCollective<I> {
    pub(crate) motion: I,
    pub(crate) momenta: Arc<QuadraticMomenta>,
}

/// The storage of the steps: that of the integrator, and what a point is compared with.
pub(crate) struct RealisedWorkspace<W> {
    inner: W,
    /// The length |z|² of the shortest point known since the last checkpoint.
    near: Option<f64>,
    is_pinned: bool,
}

/// The growth of |z|² beyond which a shorter point is looked for: that of z by a half.
const GROWN: f64 = 2.25;

impl<I> RealisedCollective<I> {
    fn momentum_of<T: Real>(&self, z: &AnyState<T>) -> AnyState<T> {
        let mut mu = SmallVec::<[T; MOST]>::new();
        mu.resize(self.momenta.count(), T::zero());
        self.momenta.values(z.as_slice(), &mut mu);
        AnyState::from_slice(&mu)
    }

    /// Returns a shorter point with the momentum of z, if a run begins or z has grown. Dual numbers are not moved, since a move has
    /// no tangent map.
    fn moved<T: Real, W>(
        &self,
        z: &AnyState<T>,
        workspace: &mut RealisedWorkspace<W>,
    ) -> Option<AnyState<T>> {
        if workspace.is_pinned {
            return None;
        }
        let mut length = T::zero();
        z.as_slice().iter().for_each(|x| length += *x * *x);
        let length = length.as_f64()?;
        if workspace.near.is_some_and(|near| length <= GROWN * near) {
            return None;
        }
        workspace.near = Some(length);
        let numbers: Vec<f64> = z.as_slice().iter().filter_map(|x| x.as_f64()).collect();
        let moved = self.momenta.recentred(&numbers)?;
        workspace.near = Some(moved.iter().map(|x| x * x).sum());
        let moved: Vec<T> = moved.into_iter().map(T::from_f64).collect();
        Some(AnyState::from_slice(&moved))
    }
}

impl<I: Integrator<T, State = AnyState<T>>, T: Real> Integrator<T> for RealisedCollective<I> {
    type State = AnyState<T>;
    type Momentum = AnyState<T>;
    type Workspace = RealisedWorkspace<I::Workspace>;

    fn workspace(&self) -> Self::Workspace {
        RealisedWorkspace { inner: self.motion.workspace(), near: None, is_pinned: false }
    }

    fn step(
        &self,
        state: &AnyState<T>,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<AnyState<T>>, StepError> {
        let moved = self.moved(state, workspace);
        if moved.is_some() {
            self.motion.forget(&mut workspace.inner);
        }
        let made = self.motion.step(moved.as_ref().unwrap_or(state), step, &mut workspace.inner)?;
        match self.momentum_of(&made.point).is_finite() {
            true => Ok(made),
            false => Err(StepError::NotFinite),
        }
    }

    fn forget(&self, workspace: &mut Self::Workspace) {
        self.motion.forget(&mut workspace.inner);
        workspace.near = None;
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        self.motion.pin(&mut workspace.inner);
        workspace.is_pinned = true;
    }

    fn momentum(&self, state: &AnyState<T>) -> AnyState<T> {
        self.momentum_of(state)
    }
}

impl<I: Integrator<State = AnyState>> Start for RealisedCollective<I> {
    fn start(&self, mu: &AnyState) -> Result<AnyState, LiftError> {
        Ok(AnyState::from_slice(&self.momenta.short_lift(mu.as_slice())?))
    }
}
