//! Scalar types and vector spaces for formulas that are written once: `f64`, dual numbers for exact
//! derivatives, and SIMD lanes (several numbers in one register).
//!
//! ```toml
//! [dependencies]
//! generic-scalars = "0.1"
//! ```
//!
//! A function over [`Real`] computes a value over `f64`, a derivative over [`DualNumber`], and several
//! values at once over [`Lanes`]:
//!
//! ```
//! use generic_scalars::{DefaultLanes, DualNumber, Lanes, Real};
//! fn cube<T: Real>(x: T) -> T {
//!     x * x * x
//! }
//! assert_eq!(cube(2.0), 8.0);
//! assert_eq!(cube(DualNumber::variable(2.0)).derivative(), 12.0);
//! assert_eq!(cube(DefaultLanes::load(&[1.0, 2.0, 3.0, 4.0])).lane(2), 27.0);
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a formula over every scalar | [`Real`] as the bound of its type parameter |
//! | a branch in such a formula | [`Real::at_most`], which returns a [`Mask`], then [`Real::select`] |
//! | exp, sin, cos, tanh and integer powers in such a formula | the methods of [`Real`]; a function of the value alone loses the derivative |
//! | an exact derivative with respect to one variable | [`DualNumber`] |
//! | the differential of a function of a vector | [`differential`] |
//! | the transposed tangent map of a map between vector spaces | [`transposed_tangent`] |
//! | a derivative along one direction | [`seed`], then [`derivative_part`] |
//! | exponentials of rotations without a small-angle branch | the Stumpff functions [`Real::stumpff`] |
//! | linear equations over any scalar | [`solve_linear`] |
//! | a constant matrix times a vector over any scalar | [`constant_times`], [`constant_transpose_times`] |
//! | several trajectories at once | [`DefaultLanes`], four SIMD lanes on every processor |
//! | the widest SIMD lanes of the processor | a [`LaneTask`], run by [`dispatch`] |
//! | results bit-identical to `f64` in every lane, whatever the processor | a [`TaskOver`] the lanes that [`dispatch_unfused`] chooses |
//! | the instruction set of the processor | [`InstructionSet::detected`] |
//! | one vector of R³ in one register | [`FourLanes`] in a [`FourLanesTask`], run by [`dispatch_four`] |
//! | a structure of your own, of vectors, as a vector | [`state_of_parts!`], [`vector_operators!`] and an implementation of [`Vector`] |
//! | a large type of your own, on the heap | an implementation of [`State`] |
//! | N copies of a small space, with N known at run time | [`Sites`] |
//! | elements of the dual space, as a separate type | [`Covector`] |
//! | dot and cross products of vectors over any scalar | [`dot`], [`cross`] |
//! | direct sums V ⊕ W and powers Vᴺ | [`Pair`] and [`Power`] |
//! | quaternions over any scalar | [`Quaternion`] |
//! | a vector space whose points exist over every scalar | [`VectorSpace`]: [`RealSpace`], [`ComplexSpace`] |
//! | a vector with its coordinates converted to another scalar | [`map_coordinates`] |
//! | norms that neither overflow nor underflow | [`euclidean_norm`] and [`squaring_scale`] |
//! | a factor whose products are exact | [`nearest_power_of_two`] |
//! | norms of vectors whose blocks have different units | [`BlockScales`] |
//! | a maximum that keeps NaN | [`larger`], [`Real::larger`] |
//!
//! # Conventions
//!
//! * The pairing of a covector with a vector is ⟨α, v⟩ = Σ αᵢ vᵢ, without a sign or a factor.
//! * Complex coordinates alternate between real and imaginary parts: χ = (q₁+iq₂, q₃+iq₄).
//! * Quaternions follow Hamilton: ij = k, with the coordinates (s, v₁, v₂, v₃).
//! * Matrices are stored by columns.
//! * Each operation on SIMD lanes is bit-identical in each lane to the operation on `f64`, except for fused
//!   multiply-add: see [`Lanes`].
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The feature `serde` serialises quaternions, pairs, covectors and sites. SIMD instructions are detected when the
//! program runs. The oldest supported compiler is Rust 1.89.
//!
//! # Related crates
//!
//! `lie-poisson` builds Lie algebras and Poisson brackets on this crate and re-exports its items.
//! `momentum-map` adds momentum maps, `collective-integrators` adds time steps, and `heavytop` adds heavy
//! tops. [`nalgebra`], [`num_complex`] and [`num_traits`] appear in the public interface and are
//! re-exported.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod numbers;
mod lanes;
mod spaces;
mod calculus;

pub use lanes::{
    DefaultLanes, FourLanes, FourLanesTask, InstructionSet, LaneTask, Lanes, MissingInstructions,
    StorageOver, TaskOver, UnfusedStorage, UnfusedTask, UnfusedWorkspace, Width, dispatch,
    dispatch_four, dispatch_unfused,
};
pub use numbers::blocks::Blocks;
pub use numbers::dual_number::DualNumber;
pub use numbers::linear_solve::solve_linear;
pub use numbers::mask::Mask;
pub use numbers::power_of_two::nearest_power_of_two;
pub use numbers::real::{Real, larger};

pub use calculus::block_scales::BlockScales;
pub use calculus::derivative::{derivative_part, differential, seed, transposed_tangent};
pub use calculus::norm::{euclidean_norm, squaring_scale};

pub use spaces::covector::Covector;
pub use spaces::matrices::{constant_times, constant_transpose_times, cross, dot};
pub use spaces::pair::Pair;
pub use spaces::power::Power;
pub use spaces::quaternion::Quaternion;
pub use spaces::sites::Sites;
pub use spaces::space::{ComplexSpace, Differential, Point, RealSpace, VectorSpace};
pub use spaces::state::State;
pub use spaces::vector::{Vector, map_coordinates};

pub use nalgebra;
pub use num_complex;
pub use num_traits;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
