//! The Runge–Kutta methods and their compositions by name: one type of scheme.

use super::{ComposedScheme, MethodError, SchemeName};
use collective_integrators::{Composition, RungeKutta, StageSolver};

impl SchemeName {
    /// Returns the Runge–Kutta method of the name, or the composition of implicit midpoint rules. A method that is no
    /// composition is one of a single substep, which is a step of the method itself to the last bit. It is `None` for
    /// a partitioned method, and for the spherical midpoint method. Stages are solved to `tolerance`, relative to the state; 0 iterates to the round-off floor.
    ///
    /// # Errors
    /// Returns [`MethodError::Scheme`] if the coefficients of the method cannot be made.
    ///
    /// # Example
    /// ```
    /// use heavytop::collective_integrators::Scheme;
    /// use heavytop::methods::SchemeName;
    /// let order = |name: &str| -> Result<Option<usize>, Box<dyn std::error::Error>> {
    ///     let scheme = name.parse::<SchemeName>()?.runge_kutta(0.0)?;
    ///     Ok(scheme.map(|scheme| scheme.order()))
    /// };
    /// assert_eq!((order("gauss-12")?, order("kahan-li-8")?), (Some(12), Some(8)));
    /// assert_eq!(order("stormer-verlet")?, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn runge_kutta(
        self,
        tolerance: f64,
    ) -> Result<Option<Composition<RungeKutta>>, MethodError> {
        let solver = StageSolver { tolerance, ..StageSolver::default() };
        let failed = |reason| MethodError::Scheme { scheme: self, reason };
        let midpoint = || RungeKutta::implicit_midpoint().with_solver(solver);
        let (base, composed) = match self {
            Self::ImplicitMidpoint => (midpoint(), ComposedScheme::Strang),
            Self::Gauss(stages) => {
                let gauss = RungeKutta::gauss(stages.into()).map_err(failed)?;
                (gauss.with_solver(solver), ComposedScheme::Strang)
            }
            Self::ExplicitMidpoint => (RungeKutta::explicit_midpoint(), ComposedScheme::Strang),
            Self::Rk4 => (RungeKutta::rk4(), ComposedScheme::Strang),
            Self::Composed(composed) => (midpoint(), composed),
            Self::Partitioned(_) | Self::SphericalMidpoint => return Ok(None),
        };
        Ok(Some(Composition::new(base, composed.substeps().map_err(failed)?)))
    }
}
