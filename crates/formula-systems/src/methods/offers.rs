//! The formulations and schemes that an algebra has.

use crate::algebras::family::Family;
use crate::algebras::system_algebra::SystemAlgebra;
use crate::error::FormulaSystemError;
use crate::realisations::quadratic_momenta::QuadraticMomenta;
use heavytop::methods::{Formulation, Method, SchemeName};

impl SystemAlgebra {
    /// Returns the formulations that the algebra has. [`method`](Self::method) has a table.
    pub fn formulations(&self) -> impl Iterator<Item = Formulation> {
        let known = self.family != Family::Other;
        let has_momenta = self.momenta().is_some();
        let all = [Formulation::Collective, Formulation::Reduced, Formulation::Direct];
        all.into_iter().filter(move |formulation| match formulation {
            Formulation::Direct => true,
            Formulation::Collective => known || has_momenta,
            _ => known,
        })
    }

    /// Returns the formulation that suits the algebra best. It is collective if that is a Poisson integrator for every
    /// Hamiltonian, namely on so(3), su(2) and se(3) by name, and on sums of so(3) and su(2), or if there are momenta of your own.
    /// Otherwise it is direct.
    #[must_use]
    pub fn default_formulation(&self) -> Formulation {
        match self.family {
            _ if self.verdict().is_some() => Formulation::Collective,
            Family::Rotations | Family::ManyRotations | Family::Motions => Formulation::Collective,
            Family::Other => Formulation::Direct,
        }
    }

    /// Returns the method of a formulation and a scheme. Stages are solved to `tolerance`, relative to the state; 0 iterates
    /// to the round-off floor.
    ///
    /// | algebra | formulations |
    /// |---|---|
    /// | so(3), su(2), se(3) by name, and sums of so(3) and su(2) | collective, reduced, direct |
    /// | another of two dimensions or more, of which a Clebsch map is found: without a centre, or with one on which a grading of the basis does not vanish, or up to dimension 16 another derivation or a cocycle of the coadjoint representation | collective, by a Clebsch map; direct |
    /// | any other | direct |
    /// | so(n), so(p,q), sp(2n,R), gl(n) of dimension 4 to 64 | collective, along copies of their matrices; direct |
    /// | one with [momenta of your own](Self::with_realisation) | collective along these, beside the others |
    ///
    /// Every scheme of [`Formulation::schemes`] is available except the partitioned ones.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoMethod`], which names those that the algebra has, if it does not have the formulation
    /// with the scheme, and [`FormulaSystemError::Method`] for a tolerance that is negative or not finite.
    ///
    /// # Example
    /// ```
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::SystemAlgebra;
    /// let se2 = SystemAlgebra::named("se(2)")?;
    /// assert!(se2.method(Formulation::Collective, SchemeName::Gauss(2), 0.0).is_ok());
    /// let error = se2.method(Formulation::Reduced, SchemeName::Gauss(2), 0.0).unwrap_err();
    /// assert_eq!(error.to_string(), "se(2) has no reduced gauss-4; it has collective and direct");
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn method(
        &self,
        formulation: Formulation,
        scheme: SchemeName,
        tolerance: f64,
    ) -> Result<Method, FormulaSystemError> {
        self.require(formulation, scheme)?;
        Ok(Method::new(formulation, scheme, tolerance)?)
    }

    /// Returns the momenta of spinors along which rotations and rigid motions are followed collectively, a Poisson map to the plus
    /// bracket; `None` for other algebras.
    pub(crate) fn spinors(&self) -> Option<QuadraticMomenta> {
        match self.family {
            Family::Rotations | Family::ManyRotations => {
                Some(QuadraticMomenta::of_rotations(self.dimension() / 3))
            }
            Family::Motions => Some(QuadraticMomenta::of_motions()),
            Family::Other => None,
        }
    }

    /// Returns whether the steps of affine schemes descend to 𝔤∗.
    pub(crate) fn descends(&self, formulation: Formulation) -> bool {
        match (formulation, self.verdict(), self.family) {
            (Formulation::Collective, Some(verdict), _) => verdict.descends(),
            (Formulation::Collective, None, Family::Other) => {
                QuadraticMomenta::clebsch_descends(self.table())
            }
            _ => true,
        }
    }

    /// Checks that the algebra has a formulation with a scheme.
    pub(super) fn require(
        &self,
        formulation: Formulation,
        scheme: SchemeName,
    ) -> Result<(), FormulaSystemError> {
        let is_partitioned = matches!(scheme, SchemeName::Partitioned(_));
        if has(self, formulation) && !is_partitioned && formulation.offers(scheme) {
            Ok(())
        } else {
            Err(refusal(self, formulation, scheme))
        }
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
    } else if formulation == Formulation::Collective && algebra.dimension() > 1 {
        "it has direct: no derivation was found that does not vanish on the centre, which the adjoint \
         representation does not see, nor such a cocycle of the coadjoint one"
            .into()
    } else {
        let names: Vec<_> = algebra.formulations().map(Formulation::name).collect();
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
    algebra.formulations().any(|other| other == formulation)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A message names the schemes that are accepted, and no others.
    #[test]
    fn what_a_refusal_names_is_offered() -> Result<(), FormulaSystemError> {
        let algebra = SystemAlgebra::named("so(3)")?;
        let mut refusals = 0;
        for formulation in algebra.formulations() {
            let accepted = |scheme: &SchemeName| algebra.method(formulation, *scheme, 0.0).is_ok();
            let refused = formulation.schemes().find(|scheme| !accepted(scheme));
            let names: Vec<_> =
                formulation.schemes().filter(accepted).map(SchemeName::name).collect();
            let Some(refused) = refused else { continue };
            let error = algebra.method(formulation, refused, 0.0).err();
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
