//! The scales of a system: [`SystemScales`].

use core::ops::Range;

/// The scales of a system, in which the accuracy of a run is a pure number whatever the units of its coordinates.
///
/// [`run_accuracy`](super::run_accuracy) has an example.
pub trait SystemScales {
    /// Returns the ranges of the coordinates of μ that have one unit and are measured together, such as Π and Γ of a top.
    ///
    /// Coordinates that are in no range are not measured.
    fn blocks(&self) -> Vec<Range<usize>>;

    /// Returns the coordinates of ξ = dh(μ).
    fn differential(&self, mu: &[f64]) -> Vec<f64>;

    /// Returns the fastest rate of the motion through μ, in radians per unit of time: for a top |Ω|, and for any system
    /// the largest magnitude of an eigenvalue of `ad*_ξ`.
    fn fastest_rate(&self, mu: &[f64]) -> f64;
}
