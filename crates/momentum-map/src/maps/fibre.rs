//! Fibres of a Poisson map, their symmetries and sections: [`Lift`], [`FibreSymmetry`].

use crate::maps::poisson_map::{Identity, PoissonMap, SourcePoint, TargetPoint};
use lie_poisson::{Point, PoissonSpace, Real, State};
use thiserror::Error;

/// The error returned for a point that has no finite pre-image.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("no lift: {reason} (|{quantity}| = {value:e})")]
pub struct LiftError {
    /// The quantity that rules out a lift.
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
        if lifted.is_finite() { Ok(lifted) } else { Err(Self { quantity, value, reason }) }
    }
}

/// A section of a Poisson map M: a choice of z with M(z) = μ.
#[diagnostic::on_unimplemented(
    message = "the Poisson map `{Self}` has no lift: no point z with M(z) = μ is known",
    label = "`Lift` is not implemented for this map",
    note = "implement `Lift` for a map of your own, or start from a point z of the source and use `apply(&z)` as μ"
)]
///
/// # Example
/// A map of your own with its lift: the angular momentum Π = q × p of a particle, with q = e₃ × Π or e₁ × Π.
/// ```
/// use lie_poisson::{Covector, LiePoisson, Real, RealSpace, So3};
/// use momentum_map::{Cotangent, CotangentBundle, Lift, LiftError, PoissonMap};
/// use nalgebra::Vector3;
///
/// #[derive(Clone)]
/// struct AngularMomentum;
/// impl PoissonMap for AngularMomentum {
///     type Source = CotangentBundle<RealSpace<3>>;
///     type Target = LiePoisson<So3>;
///     fn source(&self) -> Self::Source {
///         CotangentBundle(RealSpace)
///     }
///     fn target(&self) -> Self::Target {
///         LiePoisson::plus(So3)
///     }
///     fn apply<T: Real>(&self, z: &Cotangent<Vector3<T>>) -> Covector<Vector3<T>> {
///         Covector(z.q.cross(&z.p.0))
///     }
/// }
/// impl Lift for AngularMomentum {
///     fn lift<T: Real>(&self, Covector(pi): &Covector<Vector3<T>>) -> Result<Cotangent<Vector3<T>>, LiftError> {
///         // each SIMD lane takes the vector that does not vanish there
///         let (zero, steep) = (T::zero(), (pi.x * pi.x + pi.y * pi.y).at_most(pi.z * pi.z));
///         let choose = |a: T, b: T| T::select(steep, a, b);
///         let q = Vector3::new(choose(zero, -pi.y), choose(-pi.z, pi.x), choose(pi.y, zero));
///         let p = pi.cross(&q) * (T::one() / q.dot(&q));
///         let size = pi.dot(pi).max_abs().sqrt();
///         LiftError::unless_finite(Cotangent::new(q, Covector(p)), "Π", size, "Π must not be zero")
///     }
/// }
/// let pi = Covector(Vector3::new(1.0, -2.0, 0.5));
/// let z = AngularMomentum.lift::<f64>(&pi)?;
/// assert!((AngularMomentum.apply(&z) - pi).0.norm() < 1e-14);
/// assert!(AngularMomentum.lift::<f64>(&Covector(Vector3::zeros())).is_err());
/// # Ok::<(), LiftError>(())
/// ```
/// For a map whose type is not yours, see [`Realisation`](crate::Realisation).
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
/// The orbits of the symmetry are the connected components of the regular fibres of M. Every collective Hamiltonian
/// h∘M is invariant under the symmetry, so that its momenta are conserved (Noether's theorem). The pull-backs of the
/// Casimirs are functions of these momenta. A scheme on P descends to a map of 𝔤∗ if and only if it maps fibres to
/// fibres. For this it suffices that the scheme commutes with the flows of the symmetry.
///
/// Source: Ohsawa 2019, §4.2; McLachlan, Modin & Verdier, *Collective symplectic integrators*,
/// Nonlinearity 27 (2014).
///
/// # Example
/// The fibres of the Hopf map C² → so(3)∗ are circles:
/// ```
/// use momentum_map::{FibreSymmetry, HOPF, HopfRealisation, PoissonMap};
/// use nalgebra::Vector2;
/// use num_complex::Complex;
/// let z = Vector2::new(Complex::new(0.3, -0.7), Complex::new(0.5, 0.2));
/// let moved = HOPF.flow(0, 0.9, &z);
/// assert_eq!(HopfRealisation::COUNT, 1);
/// assert!((moved - z).norm() > 0.5);
/// assert!((HOPF.apply(&moved) - HOPF.apply(&z)).0.norm() < 1e-15);
/// // the momentum of the flow is a function of the Casimir |Π|
/// assert!((HOPF.momentum(0, &z).abs() - 2.0 * HOPF.apply(&z).0.norm()).abs() < 1e-15);
/// ```
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
