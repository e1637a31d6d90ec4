//! The negative control of every suite: [`Spoilt`], an object whose result is wrong in one place.

use collective_integrators::{
    BatchIntegrator, IntegrationError, Integrator, Start, Step, StepError,
};
use core::ops::Range;
use lie_poisson::{Differential, Hamiltonian, Point, PoissonSpace, Real, State, Vector};
use momentum_map::{
    FibreSymmetry, Lift, LiftError, PoissonMap, SourcePoint, TargetDifferential, TargetPoint,
};

/// An object as it is, or with a fault:
///
/// * the differential of a Hamiltonian, the image of a map, or the flow of a symmetry has the wrong sign in one coordinate;
/// * a lift has twice the size;
/// * the step of an integrator is halved in one coordinate, since squares, and so many invariants, do not see a sign;
/// * a batch leaves its last member where it was, unless it is the only one.
#[derive(Clone, Debug)]
pub struct Spoilt<S> {
    pub object: S,
    pub coordinate: Option<usize>,
}

impl<S> Spoilt<S> {
    fn reversed<V: Vector>(&self, v: V) -> V {
        let sign = |i| if Some(i) == self.coordinate { -v.coordinate(i) } else { v.coordinate(i) };
        V::from_coordinates(sign)
    }

    fn halved<V: State>(&self, state: &mut V) {
        if let Some(wrong) = self.coordinate {
            state.set_entry(wrong, state.entry(wrong) * 0.5);
        }
    }
}

impl<P: PoissonSpace, T: Real, H: Hamiltonian<P, T>> Hamiltonian<P, T> for Spoilt<H> {
    fn value(&self, z: &Point<P, T>) -> T {
        self.object.value(z)
    }

    fn differential(&self, z: &Point<P, T>) -> Differential<P, T> {
        self.reversed(self.object.differential(z))
    }

    fn hessian(&self, z: &Point<P, T>, v: &Point<P, T>) -> Option<Differential<P, T>> {
        self.object.hessian(z, v)
    }
}

impl<M: PoissonMap> PoissonMap for Spoilt<M> {
    type Source = M::Source;
    type Target = M::Target;

    fn source(&self) -> M::Source {
        self.object.source()
    }

    fn target(&self) -> M::Target {
        self.object.target()
    }

    fn apply<T: Real>(&self, z: &SourcePoint<M, T>) -> TargetPoint<M, T> {
        self.object.apply::<T>(z)
    }

    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<M, T>,
        z: &SourcePoint<M, T>,
    ) -> Differential<M::Source, T> {
        self.reversed(self.object.pull_back::<T>(alpha, z))
    }

    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<M, T>,
        z: &SourcePoint<M, T>,
    ) -> SourcePoint<M, T> {
        self.object.generator::<T>(alpha, z)
    }

    fn gauge<T: Real>(&self, z: &SourcePoint<M, T>) -> SourcePoint<M, T> {
        self.object.gauge::<T>(z)
    }
}

impl<M: Lift> Lift for Spoilt<M> {
    fn lift<T: Real>(&self, mu: &TargetPoint<M, T>) -> Result<SourcePoint<M, T>, LiftError> {
        let factor = if self.coordinate.is_some() { 2.0 } else { 1.0 };
        Ok(self.object.lift::<T>(mu)?.scaled(T::from_f64(factor)))
    }
}

impl<M: FibreSymmetry> FibreSymmetry for Spoilt<M> {
    const COUNT: usize = M::COUNT;

    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<M, T>) -> SourcePoint<M, T> {
        self.reversed(self.object.flow::<T>(index, s, z))
    }

    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<M, T>) -> T {
        self.object.momentum::<T>(index, z)
    }
}

impl<I: Integrator> Integrator for Spoilt<I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> I::Workspace {
        self.object.workspace()
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        let mut made = self.object.step(state, step, workspace)?;
        self.halved(&mut made.point);
        Ok(made)
    }

    fn step_in_place(
        &self,
        state: &mut I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<usize, StepError> {
        let iterations = self.object.step_in_place(state, step, workspace)?;
        self.halved(state);
        Ok(iterations)
    }

    fn forget(&self, workspace: &mut I::Workspace) {
        self.object.forget(workspace);
    }

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.object.momentum(state)
    }
}

impl<I: Start> Start for Spoilt<I> {
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.object.start(mu)
    }
}

impl<B: BatchIntegrator> BatchIntegrator for Spoilt<B> {
    type Member = B::Member;
    type Workspace = B::Workspace;

    fn workspace(&self) -> B::Workspace {
        self.object.workspace()
    }

    fn advance(
        &self,
        members: &mut [B::Member],
        step: f64,
        steps: Range<u64>,
        workspace: &mut B::Workspace,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let left = usize::from(self.coordinate.is_some() && members.len() > 1);
        let moved = members.len() - left;
        self.object.advance(&mut members[..moved], step, steps, workspace, failed);
    }
}
