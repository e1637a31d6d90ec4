//! The damping of spins by Gilbert's equation: [`GilbertDamping`].

use crate::algebras::product::PowerAlgebra;
use crate::brackets::poisson::{LiePoisson, PoissonSpace};
use crate::brackets::product_space::PowerSpace;
use crate::groups::so3::So3;
use crate::orbits::orbit_field::OrbitField;
use generic_scalars::{Differential, Point, Real, State, Vector, euclidean_norm};
use nalgebra::Vector3;
use thiserror::Error;

/// A space of spins: its coordinates are those of s₁, s₂, … in R³, one spin after the other, and Λ(s) Ω has the parts
/// s_i × Ω_i for the minus bracket and −s_i × Ω_i for the plus bracket.
pub trait SpaceOfSpins: PoissonSpace {}

impl SpaceOfSpins for LiePoisson<So3> {}
impl<const N: usize> SpaceOfSpins for LiePoisson<PowerAlgebra<So3, N>> {}
impl<const N: usize> SpaceOfSpins for PowerSpace<LiePoisson<So3>, N> {}

/// The error returned for a damping that would feed energy, or is no number.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("the damping of spins is a finite number of at least 0, got {damping}")]
pub struct GilbertDampingError {
    /// The damping that was given.
    pub damping: f64,
}

/// The field of spins with Gilbert's damping α ≥ 0, which has no unit:
///
/// ```text
/// ds/dt = s × Ω + (α/|s|) s × ds/dt,    with Ω = ξ₀(s, t) the field that is damped, for the minus bracket,
/// ```
///
/// for each spin s. In a magnetic field B a spin has h = −γ s·B and Ω = −γ B, so that this is ds/dt = −γ s × B +
/// (α/|s|) s × ds/dt.
///
/// Since s·ds/dt = 0, the cross product of s with the equation gives s × ds/dt = s × (s × Ω) − α |s| ds/dt. This solves
/// it:
///
/// ```text
/// (1 + α²) ds/dt = s × Ω + (α/|s|) s × (s × Ω),    dh/dt = −Σ α/((1 + α²) |s|) |s × Ω|² for Ω = dh.
/// ```
///
/// It is the equation of Landau and Lifshitz with other constants: for spins of one length |s|, a
/// [`DoubleBracket`](crate::DoubleBracket) with θ = α/|s| of the field Ω/(1 + α²). Conversely, a double bracket of the
/// field Ω with the friction θ is Gilbert's equation with α = θ |s| and the field (1 + α²) Ω. So the precession slows
/// down by the factor 1 + α² with Gilbert's damping, and does not change with the other one. A spin of length 0 stays
/// 0.
///
/// For the plus bracket both cross products with s have the other sign, and the energy falls, too.
///
/// Sources: Landau & Lifshitz, Phys. Z. Sowjetunion 8 (1935); Gilbert, IEEE Trans. Magn. 40 (2004); Lakshmanan, Phil.
/// Trans. R. Soc. A 369 (2011).
///
/// # Example
/// Two spins of different lengths in the field e₃, h = −Σ s₃:
/// ```
/// use lie_poisson::{Autonomous, Covector, GilbertDamping, LiePoisson, OrbitField, PoissonSpace, Power, PowerAlgebra};
/// use lie_poisson::{So3, from_closure};
/// use nalgebra::Vector3;
/// let space = LiePoisson::minus(PowerAlgebra::<So3, 2>(So3));
/// let h = from_closure::<LiePoisson<PowerAlgebra<So3, 2>>, _>(|Covector(s)| -s.0[0].z - s.0[1].z);
/// let damped = GilbertDamping::new(space, Autonomous(h), 0.5)?;
/// let s = [Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.0, 3.0, 4.0)];
/// let at = Covector(Power(s));
/// let rate = space.hamiltonian_vector(&at, &damped.element(&at, 0.0)).0;
/// for (s, rate) in s.iter().zip(rate.0) {
///     let gilbert = s.cross(&-Vector3::z()) + s.cross(&rate) * (0.5 / s.norm());
///     assert!((rate - gilbert).norm() < 1e-15 * s.norm());
///     assert!(rate.z > 0.0);
/// }
/// assert!(GilbertDamping::new(space, damped.field(), -0.5).is_err());
/// # Ok::<(), lie_poisson::GilbertDampingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GilbertDamping<P, X> {
    space: P,
    field: X,
    damping: f64,
}

