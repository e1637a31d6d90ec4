//! Hamiltonians and their exact differentials: [`Hamiltonian`], [`Energy`].

use crate::brackets::poisson::PoissonSpace;
use core::marker::PhantomData;
use generic_scalars::{Differential, DualNumber, Point, Real, derivative_part, differential, seed};

/// A function h: P → R with its differential, over the scalar `T`.
///
/// On P = 𝔤∗ the differential dh(μ) lies in 𝔤: it is a velocity. There are three ways to make a
/// Hamiltonian:
///
/// * implement [`Energy`] and wrap it in [`Automatic`]: one generic formula for every scalar, differentiated by dual
///   numbers;
/// * pass closures over `f64` to [`from_closure`], which differentiates automatically, or to [`from_closures`], with
///   a differential written by hand;
/// * implement this trait with a differential written by hand, which is the fastest way.
///
/// # Example
/// The free rigid body, with an explicit differential:
/// ```
/// use lie_poisson::{Covector, Hamiltonian, LiePoisson, PoissonSpace, Real, So3};
/// use nalgebra::Vector3;
///
/// struct RigidBody {
///     moments: [f64; 3],
/// }
/// impl<T: Real> Hamiltonian<LiePoisson<So3>, T> for RigidBody {
///     fn value(&self, pi: &Covector<Vector3<T>>) -> T {
///         self.differential(pi).dot(&pi.0) * 0.5
///     }
///     fn differential(&self, Covector(pi): &Covector<Vector3<T>>) -> Vector3<T> {
///         let [a, b, c] = self.moments;
///         Vector3::new(pi.x / a, pi.y / b, pi.z / c)
///     }
/// }
///
/// let body = RigidBody { moments: [1.0, 2.0, 4.0] };
/// let pi = Covector(Vector3::new(1.0, 1.0, 1.0));
/// let omega = body.differential(&pi);
/// assert_eq!(omega, Vector3::new(1.0, 0.5, 0.25));
/// // Euler's equations dΠ/dt = Π × Ω
/// let rate = LiePoisson::minus(So3).hamiltonian_vector(&pi, &omega);
/// assert_eq!(rate, Covector(pi.0.cross(&omega)));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a Hamiltonian on `{P}` over `{T}`",
    label = "no value and differential over `{T}`",
    note = "implement `Energy` (one formula for all scalars) and pass `Automatic(…)` of it",
    note = "`from_closure` and `from_closures` make Hamiltonians over `f64` alone",
    note = "an implementation by hand serves all scalars as `impl<T: Real> Hamiltonian<…, T> for …`"
)]
pub trait Hamiltonian<P: PoissonSpace, T: Real = f64> {
    /// Returns the value h(z).
    fn value(&self, z: &Point<P, T>) -> T;

    /// Returns the differential dh(z), a covector at z.
    fn differential(&self, z: &Point<P, T>) -> Differential<P, T>;

    /// Returns the derivative D²h(z)·v of dh at z along v, or `None` if it is not known, as for closures.
    ///
    /// Newton's iteration for the stages of an implicit method uses this derivative. A Hamiltonian that is
    /// implemented over all scalars can return [`hessian_by_dual_numbers`].
    #[inline]
    fn hessian(&self, _z: &Point<P, T>, _v: &Point<P, T>) -> Option<Differential<P, T>> {
        None
    }
}

/// Computes D²h(z)·v exactly by dual numbers, for a Hamiltonian that is implemented over every scalar.
///
/// Use it as the body of [`Hamiltonian::hessian`].
#[inline]
pub fn hessian_by_dual_numbers<P, T, H>(
    h: &H,
    z: &Point<P, T>,
    v: &Point<P, T>,
) -> Differential<P, T>
where
    P: PoissonSpace,
    T: Real,
    H: Hamiltonian<P, DualNumber<T>>,
{
    derivative_part(&h.differential(&seed(z, v)))
}

