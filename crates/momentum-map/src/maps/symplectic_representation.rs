//! Linear symplectic actions and their quadratic momentum maps: [`QuadraticMomentumMap`].

use crate::maps::poisson_map::TargetDifferential;
use crate::{PoissonMap, Side, SourcePoint, SymplecticComplexSpace, SymplecticSpace, TargetPoint};
use lie_poisson::{
    Covector, Diagonal, LiePoisson, Pair, PoissonSpace, Power, Real, Representation,
    RepresentedElement, SL2OnR2, SU2OnC2, So3, Su2, Sum, UnitaryOnComplexSpace, Vector,
    VectorSpace,
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
}

/// The symplectic vector space V of a representation.
///
/// [`SymplecticComplexSpace`] is the same space as that of U(N) on C^N, but another type. Maps can be
/// composed only if the types are equal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Symplectic<R>(pub R);

impl<R: Representation> VectorSpace for Symplectic<R> {
    type Point<T: Real> = R::Space<T>;
}

impl<R: SymplecticRepresentation> PoissonSpace for Symplectic<R> {
    #[inline]
    fn hamiltonian_vector<T: Real>(
        &self,
        _: &R::Space<T>,
        dh: &Covector<R::Space<T>>,
    ) -> R::Space<T> {
        self.0.sharp::<T>(dh)
    }
}

impl<R: SymplecticRepresentation> SymplecticSpace for Symplectic<R> {
    #[inline]
    fn symplectic_form<T: Real>(&self, u: &R::Space<T>, v: &R::Space<T>) -> T {
        self.0.form::<T>(u, v)
    }
}

/// The momentum map of a linear symplectic action, derived from its representation:
///
/// ```text
/// ⟨J(z), ξ⟩ = ½ Ω(ξ_P z, z),    ξ_P z = ξz for the left action, −ξz for the right one
/// ```
///
/// The generator is ξ_P z. The maps to so(3)∗ from C² by the Hopf map, to sl(2, R)∗ from R²ⁿ and to u(N)∗ by
/// outer products are all of this kind, and share this code.
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., Ch. 12
/// (linear symplectic actions); McLachlan, Modin & Verdier, *Collective symplectic integrators*,
/// Nonlinearity 27 (2014), §4.
///
/// # Example
/// The right action of SL(2, R) on the plane has J = −(qp, ½p², −½q²), whose image is a cone in sl(2, R)∗:
/// ```
/// use lie_poisson::{Casimirs, SL2OnR2, Sl2};
/// use momentum_map::{PoissonMap, QuadraticMomentumMap, Side};
/// use nalgebra::Vector2;
/// let map = QuadraticMomentumMap::new(SL2OnR2, Side::Right);
/// let j = map.apply(&Vector2::new(3.0, 4.0));
/// assert_eq!(Sl2.casimir(0, &j), 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuadraticMomentumMap<R> {
    representation: R,
    side: Side,
}

impl<R: SymplecticRepresentation> QuadraticMomentumMap<R> {
    /// Creates the momentum map of the action v ↦ gv (left) or v ↦ g⁻¹v (right).
    pub const fn new(representation: R, side: Side) -> Self {
        Self { representation, side }
    }

    /// Returns the representation of the action.
    pub const fn representation(&self) -> &R {
        &self.representation
    }

    /// Returns the side of the action.
    pub const fn side(&self) -> Side {
        self.side
    }
}

impl<R: SymplecticRepresentation> PoissonMap for QuadraticMomentumMap<R> {
    type Source = Symplectic<R>;
    type Target = LiePoisson<R::Algebra>;

    fn source(&self) -> Symplectic<R> {
        Symplectic(self.representation.clone())
    }

    fn target(&self) -> Self::Target {
        LiePoisson::new(self.representation.algebra(), self.side.lie_poisson_sign())
    }

    #[inline]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        TargetPoint::<Self, T>::from_coordinates(|i| {
            let velocity = self.generator::<T>(&Vector::basis(i), z);
            self.representation.form::<T>(&velocity, z) * 0.5
        })
    }

    #[inline]
    fn generator<T: Real>(
        &self,
        xi: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        let velocity = self.representation.act::<T>(xi, z);
        match self.side {
            Side::Left => velocity,
            Side::Right => -velocity,
        }
    }
}

