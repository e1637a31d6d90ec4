//! Linear symplectic actions: [`SymplecticRepresentation`], [`Symplectic`].

use crate::phase_spaces::symplectic::{SymplecticComplexSpace, SymplecticSpace};
use lie_poisson::{
    Covector, Diagonal, Momentum, Pair, PoissonSpace, Power, Real, Representation,
    RepresentedElement, SL2OnR2, SU2OnC2, So3, Sum, UnitaryOnComplexSpace, Vector, VectorSpace,
    odd_power_defect,
};
use nalgebra::{SVector, Vector2, Vector3};
use num_complex::Complex;

/// A representation that preserves a symplectic form on V: Ω(ξu, v) + Ω(u, ξv) = 0.
///
/// [`Symplectic<R>`] is V as a symplectic vector space.
pub trait SymplecticRepresentation: Representation {
    /// Returns the symplectic form Ω(u, v).
    fn form<T: Real>(&self, u: &Self::Space<T>, v: &Self::Space<T>) -> T;

    /// Returns the vector x with Ω(x, ·) = α.
    fn sharp<T: Real>(&self, alpha: &Covector<Self::Space<T>>) -> Self::Space<T>;

    /// Returns the covector Ω(x, ·), the inverse of [`sharp`](Self::sharp).
    ///
    /// The default implementation evaluates the form once for each coordinate.
    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &Self::Space<T>) -> Covector<Self::Space<T>> {
        Covector::from_coordinates(|i| self.form::<T>(x, &Vector::basis(i)))
    }

    /// Returns whether the matrices of the representation contain their odd powers, so that affinely equivariant
    /// symplectic maps descend: see [`odd_power_defect`].
    ///
    /// The default implementation computes the defect and accepts values up to 10⁻¹². It takes about n³ products of
    /// matrices for an algebra of dimension n.
    fn odd_powers_belong(&self) -> bool {
        odd_power_defect(self) <= ODD_POWER_TOLERANCE
    }
}

/// The largest [`odd_power_defect`] that is a rounding error.
pub(crate) const ODD_POWER_TOLERANCE: f64 = 1e-12;

/// The symplectic vector space V of a representation.
///
/// For U(N) on C^N it is the same space as [`SymplecticComplexSpace`], but a different type. Maps can be composed
/// only if the types are equal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Symplectic<R>(pub R);

impl<R: Representation> VectorSpace for Symplectic<R> {
    type Point<T: Real> = R::Space<T>;
}

impl<R: SymplecticRepresentation> PoissonSpace for Symplectic<R> {
    #[cfg_attr(optimised, inline(always))]
    fn hamiltonian_vector<T: Real>(
        &self,
        _: &R::Space<T>,
        dh: &Covector<R::Space<T>>,
    ) -> R::Space<T> {
        self.0.sharp::<T>(dh)
    }
}

impl<R: SymplecticRepresentation> SymplecticSpace for Symplectic<R> {
    #[cfg_attr(optimised, inline(always))]
    fn symplectic_form<T: Real>(&self, u: &R::Space<T>, v: &R::Space<T>) -> T {
        self.0.form::<T>(u, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &R::Space<T>) -> Covector<R::Space<T>> {
        self.0.flat::<T>(x)
    }
}

/// The spin representation ξ ↦ −(i/2) ξ·σ of so(3) on C², which is the representation of su(2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct So3OnC2;

impl Representation for So3OnC2 {
    type Algebra = So3;
    type Space<T: Real> = Vector2<Complex<T>>;

    fn algebra(&self) -> So3 {
        So3
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
        SU2OnC2.act(xi, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &Vector3<T>,
        alpha: &Covector<Vector2<Complex<T>>>,
    ) -> Covector<Vector2<Complex<T>>> {
        SU2OnC2.transpose_act(xi, alpha)
    }

    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &Vector2<Complex<T>>,
        alpha: &Covector<Vector2<Complex<T>>>,
    ) -> Covector<Vector3<T>> {
        SU2OnC2.diamond(v, alpha)
    }
}

/// Implements the symplectic form Ω(u, v) = Im(u∗v) for representations on C^N by skew-Hermitian matrices.
macro_rules! unitary {
    ($($representation:ty, $n:expr, [$($generic:tt)*]);*) => {$(
        impl<$($generic)*> SymplecticRepresentation for $representation {
            #[cfg_attr(optimised, inline(always))]
            fn form<T: Real>(&self, u: &Self::Space<T>, v: &Self::Space<T>) -> T {
                SymplecticComplexSpace::<$n>.symplectic_form(u, v)
            }

            #[cfg_attr(optimised, inline(always))]
            fn sharp<T: Real>(&self, alpha: &Covector<Self::Space<T>>) -> Self::Space<T> {
                let zero: SVector<Complex<T>, $n> = Vector::zero();
                SymplecticComplexSpace::<$n>.hamiltonian_vector(&zero, alpha)
            }

            #[cfg_attr(optimised, inline(always))]
            fn flat<T: Real>(&self, x: &Self::Space<T>) -> Covector<Self::Space<T>> {
                SymplecticComplexSpace::<$n>.flat(x)
            }

            /// Returns true: the odd powers of skew-Hermitian matrices are skew-Hermitian, and those of matrices in
            /// su(2) are traceless.
            fn odd_powers_belong(&self) -> bool {
                true
            }
        }
    )*};
}
unitary!(So3OnC2, 2, []; SU2OnC2, 2, []; UnitaryOnComplexSpace<N>, N, [const N: usize]);

/// SL(2, R) preserves the area Ω(u, v) = u₁v₂ − u₂v₁.
impl SymplecticRepresentation for SL2OnR2 {
    #[cfg_attr(optimised, inline(always))]
    fn form<T: Real>(&self, u: &Vector2<T>, v: &Vector2<T>) -> T {
        u.x * v.y - u.y * v.x
    }

