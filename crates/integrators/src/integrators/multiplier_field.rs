//! The vector field of multipliers, and its successive steps.

use crate::stage_frame::StageFrame;
use crate::stages::checkpoints::CHECKPOINT;
use crate::stages::history::near;
use crate::vector_field::{VectorField, dual_differential};
use lie_poisson::{
    DualNumber, Hamiltonian, Mask, Point, Real, Vector, derivative_part, map_coordinates, seed,
};
use momentum_map::{Multiplier, Multipliers};

/// The vector field Q ↦ dh(transport(Q, μ₀)) Q of multipliers.
pub(crate) struct MultiplierField<'a, M: Multipliers, H, T: Real> {
    pub(crate) multipliers: &'a M,
    pub(crate) hamiltonian: &'a H,
    pub(crate) start: Point<M::Space, T>,
    /// The pair A and A⁻¹. A is the multiplier of the course at the start of this step. The course continues as Q(t) A.
    pub(crate) frame: (Multiplier<M, T>, Multiplier<M, T>),
    /// Whether steps of the course come before this one.
    pub(crate) continues: bool,
}

impl<M, H, T> VectorField<T> for MultiplierField<'_, M, H, T>
where
    M: Multipliers,
    H: Hamiltonian<M::Space, T>,
    T: Real,
{
    type Point = Multiplier<M, T>;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, q: &Multiplier<M, T>) -> Multiplier<M, T> {
        let mu = self.multipliers.transport::<T>(q, &self.start);
        self.multipliers.generate::<T>(&self.hamiltonian.differential(&mu), q)
    }

    fn derivative(&self, q: &Multiplier<M, T>, v: &Multiplier<M, T>) -> Option<Multiplier<M, T>> {
        let moved: Multiplier<M, DualNumber<T>> = seed(q, v);
        let start: Point<M::Space, DualNumber<T>> =
            map_coordinates(&self.start, DualNumber::constant);
        let image = self.multipliers.transport::<DualNumber<T>>(&moved, &start);
        let dh = dual_differential::<M::Space, T, _>(self.hamiltonian, &image)?;
        Some(derivative_part(&self.multipliers.generate::<DualNumber<T>>(&dh, &moved)))
    }

    #[cfg_attr(optimised, inline(always))]
    fn stage_frame(&self) -> impl StageFrame<Multiplier<M, T>> {
        self
    }
}

/// The vector field of multipliers over any scalar, from its start over `f64`.
pub(crate) struct AnyScalar<'a, M: Multipliers, H>(pub(crate) &'a MultiplierField<'a, M, H, f64>);

impl<M, H, T> VectorField<T> for AnyScalar<'_, M, H>
where
    M: Multipliers,
    H: Hamiltonian<M::Space, T>,
    T: Real,
{
    type Point = Multiplier<M, T>;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, q: &Multiplier<M, T>) -> Multiplier<M, T> {
        let MultiplierField { multipliers, hamiltonian, start, .. } = *self.0;
        let start: Point<M::Space, T> = map_coordinates(&start, T::from_f64);
        let mu = multipliers.transport::<T>(q, &start);
        multipliers.generate::<T>(&hamiltonian.differential(&mu), q)
    }
}

/// The frame of the course, in which the stage derivatives are k A.
impl<M, H, T> StageFrame<Multiplier<M, T>> for &MultiplierField<'_, M, H, T>
where
    M: Multipliers,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn continues(&self) -> bool {
        self.continues
    }

    /// Writes k A, the stage derivative in the frame of the course.
    #[cfg_attr(optimised, inline(always))]
    fn remember(&self, k: &Multiplier<M, T>, past: &mut Multiplier<M, T>) {
        *past = self.multipliers.product::<T>(k, &self.frame.0);
    }

    /// Changes k to k A⁻¹, the stage derivative in the frame of this step.
    #[cfg_attr(optimised, inline(always))]
    fn recall(&self, k: &mut Multiplier<M, T>) {
        *k = self.multipliers.product::<T>(k, &self.frame.1);
    }
}

/// The record of successive steps of a multiplier.
#[derive(Debug)]
pub(crate) struct Course<V, Q> {
    /// The point where the last step ended.
    pub(crate) end: V,
    /// The multiplier A of all the steps together.
    pub(crate) moved: Q,
    pub(crate) steps: u64,
}

impl<V: Vector, Q> Course<V, Q> {
    /// Returns whether a step from μ continues the course.
    ///
    /// A trajectory begins a new course at every checkpoint, and so do steps outside of a trajectory, since A may grow.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn goes_on_from(&self, mu: &V) -> bool {
        // In wide registers the compiler would make this comparison a function call. It only serves to skip the more
        // exact one.
        let same = V::Scalar::HAS_SLOW_PATHS && self.end == *mu;
        self.steps < CHECKPOINT && (same || near(mu, &self.end).all())
    }
}
