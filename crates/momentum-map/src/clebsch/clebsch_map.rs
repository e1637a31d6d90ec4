//! Clebsch maps T∗V → 𝔤∗: [`ClebschMap`].

use crate::actions::action::Side;
use crate::clebsch::cotangent_representation::CotangentRepresentation;
use crate::maps::quadratic_momentum_map::QuadraticMomentumMap;
use lie_poisson::Representation;

/// The Clebsch map of a representation of 𝔤 on V, the momentum map T∗V → 𝔤∗ of the lifted action:
///
/// ```text
/// ⟨J(q, p), ξ⟩ = ±⟨p, ξq⟩,    dq/dt = ±ξq,  dp/dt = ∓ξᵀp    for ξ = dh(J(q, p))
/// ```
///
/// The upper signs belong to the left action and to the plus bracket, the lower signs to the right action and to the
/// minus bracket. For the adjoint representation and structure constants c the coordinates are
///
/// ```text
/// J_i = ± Σ_jk c[i][j][k] q_j p_k
/// ```
///
/// so that the map needs no group. In this case ⟨J(q, p), q⟩ = 0, and J(q, p) vanishes on the centre of 𝔤. The
/// momenta that the map reaches depend on V:
///
/// | V | representation | image |
/// |---|---|---|
/// | 𝔤 | [`InfinitesimalAdjoint`](lie_poisson::InfinitesimalAdjoint) | all μ that vanish on the centraliser of some q |
/// | 𝔤ᴷ | [`Diagonal<_, K>`](lie_poisson::Diagonal) of it | for K large enough, all μ that vanish on the centre |
/// | (𝔤 ⋊ RD)ᴷ | `Diagonal<_, K>` of [`ExtendedAdjoint`](lie_poisson::ExtendedAdjoint) | for K large enough, all μ if D is injective on the centre |
/// | (𝔤∗ ⊕ R)ᴷ | `Diagonal<_, K>` of [`ExtendedCoadjoint`](lie_poisson::ExtendedCoadjoint) | for K large enough, all μ if the cocycle is injective on the centre |
///
/// For each of the 62 indecomposable real Lie algebras of dimension 2 to 5 in a published list, with generic
/// parameters, one of the two extensions with K = 2 reaches all of 𝔤∗ (J. Patera et al., J. Math. Phys. 17 (1976) 986).
///
/// V also decides whether the maps of symplectic Runge–Kutta methods descend to 𝔤∗: they do if
/// [`odd_power_defect`](lie_poisson::odd_power_defect) is 0. Otherwise the image of such a map depends in general on
/// (q, p), and Casimirs are conserved only to its order of approximation.
/// [`equivariant_maps_descend`](crate::PoissonMap::equivariant_maps_descend) returns which case holds.
///
/// Source: B. Jayawardana, P. J. Morrison & T. Ohsawa, *Clebsch canonization of Lie–Poisson systems*, J. Geom. Mech.
/// 14 (2022) 635; P. J. Morrison, *Hamiltonian description of the ideal fluid*, Rev. Mod. Phys. 70 (1998), §VI.
///
/// # Example
/// ```
/// use lie_poisson::{Covector, InfinitesimalAdjoint, StructureConstants};
/// use momentum_map::{Cotangent, PoissonMap, Side, clebsch_map};
/// use nalgebra::Vector2;
/// // [e₀, e₁] = e₁
/// let affine = StructureConstants::<2>::new(|i, j, k| match (i, j, k) {
///     (0, 1, 1) => 1.0,
///     (1, 0, 1) => -1.0,
///     _ => 0.0,
/// })?;
/// let map = clebsch_map(InfinitesimalAdjoint(affine), Side::Left);
/// let (q, p) = (Vector2::new(2.0, 3.0), Vector2::new(5.0, 7.0));
/// // J = (q₁p₁, −q₀p₁)
/// let image = map.apply(&Cotangent::new(q, Covector(p)));
/// assert_eq!(image, Covector(Vector2::new(21.0, -14.0)));
/// # Ok::<(), lie_poisson::StructureError>(())
/// ```
pub type ClebschMap<R> = QuadraticMomentumMap<CotangentRepresentation<R>>;

/// Returns the Clebsch map of a representation, for the left or for the right action.
pub const fn clebsch_map<R: Representation>(representation: R, side: Side) -> ClebschMap<R> {
    QuadraticMomentumMap::new(CotangentRepresentation(representation), side)
}
