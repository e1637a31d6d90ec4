//! Poisson maps.

use crate::maps::recentring::{Both, RecentringSpace};
use lie_poisson::{
    Differential, DualNumber, Point, PoissonSpace, Real, Vector, transposed_tangent,
};

/// z in the source of a map, over the scalar `T`.
pub type SourcePoint<M, T = f64> = Point<<M as PoissonMap>::Source, T>;

/// A point in the target of a map, over the scalar `T`.
pub type TargetPoint<M, T = f64> = Point<<M as PoissonMap>::Target, T>;

/// A covector on the target of a map, over the scalar `T`; an element of 𝔤 if the target is 𝔤∗.
pub type TargetDifferential<M, T = f64> = Differential<<M as PoissonMap>::Target, T>;

/// A smooth map M: P → Q with {f ∘ M, h ∘ M}_P = {f, h}_Q ∘ M.
///
/// Only `apply` is asked for; that the map is Poisson is a promise that the law suite checks.
/// From P canonical to Q = 𝔤∗ it is a *realisation* of 𝔤∗, and lifts every Hamiltonian system
/// on 𝔤∗ to a canonical one, its *collective* dynamics:
///
/// ```text
/// X_{h∘M}(z) = generator(dh(M(z)), z)
/// ```
///
/// A scheme that commutes with affine maps descends to Q if the symmetry along the fibres of M acts
/// affinely, as it does for every realisation of this crate; it conserves Casimirs whose
/// pull-backs are functions of quadratic invariants.
///
/// If M is the momentum map of an action, `generator` is its infinitesimal generator ξ_P(z).
/// Written down by hand, it gives collective dynamics without any Jacobian.
///
/// Source: Guillemin & Sternberg, *The moment map and collective motion*, Ann. Phys. 127 (1980);
/// Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §10.3, §12.4.
pub trait PoissonMap: Clone {
    /// P
    type Source: PoissonSpace;

    /// Q
    type Target: PoissonSpace;

    /// P as a value.
    fn source(&self) -> Self::Source;

    /// Q as a value.
    fn target(&self) -> Self::Target;

    /// M(z)
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T>;

    /// The pull-back (T_z M)ᵀ α of a covector at M(z); derived from `apply` by dual numbers.
    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        transposed_tangent(
            |z: &SourcePoint<Self, DualNumber<T>>| self.apply::<DualNumber<T>>(z),
            z,
            alpha,
        )
    }

    /// The Hamiltonian vector field at z of z ↦ ⟨α, M(z)⟩ for constant α.
    ///
    /// By default Λ(z) (T_z M)ᵀ α.
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        self.source().hamiltonian_vector::<T>(z, &self.pull_back::<T>(alpha, z))
    }

    /// A displacement along the fibre that keeps z from running away: M(z + gauge(z)) = M(z).
    ///
    /// Along collective dynamics z may drift along its fibre, which is invisible in M(z) but costs
    /// digits. Collective integrators pass to z + gauge(z) after each step; it should mostly be 0,
    /// since stages are guessed from those of steps that follow each other, and itself free of rounding
    /// if it can. By default 0.
    #[inline]
    fn gauge<T: Real>(&self, _z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        Vector::zero()
    }

    /// A point z′ of the fibre through z near the origin: M(z′) = M(z) to the round-off of M at z, |z′| ≤ |z|.
    ///
    /// A collective run in which z has grown continues from there, since M(z), a difference of larger and larger
    /// products, would lose its digits and the stage equations their solution. Collective integrators ask when z
    /// has grown fourfold, and where a run may be resumed.
    ///
    /// By default z itself where M(z) has lost few bits, over lanes lane by lane; else the point of least norm,
    /// in units in which the blocks of z have equal size, is approached by Newton's iteration on the tangent map of M,
    /// from `apply` by dual numbers. It takes no lift and no [symmetry](crate::FibreSymmetry) to be known. Where that
    /// fails, as at points where M is not regular, z stays. A map with a [`gauge`](Self::gauge) of its own may
    /// return z.
    ///
    /// # Example
    /// A particle under rigid motions, J(q, p) = −(q × p, p), whose fibres are the lines q + sp:
    /// ```
    /// use lie_poisson::Covector;
    /// use momentum_map::{Cotangent, PARTICLE, PoissonMap, RecentringSpace};
    /// use nalgebra::Vector3;
    /// let (q, p) = (Vector3::new(0.0, 1.0, 0.0), Vector3::new(2.0, 0.0, 0.0));
    /// let far = Cotangent::new(q + p * 1000.0, Covector(p));
    /// let near = PARTICLE.recentred(&far, &mut RecentringSpace::default());
    /// assert!(near.q.norm() < 20.0);
    /// assert!((PARTICLE.apply(&near) - PARTICLE.apply(&far)).0.0.norm() < 1e-12);
    /// ```
    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<Self, T>,
        space: &mut RecentringSpace<T>,
    ) -> SourcePoint<Self, T> {
        let map = Both {
            apply: |z: &SourcePoint<Self, T>| self.apply::<T>(z),
            apply_dual: |z: &SourcePoint<Self, DualNumber<T>>| self.apply::<DualNumber<T>>(z),
        };
        space.recentred(&map, z)
    }
}

/// The composition `outer` ∘ `inner` of two Poisson maps, which is Poisson.
///
/// The differential is first pulled back through `outer`, and generated by `inner`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Composition<Outer, Inner> {
    /// The map that comes second.
    pub outer: Outer,
    /// The map that comes first.
    pub inner: Inner,
}

impl<Outer, Inner> PoissonMap for Composition<Outer, Inner>
where
    Inner: PoissonMap,
    Outer: PoissonMap<Source = Inner::Target>,
{
    type Source = Inner::Source;
    type Target = Outer::Target;

    fn source(&self) -> Self::Source {
        self.inner.source()
    }

    fn target(&self) -> Self::Target {
        self.outer.target()
    }

    #[inline]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        self.outer.apply::<T>(&self.inner.apply::<T>(z))
    }

    #[inline]
    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        let middle = self.outer.pull_back::<T>(alpha, &self.inner.apply::<T>(z));
        self.inner.pull_back::<T>(&middle, z)
    }

    #[inline]
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        let middle = self.outer.pull_back::<T>(alpha, &self.inner.apply::<T>(z));
        self.inner.generator::<T>(&middle, z)
    }

    #[inline]
    fn gauge<T: Real>(&self, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        self.inner.gauge::<T>(z)
    }
}

/// The identity of P.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Identity<P>(pub P);

impl<P: PoissonSpace> PoissonMap for Identity<P> {
    type Source = P;
    type Target = P;

    fn source(&self) -> P {
        self.0.clone()
    }

    fn target(&self) -> P {
        self.0.clone()
    }

    #[inline]
    fn apply<T: Real>(&self, z: &Point<P, T>) -> Point<P, T> {
        *z
    }

    #[inline]
    fn pull_back<T: Real>(
        &self,
        alpha: &Differential<P, T>,
        _: &Point<P, T>,
    ) -> Differential<P, T> {
        *alpha
    }
}
