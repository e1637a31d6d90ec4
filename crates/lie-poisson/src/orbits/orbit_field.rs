//! Fields of Lie algebra elements, whose motions stay on coadjoint orbits: [`OrbitField`].

use crate::brackets::hamiltonian::Hamiltonian;
use crate::brackets::poisson::PoissonSpace;
use crate::brackets::product_space::parts;
use crate::orbits::time_axis::{InTime, Time};
use generic_scalars::{Differential, Pair, Point, Real};

/// A field ξ: 𝔤∗ × R → 𝔤 over the scalar `T`, with the motion
///
/// ```text
/// dμ/dt = Λ(μ) ξ(μ, t),    which is ad∗_ξ μ for the minus bracket and −ad∗_ξ μ for the plus bracket.
/// ```
///
/// The motion stays on the symplectic leaves, which are the coadjoint orbits of 𝔤∗, whatever ξ is: every Casimir C is
/// constant, since Λ dC = 0. A Hamiltonian is the case ξ = dh, [`Autonomous`], and one that depends on time the case ξ
/// = `d_μ` h(μ, t), [`TimeDependent`]; their flows are Poisson maps. The flow of any other ξ, such as that of a
/// [`DoubleBracket`](crate::DoubleBracket) or of a control, conserves the Casimirs alone.
///
/// Sources: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §14.3; Bloch, Krishnaprasad, Marsden &
/// Ratiu, *The Euler–Poincaré equations and double bracket dissipation*, Commun. Math. Phys. 175 (1996).
///
/// # Example
/// A spin that is turned about e₃ at the rate Π₁ cos t; this ξ is the gradient of no function:
/// ```
/// use lie_poisson::{Casimirs, Covector, LiePoisson, OrbitField, PoissonSpace, Real, So3};
/// use nalgebra::Vector3;
/// struct Turn;
/// impl<T: Real> OrbitField<LiePoisson<So3>, T> for Turn {
///     fn element(&self, Covector(pi): &Covector<Vector3<T>>, time: T) -> Vector3<T> {
///         Vector3::new(T::zero(), T::zero(), time.cos() * pi.x)
///     }
/// }
/// let pi = Covector(Vector3::new(1.0, 2.0, 2.0));
/// let rate = LiePoisson::minus(So3).hamiltonian_vector(&pi, &Turn.element(&pi, 0.5));
/// assert_eq!(rate.0.dot(&pi.0), 0.0); // |Π|² is a Casimir
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no field of Lie algebra elements on `{P}` over `{T}`",
    note = "implement `OrbitField`; a Hamiltonian is `Autonomous(h)`, and one that depends on time `TimeDependent(h)`"
)]
pub trait OrbitField<P: PoissonSpace, T: Real = f64> {
    /// Returns ξ(μ, t), an element of 𝔤.
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T>;

    /// Returns the next time strictly after `time`, or strictly before it if `forward` is false, at which ξ or a
    /// derivative of it jumps, such as a time of an [`InputTable`](crate::InputTable). Integrators end a step there,
    /// since a step across a jump loses the order of its method. There is none by default.
    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        let (_, _) = (time, forward);
        None
    }
}

/// A reference to a field is a field.
impl<P: PoissonSpace, T: Real, X: OrbitField<P, T> + ?Sized> OrbitField<P, T> for &X {
    #[cfg_attr(optimised, inline(always))]
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T> {
        (**self).element(mu, time)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        (**self).next_break(time, forward)
    }
}

/// The field ξ = dh(μ) of a Hamiltonian that does not depend on time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Autonomous<H>(pub H);

impl<P: PoissonSpace, T: Real, H: Hamiltonian<P, T>> OrbitField<P, T> for Autonomous<H> {
    #[cfg_attr(optimised, inline(always))]
    fn element(&self, mu: &Point<P, T>, _: T) -> Differential<P, T> {
        self.0.differential(mu)
    }
}

/// The field ξ = `d_μ` h(μ, t) of a Hamiltonian that depends on time: a Hamiltonian on [`InTime<P>`](InTime).
///
/// If h has jumps in time, as inputs by tables make, [`WithBreakpoints`](crate::WithBreakpoints) tells them.
///
/// # Example
/// A spin in a field that oscillates, h = −Π₁ cos t:
/// ```
/// use lie_poisson::{Automatic, Energy, InTime, LiePoisson, OrbitField, Pair, Point, Real, So3, Time, TimeDependent};
/// use lie_poisson::Covector;
/// use nalgebra::Vector3;
/// struct Oscillating;
/// impl Energy for Oscillating {
///     type Space = InTime<LiePoisson<So3>>;
///     fn energy<T: Real>(&self, Pair(pi, Time(t)): &Point<Self::Space, T>) -> T {
///         -(pi.0.x * t.cos())
///     }
/// }
/// let xi = TimeDependent(Automatic(Oscillating)).element(&Covector(Vector3::y()), 0.5);
/// assert_eq!(xi, Vector3::new(-0.5_f64.cos(), 0.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TimeDependent<H>(pub H);

impl<P, T, H> OrbitField<P, T> for TimeDependent<H>
where
    P: PoissonSpace,
    T: Real,
    H: Hamiltonian<InTime<P>, T>,
{
    #[cfg_attr(optimised, inline(always))]
    fn element(&self, mu: &Point<P, T>, time: T) -> Differential<P, T> {
        parts(&self.0.differential(&Pair(*mu, Time(time)))).0
    }
}
