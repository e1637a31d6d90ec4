//! A Poisson map whose fibres a separate type describes: [`Realisation`].

use crate::maps::fibre::{FibreSymmetry, Lift, LiftError};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential, TargetPoint};
use crate::maps::recentring::RecentringWorkspace;
use lie_poisson::{Differential, Real};

/// A description of the fibres of a Poisson map M, in a type separate from the map: a section, and where they are known
/// the symmetry along the fibres and a gauge.
///
/// Implement it for a type of your own. [`Realisation`] then attaches the type to the map.
pub trait Fibres<M: PoissonMap>: Clone {
    /// The number of one-parameter groups of the symmetry, as in [`FibreSymmetry`]; by default 0, for fibres whose
    /// symmetry is not described.
    const COUNT: usize = 0;

    /// Returns a point z with M(z) = μ, as [`Lift`] does.
    ///
    /// # Errors
    /// Returns [`LiftError`] if μ is not in the image of M or not finite, in any SIMD lane (one of several
    /// trajectories in a register).
    fn lift<T: Real>(
        &self,
        map: &M,
        mu: &TargetPoint<M, T>,
    ) -> Result<SourcePoint<M, T>, LiftError>;

    /// Returns the flow for parameter s of the group with the given index, or z for `index` ≥ `COUNT`.
    fn flow<T: Real>(
        &self,
        _map: &M,
        _index: usize,
        _s: T,
        z: &SourcePoint<M, T>,
    ) -> SourcePoint<M, T> {
        *z
    }

    /// Returns the momentum of the group with the given index, or zero for `index` ≥ `COUNT`.
    fn momentum<T: Real>(&self, _map: &M, _index: usize, _z: &SourcePoint<M, T>) -> T {
        T::zero()
    }

    /// Returns the displacement [`PoissonMap::gauge`] along the fibre, by default that of the map.
    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, map: &M, z: &SourcePoint<M, T>) -> SourcePoint<M, T> {
        map.gauge::<T>(z)
    }

    /// Returns the point [`PoissonMap::recentred`] of the fibre near the origin, by default that of the map.
    fn recentred<T: Real>(
        &self,
        map: &M,
        z: &SourcePoint<M, T>,
        space: &mut RecentringWorkspace<T>,
    ) -> SourcePoint<M, T> {
        map.recentred::<T>(z, space)
    }
}

/// A Poisson map M with the fibres that F describes.
///
/// A crate cannot implement [`Lift`] for the `MomentumMap` of its own action, since it owns neither the trait nor the
/// type constructor. It can implement [`Fibres`] for a type of its own, and attach that type to the map. The result is a Poisson map as M is, with the lift and the symmetry of F. The law suites check both.
///
/// The methods of the traits are generic over the scalar, which a closure cannot be. So F is a type with methods, not
/// a collection of closures.
///
/// # Example
/// The momentum map of the right action of SE(2) on the plane, J(q, p) = −(q₁p₂ − q₂p₁, p), with the lift of (Π, Γ) for
/// Γ ≠ 0:
/// ```
/// use lie_poisson::{Covector, Pair, Real, SO2OnR2};
/// use momentum_map::{
///     AffineAction, Cotangent, Fibres, Lift, LiftError, MomentumMap, Opposite, PoissonMap,
///     Realisation, SourcePoint, TargetPoint,
/// };
/// use nalgebra::{Vector1, Vector2};
/// type Map = MomentumMap<Opposite<AffineAction<SO2OnR2>>>;
///
/// #[derive(Clone)]
/// struct Lines; // the fibres are the lines q + sp
/// impl Fibres<Map> for Lines {
///     fn lift<T: Real>(
///         &self,
///         _: &Map,
///         mu: &TargetPoint<Map, T>,
///     ) -> Result<SourcePoint<Map, T>, LiftError> {
///         let Covector(Pair(pi, gamma)) = *mu;
///         let q = Vector2::new(gamma.y, -gamma.x) * (pi.x / gamma.dot(&gamma));
///         let z = Cotangent::new(q, Covector(-gamma));
///         LiftError::unless_finite(z, "Γ", 0.0, "Γ must be different from 0")
///     }
/// }
///
/// let map = Realisation::new(MomentumMap(Opposite(AffineAction(SO2OnR2))), Lines);
/// let mu = Covector(Pair(Vector1::new(0.7), Vector2::new(0.6, -0.8)));
/// assert!((map.apply(&map.lift(&mu)?) - mu).0.0.norm() < 1e-15);
/// assert!(map.lift(&Covector(Pair(Vector1::new(0.7), Vector2::new(0.0, 0.0)))).is_err());
/// # Ok::<(), LiftError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Realisation<M, F> {
    map: M,
    fibres: F,
}

impl<M: PoissonMap, F: Fibres<M>> Realisation<M, F> {
    /// Creates the map M with the fibres that F describes.
    pub const fn new(map: M, fibres: F) -> Self {
        Self { map, fibres }
    }

    /// Returns the map M.
    pub const fn map(&self) -> &M {
        &self.map
    }

    /// Returns the description of the fibres.
    pub const fn fibres(&self) -> &F {
        &self.fibres
    }
}

impl<M: PoissonMap, F: Fibres<M>> PoissonMap for Realisation<M, F> {
    type Source = M::Source;
    type Target = M::Target;

    fn source(&self) -> M::Source {
        self.map.source()
    }

    fn target(&self) -> M::Target {
        self.map.target()
    }

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &SourcePoint<M, T>) -> TargetPoint<M, T> {
        self.map.apply::<T>(z)
    }

    #[cfg_attr(optimised, inline(always))]
    fn pull_back<T: Real>(
        &self,
        alpha: &TargetDifferential<M, T>,
        z: &SourcePoint<M, T>,
    ) -> Differential<M::Source, T> {
        self.map.pull_back::<T>(alpha, z)
    }

    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Real>(
        &self,
        alpha: &TargetDifferential<M, T>,
        z: &SourcePoint<M, T>,
    ) -> SourcePoint<M, T> {
        self.map.generator::<T>(alpha, z)
    }

    fn equivariant_maps_descend(&self) -> bool {
        self.map.equivariant_maps_descend()
    }

    #[cfg_attr(optimised, inline(always))]
    fn gauge<T: Real>(&self, z: &SourcePoint<M, T>) -> SourcePoint<M, T> {
        self.fibres.gauge::<T>(&self.map, z)
    }

    fn recentred<T: Real>(
        &self,
        z: &SourcePoint<M, T>,
        space: &mut RecentringWorkspace<T>,
    ) -> SourcePoint<M, T> {
        self.fibres.recentred::<T>(&self.map, z, space)
    }
}

impl<M: PoissonMap, F: Fibres<M>> Lift for Realisation<M, F> {
    fn lift<T: Real>(&self, mu: &TargetPoint<M, T>) -> Result<SourcePoint<M, T>, LiftError> {
        self.fibres.lift::<T>(&self.map, mu)
    }
}

impl<M: PoissonMap, F: Fibres<M>> FibreSymmetry for Realisation<M, F> {
    const COUNT: usize = F::COUNT;

    fn flow<T: Real>(&self, index: usize, s: T, z: &SourcePoint<M, T>) -> SourcePoint<M, T> {
        self.fibres.flow::<T>(&self.map, index, s, z)
    }

    fn momentum<T: Real>(&self, index: usize, z: &SourcePoint<M, T>) -> T {
        self.fibres.momentum::<T>(&self.map, index, z)
    }
}
