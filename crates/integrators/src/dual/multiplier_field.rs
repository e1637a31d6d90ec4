//! The vector field of multipliers, and steps of it in a row.

use crate::stage_frame::StageFrame;
use crate::stages::history::near;
use crate::{CHECKPOINT, VectorField};
use lie_poisson::{
    Differential, DualNumber, Hamiltonian, Mask, Point, Real, Vector, derivative_part,
    map_coordinates, seed,
};
use momentum_map::{Multiplier, Multipliers};

/// Q ↦ dh(transport(Q, μ₀)) Q
pub(crate) struct MultiplierField<'a, M: Multipliers, H, T: Real> {
    pub(crate) multipliers: &'a M,
    pub(crate) hamiltonian: &'a H,
    pub(crate) start: Point<M::Space, T>,
    /// A and A⁻¹: where Q(t) of this step begins, that of its course is A, and continues as Q(t) A.
    pub(crate) frame: Option<(Multiplier<M, T>, Multiplier<M, T>)>,
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

    #[inline]
    fn at(&self, q: &Multiplier<M, T>) -> Multiplier<M, T> {
        let mu = self.multipliers.transport::<T>(q, &self.start);
        self.multipliers.generate::<T>(&self.hamiltonian.differential(&mu), q)
    }

    fn derivative(&self, q: &Multiplier<M, T>, v: &Multiplier<M, T>) -> Option<Multiplier<M, T>> {
        let moved: Multiplier<M, DualNumber<T>> = seed(q, v);
        let start: Point<M::Space, DualNumber<T>> =
            map_coordinates(&self.start, DualNumber::constant);
        let image = self.multipliers.transport::<DualNumber<T>>(&moved, &start);
        let mu: Point<M::Space, T> = map_coordinates(&image, |x| x.value);
        let hessian = self.hamiltonian.hessian(&mu, &derivative_part(&image))?;
        let dh: Differential<M::Space, DualNumber<T>> =
            seed(&self.hamiltonian.differential(&mu), &hessian);
        Some(derivative_part(&self.multipliers.generate::<DualNumber<T>>(&dh, &moved)))
    }

    #[inline]
    fn stage_frame(&self) -> impl StageFrame<Multiplier<M, T>> {
        self
    }
}

/// That of the course, in which the stage derivatives are k A.
impl<M, H, T> StageFrame<Multiplier<M, T>> for &MultiplierField<'_, M, H, T>
where
    M: Multipliers,
    T: Real,
{
    #[inline]
    fn continues(&self) -> bool {
        self.continues
    }

    /// k A
    #[inline]
    fn remembered(&self, k: &Multiplier<M, T>) -> Multiplier<M, T> {
        self.frame.map_or(*k, |(moved, _)| self.multipliers.product::<T>(k, &moved))
    }

    /// k A⁻¹
    #[inline]
    fn recalled(&self, k: &Multiplier<M, T>) -> Multiplier<M, T> {
        self.frame.map_or(*k, |(_, back)| self.multipliers.product::<T>(k, &back))
    }
}

/// Steps in a row.
#[derive(Debug)]
pub(crate) struct Course<V, Q> {
    /// Where the last one ended.
    pub(crate) end: V,
    /// The multiplier A of all of them.
    pub(crate) moved: Q,
    pub(crate) steps: u64,
}

impl<V: Vector, Q> Course<V, Q> {
    /// Whether a step from μ is one more of them. A trajectory begins anew at every checkpoint, and so
    /// do steps outside of one: A may grow.
    #[inline]
    pub(crate) fn goes_on_from(&self, mu: &V) -> bool {
        self.steps < CHECKPOINT && (self.end == *mu || near(mu, &self.end).all())
    }
}
