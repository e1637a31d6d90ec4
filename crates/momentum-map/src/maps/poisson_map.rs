//! Poisson maps and their composition: [`PoissonMap`], [`ComposedMap`].

use crate::maps::recentring::{Both, RecentringWorkspace, Sizes, block_sizes};
use lie_poisson::{
    Differential, DualNumber, Point, PoissonSpace, Real, Vector, transposed_tangent,
};

/// A point z of the source of a map, over the scalar `T`.
pub type SourcePoint<M, T = f64> = Point<<M as PoissonMap>::Source, T>;

/// A point of the target of a map, over the scalar `T`.
pub type TargetPoint<M, T = f64> = Point<<M as PoissonMap>::Target, T>;

/// A covector on the target of a map, over the scalar `T`; an element of 𝔤 if the target is 𝔤∗.
pub type TargetDifferential<M, T = f64> = Differential<<M as PoissonMap>::Target, T>;

/// A smooth map M: P → Q that preserves Poisson brackets: {f∘M, h∘M} on P is {f, h}∘M.
///
/// Only `apply` is required. The trait cannot enforce that the map is Poisson; the law suite tests it. If P is
/// canonical and Q = 𝔤∗, the map is a *realisation* of 𝔤∗. It lifts every Hamiltonian system on 𝔤∗ to a canonical
/// one, the *collective* dynamics of the system:
///
/// ```text
/// X_(h∘M)(z) = generator(dh(M(z)), z)
/// ```
///
/// An approximation of the collective flow that commutes with affine maps descends to Q if the symmetry along the
/// fibres of M acts affinely, or if the action is linear and the matrices of the algebra contain their odd powers.
/// The method [`equivariant_maps_descend`](Self::equivariant_maps_descend) returns whether it does. If the
/// approximation is symplectic, it conserves the Casimirs whose pull-backs are functions of quadratic invariants.
///
/// If M is the momentum map of an action, `generator` is the infinitesimal generator ξ_P(z). If `generator` is
/// implemented by hand, collective dynamics needs no Jacobian.
///
/// Source: Guillemin & Sternberg, *The moment map and collective motion*, Ann. Phys. 127 (1980);
/// Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §10.3, §12.4.
pub trait PoissonMap: Clone {
    /// The source P of the map.
    type Source: PoissonSpace;

    /// The target Q of the map.
    type Target: PoissonSpace;

    /// Returns the source P as a value.
    fn source(&self) -> Self::Source;

    /// Returns the target Q as a value.
    fn target(&self) -> Self::Target;

    /// Returns the image M(z).
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T>;

    /// Returns the pull-back (T_z M)ᵀ α of a covector at M(z), by default derived from `apply` by dual
    /// numbers.
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

