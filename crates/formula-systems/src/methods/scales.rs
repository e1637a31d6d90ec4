//! The scales of systems.

use super::spectral_radius::spectral_radius;
use crate::systems::formula_system::FormulaSystem;
use collective_integrators::diagnostics::SystemScales;
use core::ops::Range;
use lie_poisson_formulas::StructureEntry;

/// Each vector of coordinates is measured by its length, and each scalar by its magnitude.
///
/// The fastest rate of the motion through a state, in radians per unit of time, is the largest magnitude of an eigenvalue of
/// `ad_ξ`, ξ = dh(μ), whose matrix is `(ad_ξ)_kj = Σ_i c_ijk ξ_i`. It is that of `ad∗_ξ`, and does not depend on the units
/// of the coordinates. It is NaN where h has no differential.
///
/// # Example
/// ```
/// use collective_integrators::diagnostics::SystemScales;
/// use lie_poisson_formula_systems::{FormulaSystem, SystemAlgebra};
/// use lie_poisson_formulas::Parameters;
/// let text = "(Pi1^2 + Pi2^2/2 + Pi3^2/4)/2";
/// let body = FormulaSystem::new(SystemAlgebra::named("so(3)")?, text, &Parameters::new())?;
/// // A body turns by |Ω|, here of Ω = (1, 2, 2).
/// assert!((body.fastest_rate(&[1.0, 4.0, 8.0]) / 3.0 - 1.0).abs() < 1e-3);
/// # Ok::<(), lie_poisson_formula_systems::FormulaSystemError>(())
/// ```
impl SystemScales for FormulaSystem {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.algebra().coordinates().groups().map(|(_, places)| places).collect()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.hamiltonian().differential_at(mu)
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        self.rate_of_element(&self.hamiltonian().differential_at(mu))
    }
}

impl FormulaSystem {
    /// Returns the fastest rate of a motion along an element ξ of the algebra.
    pub(crate) fn rate_of_element(&self, xi: &[f64]) -> f64 {
        let dimension = self.algebra().dimension();
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
