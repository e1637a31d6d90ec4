//! Errors of formulations and schemes.

use super::{Formulation, SchemeName, UnknownName};
use collective_integrators::SchemeError;
use lie_poisson::MissingInstructions;
use thiserror::Error;

/// The reason why there is no integrator for a formulation and a scheme.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum MethodError {
    /// There is no formulation, or no scheme, with this name.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// The formulation does not have the scheme.
    #[error(
        "{formulation} has no scheme {scheme}; it has {}",
        formulation.schemes().map(SchemeName::name).collect::<Vec<_>>().join(", ")
    )]
    NoSuchPair {
        /// The formulation that was asked for.
        formulation: Formulation,
        /// The scheme that was asked for.
        scheme: SchemeName,
    },
    /// The tolerance of the stage equations is negative or not finite.
    #[error("tolerance must be finite and not negative, got {value:?}")]
    Tolerance {
        /// The tolerance that was asked for.
        value: f64,
    },
    /// The processor lacks the instructions that were asked for.
    #[error(transparent)]
    Instructions(#[from] MissingInstructions),
    /// The scheme could not be made.
    #[error("{scheme}: {reason}")]
    Scheme {
        /// The scheme that was asked for.
        scheme: SchemeName,
        /// The reason why the scheme could not be made.
        reason: SchemeError,
    },
}
