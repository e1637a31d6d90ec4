//! The equations of spins on a chain of atoms in motion: [`Chain`].

use collective_integrators::{AnyState, VectorField};
use lie_poisson::{Real, State};
use nalgebra::Vector3;

/// A periodic chain of atoms with spins.
#[derive(Clone, Copy, Debug)]
pub(in crate::arrays) struct Chain {
    pub(in crate::arrays) count: usize,
    pub(in crate::arrays) mass: f64,
    pub(in crate::arrays) stiffness: f64,
    pub(in crate::arrays) exchange: f64,
    pub(in crate::arrays) coupling: f64,
}

impl Chain {
    /// Returns a spin of a state.
    pub(super) fn spin<T: Real>(state: &[T], i: usize) -> Vector3<T> {
        Vector3::from_fn(|k, _| state[3 * i + k])
    }

    /// Returns the stretch qᵢ₊₁ − q_i and the neighbour i + 1.
    fn stretch<T: Real>(&self, q: &[T], i: usize) -> (T, usize) {
        let next = if i + 1 == self.count { 0 } else { i + 1 };
        (q[next] - q[i], next)
    }

    /// Returns h.
    pub(in crate::arrays) fn energy(&self, state: &[f64]) -> f64 {
        let (spins, atoms) = state.split_at(3 * self.count);
        let (q, p) = atoms.split_at(self.count);
        let bond = |i: usize| {
            let (stretch, next) = self.stretch(q, i);
            let exchange = self.exchange - self.coupling * stretch;
            p[i] * p[i] / (2.0 * self.mass) + 0.5 * self.stiffness * stretch * stretch
                - exchange * Self::spin(spins, i).dot(&Self::spin(spins, next))
        };
        (0..self.count).map(bond).sum()
    }

    /// Writes dh at a state (s, q, p).
    pub(in crate::arrays) fn differential<T: Real>(&self, state: &[T], dh: &mut [T]) {
        dh.fill(T::zero());
        let (spins, atoms) = state.split_at(3 * self.count);
        let (q, p) = atoms.split_at(self.count);
        let (of_spins, of_atoms) = dh.split_at_mut(3 * self.count);
        let (of_q, of_p) = of_atoms.split_at_mut(self.count);
        for i in 0..self.count {
            let (stretch, next) = self.stretch(q, i);
            let exchange = T::from_f64(self.exchange) - stretch * self.coupling;
            let [this, other] = [i, next].map(|i| Self::spin(spins, i));
            for k in 0..3 {
                of_spins[3 * i + k] -= exchange * other[k];
                of_spins[3 * next + k] -= exchange * this[k];
            }
            let tension = stretch * self.stiffness + this.dot(&other) * self.coupling;
            of_q[next] += tension;
            of_q[i] -= tension;
            of_p[i] = p[i] / self.mass;
        }
    }
}

/// The equations ds/dt = dh/ds × s, dq/dt = dh/dp, dp/dt = −dh/dq.
impl<T: Real> VectorField<T> for Chain {
    type Point = AnyState<T>;

    fn at(&self, state: &AnyState<T>) -> AnyState<T> {
        let mut rate = state.zeros_like();
        self.at_into(state, &mut rate);
        rate
    }

    fn at_into(&self, state: &AnyState<T>, rate: &mut AnyState<T>) {
        let (state, rate) = (state.as_slice(), rate.as_mut_slice());
        self.differential(state, rate);
        for i in 0..self.count {
            let turned = Self::spin(rate, i).cross(&Self::spin(state, i));
            rate[3 * i..3 * i + 3].copy_from_slice(turned.as_slice());
        }
        canonical(&mut rate[3 * self.count..]);
    }
}

/// Replaces (dh/dq, dh/dp) by (dh/dp, −dh/dq).
pub(super) fn canonical<T: Real>(rate: &mut [T]) {
    let (q, p) = rate.split_at_mut(rate.len() / 2);
    q.swap_with_slice(p);
    p.iter_mut().for_each(|p| *p = -*p);
}
