//! Noise that moves along coadjoint orbits: [`Noise`], [`IsotropicNoise`].

use crate::brackets::poisson::PoissonSpace;
use crate::dissipation::dissipation_error::DissipationError;
use crate::orbits::inner_product::InnerProduct;
use generic_scalars::{Differential, Point, Real, Vector};

/// Fields σ_k: 𝔤∗ × R → 𝔤 that are driven by independent Brownian motions `W_k`, in Stratonovich's sense:
///
/// ```text
/// dμ = Λ(μ) ξ(μ, t) dt + Σ_k Λ(μ) σ_k(μ, t) ∘ dW_k
/// ```
///
/// Each path stays on its coadjoint orbit, so that all Casimirs are constant along it. The unit of σ_k is that of ξ times the
/// root of a time.
///
/// Source: Lázaro-Camí & Ortega, *Stochastic Hamiltonian dynamical systems*, Rep. Math. Phys. 61 (2008), for σ_k = dh_k.
///
/// # Example
/// A field about e₃ that fluctuates:
/// ```
/// use lie_poisson::{Covector, LiePoisson, Noise, PoissonSpace, Real, So3};
/// use nalgebra::Vector3;
/// struct Fluctuating {
///     strength: f64,
/// }
/// impl<T: Real> Noise<LiePoisson<So3>, T> for Fluctuating {
///     fn count(&self) -> usize {
///         1
///     }
///     fn element(&self, _: &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
///         Vector3::new(T::zero(), T::zero(), weights[0] * self.strength)
///     }
/// }
/// let pi = Covector(Vector3::new(1.0, 2.0, 2.0));
/// let xi = Fluctuating { strength: 0.5 }.element(&pi, 0.0, &[0.2]);
/// assert_eq!(LiePoisson::minus(So3).hamiltonian_vector(&pi, &xi).0, Vector3::new(0.2, -0.1, 0.0));
/// ```
pub trait Noise<P: PoissonSpace, T: Real = f64> {
    /// Returns the number of Brownian motions.
    fn count(&self) -> usize;

    /// Returns Σ_k w_k σ_k(μ, t) for as many weights as there are Brownian motions.
    fn element(&self, mu: &Point<P, T>, time: T, weights: &[T]) -> Differential<P, T>;

    /// Returns whether no field σ_k depends on μ; the fields may depend on the time. Then the motion with σ_k alone is the coadjoint
    /// action of exp(s σ_k), which integrators that make the fields one after the other make exactly. The default is false, which
    /// is right for every noise.
    fn is_constant(&self) -> bool {
        false
    }

    /// Returns the next time strictly after `time`, or strictly before it if `forward` is false, at which a field σ_k or a
    /// derivative of it jumps, such as a time of an [`InputTable`](crate::InputTable). Integrators end a step there, as at the
    /// [breakpoints of the drift](crate::OrbitField::next_break). There is none by default.
    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let (_, _) = (time, forward);
        None
    }
}

/// A reference to a noise is a noise.
impl<P: PoissonSpace, T: Real, N: Noise<P, T> + ?Sized> Noise<P, T> for &N {
    fn count(&self) -> usize {
        (**self).count()
    }

    #[cfg_attr(optimised, inline(always))]
    fn element(&self, mu: &Point<P, T>, time: T, weights: &[T]) -> Differential<P, T> {
        (**self).element(mu, time, weights)
    }

    fn is_constant(&self) -> bool {
        (**self).is_constant()
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        (**self).next_break(time, forward)
    }
}

/// Noise that is the same in all directions of an inner product: constant fields σ_k = σ e_k, with elements e_k of 𝔤 that are
/// orthonormal.
///
/// With the double bracket of the same inner product and friction θ, and σ² = 2θkT, it is Langevin's dynamics at the temperature
/// T: the invariant measure on each orbit is exp(−h/kT) times Liouville's.
///
/// # Example
/// ```
/// use lie_poisson::{InnerProduct, IsotropicNoise, DissipationError};
/// let noise = IsotropicNoise::thermal(InnerProduct::euclidean(), (0.5, 2.0))?;
/// assert!((noise.strength - 2.0_f64.sqrt()).abs() < 1e-15); // √(2θkT)
/// let refused = IsotropicNoise::thermal(InnerProduct::euclidean(), (0.5, -2.0));
/// assert_eq!(refused, Err(DissipationError::Temperature { temperature: -2.0 }));
/// # Ok::<(), DissipationError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct IsotropicNoise {
    /// The inner product ♯.
    pub inner_product: InnerProduct,
    /// The strength σ.
    pub strength: f64,
}

impl IsotropicNoise {
    /// Returns the noise of a temperature, σ = √(2θkT) with the friction θ and the energy kT. Both must be 0 or positive.
    ///
    /// # Errors
    /// Returns [`DissipationError`] for a negative friction or temperature, or one that is no finite number.
    pub fn thermal(
        inner_product: InnerProduct,
        (friction, temperature): (f64, f64),
    ) -> Result<Self, DissipationError> {
        DissipationError::require_friction(friction)?;
        DissipationError::require_temperature(temperature)?;
        Ok(Self { inner_product, strength: thermal_strength(friction, temperature) })
    }
}

/// Returns the strength σ = √(2θkT) of the noise that goes with a friction θ at the energy kT, both 0 or positive.
///
/// ```
/// use lie_poisson::thermal_strength;
/// assert!((thermal_strength(0.5, 4.0) - 2.0).abs() < 1e-15);
/// assert!((thermal_strength(1e200, 2e200) / 2e200 - 1.0).abs() < 1e-15); // the product would overflow
/// ```
#[must_use]
pub fn thermal_strength(friction: f64, temperature: f64) -> f64 {
    2.0_f64.sqrt() * friction.sqrt() * temperature.sqrt()
}

impl<P: PoissonSpace, T: Real> Noise<P, T> for IsotropicNoise {
    /// Returns the dimension of the algebra.
    fn count(&self) -> usize {
        Point::<P, T>::DIM
    }

    #[cfg_attr(optimised, inline(always))]
    fn element(&self, _: &Point<P, T>, _: T, weights: &[T]) -> Differential<P, T> {
        self.inner_product.orthonormal::<P, T>(weights).scaled(T::from_f64(self.strength))
    }

    fn is_constant(&self) -> bool {
        true
    }
}
