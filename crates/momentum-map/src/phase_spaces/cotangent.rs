//! Cotangent bundles of vector spaces: [`CotangentBundle`].

use crate::phase_spaces::symplectic::SymplecticSpace;
use lie_poisson::{
    Covector, Differential, Point, PoissonSpace, Real, Vector, VectorSpace, map_coordinates,
    state_of_parts, vector_operators,
};

/// A point (q, p) ∈ T∗Q = Q × Q∗; the coordinates of q come first.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Q: serde::Serialize, Q::Dual: serde::Serialize",
        deserialize = "Q: serde::Deserialize<'de>, Q::Dual: serde::Deserialize<'de>"
    ))
)]
pub struct Cotangent<Q: Vector> {
    /// The configuration q, a vector of Q.
    pub q: Q,
    /// The momentum p conjugate to q, a covector on Q.
    pub p: Q::Dual,
}

impl<Q: Vector> Cotangent<Q> {
    /// Creates the point (q, p).
    #[cfg_attr(optimised, inline(always))]
    pub fn new(q: Q, p: Q::Dual) -> Self {
        Self { q, p }
    }
}

state_of_parts!([Q: Vector] Cotangent<Q>, Q::Scalar, q: Q, p: Q::Dual);
vector_operators!([Q: Vector] Cotangent<Q>);

impl<Q: Vector> Vector for Cotangent<Q> {
    type Dual = Covector<Self>;
    const DIM: usize = 2 * Q::DIM;

    #[allow(clippy::redundant_closure)] // `&mut f` would be called, and this closure is inlined.
    #[cfg_attr(optimised, inline(always))]
    fn from_coordinates(mut f: impl FnMut(usize) -> Q::Scalar) -> Self {
        let q = Q::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| f(i),
        );
        let p = Q::Dual::from_coordinates(
            #[cfg_attr(optimised, inline(always))]
            |i| f(Q::DIM + i),
        );
        Self { q, p }
    }
}

/// The cotangent bundle T∗Q of a vector space Q, with its canonical structure:
///
/// ```text
/// Θ = p dq,   Ω = −dΘ = dq ∧ dp,   {F, H} = ∂F/∂q·∂H/∂p − ∂F/∂p·∂H/∂q,
/// dq/dt = ∂H/∂p,  dp/dt = −∂H/∂q
/// ```
///
/// Source: Ohsawa 2019, §2.1, eqs. (2.2) and (4.4).
///
/// # Example
/// ```
/// use lie_poisson::{Covector, PoissonSpace, RealSpace};
/// use momentum_map::{Cotangent, CotangentBundle};
/// use nalgebra::Vector1;
/// // the oscillator H = (q² + p²)/2 at (q, p) = (1, 2): dH = (1, 2), X_H = (2, −1)
/// let z = Cotangent::new(Vector1::new(1.0), Covector(Vector1::new(2.0)));
/// let x = CotangentBundle(RealSpace::<1>).hamiltonian_vector(&z, &Covector(z));
/// assert_eq!((x.q.x, x.p.0.x), (2.0, -1.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CotangentBundle<Q>(pub Q);

impl<Q: VectorSpace> VectorSpace for CotangentBundle<Q> {
    type Point<T: Real> = Cotangent<Point<Q, T>>;
}

impl<Q: VectorSpace> PoissonSpace for CotangentBundle<Q> {
    /// Returns the Hamiltonian vector (∂H/∂p, −∂H/∂q).
    #[cfg_attr(optimised, inline(always))]
    fn hamiltonian_vector<T: Real>(
        &self,
        _: &Point<Self, T>,
        dh: &Differential<Self, T>,
    ) -> Point<Self, T> {
        let Covector(Cotangent { q: by_q, p: by_p }) = dh;
        Cotangent { q: map_coordinates(by_p, |x| x), p: map_coordinates(by_q, |x: T| -x) }
    }
}

impl<Q: VectorSpace> SymplecticSpace for CotangentBundle<Q> {
    /// Returns the canonical form Ω(u, v) = ⟨v.p, u.q⟩ − ⟨u.p, v.q⟩.
    #[cfg_attr(optimised, inline(always))]
    fn symplectic_form<T: Real>(&self, u: &Point<Self, T>, v: &Point<Self, T>) -> T {
        u.q.pairing(&v.p) - v.q.pairing(&u.p)
    }

    /// Returns the covector i_x Ω = (−x.p, x.q), by coordinates.
    #[cfg_attr(optimised, inline(always))]
    fn flat<T: Real>(&self, x: &Point<Self, T>) -> Differential<Self, T> {
        let p = map_coordinates(&x.q, |x| x);
        Covector(Cotangent { q: map_coordinates(&x.p, |x: T| -x), p })
    }
}