/// A reference to a Hamiltonian is a Hamiltonian.
impl<P: PoissonSpace, T: Real, H: Hamiltonian<P, T> + ?Sized> Hamiltonian<P, T> for &H {
    #[cfg_attr(optimised, inline(always))]
    fn value(&self, z: &Point<P, T>) -> T {
        (**self).value(z)
    }

    #[cfg_attr(optimised, inline(always))]
    fn differential(&self, z: &Point<P, T>) -> Differential<P, T> {
        (**self).differential(z)
    }

    #[inline]
    fn hessian(&self, z: &Point<P, T>, v: &Point<P, T>) -> Option<Differential<P, T>> {
        (**self).hessian(z, v)
    }
}

/// An energy h(z), given by one formula that is written once for all scalars. [`Automatic`] makes a [`Hamiltonian`] of
/// it.
///
/// # Example
/// ```
/// use lie_poisson::*;
/// use nalgebra::Vector3;
///
/// struct FreeBody {
///     inertia: Vector3<f64>,
/// }
/// impl Energy for FreeBody {
///     type Space = LiePoisson<So3>;
///     fn energy<T: Real>(&self, Covector(pi): &Covector<Vector3<T>>) -> T {
///         let term = |pi: T, inertia: f64| pi * pi / inertia * 0.5;
///         term(pi.x, self.inertia.x) + term(pi.y, self.inertia.y) + term(pi.z, self.inertia.z)
///     }
/// }
///
/// let h = Automatic(FreeBody { inertia: Vector3::new(1.0, 2.0, 4.0) });
/// // dh = I⁻¹ Π, the angular velocity
/// let omega = h.differential(&Covector(Vector3::new(1.0, 1.0, 1.0)));
/// assert_eq!(omega, Vector3::new(1.0, 0.5, 0.25));
/// ```
pub trait Energy {
    /// The space on which the energy is defined.
    type Space: PoissonSpace;

    /// Returns the energy h(z).
    fn energy<T: Real>(&self, z: &Point<Self::Space, T>) -> T;
}

/// Defines an [`Energy`] from its name, its parameters, its space and one formula.
///
/// The formula becomes the body of a method over the scalar `T: Real`, so a number of type `f64` must stand on the
/// right of a product. Wrap the value in [`Automatic`], which adds the exact differential.
///
/// # Example
/// ```
/// use lie_poisson::*;
/// use nalgebra::Vector3;
///
/// energy!(FreeBody { inertia: Vector3<f64> } on LiePoisson<So3>: |body, Covector(pi)| {
///     (pi.x * pi.x / body.inertia.x + pi.y * pi.y / body.inertia.y + pi.z * pi.z / body.inertia.z) * 0.5
/// });
/// let h = Automatic(FreeBody { inertia: Vector3::new(1.0, 2.0, 4.0) });
/// let pi = Covector(Vector3::new(1.0, 1.0, 1.0));
/// assert_eq!(h.value(&pi), 0.875);
/// assert_eq!(h.differential(&pi), Vector3::new(1.0, 0.5, 0.25));
///
/// energy!(pub Height {} on LiePoisson<Se3>: |_height, Covector(Pair(_, gamma))| gamma.z);
/// assert_eq!(Automatic(Height {}).value(&Se3Dual::<f64>::new(Vector3::zeros(), Vector3::z())), 1.0);
/// ```
#[macro_export]
macro_rules! energy {
    (
        $(#[$attribute:meta])*
        $visibility:vis $name:ident { $($parameter:ident: $kind:ty),* $(,)? }
        on $space:ty: |$system:ident, $point:pat_param| $formula:expr
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Debug)]
        $visibility struct $name {
            $($visibility $parameter: $kind),*
        }

        impl $crate::Energy for $name {
            type Space = $space;

            #[inline(always)]
            fn energy<T: $crate::Real>(&self, $point: &$crate::Point<$space, T>) -> T {
                let $system = self;
                $formula
            }
        }
    };
}

