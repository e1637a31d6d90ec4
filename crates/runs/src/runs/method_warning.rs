//! Warnings about what a method does not conserve.

use crate::RunFailure;
use heavytop::methods::{Method, SchemeName};
use lie_poisson_formula_systems::{FormulaSystem, SystemMethod};

/// Returns a warning for users about what the method does not conserve.
#[must_use]
pub fn method_warning(method: &Method) -> Option<String> {
    matches!(method.scheme(), SchemeName::Partitioned(_)).then(|| {
        format!(
            "warning: {} does not descend from T*C² to se(3)*: what comes out depends on the lift, \
             and f1 and f2 are not conserved",
            method.scheme()
        )
    })
}

/// Returns a warning for users about what the method of a system does not conserve for runs from a state.
///
/// # Errors
/// If there is no such method.
pub fn system_warning(
    method: &SystemMethod,
    system: &FormulaSystem,
    start: &[f64],
) -> Result<Option<String>, RunFailure> {
    let descends = method.descends(system, start)?;
    Ok((!descends).then(|| {
        format!(
            "warning: the steps of {}, {} by the Clebsch map of {} are not Poisson maps: the Casimirs are \
             conserved to the order of the scheme alone",
            method.formulation(),
            method.scheme(),
            system.algebra().name()
        )
    }))
}
