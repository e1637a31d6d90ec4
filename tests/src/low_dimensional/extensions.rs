//! Representations of the algebras that see their centres.

use lie_poisson::{CocycleError, Diagonal, ExtendedAdjoint, ExtendedCoadjoint, StructureConstants};

/// The two algebras whose derivations all vanish on the centre.
pub const WITHOUT_DERIVATION: [&str; 2] = ["A5,38", "A5,39"];

/// Two copies of the adjoint representation, extended by a derivation.
pub type Extended<const N: usize> = Diagonal<ExtendedAdjoint<StructureConstants<N>>, 2>;
/// Two copies of the coadjoint representation, extended by a cocycle.
pub type Coextended<const N: usize> = Diagonal<ExtendedCoadjoint<StructureConstants<N>>, 2>;

/// Returns two copies of the adjoint representation, extended by the derivation nearest to the identity.
///
/// # Errors
/// Returns [`CocycleError`] if a structure constant is not finite.
pub fn extended<const N: usize>(
    algebra: &StructureConstants<N>,
) -> Result<Extended<N>, CocycleError> {
    Ok(Diagonal(ExtendedAdjoint::of(algebra.clone())?))
}

/// Returns two copies of the coadjoint representation, extended by a generic cocycle.
///
/// # Errors
/// Returns [`CocycleError`] if a structure constant is not finite.
pub fn coextended<const N: usize>(
    algebra: &StructureConstants<N>,
) -> Result<Coextended<N>, CocycleError> {
    Ok(Diagonal(ExtendedCoadjoint::of(algebra.clone())?))
}
