//! A method for a system, by names: [`SystemMethod`].

use super::integration::Integration;
use super::offers::{formulations, require};
use crate::algebras::system_algebra::Family;
use crate::{FormulaSystem, FormulaSystemError, SystemAlgebra};
use collective_integrators::{AnyIntegrator, AnyTangents};
use heavytop::methods::{Formulation, MethodError, SchemeName};

/// A formulation, a scheme, and the tolerance of its stage equations: an integrator for the systems on an algebra.
///
/// | algebra | formulations |
/// |---|---|
/// | so(3), su(2), se(3) by name | collective, reduced, direct |
/// | another of dimension 2 to 6 | collective, by a Clebsch map; direct |
/// | any other | direct |
///
/// Every scheme of [`Formulation::schemes`] is available except the partitioned ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SystemMethod {
    formulation: Formulation,
    scheme: SchemeName,
    tolerance: f64,
}

impl SystemMethod {
    /// Creates the method from a formulation and a scheme for an algebra. Stages are solved to `tolerance`, relative to
    /// the state; 0 iterates to the round-off floor.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoMethod`] if the algebra does not have the formulation with the scheme, and
    /// [`FormulaSystemError::Method`] for a tolerance that is negative or not finite.
    ///
    /// # Example
    /// ```
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::{SystemAlgebra, SystemMethod};
    /// let se2 = SystemAlgebra::named("se(2)")?;
    /// assert!(SystemMethod::new(&se2, Formulation::Collective, SchemeName::Gauss(2), 0.0).is_ok());
    /// let error = SystemMethod::new(&se2, Formulation::Reduced, SchemeName::Gauss(2), 0.0).unwrap_err();
    /// assert_eq!(error.to_string(), "se(2) has no reduced gauss-4; it has collective and direct");
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn new(
        algebra: &SystemAlgebra,
        formulation: Formulation,
        scheme: SchemeName,
        tolerance: f64,
    ) -> Result<Self, FormulaSystemError> {
        require(algebra, formulation, scheme)?;
        if !(tolerance >= 0.0 && tolerance.is_finite()) {
            return Err(MethodError::Tolerance { value: tolerance }.into());
        }
        Ok(Self { formulation, scheme, tolerance })
    }

    /// Returns the formulation that suits an algebra best. It is collective if that is a Poisson integrator for every
    /// Hamiltonian, namely on so(3), su(2) and se(3) by name. Otherwise it is direct.
    #[must_use]
    pub fn default_formulation(algebra: &SystemAlgebra) -> Formulation {
        match algebra.family {
            Family::Rotations | Family::Motions => Formulation::Collective,
            Family::Other => Formulation::Direct,
        }
    }

    /// Returns the formulations that an algebra has.
    pub fn formulations(algebra: &SystemAlgebra) -> impl Iterator<Item = Formulation> {
        formulations(algebra)
    }

    /// Returns the formulation of the method.
    #[must_use]
    pub const fn formulation(&self) -> Formulation {
        self.formulation
    }

    /// Returns the scheme of the method.
    #[must_use]
    pub const fn scheme(&self) -> SchemeName {
        self.scheme
    }

    /// Returns the tolerance of the stage equations.
    #[must_use]
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Returns the integrator of a system, for runs from a state. It has tangent maps.
    ///
    /// The state is needed because some Clebsch maps have a lift for one state but not for another.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError`] if the algebra of this system does not have the method, if the length of the
    /// state is not the dimension, if h has no value or no differential at the start, or if the integrator cannot be made.
    ///
    /// # Example
    /// The drift of the Casimir |Π|² of a free rigid body over 100 steps:
    /// ```
    /// use collective_integrators::{AnyState, Start};
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra, SystemMethod};
    /// use lie_poisson_formulas::Parameters;
    ///
    /// let body = FormulaSystem::new(SystemAlgebra::named("so(3)")?, "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", &Parameters::new())?;
    /// let body = body.with_found_casimirs()?;
    /// let start = [1.0, 2.0, 0.5];
    /// let drift = |formulation, scheme| -> Result<f64, Box<dyn std::error::Error>> {
    ///     let method = SystemMethod::new(body.algebra(), formulation, scheme, 0.0)?;
    ///     let integrator = method.integrator(&body, &start)?;
    ///     let end = integrator.after(&AnyState::from_slice(&start), 0.1, 100)?.momentum;
    ///     Ok((body.invariants(end.as_slice())?[1] - body.invariants(&start)?[1]).abs())
    /// };
    /// assert!(drift(Formulation::Collective, SchemeName::Gauss(2))? < 1e-13);
    /// assert!(drift(Formulation::Direct, SchemeName::Rk4)? > 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn integrator(
        &self,
        system: &FormulaSystem,
        start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, FormulaSystemError> {
        self.integration(system, start)?.make()
    }

    /// Returns whether the steps descend to 𝔤∗. It is false for a collective method by a Clebsch map whose
    /// [`equivariant_maps_descend`](momentum_map::PoissonMap::equivariant_maps_descend) is false. The steps are then
    /// not Poisson maps, and the Casimirs are conserved only to the order of the scheme.
    ///
    /// # Errors
    /// Returns the errors of [`integrator`](Self::integrator).
    ///
    /// # Example
    /// ```
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra, SystemMethod};
    /// use lie_poisson_formulas::{Coordinates, Parameters};
    /// let descends = |brackets: [(&str, &str); 2]| -> Result<bool, Box<dyn std::error::Error>> {
    ///     let names = Coordinates::scalars(["x", "y", "z"])?;
    ///     let algebra = SystemAlgebra::of_brackets(names, brackets, &Parameters::new())?;
    ///     let method = SystemMethod::new(&algebra, Formulation::Collective, SchemeName::Gauss(2), 0.0)?;
    ///     let system = FormulaSystem::new(algebra, "x^2 + y^2 + z^2", &Parameters::new())?;
    ///     Ok(method.descends(&system, &[0.1, 0.3, -0.2])?)
    /// };
    /// assert!(descends([("x, y", "z"), ("x, z", "y")])?); // the Poincaré algebra
    /// assert!(!descends([("x, z", "x"), ("y, z", "2*y")])?); // the cube of ad z is no multiple of it
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn descends(
        &self,
        system: &FormulaSystem,
        start: &[f64],
    ) -> Result<bool, FormulaSystemError> {
        self.integration(system, start)?.descends()
    }

    /// Checks that the method exists for the system and the start, and returns it with them.
    fn integration<'a>(
        &self,
        system: &'a FormulaSystem,
        start: &'a [f64],
    ) -> Result<Integration<'a>, FormulaSystemError> {
        let Self { formulation, scheme, tolerance } = *self;
        require(system.algebra(), formulation, scheme)?;
        system.require_differential(start)?;
        Ok(Integration { formulation, scheme, tolerance, system, start })
    }
}
