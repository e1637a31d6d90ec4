//! What a system of arrays has: [`Arrays`].

use super::arguments::Given;
use super::open::array_terms::ArrayTerms;
use super::open::opened::Opening;
use crate::error::RunFailure;
use collective_integrators::{AnyIntegrator, AnyTangents};
use core::fmt;
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson_formula_systems::FormulaSystemError;

/// The system that parameters describe.
pub(super) type Made = Result<Box<dyn Arrays>, FormulaSystemError>;

/// The state at a start, in the arrays of the users.
pub(super) type Started = Result<Vec<f64>, FormulaSystemError>;

/// An array of a state: its name, and its shape, the last index of which is the fastest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ArrayShape {
    pub(super) name: &'static str,
    pub(super) shape: Vec<usize>,
    /// The number of coordinates that are measured together, such as the three of a spin.
    pub(super) block: usize,
}

impl ArrayShape {
    pub(super) fn count(&self) -> usize {
        self.shape.iter().product()
    }
}

/// A Lie–Poisson system whose states are arrays, one after the other. States are slices of all their numbers.
pub(super) trait Arrays: fmt::Debug + Send + Sync {
    /// Returns the name of the Lie algebra.
    fn algebra_name(&self) -> String;

    /// Returns the Hamiltonian, in words of formulas.
    fn hamiltonian(&self) -> &'static str;

    /// Returns the arrays.
    fn arrays(&self) -> Vec<ArrayShape>;

    /// Returns the names of the conserved quantities, h first.
    fn invariant_names(&self) -> Vec<String>;

    /// Appends their values.
    fn invariants(&self, state: &[f64], values: &mut Vec<f64>);

    /// Returns dh.
    fn differential(&self, state: &[f64]) -> Vec<f64>;

    /// Returns the rate dμ/dt of a state.
    fn rate(&self, state: &[f64]) -> Vec<f64>;

    /// Returns the fastest rate of the motion, in radians per unit of time.
    fn fastest_rate(&self, state: &[f64]) -> f64;

    /// Returns the formulations that the system has, the default one first.
    fn formulations(&self) -> &'static [Formulation];

    /// Returns whether the system has a scheme in a formulation that it has.
    fn offers(&self, formulation: Formulation, scheme: SchemeName) -> bool;

    /// Returns the fastest integrator of a method that the system offers.
    ///
    /// # Errors
    /// If the coefficients of the scheme cannot be made.
    fn integrator(&self, method: &Method) -> Result<AnyIntegrator, RunFailure>;

    /// Returns the integrator of a method that has tangent maps.
    ///
    /// # Errors
    /// If there is none.
    fn tangent_integrator(
        &self,
        method: &Method,
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure>;

    /// Returns the state that is given by the parameters of a start.
    ///
    /// # Errors
    /// If they give none.
    fn start(&self, given: &Given<'_>) -> Started;

    /// Replaces a state by what users read, of the same size.
    fn present(&self, _state: &mut [f64]) {}

    /// Returns the values of the field of a state, as users read it, on a circle of constant colatitude at so many longitudes
    /// from 0 on; `None` if it is no field on the sphere.
    fn on_circle(&self, _given: &[f64], _colatitude: f64, _count: usize) -> Option<Vec<f64>> {
        None
    }

    /// Returns the system with friction, forces and noise for steps of a size, s; `None` if it has no such terms.
    fn opened(&self, _terms: &ArrayTerms, _step: f64) -> Option<Opening> {
        None
    }

    /// Replaces what users read by the state.
    fn understand(&self, _given: &mut [f64]) {}
}
