//! Errors of sweeps: why a configuration describes no sweep.

use thiserror::Error;

/// The reason why a configuration describes no sweep.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The sweep has no axes.
    #[error("axes must have at least one axis")]
    NoAxes,
    /// The sweep has no observables.
    #[error("observables must name at least one")]
    NoObservables,
    /// An observable is named twice.
    #[error("observables must not name one twice")]
    Twice,
    /// An axis does not say how its values are chosen.
    #[error("the axis {parameter} needs {needs}")]
    Axis {
        /// The parameter of the axis.
        parameter: String,
        /// The keys that the axis needs, and those that it has.
        needs: String,
    },
    /// An axis of a top is asked of a system, or one of a system of a top.
    #[error("the axis {parameter} is of {of}, and there is none here: {has}")]
    OfAnother {
        /// The parameter of the axis.
        parameter: String,
        /// What has the parameter.
        of: &'static str,
        /// The parameters that can be varied here.
        has: String,
    },
    /// An observable of tops is asked of a system.
    #[error("the observable {observable} is of a top; a system has {}", has.join(", "))]
    OfTops {
        /// The name of the observable.
        observable: &'static str,
        /// The names of the observables of systems.
        has: Vec<&'static str>,
    },
    /// An observable of motions without forces is asked of one with forces.
    #[error(
        "the observable {observable} is of motions without forces; with [inputs], [drive], [damping], [noise], [torque] or t \
         in the Hamiltonian there are {}", has.join(", ")
    )]
    OfClosed {
        /// The name of the observable.
        observable: &'static str,
        /// The names of the observables of motions with forces.
        has: Vec<&'static str>,
    },
    /// An indicator of chaos is asked of a collective method whose steps do not descend to the dual of the algebra.
    #[error(
        "the observable {observable} has no meaning for the formulation {formulation} here: by the Clebsch map of this \
         algebra, tangent vectors depend on the lift"
    )]
    Lifted {
        /// The name of the observable.
        observable: &'static str,
        /// The name of the formulation.
        formulation: &'static str,
    },
    /// The table of a parameter does not have its name.
    #[error("there is no {parameter}; {has}")]
    NoParameter {
        /// The parameter of the axis.
        parameter: String,
        /// The parameters that there are, and that most like the one asked for.
        has: String,
    },
    /// A number of a vector is asked for without its index, or with too large a one.
    #[error(
        "the axis {parameter} needs an index from 0 to {most}{}",
        index.map_or_else(String::new, |index| format!(", got {index}"))
    )]
    Index {
        /// The parameter of the axis.
        parameter: String,
        /// The index, if there is one.
        index: Option<usize>,
        /// The largest index of the vector.
        most: usize,
    },
    /// A number that is no vector has an index.
    #[error("the axis {parameter} needs no index: it is one number, not a vector")]
    NoVector {
        /// The parameter of the axis.
        parameter: String,
    },
    /// Two columns of the table would have one name.
    #[error(
        "two columns would have the name {name}: rename the coordinate, or leave out final-state"
    )]
    SameColumn {
        /// The name that both columns would have.
        name: String,
    },
    /// The algebra of a member has another number of independent Casimirs than that of the configuration.
    #[error("it has {found} Casimirs, and the system with the configured parameters {expected}")]
    Casimirs {
        /// The number of independent Casimirs of the member, whether they are polynomials or not.
        found: usize,
        /// The number of independent Casimirs of the system with the configured parameters.
        expected: usize,
    },
    /// A member has another number of coordinates than the system of the configuration.
    #[error("it has {found} coordinates, and the system with the configured parameters {expected}")]
    OtherColumns {
        /// The number of coordinates of the member.
        found: usize,
        /// That of the system with the configured parameters.
        expected: usize,
    },
    /// The state is too large for columns of a table.
    #[error(
        "the observable final-state would have {found} columns; it has at most {most}: simulate writes the states of one run"
    )]
    WideState {
        /// The number of coordinates.
        found: usize,
        /// The largest number of columns.
        most: usize,
    },
    /// Two axes set the same number.
    #[error("the axes {first} and {second} set the same thing")]
    Clash {
        /// The parameter of the first axis.
        first: String,
        /// The parameter of the second axis.
        second: String,
    },
    /// An axis sets the angular momentum of a configuration that gives the angular velocity.
    #[error("the axis {axis} needs [initial] angular_momentum instead of angular_velocity")]
    Velocity {
        /// The parameter of the axis.
        axis: String,
    },
    /// An axis sets a component of the angular velocity of a configuration that does not give the others.
    #[error("the axis {axis} needs [initial] angular_velocity, of which it varies a component")]
    Momentum {
        /// The parameter of the axis.
        axis: String,
    },
    /// An axis varies a principal moment of a body whose moments are a matrix.
    #[error(
        "the axis {axis} is a principal moment, and [body] inertia is a matrix; write principal moments"
    )]
    Matrix {
        /// The parameter of the axis.
        axis: String,
    },
    /// An axis varies a factor of the weight moment, which is given as a product.
    #[error(
        "the axis {axis} is a factor of m g l, and [body] has weight_moment; write mass, gravity and length"
    )]
    Weight {
        /// The parameter of the axis.
        axis: String,
    },
    /// Some axes are grids, others are random.
    #[error("the axes must be all grids or all random")]
    Mixed,
    /// The axes are random and the number of runs is missing, or the axes are grids and it is given.
    #[error("count is needed where the axes are random, and only there; at least 1")]
    Count,
    /// There are too many runs.
    #[error("the sweep has {runs:e} runs, more than {most:e}")]
    TooMany {
        /// The number of runs.
        runs: f64,
        /// The largest number of runs allowed.
        most: f64,
    },
}
