//! Spins on a chain of atoms, lifted to C² for each spin: [`LiftedChain`].

use super::chain::{Chain, canonical};
use collective_integrators::{AnyState, Integrator, Scheme, Start, Step, StepError, VectorField};
use core::cell::RefCell;
use lie_poisson::{Covector, Real, State, Vector};
use momentum_map::{
    HopfRealisation, Lift, LiftError, PoissonMap, QuadraticMomentumMap, Side, So3OnC2,
};
use nalgebra::Vector2;
use num_complex::Complex;

/// The map of each spin, with the plus bracket of spins.
const MAP: HopfRealisation = QuadraticMomentumMap::new(So3OnC2, Side::Left);

/// The number of coordinates of a point of C².
const SPINOR: usize = 4;

/// A scheme applied to (z, q, p), of which s_i = J(z_i), q and p are read: a Poisson map, if it is symplectic.
pub(super) struct LiftedChain<S> {
    pub(super) scheme: S,
    pub(super) chain: Chain,
}

fn spinor<T: Real>(state: &[T], i: usize) -> Vector2<Complex<T>> {
    Vector::from_coordinates(|k| state[SPINOR * i + k])
}

/// Returns the coordinates of (s, q, p) of those of (z, q, p) for so many atoms.
fn momentum_of<T: Real>(state: &[T], count: usize) -> impl Iterator<Item = T> {
    let (spinors, atoms) = state.split_at(SPINOR * count);
    let spins = (0..count).map(|i| MAP.apply::<T>(&spinor(spinors, i)).0);
    spins.flat_map(|s| [s.x, s.y, s.z]).chain(atoms.iter().copied())
}

/// The equations of (z, q, p).
struct LiftedField<'a, T> {
    chain: &'a Chain,
    storage: &'a RefCell<Storage<T>>,
}

/// (s, q, p) of a point, and dh there.
pub(super) struct Storage<T> {
    momentum: Vec<T>,
    differential: Vec<T>,
}

impl<T: Real> VectorField<T> for LiftedField<'_, T> {
    type Point = AnyState<T>;

    fn at(&self, state: &AnyState<T>) -> AnyState<T> {
        let mut rate = state.zeros_like();
        self.at_into(state, &mut rate);
        rate
    }

    fn at_into(&self, state: &AnyState<T>, rate: &mut AnyState<T>) {
        let (state, rate) = (state.as_slice(), rate.as_mut_slice());
        let count = self.chain.count;
        let Storage { momentum, differential: dh } = &mut *self.storage.borrow_mut();
        momentum.clear();
        momentum.extend(momentum_of(state, count));
        dh.resize(5 * count, T::zero());
        self.chain.differential(momentum, dh);
        let (spinors, atoms) = rate.split_at_mut(SPINOR * count);
        for (i, to) in spinors.as_chunks_mut::<SPINOR>().0.iter_mut().enumerate() {
            let moved = MAP.generator::<T>(&Chain::spin(dh, i), &spinor(state, i));
            *to = core::array::from_fn(|k| moved.coordinate(k));
        }
        atoms.copy_from_slice(&dh[3 * count..]);
        canonical(atoms);
    }
}

impl<S: Scheme, T: Real> Integrator<T> for LiftedChain<S> {
    type State = AnyState<T>;
    type Momentum = AnyState<T>;
    type Workspace = (S::Workspace<AnyState<T>>, RefCell<Storage<T>>);

    fn workspace(&self) -> Self::Workspace {
        let storage = Storage { momentum: Vec::new(), differential: Vec::new() };
        (self.scheme.workspace(), RefCell::new(storage))
    }

    fn step(
        &self,
        state: &AnyState<T>,
        step: f64,
        (workspace, storage): &mut Self::Workspace,
    ) -> Result<Step<AnyState<T>>, StepError> {
        let field = LiftedField { chain: &self.chain, storage };
        let made = self.scheme.step(&field, state, step, workspace)?;
        match made.point.is_finite() {
            true => Ok(made),
            false => Err(StepError::NotFinite),
        }
    }

    fn forget(&self, (workspace, _): &mut Self::Workspace) {
        self.scheme.forget(workspace);
    }

    fn momentum(&self, state: &AnyState<T>) -> AnyState<T> {
        AnyState::from_slice(&momentum_of(state.as_slice(), self.chain.count).collect::<Vec<_>>())
    }
}

impl<S: Scheme> Start for LiftedChain<S> {
    fn start(&self, mu: &AnyState) -> Result<AnyState, LiftError> {
        let (spins, atoms) = mu.as_slice().split_at(3 * self.chain.count);
        let mut state = Vec::with_capacity(6 * self.chain.count);
        for i in 0..self.chain.count {
            let lifted = MAP.lift::<f64>(&Covector(Chain::spin(spins, i)))?;
            state.extend((0..SPINOR).map(|k| lifted.coordinate(k)));
        }
        state.extend_from_slice(atoms);
        Ok(AnyState::from_slice(&state))
    }
}
