//! The negative control of every suite: [`Faulty`], a system with one coordinate that is wrong.

use lie_poisson_systems::collective_integrators::{
    Integrator, Start, Step, StepError, VectorField,
};
use lie_poisson_systems::isospectral_flows::{IsospectralField, LargeSkewHermitian};
use lie_poisson_systems::lie_poisson::laws::{NoSamples, Report};
use lie_poisson_systems::lie_poisson::{
    Casimirs, Covector, Differential, Hamiltonian, LieAlgebra, Momentum, Point, PoissonSpace, Real,
    Sites, SitesHamiltonian, State, Vector,
};
use lie_poisson_systems::momentum_map::{
    Lift, LiftError, PoissonMap, SourcePoint, TargetDifferential, TargetPoint,
};

/// A system as it is, or with a fault in one coordinate of its result: of a differential, a rate, a generator, a Lie
/// bracket, a map or a step.
///
/// The coordinate has the wrong sign. That of a step is halved instead: squares, and so many invariants, do not depend
/// on a sign.
#[derive(Clone, Debug)]
pub struct Faulty<S> {
    system: S,
    coordinate: Option<usize>,
}

/// Checks that a suite accepts a system, where no fault can be seen, or where the same suite has its control beside it.
pub fn holds<S>(
    system: S,
    tolerance: f64,
    suite: impl Fn(&Faulty<S>) -> Result<Report, NoSamples>,
) {
    suite(&Faulty { system, coordinate: None }).unwrap().check(tolerance).unwrap();
}

/// The residual that a fault must exceed: it changes a result by its own size, and not by a rounding error.
const CLEAR: f64 = 1e-3;

/// Checks that a suite accepts a system, and that it refuses the system with a fault in the given coordinate.
pub fn obeys<S: Clone>(
    system: S,
    coordinate: usize,
    tolerance: f64,
    suite: impl Fn(&Faulty<S>) -> Result<Report, NoSamples>,
) {
    let faulty = Faulty { system: system.clone(), coordinate: Some(coordinate) };
    let refused = suite(&faulty).unwrap().check(CLEAR);
    assert!(refused.is_err(), "a fault in coordinate {coordinate} was not found");
    holds(system, tolerance, suite);
}

impl<S> Faulty<S> {
    /// Returns the vector with the sign of the coordinate reversed.
    fn reversed<V: Vector>(&self, v: V) -> V {
        match self.coordinate {
            None => v,
            Some(wrong) => {
                V::from_coordinates(|i| if i == wrong { -v.coordinate(i) } else { v.coordinate(i) })
            }
        }
    }

    /// Multiplies the coordinate of a state.
    fn spoil<V: State>(&self, state: &mut V, factor: f64) {
        if let Some(wrong) = self.coordinate {
            state.set_entry(wrong, state.entry(wrong) * factor);
        }
    }
}

impl<P: PoissonSpace, T: Real, H: Hamiltonian<P, T>> Hamiltonian<P, T> for Faulty<H> {
    fn value(&self, z: &Point<P, T>) -> T {
        self.system.value(z)
    }

    fn differential(&self, z: &Point<P, T>) -> Differential<P, T> {
        self.reversed(self.system.differential(z))
    }

    fn hessian(&self, z: &Point<P, T>, v: &Point<P, T>) -> Option<Differential<P, T>> {
        self.system.hessian(z, v)
    }
}

impl<V: Vector, H: SitesHamiltonian<V>> SitesHamiltonian<V> for Faulty<H> {
    fn value(&self, mu: &Covector<Sites<V>>) -> V::Scalar {
        self.system.value(mu)
    }

    fn differential_into(&self, mu: &Covector<Sites<V>>, dh: &mut Sites<V>) {
        self.system.differential_into(mu, dh);
        self.spoil(dh, -1.0);
    }
}

impl<T: Real, F: VectorField<T>> VectorField<T> for Faulty<F> {
    type Point = F::Point;