/// The spin representation of so(3) on C², ξ ↦ −(i/2) ξ·σ, which is that of su(2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct So3OnC2;

impl Representation for So3OnC2 {
    type Algebra = So3;
    type Space<T: Real> = Vector2<Complex<T>>;

    fn algebra(&self) -> So3 {
        So3
    }

    #[inline]
    fn act<T: Real>(&self, xi: &Vector3<T>, v: &Vector2<Complex<T>>) -> Vector2<Complex<T>> {
        Su2.matrix(xi) * v
    }
}

/// Implements the symplectic form Ω(u, v) = Im(u∗v) for representations on C^N by skew-Hermitian matrices.
macro_rules! unitary {
    ($($representation:ty, $n:expr, [$($generic:tt)*]);*) => {$(
        impl<$($generic)*> SymplecticRepresentation for $representation {
            #[inline]
            fn form<T: Real>(&self, u: &Self::Space<T>, v: &Self::Space<T>) -> T {
                SymplecticComplexSpace::<$n>.symplectic_form(u, v)
            }

            #[inline]
            fn sharp<T: Real>(&self, alpha: &Covector<Self::Space<T>>) -> Self::Space<T> {
                let zero: SVector<Complex<T>, $n> = Vector::zero();
                SymplecticComplexSpace::<$n>.hamiltonian_vector(&zero, alpha)
            }
        }
    )*};
}
unitary!(So3OnC2, 2, []; SU2OnC2, 2, []; UnitaryOnComplexSpace<N>, N, [const N: usize]);

/// SL(2, R) preserves the area Ω(u, v) = u₁v₂ − u₂v₁.
impl SymplecticRepresentation for SL2OnR2 {
    #[inline]
    fn form<T: Real>(&self, u: &Vector2<T>, v: &Vector2<T>) -> T {
        u.x * v.y - u.y * v.x
    }

    #[inline]
    fn sharp<T: Real>(&self, alpha: &Covector<Vector2<T>>) -> Vector2<T> {
        Vector2::new(alpha.0.y, -alpha.0.x)
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

    #[inline]
    fn act<T: Real>(&self, xi: &RepresentedElement<R, T>, v: &R::Space<T>) -> R::Space<T> {
        self.0.act::<T>(xi, v)
    }
}

impl<R: SymplecticRepresentation> SymplecticRepresentation for Reversed<R> {
    #[inline]
    fn form<T: Real>(&self, u: &R::Space<T>, v: &R::Space<T>) -> T {
        -self.0.form::<T>(u, v)
    }

    #[inline]
    fn sharp<T: Real>(&self, alpha: &Covector<R::Space<T>>) -> R::Space<T> {
        -self.0.sharp::<T>(alpha)
    }
}

impl<R, S> SymplecticRepresentation for Sum<R, S>
where
    R: SymplecticRepresentation,
    S: SymplecticRepresentation<Algebra = R::Algebra>,
{
    #[inline]
    fn form<T: Real>(&self, u: &Self::Space<T>, v: &Self::Space<T>) -> T {
        self.0.form::<T>(&u.0, &v.0) + self.1.form::<T>(&u.1, &v.1)
    }

    #[inline]
    fn sharp<T: Real>(&self, alpha: &Covector<Self::Space<T>>) -> Self::Space<T> {
        let Covector(Pair(first, second)) = *alpha;
        Pair(self.0.sharp::<T>(&Covector(first)), self.1.sharp::<T>(&Covector(second)))
    }
}

impl<R: SymplecticRepresentation, const N: usize> SymplecticRepresentation for Diagonal<R, N> {
    #[inline]
    fn form<T: Real>(&self, u: &Self::Space<T>, v: &Self::Space<T>) -> T {
        let terms = u.0.iter().zip(&v.0);
        terms.fold(T::zero(), |sum, (u, v)| sum + self.0.form::<T>(u, v))
    }

    #[inline]
    fn sharp<T: Real>(&self, alpha: &Covector<Self::Space<T>>) -> Self::Space<T> {
        Power(alpha.0.0.map(|alpha| self.0.sharp::<T>(&Covector(alpha))))
    }
}
