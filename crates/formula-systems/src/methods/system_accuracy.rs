//! The accuracy of runs of systems: [`SystemMethod::accuracy`] and [`SystemMethod::check`].

use super::spectral_radius::spectral_radius;
use super::system_method::SystemMethod;
use crate::{FormulaSystem, FormulaSystemError};
use collective_integrators::RunError;
use collective_integrators::diagnostics::{
    RunAccuracy, StepCheck, SystemScales, check_by_half_steps, run_accuracy,
};
use core::ops::Range;
use lie_poisson_formulas::StructureEntry;

/// The scales of a system: each vector of coordinates is measured by its length, and each scalar by its magnitude.
struct FormulaScales<'a>(&'a FormulaSystem);

impl SystemScales for FormulaScales<'_> {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.0.algebra().coordinates().groups().map(|(_, places)| places).collect()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.0.hamiltonian().differential_at(mu)
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        self.0.fastest_rate(mu)
    }
}

impl FormulaSystem {
    /// Returns the fastest rate of the motion through a state, in radians per unit of time: the largest magnitude of an
    /// eigenvalue of `ad_ξ`, ξ = dh(μ), whose matrix is `(ad_ξ)_kj = Σ_i c_ijk ξ_i`. It is that of `ad∗_ξ`, and does not
    /// depend on the units of the coordinates. It is NaN where h has no differential.
    ///
    /// [`SystemMethod::accuracy`] measures steps by it.
    ///
    /// # Example
    /// ```
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
    /// use lie_poisson_formulas::Parameters;
    /// let text = "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2";
    /// let body = FormulaSystem::new(SystemAlgebra::named("so(3)")?, text, &Parameters::new())?;
    /// // A body turns by |Ω|, here of Ω = (1, 2, 2).
    /// assert!((body.fastest_rate(&[1.0, 4.0, 8.0]) / 3.0 - 1.0).abs() < 1e-3);
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    #[must_use]
    pub fn fastest_rate(&self, state: &[f64]) -> f64 {
        let (xi, dimension) =
            (self.hamiltonian().differential_at(state), self.algebra().dimension());
        let mut adjoint = vec![0.0; dimension * dimension];
        for &StructureEntry { i, j, k, value } in self.algebra().entries() {
            for (i, j, value) in [(i, j, value), (j, i, -value)] {
                let velocity = xi.get(i).copied().unwrap_or(0.0);
                if let Some(entry) = adjoint.get_mut(k * dimension + j) {
                    *entry += value * velocity;
                }
            }
        }
        spectral_radius(adjoint, dimension)
    }
}

impl SystemMethod {
    /// Measures how accurate a run of `steps` steps of size `step` from a state is, without making the whole run if it is
    /// long: [`run_accuracy`]. There is no estimate if `going` tells it to end.
    ///
    /// # Errors
    /// Returns the errors of [`integrator`](Self::integrator).
    ///
    /// # Example
    /// A free rigid body that turns by 15 rad in a step. The energy and |Π|² are conserved to round-off.
    /// ```
    /// use heavytop::methods::{Formulation, SchemeName};
    /// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra, SystemMethod};
    /// use lie_poisson_formulas::Parameters;
    /// let text = "(Pi1^2 + Pi2^2/2 + Pi3^2/3)/2";
    /// let body = FormulaSystem::new(SystemAlgebra::named("so(3)")?, text, &Parameters::new())?;
    /// let gauss = SystemMethod::new(body.algebra(), Formulation::Collective, SchemeName::Gauss(4), 0.0)?;
    /// let start = [10.0, 0.1, 10.0];
    /// let accuracy = gauss.accuracy(&body, &start, (0.02, 500), &|| true)?;
    /// assert!(accuracy.error < Some(1e-9) && accuracy.warning().is_none());
    /// let accuracy = gauss.accuracy(&body, &start, (0.3, 500), &|| true)?;
    /// assert!(accuracy.angle > 3.0 && accuracy.warning().is_some());
    /// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
    /// ```
    pub fn accuracy(
        &self,
        system: &FormulaSystem,
        start: &[f64],
        steps: (f64, u64),
        going: &dyn Fn() -> bool,
    ) -> Result<RunAccuracy, FormulaSystemError> {
        let integrator = self.integrator(system, start)?.without_tangents();
        let (scales, order) = (FormulaScales(system), self.scheme().order());
        Ok(run_accuracy(&integrator, &scales, start, steps, order, going))
    }

    /// Checks a whole run of `steps` steps of size `step` from a state by runs with half the step and with twice the step:
    /// [`check_by_half_steps`]. Returns `None` if `going` tells it to end.
    ///
    /// # Errors
    /// Returns the errors of [`integrator`](Self::integrator). The inner error is that of a step that fails.
    pub fn check(
        &self,
        system: &FormulaSystem,
        start: &[f64],
        steps: (f64, u64),
        going: &dyn Fn() -> bool,
    ) -> Result<Result<Option<StepCheck>, RunError>, FormulaSystemError> {
        let integrator = self.integrator(system, start)?.without_tangents();
        let (scales, order) = (FormulaScales(system), self.scheme().order());
        Ok(check_by_half_steps(&integrator, &scales, start, steps, order, going))
    }
}
