//! Collective dynamics without a lift: the trait [`Multipliers`].

use lie_poisson::{Differential, Point, PoissonSpace, Real, Vector};

/// An associative algebra 𝔄 of linear maps Q of P, for collective dynamics without a lift.
///
/// 𝔄 contains the generators of a linear collective system, and acts on 𝔤∗ in such a way that J(Qz) depends on J(z)
/// and Q alone. Collective dynamics dz/dt = ξ(J(z)) z with ξ = dh keeps the form z = Q z₀, where Q satisfies
///
/// ```text
/// dQ/dt = ξ(J(Qz₀)) Q,    Q(0) = 1,    J(Qz₀) = transport(Q, J(z₀))
/// ```
///
/// These equations depend on z₀ only through μ₀ = J(z₀). A Runge–Kutta method commutes with the linear map Q ↦ Qz₀,
/// so the collective method on P *is* the same method for Q. It is a map of 𝔤∗ in closed form, without a lift and
/// without drift along a fibre. It is defined on all of 𝔤∗, even outside of the image of J.
///
/// A multiplier is determined only up to changes that do not affect `transport`. The flow conserves quadratic
/// invariants of Q (|Q|² = 1 for quaternions) that make `transport` a coadjoint motion. Every Gauss method conserves
/// them too.
///
/// # Example
/// Multipliers of your own: real 3×3 matrices for so(3)∗ with the minus bracket. On pairs z = (q, p) of vectors with
/// J(z) = −q × p they act by (Qq, Qp), so that J(Qz₀) is the matrix of cofactors of Q times J(z₀).
/// ```
/// use lie_poisson::{Covector, LiePoisson, Real, So3};
/// use momentum_map::Multipliers;
/// use nalgebra::{Matrix3, Vector3};
///
/// #[derive(Clone)]
/// struct RealMatrices;
/// impl Multipliers for RealMatrices {
///     type Space = LiePoisson<So3>;
///     type Multiplier<T: Real> = Matrix3<T>;
///     fn space(&self) -> Self::Space {
///         LiePoisson::minus(So3)
///     }
///     fn one<T: Real>(&self) -> Matrix3<T> {
///         Matrix3::identity()
///     }
///     // ξ acts as −ξ×, the generator of a right action
///     fn generate<T: Real>(&self, xi: &Vector3<T>, q: &Matrix3<T>) -> Matrix3<T> {
///         Matrix3::from_columns(&[0, 1, 2].map(|i| q.column(i).into_owned().cross(xi)))
///     }
///     fn transport<T: Real>(&self, q: &Matrix3<T>, mu: &Covector<Vector3<T>>) -> Covector<Vector3<T>> {
///         let column = |i: usize| q.column(i).into_owned();
///         let cofactors = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| column(i).cross(&column(j)));
///         Covector(Matrix3::from_columns(&cofactors) * mu.0)
///     }
///     fn product<T: Real>(&self, q: &Matrix3<T>, b: &Matrix3<T>) -> Matrix3<T> {
///         q * b
///     }
///     // the flow conserves QᵀQ = 1
///     fn inverse<T: Real>(&self, b: &Matrix3<T>) -> Matrix3<T> {
///         b.transpose()
///     }
/// }
///
/// // d/dt transport(Q, μ) = ad*_ξ μ = μ × ξ at Q = 1
/// let (xi, mu) = (Vector3::new(0.3, -0.2, 0.5), Covector(Vector3::new(1.0, 2.0, -1.0)));
/// let step = 1e-6;
/// let q = RealMatrices.one::<f64>() + RealMatrices.generate(&xi, &RealMatrices.one::<f64>()) * step;
/// let rate = (RealMatrices.transport(&q, &mu) - mu).0 / step;
/// assert!((rate - mu.0.cross(&xi)).norm() < 1e-5);
/// ```
/// `LiftFree::new(RungeKutta::gauss(2)?, RealMatrices, hamiltonian)` of `collective-integrators` integrates with them.
/// The law suite `laws::multipliers` checks the other properties.
pub trait Multipliers: Clone {
    /// The dual 𝔤∗, or a product of such spaces.
    type Space: PoissonSpace;

    /// A multiplier Q ∈ 𝔄 over the scalar `T`.
    type Multiplier<T: Real>: Vector<Scalar = T>;

    /// Returns the dual 𝔤∗ as a value.
    fn space(&self) -> Self::Space;

    /// Returns the unit 1 ∈ 𝔄.
    fn one<T: Real>(&self) -> Self::Multiplier<T>;

    /// Returns ξ Q, the rate of change of Q for ξ = dh.
    fn generate<T: Real>(
        &self,
        xi: &Differential<Self::Space, T>,
        q: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T>;

    /// Returns J(Qz₀), computed from μ₀ = J(z₀).
    fn transport<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T>;

    /// Returns the change of μ under the coadjoint motion by Q, by default transport(Q, μ) − μ.
    ///
    /// Integrators change the quadratic invariants of Q only by round-off. An implementation of this
    /// method restores them first. If it then computes the change without cancellation, the change is exact
    /// to a few units of round-off of its own size, and the Casimirs of μ are conserved up to unbiased
    /// rounding errors.
    #[cfg_attr(optimised, inline(always))]
    fn coadjoint_change<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        mu: &Point<Self::Space, T>,
    ) -> Point<Self::Space, T> {
        self.transport::<T>(q, mu) - *mu
    }

    /// Returns the product Q B in 𝔄, the multiplier of the motion by B followed by the motion by Q: transport(QB, μ)
    /// = transport(Q, transport(B, μ)).
    fn product<T: Real>(
        &self,
        q: &Self::Multiplier<T>,
        b: &Self::Multiplier<T>,
    ) -> Self::Multiplier<T>;

    /// Returns the inverse B⁻¹.
    ///
    /// The result is exact for a B whose quadratic invariants hold. If they hold only approximately, the
    /// result is near the inverse.
    ///
    /// Integrators predict the stages of a step from those of the steps before it, which began at other multipliers. The
    /// inverse carries them to the next step. It affects the speed and the last digits of a step, and nothing else.
    fn inverse<T: Real>(&self, b: &Self::Multiplier<T>) -> Self::Multiplier<T>;
}

/// Multipliers whose [`inverse`](Multipliers::inverse) is the inverse of every element that has one, and not only of those
/// with the quadratic invariants of the motion: Cayley's map (1 − ξ/2)⁻¹(1 + ξ/2) is in closed form.
///
/// # Example
/// ```
/// use lie_poisson::Quaternion;
/// use momentum_map::{InvertibleMultipliers, Multiplier, Multipliers, Quaternions};
/// use nalgebra::Vector3;
/// fn cayley<M: InvertibleMultipliers>(m: &M, half: Multiplier<M>) -> Multiplier<M> {
///     let one = m.one::<f64>();
///     m.product::<f64>(&m.inverse::<f64>(&(one - half)), &(one + half))
/// }
/// let turn = cayley(&Quaternions, Quaternion { scalar: 0.0, vector: Vector3::new(0.3, -0.2, 0.5) });
/// assert!((turn.norm_squared() - 1.0).abs() < 1e-15);
/// ```
pub trait InvertibleMultipliers: Multipliers {}

/// A multiplier of a collective system, over the scalar `T`.
pub type Multiplier<M, T = f64> = <M as Multipliers>::Multiplier<T>;
