//! Poisson vector spaces and the Lie–Poisson bracket: [`PoissonSpace`], [`LiePoisson`].

use crate::algebras::algebra::{LieAlgebra, Momentum};
use generic_scalars::{Differential, Point, Real, State, Vector, VectorSpace};
use nalgebra::DMatrix;

/// A vector space P with a Poisson bracket, given by its Poisson tensor Λ(z): T∗P → TP:
///
/// ```text
/// {f, h}(z) = ⟨df(z), Λ(z) dh(z)⟩,    X_h(z) = Λ(z) dh(z),    df/dt = {f, h}
/// ```
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §10.4.
pub trait PoissonSpace: VectorSpace {
    /// Returns Λ(z) α, the Hamiltonian vector at z of any function whose differential at z is α.
    fn hamiltonian_vector<T: Real>(
        &self,
        z: &Point<Self, T>,
        alpha: &Differential<Self, T>,
    ) -> Point<Self, T>;

    /// Returns the bracket {f, h}(z) of functions with the differentials `df` and `dh` at z.
    #[cfg_attr(optimised, inline(always))]
    fn bracket<T: Real>(
        &self,
        z: &Point<Self, T>,
        df: &Differential<Self, T>,
        dh: &Differential<Self, T>,
    ) -> T {
        df.pairing(&self.hamiltonian_vector::<T>(z, dh))
    }

    /// Returns the matrix Λ_ij(z) = {z_i, z_j} of the Poisson tensor, of size DIM × DIM.
    fn poisson_tensor<T: Real>(&self, z: &Point<Self, T>) -> DMatrix<T> {
        let n = Point::<Self, T>::DIM;
        let columns = (0..n).map(|j| self.hamiltonian_vector::<T>(z, &Vector::basis(j)));
        DMatrix::from_iterator(n, n, columns.flat_map(|x| (0..n).map(move |i| x.coordinate(i))))
    }
}

/// The sign of a Lie–Poisson bracket {f, h}±(μ) = ±⟨μ, [df, dh]⟩.
///
/// Momentum maps of right actions are Poisson maps to 𝔤∗ with the minus sign; momentum maps of left actions are
/// Poisson maps to 𝔤∗ with the plus sign. Dynamics in the body frame has the minus sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Sign {
    /// The plus sign: {f, h}(μ) = +⟨μ, [df, dh]⟩, so that dμ/dt = −`ad∗_ξ μ` with ξ = dh(μ).
    Plus,
    /// The minus sign: {f, h}(μ) = −⟨μ, [df, dh]⟩, so that dμ/dt = +`ad∗_ξ μ` with ξ = dh(μ).
    Minus,
}

/// The dual 𝔤∗ with a (±)-Lie–Poisson bracket {f, h}±(μ) = ±⟨μ, [df(μ), dh(μ)]⟩.
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., §13.1; Ohsawa
/// 2019, eqs. (1.2), (2.4) and (3.3) for the minus sign.
///
/// # Example
/// The free rigid body dΠ/dt = Π × Ω is Hamiltonian for the minus sign:
/// ```
/// use lie_poisson::{Covector, LiePoisson, PoissonSpace, So3};
/// use nalgebra::Vector3;
/// let (pi, omega) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.5, 1.0, 3.0));
/// let rate = LiePoisson::minus(So3).hamiltonian_vector(&Covector(pi), &omega);
/// assert_eq!(rate, Covector(pi.cross(&omega)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LiePoisson<A> {
    algebra: A,
    sign: Sign,
}

impl<A: LieAlgebra> LiePoisson<A> {
    /// Creates 𝔤∗ with the Lie–Poisson bracket of the given sign.
    pub const fn new(algebra: A, sign: Sign) -> Self {
        Self { algebra, sign }
    }

    /// Creates 𝔤∗ with the minus Lie–Poisson bracket {f, g}(μ) = −⟨μ, [df, dg]⟩, the bracket of momenta in the body
    /// frame: dμ/dt = `ad*_ξ μ` with ξ = dh(μ).
    pub const fn minus(algebra: A) -> Self {
        Self::new(algebra, Sign::Minus)
    }

    /// Creates 𝔤∗ with the plus Lie–Poisson bracket {f, g}(μ) = ⟨μ, [df, dg]⟩, the bracket of momenta in the spatial
    /// frame: dμ/dt = −`ad*_ξ μ` with ξ = dh(μ).
    pub const fn plus(algebra: A) -> Self {
        Self::new(algebra, Sign::Plus)
    }

    /// Returns the Lie algebra 𝔤.
    pub const fn algebra(&self) -> &A {
        &self.algebra
    }

    /// Returns the sign of the bracket.
    pub const fn sign(&self) -> Sign {
        self.sign
    }
}

impl<A: LieAlgebra> VectorSpace for LiePoisson<A> {
    type Point<T: Real> = Momentum<A, T>;
}

impl<A: LieAlgebra> PoissonSpace for LiePoisson<A> {
    /// Returns ∓`ad∗_ξ μ` with ξ = dh, for the (±)-bracket.
    #[cfg_attr(optimised, inline(always))]
    fn hamiltonian_vector<T: Real>(
        &self,
        mu: &Momentum<A, T>,
        dh: &A::Element<T>,
    ) -> Momentum<A, T> {
        let rate = self.algebra.coadjoint::<T>(dh, mu);
        match self.sign {
            Sign::Plus => -rate,
            Sign::Minus => rate,
        }
    }
}
