//! A system whose states are arrays, as a model: [`ArraySystem`].

use super::any_arrays::Arrays;
use super::arguments::{Arguments, Given};
use super::array_kind::ArrayKind;
use super::open::array_terms::ArrayTerms;
use super::open::opened::Opening;
use super::renewed::resumable_after;
use crate::error::RunFailure;
use crate::models::conserved::Conserved;
use crate::models::model::Model;
use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyIntegrator, AnyTangents};
use core::ops::Range;
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson_formula_systems::FormulaSystemError;
use std::sync::Arc;

/// A system of an [`ArrayKind`](crate::ArrayKind), of a size that is known only when the program runs.
#[derive(Clone, Debug)]
pub struct ArraySystem {
    kind: &'static ArrayKind,
    system: Arc<dyn Arrays>,
}

impl ArrayKind {
    /// Returns the system with these parameters.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::KindParameter`] if a parameter is missing, has another shape, or is none of the system,
    /// and [`FormulaSystemError::KindValue`] if it has a value that it cannot have.
    pub fn system(
        &'static self,
        parameters: &Arguments,
    ) -> Result<ArraySystem, FormulaSystemError> {
        let given = Given::new((self.name, false), self.parameters, parameters)?;
        Ok(ArraySystem { kind: self, system: (self.make)(&given)?.into() })
    }
}

impl ArraySystem {
    /// Returns the kind of system.
    #[must_use]
    pub const fn kind(&self) -> &'static ArrayKind {
        self.kind
    }

    /// Returns the name of the kind of system.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.kind.name
    }

    /// Returns what the system is, in a few words.
    #[must_use]
    pub fn about(&self) -> &'static str {
        self.kind.about
    }

    /// Returns the arrays of a state, one after the other: the name and the shape of each, whose last index is the fastest.
    #[must_use]
    pub fn arrays(&self) -> Vec<(&'static str, Vec<usize>)> {
        self.system.arrays().into_iter().map(|array| (array.name, array.shape)).collect()
    }

    /// Returns the number of coordinates.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.system.arrays().iter().map(|array| array.count()).sum()
    }

    /// Returns the state that is given by the [parameters of a start](crate::ArrayKind::start), in the arrays of the users.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError`] as [`ArrayKind::system`](crate::ArrayKind::system) does.
    pub fn start_of(&self, given: &Arguments) -> Result<Vec<f64>, FormulaSystemError> {
        self.system.start(&Given::new((self.name(), true), self.kind.start, given)?)
    }

    /// Returns the rate dμ/dt of a state, both in the arrays of the users.
    ///
    /// # Errors
    /// If the state has another number of coordinates.
    pub fn rate(&self, given: &[f64]) -> Result<Vec<f64>, RunFailure> {
        let mut rate = self.system.rate(&Model::start(self, given)?);
        // What users read depends linearly on the state.
        self.system.present(&mut rate);
        Ok(rate)
    }

    /// Returns the values of the field of a state, as users read it, on a circle of constant colatitude (rad), at so many
    /// longitudes from 0 on; `None` if the system is no fluid on the sphere.
    #[must_use]
    pub fn on_circle(&self, state: &[f64], colatitude: f64, count: usize) -> Option<Vec<f64>> {
        self.fits(state).then(|| self.system.on_circle(state, colatitude, count))?
    }

    /// Returns the system with friction, forces and noise for steps of a size, s; `None` if it has no such terms.
    pub(super) fn opened(&self, terms: &ArrayTerms, step: f64) -> Option<Opening> {
        self.system.opened(terms, step)
    }

    /// Returns whether a state has as many numbers as there are coordinates.
    fn fits(&self, state: &[f64]) -> bool {
        state.len() == self.dimension()
    }

    /// Returns the formulations that the system has, the default one first.
    #[must_use]
    pub fn formulations(&self) -> &'static [Formulation] {
        self.system.formulations()
    }

    /// Returns the method of a scheme in a formulation, by default the first of the system. Stages are solved to the
    /// tolerance, relative to the state; 0 iterates to the round-off floor.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoMethod`], which names the methods that the system has, and
    /// [`FormulaSystemError::Method`] for a tolerance that is negative or not finite.
    pub fn method(
        &self,
        formulation: Option<Formulation>,
        scheme: SchemeName,
        tolerance: f64,
    ) -> Result<Method, FormulaSystemError> {
        let all = self.formulations();
        let formulation = formulation.or(all.first().copied()).unwrap_or_default();
        let has = if !all.contains(&formulation) {
            let names: Vec<_> = all.iter().map(|formulation| formulation.name()).collect();
            format!("it has {}", names.join(", "))
        } else if !self.system.offers(formulation, scheme) {
            let names = SchemeName::NAMES.iter();
            let names = names.filter(|(_, scheme)| self.system.offers(formulation, *scheme));
            let names: Vec<_> = names.map(|(name, _)| *name).collect();
            format!("{formulation} has {}", names.join(", "))
        } else {
            return Ok(Method::of_system(formulation, scheme, tolerance)?);
        };
        let algebra = self.name().into();
        Err(FormulaSystemError::NoMethod { algebra, formulation, scheme, has })
    }
}