/// The [`Hamiltonian`] of an [`Energy`], with its exact differential by dual numbers.
#[derive(Clone, Copy, Debug, Default)]
pub struct Automatic<E>(pub E);

impl<E: Energy, T: Real> Hamiltonian<E::Space, T> for Automatic<E> {
    #[cfg_attr(optimised, inline(always))]
    fn value(&self, z: &Point<E::Space, T>) -> T {
        self.0.energy::<T>(z)
    }

    #[cfg_attr(optimised, inline(always))]
    fn differential(&self, z: &Point<E::Space, T>) -> Differential<E::Space, T> {
        differential(
            #[cfg_attr(optimised, inline(always))]
            |z: &Point<E::Space, DualNumber<T>>| self.0.energy::<DualNumber<T>>(z),
            z,
        )
    }

    #[inline]
    fn hessian(
        &self,
        z: &Point<E::Space, T>,
        v: &Point<E::Space, T>,
    ) -> Option<Differential<E::Space, T>> {
        Some(hessian_by_dual_numbers::<E::Space, T, _>(self, z, v))
    }
}

/// Creates a Hamiltonian from a closure over dual numbers, differentiated automatically.
///
/// # Example
/// ```
/// use lie_poisson::*;
/// use nalgebra::Vector3;
/// let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.y);
/// let dh = h.differential(&Covector(Vector3::new(2.0, 3.0, 0.0)));
/// assert_eq!(dh, Vector3::new(3.0, 2.0, 0.0));
/// ```
pub fn from_closure<P, F>(energy: F) -> Closure<P, F>
where
    P: PoissonSpace,
    F: Fn(&Point<P, DualNumber>) -> DualNumber,
{
    Closure { energy, space: PhantomData }
}

/// The Hamiltonian of one closure, created by [`from_closure`].
#[derive(Clone, Copy, Debug)]
pub struct Closure<P, F> {
    energy: F,
    space: PhantomData<fn() -> P>,
}

impl<P, F> Hamiltonian<P> for Closure<P, F>
where
    P: PoissonSpace,
    F: Fn(&Point<P, DualNumber>) -> DualNumber,
{
    fn value(&self, z: &Point<P>) -> f64 {
        (self.energy)(&crate::map_coordinates(z, DualNumber::constant)).value_without_derivative()
    }

    fn differential(&self, z: &Point<P>) -> Differential<P> {
        differential(&self.energy, z)
    }
}

/// Creates a Hamiltonian from two closures: the value, and the differential written by hand.
///
/// # Example
/// ```
/// use lie_poisson::*;
/// use nalgebra::Vector3;
/// let h = from_closures::<LiePoisson<So3>, _, _>(
///     |Covector(pi)| 0.5 * pi.dot(pi),
///     |Covector(pi)| *pi,
/// );
/// assert_eq!(h.differential(&Covector(Vector3::x())), Vector3::x());
/// ```
pub fn from_closures<P, F, D>(value: F, differential: D) -> Closures<P, F, D>
where
    P: PoissonSpace,
    F: Fn(&Point<P>) -> f64,
    D: Fn(&Point<P>) -> Differential<P>,
{
    Closures { value, differential, space: PhantomData }
}

/// The Hamiltonian of two closures, created by [`from_closures`].
#[derive(Clone, Copy, Debug)]
pub struct Closures<P, F, D> {
    value: F,
    differential: D,
    space: PhantomData<fn() -> P>,
}

impl<P, F, D> Hamiltonian<P> for Closures<P, F, D>
where
    P: PoissonSpace,
    F: Fn(&Point<P>) -> f64,
    D: Fn(&Point<P>) -> Differential<P>,
{
    fn value(&self, z: &Point<P>) -> f64 {
        (self.value)(z)
    }

    fn differential(&self, z: &Point<P>) -> Differential<P> {
        (self.differential)(z)
    }
}