    /// Returns the Hamiltonian vector field at z of the function z ↦ ⟨α, M(z)⟩ for constant α.
    ///
    /// The default implementation returns Λ(z) (T_z M)ᵀ α.
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        self.source().hamiltonian_vector::<T>(z, &self.pull_back::<T>(alpha, z))
    }

    /// Returns whether affinely equivariant approximations Φ of collective flows, such as those of symplectic
    /// Runge–Kutta methods, descend to Q: whether M(Φ(z)) depends on M(z) alone.
    ///
    /// Only then may z be moved along its fibre between such maps. The default is true. Override it for a map of your
    /// own whose fibres have no affine symmetry. The maps of this crate compute the answer from the matrices of their
    /// action, or ask the maps that they consist of.
    ///
    /// # Example
    /// The [`ClebschMap`](crate::ClebschMap) of so(3), and the Clebsch map of the plane with a dilation with two
    /// rates:
    /// ```
    /// use lie_poisson::{InfinitesimalAdjoint, So3, StructureConstants};
    /// use momentum_map::{PoissonMap, Side, clebsch_map};
    /// assert!(clebsch_map(InfinitesimalAdjoint(So3), Side::Left).equivariant_maps_descend());
    /// // [e₀, e₂] = e₀, [e₁, e₂] = 2e₁
    /// let rates = StructureConstants::<3>::new(|i, j, k| match (i, j, k) {
    ///     (0, 2, 0) => 1.0,
    ///     (2, 0, 0) => -1.0,
    ///     (1, 2, 1) => 2.0,
    ///     (2, 1, 1) => -2.0,
    ///     _ => 0.0,
    /// })?;
    /// assert!(!clebsch_map(InfinitesimalAdjoint(rates), Side::Left).equivariant_maps_descend());
    /// # Ok::<(), lie_poisson::StructureError>(())
    /// ```
    fn equivariant_maps_descend(&self) -> bool {
        true
    }

    /// Returns a displacement along the fibre that keeps z from growing along the fibre: M(z + gauge(z)) = M(z).
    ///
    /// Under collective dynamics z may drift along its fibre. The drift is invisible in M(z), but costs
    /// digits. Collective integrators replace z by z + gauge(z). The gauge should be 0 at most points, so that
    /// neighbouring points of a motion stay neighbours, and its addition should be free of rounding errors if
    /// possible. The default is 0.
    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, _z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        Vector::zero()
    }

    /// Returns a point z′ near the origin on the fibre through z: M(z′) = M(z) and |z′| ≤ |z|.
    ///
    /// The equation holds to the round-off of M at z. Collective integrators continue from z′ when z has grown
    /// fourfold, because M(z) is a difference of larger and larger products: it would lose its digits, and the
    /// equations for the next point would lose their solution. They also ask for z′ at points from which a run may be
    /// resumed.
    ///
    /// The default implementation treats each SIMD lane (one of several trajectories in a register) separately. It
    /// returns z itself where M(z) has lost few bits. Elsewhere it approaches the point of least norm, in units in
    /// which the blocks of z have equal size. It uses Newton's iteration on the tangent map of M, which comes from
    /// `apply` by dual numbers. It needs neither a lift nor a [symmetry](crate::FibreSymmetry) of M. Where the
    /// iteration fails, as at points where M is not regular, it returns z. A map with a [`gauge`](Self::gauge) of its
    /// own may return z.
    ///
    /// # Example
    /// For a particle under rigid motions, J(q, p) = −(q × p, p), the fibres are the lines q + sp:
    /// ```
    /// use lie_poisson::Covector;
    /// use momentum_map::{Cotangent, PARTICLE, PoissonMap, RecentringWorkspace};
    /// use nalgebra::Vector3;
    /// let (q, p) = (Vector3::new(0.0, 1.0, 0.0), Vector3::new(2.0, 0.0, 0.0));
    /// let far = Cotangent::new(q + p * 1000.0, Covector(p));
    /// let near = PARTICLE.recentred(&far, &mut RecentringWorkspace::default());
    /// assert!(near.q.norm() < 20.0);
    /// assert!((PARTICLE.apply(&near) - PARTICLE.apply(&far)).0.0.norm() < 1e-12);
    /// ```
    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<Self, T>,
        space: &mut RecentringWorkspace<T>,
    ) -> SourcePoint<Self, T> {
        let map = Both {
            apply: |z: &SourcePoint<Self, T>| self.apply::<T>(z),
            apply_dual: |z: &SourcePoint<Self, DualNumber<T>>| self.apply::<DualNumber<T>>(z),
        };
        let sizes = block_sizes(z);
        space.recentred(&map, z, Sizes { units: &sizes, factors: &sizes })
    }
}

/// The composition `outer` ∘ `inner` of two Poisson maps, which is a Poisson map.
///
/// Its generator first pulls the differential back through `outer`, then applies the generator of `inner`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ComposedMap<Outer, Inner> {
    /// The map that is applied second.
    pub outer: Outer,
    /// The map that is applied first.
    pub inner: Inner,
}

impl<Outer, Inner> PoissonMap for ComposedMap<Outer, Inner>
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

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        self.outer.apply::<T>(&self.inner.apply::<T>(z))
    }

    #[cfg_attr(optimised, inline(always))]
    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        let middle = self.outer.pull_back::<T>(alpha, &self.inner.apply::<T>(z));
        self.inner.pull_back::<T>(&middle, z)
    }

    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        let middle = self.outer.pull_back::<T>(alpha, &self.inner.apply::<T>(z));
        self.inner.generator::<T>(&middle, z)
    }

    /// Returns whether equivariant maps descend along both maps.
    fn equivariant_maps_descend(&self) -> bool {
        self.inner.equivariant_maps_descend() && self.outer.equivariant_maps_descend()
    }

    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, z: &SourcePoint<Self, T>) -> SourcePoint<Self, T> {
        self.inner.gauge::<T>(z)
    }
}

/// The identity map of a Poisson space P.
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

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &Point<P, T>) -> Point<P, T> {
        *z
    }

    #[cfg_attr(optimised, inline(always))]
    fn pull_back<T: Real>(
        &self,
        alpha: &Differential<P, T>,
        _: &Point<P, T>,
    ) -> Differential<P, T> {
        *alpha
    }
}