impl SystemScales for ArraySystem {
    /// Each spin, and each other array as a whole.
    fn blocks(&self) -> Vec<Range<usize>> {
        let (mut blocks, mut first) = (Vec::new(), 0);
        for array in self.system.arrays() {
            let last = first + array.count();
            let ends = (first..last).step_by(array.block.max(1));
            blocks.extend(ends.map(|start| start..(start + array.block).min(last)));
            first = last;
        }
        blocks
    }

    /// It is NaN for a state of another dimension.
    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        match self.fits(mu) {
            true => self.system.differential(mu),
            false => vec![f64::NAN; mu.len()],
        }
    }

    /// It is NaN for a state of another dimension.
    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        if self.fits(mu) { self.system.fastest_rate(mu) } else { f64::NAN }
    }
}

impl Model for ArraySystem {
    fn algebra_name(&self) -> String {
        self.system.algebra_name()
    }

    /// Columns have the names of their arrays, with the number of the row in it and that in the row.
    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        let columns = |name: &str, shape: &[usize]| {
            let (rows, width) = match shape {
                [] => (1, 1),
                [rows] => (*rows, 1),
                [rows @ .., width] => (rows.iter().product(), *width),
            };
            let column = |i: usize| match shape.len() {
                0 | 1 => format!("{name}_{}", i + 1),
                _ => format!("{name}_{}_{}", i / width + 1, i % width + 1),
            };
            (0..rows * width).map(column).collect()
        };
        let arrays = self.system.arrays().into_iter();
        arrays.map(|array| (array.name.to_owned(), columns(array.name, &array.shape))).collect()
    }

    fn shape(&self, coordinate: &str) -> Option<Vec<usize>> {
        let arrays = self.system.arrays();
        Some(arrays.into_iter().find(|array| array.name == coordinate)?.shape)
    }

    fn conserved(&self, _start: &[f64]) -> Box<dyn Conserved + '_> {
        Box::new(Invariants(self))
    }

    fn tangent_integrator(
        &self,
        method: &Method,
        _start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        self.system.tangent_integrator(method)
    }

    fn integrator(&self, method: &Method, _start: &[f64]) -> Result<AnyIntegrator, RunFailure> {
        self.system.integrator(method)
    }

    fn resumable_after(&self) -> u64 {
        resumable_after(self.dimension())
    }

    fn require_dimension(&self, momentum: &[f64]) -> Result<(), RunFailure> {
        let (expected, found) = (self.dimension(), momentum.len());
        match expected == found {
            true => Ok(()),
            false => Err(FormulaSystemError::StateLength { expected, found }.into()),
        }
    }

    fn start(&self, given: &[f64]) -> Result<Vec<f64>, RunFailure> {
        self.require_dimension(given)?;
        let mut state = given.to_vec();
        self.system.understand(&mut state);
        Ok(state)
    }

    fn present(&self, momentum: &mut [f64]) {
        if self.fits(momentum) {
            self.system.present(momentum);
        }
    }

    fn formula(&self, conserved: &str) -> Option<String> {
        (conserved == "h").then(|| self.system.hamiltonian().into())
    }
}

/// The conserved quantities of a system.
struct Invariants<'a>(&'a ArraySystem);

impl Conserved for Invariants<'_> {
    fn names(&self) -> Vec<String> {
        self.0.system.invariant_names()
    }

    fn append(&self, _time: f64, momentum: &[f64], values: &mut Vec<f64>) {
        match self.0.fits(momentum) {
            true => self.0.system.invariants(momentum, values),
            false => values.extend(self.names().iter().map(|_| f64::NAN)),
        }
    }

    fn without_value(&self, time: f64, momentum: &[f64]) -> String {
        without_value(self, time, momentum)
    }
}

/// Returns which quantity has no value, in words.
pub(super) fn without_value(conserved: &dyn Conserved, time: f64, momentum: &[f64]) -> String {
    let (mut values, names) = (Vec::new(), conserved.names());
    conserved.append(time, momentum, &mut values);
    let found = names.iter().zip(&values).find(|(_, value)| !value.is_finite());
    found.map_or("a quantity has no value".into(), |(name, value)| format!("{name} is {value}"))
}
