//! The errors of systems, methods and initial states: [`FormulaSystemError`].

use crate::open_system_error::OpenSystemError;
use heavytop::methods::{Formulation, MethodError, SchemeName};
use lie_poisson_formulas::{CasimirError, EntryError, FormulaError, NameError, ValueError};
use momentum_map::LiftError;
use thiserror::Error;

/// The reason why a system, a method for it, or an initial state cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FormulaSystemError {
    /// What drives, damps, shakes or forces a system does not fit it.
    #[error(transparent)]
    Open(#[from] OpenSystemError),
    /// No algebra of the library has this name.
    #[error("there is no algebra {name}; there are {}", names.join(", "))]
    NoAlgebra {
        /// The name that no algebra has.
        name: String,
        /// The names of all algebras.
        names: Vec<&'static str>,
    },
    /// The text of an algebra cannot be read from a column on.
    #[error("algebra: `{text}`, column {column}: {problem}")]
    AlgebraText {
        /// The text.
        text: String,
        /// The column, from 1.
        column: usize,
        /// What is wrong, and what could stand there.
        problem: String,
    },
    /// There are fewer or more symbols for the coordinates of an algebra than it has.
    #[error("coordinates: {found} symbols; the algebra has {}: {}", own.len(), own.join(", "))]
    Symbols {
        /// The number of symbols.
        found: usize,
        /// The symbols of the algebra.
        own: Vec<String>,
    },
    /// Matrices that are given by a name in the text of an algebra are no representation of the algebra before it.
    #[error("{name} is no representation: {problem}")]
    Representation {
        /// The name of the matrices.
        name: String,
        /// What is wrong.
        problem: String,
    },
    /// Matrices make no realisation of an algebra.
    #[error("realisation: {problem}")]
    Realisation {
        /// What is wrong.
        problem: String,
    },
    /// There is no system of this name.
    #[error("there is no system {name}; there are {}", kinds.join(", "))]
    NoKind {
        /// The name that no system has.
        name: String,
        /// The names of all systems, and what they are.
        kinds: Vec<String>,
    },
    /// A parameter of a system by name is missing, has another number of components, or is none of its parameters.
    #[error("{kind}: {problem}{} It takes {}", if problem.ends_with('?') { "" } else { "." }, has.join(", "))]
    KindParameter {
        /// The name of the system.
        kind: &'static str,
        /// Whether it is a part of the start.
        is_start: bool,
        /// The name of the parameter.
        name: String,
        /// What is wrong with it.
        problem: String,
        /// The parameters of the system, or of its start.
        has: Vec<String>,
    },
    /// A parameter of a system by name, or a part of its start, has a value that it cannot have.
    #[error("{kind}: {name} must be {needed}")]
    KindValue {
        /// The name of the system.
        kind: &'static str,
        /// The name of the parameter.
        name: &'static str,
        /// What it must be, and what it is.
        needed: String,
    },
    /// The algebra has no coordinates, or too many.
    #[error("a system has 1 to {most} coordinates, not {count}")]
    Dimension {
        /// The number of coordinates.
        count: usize,
        /// The largest number of coordinates.
        most: usize,
    },
    /// A name cannot be that of a coordinate.
    #[error("coordinates: {0}")]
    Coordinates(NameError),
    /// A parameter has the same name as a coordinate.
    #[error("parameters: {0}")]
    Parameters(NameError),
    /// The key of a bracket is not a pair of coordinates.
    #[error("brackets: `{key}` is not a pair of coordinates such as \"x, y\"")]
    NoPair {
        /// The key that is not a pair of coordinates.
        key: String,
    },
    /// The text of a bracket is not a formula.
    #[error("brackets.{key}: {problem}")]
    Bracket {
        /// The pair of coordinates.
        key: String,
        /// What is wrong, and where in the text.
        problem: FormulaError,
    },
    /// A bracket is not a linear combination of the coordinates.
    #[error("brackets.{key}: a bracket is a sum of multiples of coordinates, such as 2*x - y")]
    NotLinear {
        /// The pair of coordinates.
        key: String,
    },
    /// The Jacobi identity fails: the cyclic sum of [x, [y, z]] is not zero.
    #[error(
        "the Jacobi identity fails for {} by {residual:e} of the size of its terms (allowed {allowed:e})",
        names.join(", ")
    )]
    Jacobi {
        /// The names of the three coordinates.
        names: [String; 3],
        /// The largest coordinate of the sum, relative to the size of its terms.
        residual: f64,
        /// The relative rounding error that is allowed.
        allowed: f64,
    },
    /// The brackets contradict each other.
    #[error("brackets, numbered from 0 in the order of their keys: {0}")]
    Brackets(EntryError),
    /// The structure constants contradict each other, or have too large an index.
    #[error("structure constants: {0}")]
    Structure(EntryError),
    /// The text of the Hamiltonian is not a formula.
    #[error("hamiltonian: {0}")]
    Hamiltonian(FormulaError),
    /// The Casimirs cannot be searched for.
    #[error("brackets: {0}")]
    Casimirs(CasimirError),
    /// A coordinate of a state has no value.
    #[error("initial has no value for {names}")]
    NoValue {
        /// The names of the coordinates, separated by commas.
        names: String,
    },
    /// A value of a state is given for a name that no coordinate has.
    #[error("initial.{name} is not a coordinate; there are {names}")]
    NoCoordinate {
        /// The name that no coordinate has.
        name: String,
        /// The names of all coordinates, separated by commas.
        names: String,
    },
    /// The value of a coordinate has the wrong number of components, or is not finite.
    #[error("initial.{name} needs {needed}")]
    WrongValue {
        /// The name of the coordinate or of the vector of coordinates.
        name: String,
        /// The kind of value that the coordinate needs, as text.
        needed: String,
    },
    /// A coordinate has two values: one of its own, and one in its vector.
    #[error("initial.{name} gives a value again that {other} gives")]
    SecondValue {
        /// The name by which a value is given again.
        name: String,
        /// The name by which it was given before.
        other: String,
    },
    /// A state has fewer or more numbers than the algebra has dimensions.
    #[error("the initial state has {found} numbers; the dimension is {expected}")]
    StateLength {
        /// The dimension of the algebra.
        expected: usize,
        /// The number of numbers in the state.
        found: usize,
    },
    /// A formula has no finite value, or no finite derivative, at a state.
    #[error(transparent)]
    NoFiniteValue(#[from] ValueError),
    /// The text of the surface of a section is not a formula.
    #[error("surface: {0}")]
    Surface(FormulaError),
    /// The text of an axis of a section is not a formula.
    #[error("axes: {problem}")]
    Axis {
        /// The number of the axis, 0 or 1.
        axis: usize,
        /// What is wrong, and where in the text.
        problem: FormulaError,
    },
    /// A section needs two axes besides its surface.
    #[error("a section of {dimension} coordinates has no two axes")]
    NoAxes {
        /// The dimension of the algebra.
        dimension: usize,
    },
    /// The level of a surface, or of a conserved quantity, is infinite or not a number.
    #[error("the level must be a finite number, got {value:?}")]
    Level {
        /// The level that is infinite or not a number.
        value: f64,
    },
    /// The Casimirs of a section have other levels than at the state, and do not determine an orbit.
    #[error(
        "the levels of the Casimirs are not those of the state, and determine no orbit, since {}",
        match missing {
            Some(0) => "no state near it has them".to_owned(),
            Some(missing) => format!("{missing} independent Casimirs are no polynomials that were found"),
            None => "the Casimirs have not been searched for".to_owned(),
        }
    )]
    UnknownOrbit {
        /// The number of independent Casimirs that were not found, or `None` if there was no search.
        missing: Option<usize>,
    },
    /// Too few states of a section were found.
    #[error(
        "of {guesses} guesses {found} lead to a state of the section, {count} are needed: is there a state with these \
         invariants on the surface?"
    )]
    TooSmall {
        /// The number of states asked for.
        count: usize,
        /// The number of states found.
        found: usize,
        /// The number of guesses.
        guesses: usize,
    },
    /// The formulation does not exist for the algebra, or not with the scheme.
    #[error("{algebra} has no {formulation} {scheme}; {has}")]
    NoMethod {
        /// The name of the algebra.
        algebra: String,
        /// The requested formulation.
        formulation: Formulation,
        /// The requested scheme.
        scheme: SchemeName,
        /// The formulations or the schemes that the algebra has.
        has: String,
    },
    /// The tolerance is negative or not finite, or the scheme could not be made.
    #[error(transparent)]
    Method(#[from] MethodError),
    /// The Clebsch map of the algebra has no lift.
    #[error(transparent)]
    Lift(#[from] LiftError),
}

impl From<NameError> for FormulaSystemError {
    fn from(error: NameError) -> Self {
        Self::Coordinates(error)
    }
}

impl From<CasimirError> for FormulaSystemError {
    fn from(error: CasimirError) -> Self {
        Self::Casimirs(error)
    }
}
