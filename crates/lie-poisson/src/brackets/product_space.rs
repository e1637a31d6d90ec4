//! Products and powers of Poisson spaces.

use crate::brackets::poisson::PoissonSpace;
use generic_scalars::{
    Covector, Differential, Pair, Point, Power, Real, Vector, VectorSpace, map_coordinates,
};

/// The product P × Q of Poisson spaces with the sum of the two brackets; functions of different factors
/// Poisson-commute.
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §10.1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ProductSpace<P, Q>(pub P, pub Q);

impl<P: VectorSpace, Q: VectorSpace> VectorSpace for ProductSpace<P, Q> {
    type Point<T: Real> = Pair<Point<P, T>, Point<Q, T>>;
}

impl<P: PoissonSpace, Q: PoissonSpace> PoissonSpace for ProductSpace<P, Q> {
    #[cfg_attr(optimised, inline(always))]
    fn hamiltonian_vector<T: Real>(
        &self,
        z: &Point<Self, T>,
        dh: &Differential<Self, T>,
    ) -> Point<Self, T> {
        let (first, second) = parts(dh);
        Pair(
            self.0.hamiltonian_vector::<T>(&z.0, &first),
            self.1.hamiltonian_vector::<T>(&z.1, &second),
        )
    }
}

/// The power Pᴺ of a Poisson space with the sum of the brackets of the factors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PowerSpace<P, const N: usize>(pub P);

impl<P: VectorSpace, const N: usize> VectorSpace for PowerSpace<P, N> {
    type Point<T: Real> = Power<Point<P, T>, N>;
}

impl<P: PoissonSpace, const N: usize> PoissonSpace for PowerSpace<P, N> {
    #[cfg_attr(optimised, inline(always))]
    fn hamiltonian_vector<T: Real>(
        &self,
        z: &Point<Self, T>,
        dh: &Differential<Self, T>,
    ) -> Point<Self, T> {
        Power::from_factors(
            #[cfg_attr(optimised, inline(always))]
            |n| {
                let part: Differential<P, T> = map_coordinates(&dh.0.0[n], |x| x);
                self.0.hamiltonian_vector::<T>(&z.0[n], &part)
            },
        )
    }
}

/// Returns the two parts (α, β) of a covector on a direct sum, each with the pairing of its own space.
#[inline]
pub fn parts<A, B>(covector: &Covector<Pair<A, B>>) -> (A::Dual, B::Dual)
where
    A: Vector,
    B: Vector<Scalar = A::Scalar>,
{
    let Covector(Pair(a, b)) = covector;
    (map_coordinates(a, |x| x), map_coordinates(b, |x| x))
}

/// Creates the covector (α, β) on a direct sum from its two parts.
#[inline]
pub fn from_parts<A, B>(alpha: &A::Dual, beta: &B::Dual) -> Covector<Pair<A, B>>
where
    A: Vector,
    B: Vector<Scalar = A::Scalar>,
{
    Covector(Pair(map_coordinates(alpha, |x| x), map_coordinates(beta, |x| x)))
}
