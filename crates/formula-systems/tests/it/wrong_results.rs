//! The negative control of the law suites: [`Wrong`], an object with one coordinate of its results that is wrong.

use collective_integrators::{Integrator, Start, Step, StepError};
use lie_poisson::{
    Differential, Hamiltonian, LieAlgebra, Momentum, Point, PoissonSpace, Real, State,
};
use momentum_map::LiftError;

/// An object as it is, or with half of one coordinate of its differential, its brackets, or its steps.
///
/// Half, and not the opposite sign: squares, and so many invariants, do not see a sign.
#[derive(Clone, Debug)]
pub struct Wrong<S> {
    pub object: S,
    pub coordinate: Option<usize>,
}

impl<S> Wrong<S> {
    fn spoil<V: State>(&self, mut v: V) -> V {
        if let Some(wrong) = self.coordinate {
            v.set_entry(wrong, v.entry(wrong) * 0.5);
        }
        v
    }
}

impl<P: PoissonSpace, T: Real, H: Hamiltonian<P, T>> Hamiltonian<P, T> for Wrong<H> {
    fn value(&self, z: &Point<P, T>) -> T {
        self.object.value(z)
    }

    fn differential(&self, z: &Point<P, T>) -> Differential<P, T> {
        self.spoil(self.object.differential(z))
    }

    fn hessian(&self, z: &Point<P, T>, v: &Point<P, T>) -> Option<Differential<P, T>> {
        self.object.hessian(z, v)
    }
}

impl<A: LieAlgebra> LieAlgebra for Wrong<A> {
    type Element<T: Real> = A::Element<T>;

    fn bracket<T: Real>(&self, xi: &A::Element<T>, eta: &A::Element<T>) -> A::Element<T> {
        self.spoil(self.object.bracket::<T>(xi, eta))
    }

    fn coadjoint<T: Real>(&self, xi: &A::Element<T>, mu: &Momentum<A, T>) -> Momentum<A, T> {
        self.object.coadjoint::<T>(xi, mu)
    }
}

impl<I: Integrator> Integrator for Wrong<&I> {
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
        let made = self.object.step(state, step, workspace)?;
        Ok(Step { point: self.spoil(made.point), ..made })
    }

    fn forget(&self, workspace: &mut I::Workspace) {
        self.object.forget(workspace);
    }

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.object.momentum(state)
    }
}

impl<I: Start> Start for Wrong<&I> {
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.object.start(mu)
    }
}
