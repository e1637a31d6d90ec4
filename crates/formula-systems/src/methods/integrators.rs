//! The integrators of a system: [`FormulaSystem::tangent_integrator`].

use super::integration::Integration;
use crate::error::FormulaSystemError;
use crate::systems::formula_system::FormulaSystem;
use collective_integrators::{AnyIntegrator, AnyTangents};
use heavytop::methods::Method;

impl FormulaSystem {
    /// Returns the integrator of a method, for runs from a state. It has tangent maps. Stages are solved to the method's
    /// tolerance, relative to the state; 0 iterates to the round-off floor.
    ///
    /// The state is needed because a realisation has a lift for one state but not for another.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError`] if the algebra [does not have the method](crate::SystemAlgebra::method), if the length of the
    /// state is not the dimension, if h has no value or no differential at the start, or if the integrator cannot be made.
    ///
    /// # Example
    /// The drift of the Casimir |Π|² of a free rigid body over 100 steps:
    /// ```
    /// use collective_integrators::{AnyState, Start};
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::Parameters;
    ///
    /// let body = FormulaSystem::new(SystemAlgebra::named("so(3)")?, "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2", &Parameters::new())?;
    /// let body = body.with_found_casimirs()?;
    /// let start = [1.0, 2.0, 0.5];
    /// let drift = |formulation, scheme| -> Result<f64, Box<dyn std::error::Error>> {
    ///     let integrator = body.tangent_integrator(&body.algebra().method(formulation, scheme, 0.0)?, &start)?;
    ///     let end = integrator.after(&AnyState::from_slice(&start), 0.1, 100)?.momentum;
    ///     Ok((body.invariants(end.as_slice())?[1] - body.invariants(&start)?[1]).abs())
    /// };
    /// assert!(drift(Formulation::Collective, SchemeName::Gauss(2))? < 1e-13);
    /// assert!(drift(Formulation::Direct, SchemeName::Rk4)? > 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn tangent_integrator(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, FormulaSystemError> {
        self.integration(method, start)?.make()
    }

    /// Returns the fastest integrator of a method, for runs from a state. It makes the steps of
    /// [`tangent_integrator`](Self::tangent_integrator) up to rounding errors, on every processor with the same bits, and has
    /// no tangent maps. The stages of Gauss's methods are in the lanes of a register, except for `reduced` on sums of so(3) and
    /// su(2). `reduced`, which is the same map as `collective` on so(3), su(2) and se(3), takes the lift of `collective` where there
    /// is one.
    ///
    /// # Errors
    /// Returns the errors of [`tangent_integrator`](Self::tangent_integrator).
    ///
    /// # Example
    /// ```
    /// use collective_integrators::{AnyState, Start};
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::Parameters;
    /// let text = "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2 + cos(Gamma1)";
    /// let body = FormulaSystem::new(SystemAlgebra::named("se(3)")?, text, &Parameters::new())?;
    /// let method = body.algebra().method(Formulation::Reduced, SchemeName::Gauss(6), 0.0)?;
    /// let start = [1.0, 2.0, 0.5, 0.6, 0.0, 0.8];
    /// let state = AnyState::from_slice(&start);
    /// let fast = body.integrator(&method, &start)?.after(&state, 0.1, 100)?.momentum;
    /// let with_tangents = body.tangent_integrator(&method, &start)?.after(&state, 0.1, 100)?.momentum;
    /// let same = |(x, y): (&f64, &f64)| (x - y).abs() < 1e-11;
    /// assert!(fast.as_slice().iter().zip(with_tangents.as_slice()).all(same));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn integrator(
        &self,
        method: &Method,
        start: &[f64],
    ) -> Result<AnyIntegrator, FormulaSystemError> {
        let lifted = self.integration(method, start)?.with_lift()?;
        let method = lifted.as_ref().unwrap_or(method);
        let integration = Integration { method, system: self, start };
        match integration.make_in_lanes()? {
            Some(integrator) => Ok(integrator),
            None => Ok(integration.make()?.without_tangents()),
        }
    }

    /// Returns whether the steps of a method descend to 𝔤∗. It is false for a collective method by a Clebsch map whose
    /// [`equivariant_maps_descend`](momentum_map::PoissonMap::equivariant_maps_descend) is false. The steps are then
    /// not Poisson maps, and the Casimirs are conserved only to the order of the scheme.
    ///
    /// # Errors
    /// Returns the errors of [`tangent_integrator`](Self::tangent_integrator).
    ///
    /// # Example
    /// ```
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::{Coordinates, Parameters};
    /// let descends = |brackets: [(&str, &str); 2]| -> Result<bool, Box<dyn std::error::Error>> {
    ///     let names = Coordinates::scalars(["x", "y", "z"])?;
    ///     let algebra = SystemAlgebra::of_brackets(names, brackets, &Parameters::new())?;
    ///     let method = algebra.method(Formulation::Collective, SchemeName::Gauss(2), 0.0)?;
    ///     let system = FormulaSystem::new(algebra, "x^2 + y^2 + z^2", &Parameters::new())?;
    ///     Ok(system.descends(&method, &[0.1, 0.3, -0.2])?)
    /// };
    /// assert!(descends([("x, y", "z"), ("x, z", "y")])?); // the Poincaré algebra
    /// assert!(!descends([("x, z", "x"), ("y, z", "2*y")])?); // the cube of ad z is no multiple of it
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn descends(&self, method: &Method, start: &[f64]) -> Result<bool, FormulaSystemError> {
        self.integration(method, start)?;
        Ok(self.algebra().descends(method.formulation()))
    }

    /// Checks that the system has the method from the start, and returns all three.
    fn integration<'a>(
        &'a self,
        method: &'a Method,
        start: &'a [f64],
    ) -> Result<Integration<'a>, FormulaSystemError> {
        self.algebra().require(method.formulation(), method.scheme())?;
        self.require_differential(start)?;
        Ok(Integration { method, system: self, start })
    }
}
