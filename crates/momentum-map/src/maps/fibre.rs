//! Fibres of a Poisson map: the symmetry along them, and sections across them.

use crate::maps::poisson_map::{Identity, PoissonMap, SourcePoint, TargetPoint};
use lie_poisson::{Point, PoissonSpace, Real, Vector};
use thiserror::Error;

/// A point has no pre-image, or none that is finite.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("no lift: {reason} (|{quantity}| = {value:e})")]
pub struct LiftError {
    /// The quantity that rules the lift out.
    pub quantity: &'static str,
    /// Its size.
    pub value: f64,
    /// The condition that it breaks.
    pub reason: &'static str,
}

impl LiftError {
    /// `lifted` if all of its coordinates are finite, the error otherwise: how lifts are checked.
    ///
    /// # Errors
    /// If a coordinate is infinite or not a number, in any lane.
    pub fn unless_finite<V: Vector>(
        lifted: V,
        quantity: &'static str,
        value: f64,
        reason: &'static str,
    ) -> Result<V, Self> {
        if lifted.is_finite() { Ok(lifted) } else { Err(Self { quantity, value, reason }) }
    }
}

/// A section of M: a choice of z with M(z) = μ.
pub trait Lift: PoissonMap {
    /// z with M(z) = μ.
    ///
    /// # Errors
    /// If μ is not in the image of M, or not finite; over lanes, if this holds for any lane.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError>;
}

/// A symmetry of P whose orbits are the connected components of the regular fibres of M, as
/// commuting one-parameter groups.
///
/// Every collective Hamiltonian h∘M is invariant under it, so its momenta are conserved
/// (Noether); they are the pull-backs of the Casimirs, up to a function. A scheme on P descends to
/// a map of 𝔤∗ if and only if it maps fibres to fibres, for which it suffices to commute with
/// these flows.
///
/// Source: Ohsawa 2019, §4.2; McLachlan, Modin & Verdier, *Collective symplectic integrators*,
/// Nonlinearity 27 (2014).
pub trait FibreSymmetry: PoissonMap {
    /// The number of one-parameter groups.
    const COUNT: usize;

    /// The flow for parameter s of the group with the given index; the identity for `index` ≥
    /// `COUNT`.
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T>;

    /// Its momentum J: P → R, whose Hamiltonian vector field generates the flow; zero for
    /// `index` ≥ `COUNT`.
    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<Self, T>) -> T;
}

impl<P: PoissonSpace> Lift for Identity<P> {
    fn lift<T: Real>(&self, mu: &Point<P, T>) -> Result<Point<P, T>, LiftError> {
        Ok(*mu)
    }
}

impl<P: PoissonSpace> FibreSymmetry for Identity<P> {
    const COUNT: usize = 0;

    fn flow<T: Real>(&self, _: usize, _: T, z: &Point<P, T>) -> Point<P, T> {
        *z
    }

    fn momentum<T: Real>(&self, _: usize, _: &Point<P, T>) -> T {
        T::zero()
    }
}
