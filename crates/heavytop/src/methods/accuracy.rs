//! The scales of tops, and the accuracy of their runs: [`Method::accuracy`] and [`Method::check`].

use super::{Method, MethodError};
use crate::tops::top::{HeavyTop, kinetic};
use collective_integrators::RunError;
use collective_integrators::diagnostics::{
    RunAccuracy, StepCheck, SystemScales, check_by_half_steps, run_accuracy,
};
use core::ops::Range;
use lie_poisson::{Se3Dual, State};
use nalgebra::Vector3;

/// Π is measured by |Π|, and Γ by |Γ|. The differential is (Ω, m g l c). The fastest rate of the motion through (Π, Γ),
/// rad/s, is |Ω| + √(m g l |Γ|/I), I the least moment: the body turns, and swings.
///
/// # Example
/// ```
/// use heavytop::HeavyTop;
/// use heavytop::collective_integrators::diagnostics::SystemScales;
/// let top = HeavyTop::kovalevskaya(1.0, 1.0)?; // moments (2, 2, 1)
/// assert_eq!(top.fastest_rate(&[6.0, 0.0, 4.0, 0.0, 0.0, 1.0]), 6.0);
/// # Ok::<(), heavytop::TopError>(())
/// ```
impl SystemScales for HeavyTop {
    fn blocks(&self) -> Vec<Range<usize>> {
        vec![0..3, 3..6]
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        let weight = self.center_of_mass() * self.weight_moment();
        self.angular_velocity(&part(mu, 0)).iter().chain(&weight).copied().collect()
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        let (pi, gamma) = (part(mu, 0), part(mu, 3));
        let swing = (self.weight_moment() * gamma.norm() / self.least_moment()).sqrt();
        self.angular_velocity(&pi).norm() + swing
    }
}

impl HeavyTop {
    /// Returns the least principal moment, kg m²; that across it for a thin rod, which does not turn about itself.
    ///
    /// # Example
    /// ```
    /// use heavytop::HeavyTop;
    /// assert_eq!(HeavyTop::kovalevskaya(1.0, 1.0)?.least_moment(), 1.0); // of (2, 2, 1)
    /// # Ok::<(), heavytop::TopError>(())
    /// ```
    #[must_use]
    pub fn least_moment(&self) -> f64 {
        kinetic(&self.inertia()).min()
    }
}

/// Returns the three coordinates from a place on.
fn part(mu: &[f64], first: usize) -> Vector3<f64> {
    Vector3::from_fn(|i, _| mu.get(first + i).copied().unwrap_or(f64::NAN))
}

impl Method {
    /// Measures how accurate a run of `steps` steps of size `step` from a start is, without making the whole run if it is
    /// long: [`run_accuracy`]. There is no estimate if `going` tells it to end.
    ///
    /// # Errors
    /// Returns the errors of [`integrator`](Self::integrator).
    ///
    /// # Example
    /// The midpoint rule is wrong in the first digit after 20 s with 0.15 rad a step, and Gauss's method of order 8 is
    /// not. The invariants show neither.
    /// ```
    /// use heavytop::HeavyTop;
    /// use heavytop::lie_poisson::Se3Dual;
    /// use heavytop::methods::{Formulation, Method, SchemeName};
    /// use heavytop::nalgebra::Vector3;
    /// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    /// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
    /// let error = |scheme| -> Result<_, heavytop::methods::MethodError> {
    ///     let method = Method::new(Formulation::Collective, scheme, 0.0)?;
    ///     Ok(method.accuracy(&top, &start, (0.032, 625), &|| true)?.error)
    /// };
    /// assert!(error(SchemeName::ImplicitMidpoint)? > Some(0.1));
    /// assert!(error(SchemeName::Gauss(4))? < Some(1e-11));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn accuracy(
        &self,
        top: &HeavyTop,
        start: &Se3Dual,
        steps: (f64, u64),
        going: &dyn Fn() -> bool,
    ) -> Result<RunAccuracy, MethodError> {
        let (integrator, order) = (self.integrator(top)?, self.scheme().order());
        let start = coordinates(start);
        Ok(run_accuracy(&integrator, top, &start, steps, order, going))
    }

    /// Checks a whole run of `steps` steps of size `step` from a start by runs with half the step and with twice the step:
    /// [`check_by_half_steps`]. Returns `None` if `going` tells it to end.
    ///
    /// # Errors
    /// Returns the errors of [`integrator`](Self::integrator). The inner error is that of a step that fails.
    ///
    /// # Example
    /// ```
    /// use heavytop::HeavyTop;
    /// use heavytop::lie_poisson::Se3Dual;
    /// use heavytop::methods::{Formulation, Method, SchemeName};
    /// use heavytop::nalgebra::Vector3;
    /// let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    /// let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
    /// let gauss = Method::new(Formulation::Reduced, SchemeName::Gauss(3), 0.0)?;
    /// let check = gauss.check(&top, &start, (0.05, 400), &|| true)??.ok_or("it was not told to end")?;
    /// assert!(check.error < Some(1e-5) && check.order.is_ok_and(|order| (order - 6.0).abs() < 0.2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn check(
        &self,
        top: &HeavyTop,
        start: &Se3Dual,
        steps: (f64, u64),
        going: &dyn Fn() -> bool,
    ) -> Result<Result<Option<StepCheck>, RunError>, MethodError> {
        let (integrator, order) = (self.integrator(top)?, self.scheme().order());
        let start = coordinates(start);
        Ok(check_by_half_steps(&integrator, top, &start, steps, order, going))
    }
}

fn coordinates(mu: &Se3Dual) -> [f64; 6] {
    core::array::from_fn(|i| mu.coordinate(i))
}
