//! Scalars and vector spaces over which a formula is written once: numbers, dual numbers, SIMD lanes (several numbers in
//! one register), vectors of them and their duals.
//!
//! ```toml
//! [dependencies]
//! generic-scalars = "0.1"
//! ```
//!
//! A function over [`Real`] computes a value over `f64`, a derivative over [`DualNumber`], and several values at once
//! over [`Lanes`]:
//!
//! ```
//! use generic_scalars::{DefaultLanes, DualNumber, Lanes, Real};
//! fn cube<T: Real>(x: T) -> T {
//!     x * x * x
//! }
//! assert_eq!(cube(2.0), 8.0);
//! assert_eq!(cube(DualNumber::variable(2.0)).derivative, 12.0);
//! assert_eq!(cube(DefaultLanes::load(&[1.0, 2.0, 3.0, 4.0])).lane(2), 27.0);
//! ```
//!
//! | when you need | take |
//! |---|---|
//! | a formula over every scalar | [`Real`]; branches by [`Mask`] |
//! | exact derivatives | [`DualNumber`] |
//! | exponentials of rotations without a small-angle branch | the Stumpff functions [`Real::stumpff`] |
//! | linear equations, lane by lane | [`solve_linear`] |
//! | several trajectories in one register | [`Lanes`]: [`DefaultLanes`], or as wide as the processor's by [`dispatch`] and [`LaneTask`] |
//! | a vector of R³ in one register | [`FourLanes`], by [`dispatch_four`] |
//! | vectors, covectors, pairs and powers of them | [`Vector`], [`Covector`], [`Pair`], [`Power`], [`Quaternion`] |
//! | spaces over every scalar at once | [`VectorSpace`]: [`RealSpace`], [`ComplexSpace`] |
//! | derivatives of maps between them | [`differential`], [`transposed_tangent`], [`seed`] |
//! | norms over the whole range of numbers | [`euclidean_norm`], [`squaring_scale`] |
//!
//! `lie-poisson` builds Lie algebras and Poisson brackets on these, and re-exports them.

mod numbers;
mod lanes;
mod spaces;

pub use lanes::{
    DefaultLanes, FourLanes, FourLanesTask, InstructionSet, LaneTask, Lanes, MissingInstructions,
    Width, dispatch, dispatch_four,
};
pub use numbers::dual_number::DualNumber;
pub use numbers::linear_solve::solve_linear;
pub use numbers::mask::Mask;
pub use numbers::real::{Real, larger};

pub use spaces::blocks::Blocks;
pub use spaces::covector::Covector;
pub use spaces::derivative::{derivative_part, differential, seed, transposed_tangent};
pub use spaces::norm::{euclidean_norm, squaring_scale};
pub use spaces::pair::Pair;
pub use spaces::power::Power;
pub use spaces::quaternion::Quaternion;
pub use spaces::space::{ComplexSpace, Differential, Point, RealSpace, VectorSpace};
pub use spaces::vector::{Vector, map_coordinates};

pub use nalgebra;
pub use num_complex;
pub use num_traits;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
