//! What a one-step method is.

use crate::{StepError, VectorField};
use lie_poisson::{Pair, Real, Vector};

/// The result of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<V> {
    /// The state after the step, or its change.
    pub point: V,
    /// Iterations of the stage solver; 0 for explicit methods.
    pub iterations: usize,
}

/// The change δz + δe of a state in a step, where δe has the size of the roundings of δz.
pub type Increment<V> = Step<Pair<V, V>>;

impl<V: Vector> Step<V> {
    /// The result itself, if it is one.
    ///
    /// # Errors
    /// [`StepError::NotFinite`] if a coordinate is infinite or not a number, in any lane.
    #[inline]
    pub fn finite(self) -> Result<Self, StepError> {
        if self.point.is_finite() { Ok(self) } else { Err(StepError::NotFinite) }
    }
}

/// A one-step method z ↦ Φ_h(z) for ż = X(z).
///
/// A scheme knows nothing of where the vector field comes from, and works over every scalar.
pub trait Scheme: Clone {
    /// The storage that a step needs, allocated once per run.
    type Workspace<V: Vector>;

    /// Allocates it.
    fn workspace<V: Vector>(&self) -> Self::Workspace<V>;

    /// Φ_h(z) − z, with roundings of its own size: those of a sum h Σ b_i k_i, and h times those of the
    /// stages. Allocates nothing. That it is finite is left to who adds it.
    ///
    /// # Errors
    /// If stage equations are not solved. Nothing is changed then, except in the workspace.
    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError>;

    /// The same as δz + δe, for [`Compensated`](crate::Compensated) summation; δe has the size of the
    /// roundings of δz. A scheme that can makes its roundings free of a mean. The default is
    /// ([`increment`](Self::increment), 0), whose are not.
    ///
    /// # Errors
    /// As for [`increment`](Self::increment).
    #[inline]
    fn refined_increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Increment<F::Point>, StepError> {
        let Step { point, iterations } = self.increment(field, z, step, workspace)?;
        Ok(Step { point: Pair(point, Vector::zero()), iterations })
    }

    /// Φ_h(z). Allocates nothing.
    ///
    /// # Errors
    /// If stage equations are not solved, or the result is not finite. Nothing is changed then,
    /// except in the workspace.
    #[inline]
    fn step<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        let Step { point, iterations } = self.increment(field, z, step, workspace)?;
        Step { point: *z + point, iterations }.finite()
    }

    /// Drops what the workspace remembers of the steps before, from which an implicit method guesses
    /// its stages: the next step depends on its starting point alone. By default nothing.
    #[inline]
    fn forget<V: Vector>(&self, _workspace: &mut Self::Workspace<V>) {}

    /// The order of convergence.
    fn order(&self) -> usize;

    /// Whether Φ_h is symplectic for every Hamiltonian vector field on a symplectic vector space.
    fn is_symplectic(&self) -> bool;

    /// Whether Φ_{−h} ∘ Φ_h = id.
    fn is_symmetric(&self) -> bool;

    /// Whether Φ_h conserves every quadratic function that the exact flow conserves, for every
    /// vector field.
    ///
    /// For a Runge–Kutta method this is the same condition as symplecticity. For a partitioned
    /// method it is not: a symplectic one conserves the invariants qᵀDp that are bilinear in q and
    /// p, not those that mix them otherwise. Nothing is promised unless a scheme says so.
    ///
    /// Source: Bochev & Scovel, *On quadratic invariants and symplectic structure*, BIT 34 (1994);
    /// Hairer, Lubich & Wanner, Thms. IV.2.2, IV.2.3 and VI.4.3.
    fn preserves_quadratic_invariants(&self) -> bool {
        false
    }
}

/// Promise: the scheme commutes with linear (indeed affine) changes of variable, A∘Φ_X = Φ_{A∗X}∘A.
///
/// Where the symmetry along the fibres of M acts affinely, as it does for every realisation of these
/// crates, such a scheme carries fibres of M to fibres, so that M∘Φ is a map of 𝔤∗; if it is
/// symplectic too, that map is Poisson. Runge–Kutta methods keep the promise. Partitioned methods, which treat q and p differently, do not: they are
/// symplectic on P, but their images are not maps of 𝔤∗ at all.
///
/// Source: McLachlan, Modin & Verdier, *Collective symplectic integrators*, Nonlinearity 27
/// (2014), Thm. 3.2; Hairer, Lubich & Wanner, *Geometric Numerical Integration*, §VI.4.
pub trait Equivariant: Scheme {}
