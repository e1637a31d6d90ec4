//! The formulations and schemes that an algebra has.

use crate::algebras::system_algebra::Family;
use crate::{FormulaSystemError, SystemAlgebra};
use heavytop::methods::{Formulation, SchemeName};

/// The dimensions of the algebras with a Clebsch map.
const CLEBSCH: [usize; 5] = [2, 3, 4, 5, 6];

/// Returns the formulations that an algebra has.
pub(super) fn formulations(algebra: &SystemAlgebra) -> impl Iterator<Item = Formulation> {
    let known = algebra.family != Family::Other;
    let clebsch = CLEBSCH.contains(&algebra.dimension());
    let all = [Formulation::Collective, Formulation::Reduced, Formulation::Direct];
    all.into_iter().filter(move |formulation| match formulation {
        Formulation::Direct => true,
        Formulation::Collective => known || clebsch,
        _ => known,
    })
}

/// Checks that an algebra has a formulation with a scheme.
pub(super) fn require(
    algebra: &SystemAlgebra,
    formulation: Formulation,
    scheme: SchemeName,
) -> Result<(), FormulaSystemError> {
    let partitioned = matches!(scheme, SchemeName::Partitioned(_));
    if has(algebra, formulation) && !partitioned && formulation.offers(scheme) {
        Ok(())
    } else {
        Err(refusal(algebra, formulation, scheme))
    }
}

/// Returns the error for an algebra that does not have a formulation with a scheme. The error names those that the
/// algebra has.
pub(super) fn refusal(
    algebra: &SystemAlgebra,
    formulation: Formulation,
    scheme: SchemeName,
) -> FormulaSystemError {
    let has = if has(algebra, formulation) {
        let schemes = formulation.schemes().filter(|s| !matches!(s, SchemeName::Partitioned(_)));
        let names: Vec<_> = schemes.map(SchemeName::name).collect();
        format!("{formulation} has {}", names.join(", "))
    } else {
        let names: Vec<_> = formulations(algebra).map(Formulation::name).collect();
        match names.split_last() {
            Some((last, before)) if !before.is_empty() => {
                format!("it has {} and {last}", before.join(", "))
            }
            _ => format!("it has {}", names.concat()),
        }
    };
    FormulaSystemError::NoMethod { algebra: algebra.name().into(), formulation, scheme, has }
}

fn has(algebra: &SystemAlgebra, formulation: Formulation) -> bool {
    formulations(algebra).any(|other| other == formulation)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A message names the schemes that are accepted, and no others.
    #[test]
    fn what_a_refusal_names_is_offered() -> Result<(), FormulaSystemError> {
        let algebra = SystemAlgebra::named("so(3)")?;
        let mut refusals = 0;
        for formulation in formulations(&algebra) {
            let accepted = |scheme: &SchemeName| require(&algebra, formulation, *scheme).is_ok();
            let refused = formulation.schemes().find(|scheme| !accepted(scheme));
            let names: Vec<_> =
                formulation.schemes().filter(accepted).map(SchemeName::name).collect();
            let Some(refused) = refused else { continue };
            let error = require(&algebra, formulation, refused).err();
            let expected = format!("{formulation} has {}", names.join(", "));
            let named = matches!(&error,
                Some(FormulaSystemError::NoMethod { has, .. }) if *has == expected);
            assert!(named, "{error:?} {expected}");
            refusals += 1;
        }
        assert!(refusals > 0);
        Ok(())
    }
}
