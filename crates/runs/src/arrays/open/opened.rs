//! What a system of arrays with friction, forces and noise has: [`Opened`].

use collective_integrators::AnyIntegrator;
use core::fmt;
use lie_poisson_formula_systems::FormulaSystemError;

/// The system with the terms of users, or the reason why it cannot have them.
pub(in crate::arrays) type Opening = Result<Box<dyn Opened>, FormulaSystemError>;

/// A system of arrays with friction, forces and noise. States are slices of all their numbers.
pub(in crate::arrays) trait Opened: fmt::Debug + Send + Sync {
    /// Returns the names of the quantities that have columns, h first.
    fn quantities(&self) -> Vec<String>;

    /// Appends their values at a time.
    fn append(&self, time: f64, state: &[f64], values: &mut Vec<f64>);

    /// Returns whether the motion keeps one of them.
    fn keeps(&self, quantity: &str) -> bool;

    /// Returns the rate of a state at a time without noise; with noise it is the drift in Stratonovich's sense.
    fn rate(&self, time: f64, state: &[f64]) -> Vec<f64>;

    /// Returns the rate, rad/s, by which a field in time may turn a state besides the system.
    fn rate_of_drive(&self) -> f64 {
        0.0
    }

    /// Returns the angle by which the noise turns a state in a step, rad.
    fn noise_angle(&self, state: &[f64], step: f64) -> f64;

    /// Returns the implicit midpoint rule, whose stages are solved to a tolerance, on the path of a number. The last
    /// two coordinates of its states are the number of the path and the time.
    fn integrator(&self, tolerance: f64, path: u64) -> AnyIntegrator;
}