    #[cfg_attr(optimised, inline(always))]
    fn sharp<T: Real>(&self, alpha: &Covector<Vector2<T>>) -> Vector2<T> {
        Vector2::new(alpha.0.y, -alpha.0.x)
    }

    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &Vector2<T>) -> Covector<Vector2<T>> {
        Covector(Vector2::new(-x.y, x.x))
    }

    /// Returns true: ξ² is a multiple of the identity.
    fn odd_powers_belong(&self) -> bool {
        true
    }
}

/// A symplectic representation with the opposite form −Ω.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reversed<R>(pub R);

impl<R: Representation> Representation for Reversed<R> {
    type Algebra = R::Algebra;
    type Space<T: Real> = R::Space<T>;

    fn algebra(&self) -> R::Algebra {
        self.0.algebra()
    }

    #[cfg_attr(optimised, inline(always))]
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, v: &R::Space<T>) -> R::Space<T> {
        self.0.act::<T>(xi, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn transpose_act<T: Real>(
        &self,
        xi: &RepresentedElement<R, T>,
        alpha: &Covector<R::Space<T>>,
    ) -> Covector<R::Space<T>> {
        self.0.transpose_act::<T>(xi, alpha)
    }

    #[cfg_attr(optimised, inline(always))]
    fn diamond<T: Real>(
        &self,
        v: &R::Space<T>,
        alpha: &Covector<R::Space<T>>,
    ) -> Momentum<R::Algebra, T> {
        self.0.diamond::<T>(v, alpha)
    }
}

impl<R: SymplecticRepresentation> SymplecticRepresentation for Reversed<R> {
    #[cfg_attr(optimised, inline(always))]
    fn form<T: Real>(&self, u: &R::Space<T>, v: &R::Space<T>) -> T {
        -self.0.form::<T>(u, v)
    }

    #[cfg_attr(optimised, inline(always))]
    fn sharp<T: Real>(&self, alpha: &Covector<R::Space<T>>) -> R::Space<T> {
        -self.0.sharp::<T>(alpha)
    }

    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &R::Space<T>) -> Covector<R::Space<T>> {
        -self.0.flat::<T>(x)
    }

    fn odd_powers_belong(&self) -> bool {
        self.0.odd_powers_belong()
    }
}

impl<R, S> SymplecticRepresentation for Sum<R, S>
where
    R: SymplecticRepresentation,
    S: SymplecticRepresentation<Algebra = R::Algebra>,
{
    #[cfg_attr(optimised, inline(always))]
    fn form<T: Real>(&self, u: &Self::Space<T>, v: &Self::Space<T>) -> T {
        self.0.form::<T>(&u.0, &v.0) + self.1.form::<T>(&u.1, &v.1)
    }

    #[cfg_attr(optimised, inline(always))]
    fn sharp<T: Real>(&self, alpha: &Covector<Self::Space<T>>) -> Self::Space<T> {
        let Covector(Pair(first, second)) = *alpha;
        Pair(self.0.sharp::<T>(&Covector(first)), self.1.sharp::<T>(&Covector(second)))
    }

    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &Self::Space<T>) -> Covector<Self::Space<T>> {
        Covector(Pair(self.0.flat::<T>(&x.0).0, self.1.flat::<T>(&x.1).0))
    }
}

impl<R: SymplecticRepresentation, const N: usize> SymplecticRepresentation for Diagonal<R, N> {
    #[cfg_attr(optimised, inline(always))]
    fn form<T: Real>(&self, u: &Self::Space<T>, v: &Self::Space<T>) -> T {
        let terms = u.0.iter().zip(&v.0);
        terms.fold(T::zero(), |sum, (u, v)| sum + self.0.form::<T>(u, v))
    }

    #[cfg_attr(optimised, inline(always))]
    fn sharp<T: Real>(&self, alpha: &Covector<Self::Space<T>>) -> Self::Space<T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.sharp::<T>(&Covector(alpha.0.0[n])),
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &Self::Space<T>) -> Covector<Self::Space<T>> {
        Covector(Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| self.0.flat::<T>(&x.0[n]).0,
        ))
    }

    fn odd_powers_belong(&self) -> bool {
        self.0.odd_powers_belong()
    }
}