    fn at(&self, z: &F::Point) -> F::Point {
        let mut rate = self.system.at(z);
        self.spoil(&mut rate, -1.0);
        rate
    }

    fn at_into(&self, z: &F::Point, rate: &mut F::Point) {
        self.system.at_into(z, rate);
        self.spoil(rate, -1.0);
    }
}

impl<F: IsospectralField> IsospectralField for Faulty<F> {
    fn size(&self) -> usize {
        self.system.size()
    }

    fn generator_into(&self, w: &LargeSkewHermitian, generator: &mut LargeSkewHermitian) {
        self.system.generator_into(w, generator);
        self.spoil(generator, -1.0);
    }
}

impl<A: LieAlgebra> LieAlgebra for Faulty<A> {
    type Element<T: Real> = A::Element<T>;

    fn bracket<T: Real>(&self, xi: &A::Element<T>, eta: &A::Element<T>) -> A::Element<T> {
        self.reversed(self.system.bracket::<T>(xi, eta))
    }

    fn coadjoint<T: Real>(&self, xi: &A::Element<T>, mu: &Momentum<A, T>) -> Momentum<A, T> {
        self.reversed(self.system.coadjoint::<T>(xi, mu))
    }
}

impl<A: Casimirs> Casimirs for Faulty<A> {
    const COUNT: usize = A::COUNT;

    fn casimir<T: Real>(&self, index: usize, mu: &Momentum<A, T>) -> T {
        self.system.casimir::<T>(index, mu)
    }

    fn casimir_differential<T: Real>(&self, index: usize, mu: &Momentum<A, T>) -> A::Element<T> {
        self.reversed(self.system.casimir_differential::<T>(index, mu))
    }
}

impl<M: PoissonMap> PoissonMap for Faulty<M> {
    type Source = M::Source;
    type Target = M::Target;

    fn source(&self) -> M::Source {
        self.system.source()
    }

    fn target(&self) -> M::Target {
        self.system.target()
    }

    fn apply<T: Real>(&self, z: &SourcePoint<M, T>) -> TargetPoint<M, T> {
        self.reversed(self.system.apply::<T>(z))
    }

    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<M, T>,
        z: &SourcePoint<M, T>,
    ) -> Differential<M::Source, T> {
        self.system.pull_back::<T>(alpha, z)
    }

    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<M, T>,
        z: &SourcePoint<M, T>,
    ) -> SourcePoint<M, T> {
        self.system.generator::<T>(alpha, z)
    }
}

impl<M: Lift> Lift for Faulty<M> {
    fn lift<T: Real>(&self, mu: &TargetPoint<M, T>) -> Result<SourcePoint<M, T>, LiftError> {
        self.system.lift::<T>(mu)
    }
}

impl<I: Integrator> Integrator for Faulty<I> {
    type State = I::State;
    type Momentum = I::Momentum;
    type Workspace = I::Workspace;

    fn workspace(&self) -> I::Workspace {
        self.system.workspace()
    }

    fn step(
        &self,
        state: &I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<Step<I::State>, StepError> {
        let mut made = self.system.step(state, step, workspace)?;
        self.spoil(&mut made.point, 0.5);
        Ok(made)
    }

    fn step_in_place(
        &self,
        state: &mut I::State,
        step: f64,
        workspace: &mut I::Workspace,
    ) -> Result<usize, StepError> {
        let iterations = self.system.step_in_place(state, step, workspace)?;
        self.spoil(state, 0.5);
        Ok(iterations)
    }

    fn forget(&self, workspace: &mut I::Workspace) {
        self.system.forget(workspace);
    }

    fn momentum(&self, state: &I::State) -> I::Momentum {
        self.system.momentum(state)
    }
}

impl<I: Start> Start for Faulty<I> {
    fn start(&self, mu: &I::Momentum) -> Result<I::State, LiftError> {
        self.system.start(mu)
    }
}
