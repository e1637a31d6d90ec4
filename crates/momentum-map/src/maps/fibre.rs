//! Fibres of a Poisson map: their symmetries and sections.

use crate::maps::poisson_map::{Identity, PoissonMap, SourcePoint, TargetPoint};
use lie_poisson::{Point, PoissonSpace, Real, State};
use thiserror::Error;

/// The error of a point that has no finite pre-image.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("no lift: {reason} (|{quantity}| = {value:e})")]
pub struct LiftError {
    /// The quantity that excludes a lift.
    pub quantity: &'static str,
    /// The size of the quantity.
    pub value: f64,
    /// The condition that the quantity violates.
    pub reason: &'static str,
}

impl LiftError {
    /// Returns `lifted` if all of its coordinates are finite, and this error otherwise.
    ///
    /// # Errors
    /// Returns the error if a coordinate is infinite or not a number in any SIMD lane.
    pub fn unless_finite<V: State>(
        lifted: V,
        quantity: &'static str,
        value: f64,
        reason: &'static str,
    ) -> Result<V, Self> {
        if lifted.all_finite() { Ok(lifted) } else { Err(Self { quantity, value, reason }) }
    }
}

/// A section of a Poisson map M: a choice of z with M(z) = μ.
#[diagnostic::on_unimplemented(
    message = "the Poisson map `{Self}` has no lift: no point z with M(z) = μ is known",
    label = "`Lift` is not implemented for this map",
    note = "implement `Lift` for a map of your own, or start from a point z of the source and use `apply(&z)` as μ"
)]
pub trait Lift: PoissonMap {
    /// Returns a point z with M(z) = μ.
    ///
    /// # Errors
    /// Returns [`LiftError`] if μ is not in the image of M or not finite; over SIMD lanes (several
    /// trajectories in one register), if this holds for any lane.
    fn lift<T: Real>(&self, mu: &TargetPoint<Self, T>) -> Result<SourcePoint<Self, T>, LiftError>;
}

/// The symmetry along the fibres of a Poisson map M, as commuting one-parameter groups.
///
/// The orbits of the symmetry are the connected components of the regular fibres of M. Every collective
/// Hamiltonian h∘M is invariant under it, so that its momenta are conserved (Noether's theorem). Up to a
/// function, the momenta are the pull-backs of the Casimirs. A scheme on P descends to a map of 𝔤∗ if and
/// only if it maps fibres to fibres. For this it suffices that the scheme commutes with the flows of the
/// symmetry.
///
/// Source: Ohsawa 2019, §4.2; McLachlan, Modin & Verdier, *Collective symplectic integrators*,
/// Nonlinearity 27 (2014).
pub trait FibreSymmetry: PoissonMap {
    /// The number of one-parameter groups.
    const COUNT: usize;

    /// Returns the flow for parameter s of the group with the given index, or z for `index` ≥ `COUNT`.
    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T>;

    /// Returns the momentum of the group with the given index, or zero for `index` ≥ `COUNT`.
    ///
    /// The Hamiltonian vector field of this function P → R generates the flow.
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