impl<P: SpaceOfSpins, X> GilbertDamping<P, X> {
    /// Creates a damped field from the space with its bracket, the field ξ₀ and the damping α.
    ///
    /// # Errors
    /// Returns [`GilbertDampingError`] if α is negative, infinite or NaN.
    pub fn new(space: P, field: X, damping: f64) -> Result<Self, GilbertDampingError> {
        match damping >= 0.0 && damping.is_finite() {
            true => Ok(Self { space, field, damping }),
            false => Err(GilbertDampingError { damping }),
        }
    }
}

impl<P, X> GilbertDamping<P, X> {
    /// Returns the field ξ₀ that is damped.
    pub const fn field(&self) -> &X {
        &self.field
    }

    /// Returns the damping α.
    pub const fn damping(&self) -> f64 {
        self.damping
    }
}

impl<P, X, T> OrbitField<P, T> for GilbertDamping<P, X>
where
    P: SpaceOfSpins,
    X: OrbitField<P, T>,
    T: Real,
{
    #[cfg_attr(optimised, inline(always))]
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T> {
        let mut xi = self.field.element(mu, time);
        let rate = self.space.hamiltonian_vector::<T>(mu, &xi);
        for spin in 0..Point::<P, T>::DIM / 3 {
            let places = [3 * spin, 3 * spin + 1, 3 * spin + 2];
            let of_spin = [
                places.map(
                    #[cfg_attr(optimised, inline(always))]
                    |i| mu.coordinate(i),
                ),
                places.map(
                    #[cfg_attr(optimised, inline(always))]
                    |i| rate.coordinate(i),
                ),
                places.map(
                    #[cfg_attr(optimised, inline(always))]
                    |i| xi.coordinate(i),
                ),
            ];
            for (i, damped) in places.into_iter().zip(gilbert_element(self.damping, of_spin)) {
                xi.set_coordinate(i, damped);
            }
        }
        xi
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.field.next_break(time, forward)
    }
}

/// Returns the element (ξ + (α/|s|) r)/(1 + α²) along which one spin s moves by Gilbert's equation with the damping α, of s, the
/// rate r = Λ(s) ξ that the element ξ makes, and ξ: for spins whose number is known only when the program runs. It is
/// ξ/(1 + α²) for s = 0, where the damping has no direction.
///
/// # Example
/// ```
/// use lie_poisson::gilbert_element;
/// // s = 2e₁ and ξ = e₃ in the minus bracket: r = s × ξ = −2e₂
/// assert_eq!(gilbert_element(1.0, [[2.0, 0.0, 0.0], [0.0, -2.0, 0.0], [0.0, 0.0, 1.0]]), [0.0, -0.5, 0.5]);
/// ```
#[cfg_attr(optimised, inline(always))]
#[must_use]
pub fn gilbert_element<T: Real>(damping: f64, [spin, rate, xi]: [[T; 3]; 3]) -> [T; 3] {
    let (slower, length) = (1.0 / (1.0 + damping * damping), euclidean_norm(&Vector3::from(spin)));
    let mut damped = xi;
    for (xi, rate) in damped.iter_mut().zip(rate) {
        *xi = (*xi + by_length(rate, length) * damping) * slower;
    }
    damped
}

/// Returns x/|s|, and 0 for s = 0, where the damping has no direction. It does not overflow for |x| ≤ |s| |Ω|, as 1/|s|
/// may.
#[cfg_attr(optimised, inline(always))]
fn by_length<T: Real>(x: T, length: T) -> T {
    let is_zero = length.at_most(T::zero());
    let divisor = T::select(is_zero, T::one(), length);
    T::select(is_zero, T::zero(), x / divisor)
}
