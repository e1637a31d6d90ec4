//! Lie algebras, Lie groups, Lie–Poisson brackets and Hamiltonians, over `f64`, dual numbers and SIMD lanes
//! (several trajectories in one register).
//!
//! ```toml
//! [dependencies]
//! lie-poisson = "0.1"
//! ```
//!
//! The free rigid body: an energy on so(3)∗ is written once, differentiated exactly, and gives Euler's
//! equations.
//!
//! ```
//! use lie_poisson::{Covector, Hamiltonian, LiePoisson, PoissonSpace, So3, from_closure};
//! use nalgebra::Vector3;
//!
//! // h(Π) = ½ (Π₁²/1 + Π₂²/2 + Π₃²/4), with the moments of inertia 1, 2 and 4
//! let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| {
//!     (pi.x * pi.x + pi.y * pi.y / 2.0 + pi.z * pi.z / 4.0) * 0.5
//! });
//! let pi = Covector(Vector3::new(1.0, 2.0, 4.0));
//! let omega = h.differential(&pi); // the angular velocity Ω = dh(Π)
//! let rate = LiePoisson::minus(So3).hamiltonian_vector(&pi, &omega);
//! assert_eq!(rate, Covector(pi.0.cross(&omega))); // dΠ/dt = Π × Ω
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a formula over every scalar | [`Real`] as the bound of its type parameter |
//! | an element of 𝔤∗, a momentum | [`Covector`]; [`Se3Dual`] for se(3)∗ |
//! | rotations of space: so(3) and SO(3) | [`So3`] and [`SO3`] |
//! | motions of space or of the plane | [`Se3`] and [`SE3`], [`Se2`] and [`SE2`] |
//! | spinors: su(2) and SU(2), unit quaternions | [`Su2`] and [`SU2`], [`SP1`] |
//! | another matrix group | [`SO2`], [`SL2`], [`UnitaryGroup`]; [`RealSpace`] for translations |
//! | an algebra or a group of your own | [`LieAlgebra`], [`LieGroup`] |
//! | an algebra from a table of structure constants | [`StructureConstants`] |
//! | direct products and powers | [`ProductAlgebra`], [`ProductGroup`], [`PowerAlgebra`], [`PowerGroup`] |
//! | semidirect products 𝔤 ⋉ V and G ⋉ V | [`SemidirectAlgebra`], [`SemidirectGroup`] |
//! | a representation of your own | [`Representation`], [`GroupRepresentation`] |
//! | a representation made from others | [`Adjoint`], [`Inherited`], [`Diagonal`], [`Sum`], [`Contragredient`] |
//! | the adjoint representation of an algebra without a group | [`InfinitesimalAdjoint`] |
//! | a derivation, or an extension of the adjoint representation on which the centre can act | [`Cocycle`], [`ExtendedAdjoint`], [`ExtendedCoadjoint`] |
//! | a test whether Runge–Kutta steps on T∗V descend to 𝔤∗ | [`odd_power_defect`] |
//! | 𝔤∗ with a Lie–Poisson bracket | [`LiePoisson::minus`], [`LiePoisson::plus`] |
//! | a Poisson space of your own | [`PoissonSpace`] |
//! | products and powers of Poisson spaces | [`ProductSpace`], [`PowerSpace`] |
//! | functions that every Hamiltonian flow conserves | [`Casimirs`] |
//! | a Hamiltonian from one formula, for `f64` | [`from_closure`] |
//! | a Hamiltonian from one formula, for every scalar | [`Energy`], wrapped in [`Automatic`] |
//! | a Hamiltonian with an explicit formula for its differential | [`Hamiltonian`], [`from_closures`] |
//! | a Hamiltonian that depends on time | [`TimeDependent`] of a Hamiltonian on [`InTime<P>`](InTime) |
//! | any field ξ(μ, t) whose motion stays on coadjoint orbits, such as a control | [`OrbitField`] |
//! | an input u(t) by a table of times and values | [`InputTable`], with an [`Interpolation`] |
//! | a control law added to a field; inputs along fixed elements of 𝔤 | [`Controlled`], [`Inputs`] |
//! | damping of spins without a unit | [`GilbertDamping`] |
//! | dissipation on coadjoint orbits | [`DoubleBracket`], with an [`InnerProduct`] |
//! | maps from 𝔤 to G other than exp | [`Cayley`] |
//! | tests of your own types against the axioms | the module `laws` (feature `laws`) |
//!
//! The scalars, vectors and derivatives of [`generic_scalars`] are re-exported here.
//!
//! # Conventions
//!
//! * The coadjoint operator is defined without a sign: ⟨`ad*_ξ μ`, η⟩ = ⟨μ, [ξ, η]⟩.
//! * The coadjoint action is defined without an inverse: ⟨`Ad*_g μ`, ξ⟩ = ⟨μ, `Ad_g ξ`⟩. It is a right action.
//! * The Lie–Poisson brackets are {f, h}±(μ) = ±⟨μ, [df, dh]⟩. The minus sign belongs to the body frame.
//! * The equation of motion is dμ/dt = +`ad*_ξ μ` for the minus bracket and −`ad*_ξ μ` for the plus bracket, where
//!   ξ = dh(μ).
//! * Semidirect products are (g, v)(h, w) = (gh, gw + v) and [(ξ, φ), (η, ζ)] = ([ξ, η], ξζ − ηφ).
//! * 𝔤 and 𝔤∗ are different types: a momentum is a [`Covector`]. Angles are in radians.
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The feature `laws` adds the module `laws`, which returns the residuals of the axioms. The feature `serde`
//! serialises signs, pairs, covectors, quaternions and sites. The oldest supported compiler is Rust 1.89.
//!
//! # Related crates
//!
//! `generic-scalars` holds the scalars and vector spaces. `momentum-map` adds group actions and momentum
//! maps, `collective-integrators` adds time steps, and `heavytop` adds heavy tops. [`nalgebra`],
//! [`num_complex`] and [`num_traits`] appear in the public interface and are re-exported.

#![cfg_attr(docsrs, feature(doc_cfg))]

mod algebras;
mod groups;
mod representations;
mod cayley;
mod brackets;
mod orbits;
mod dissipation;

#[cfg(feature = "laws")]
pub mod laws;

pub use generic_scalars::{
    BlockScales, Blocks, ComplexSpace, Covector, DefaultLanes, Differential, DualNumber, FourLanes,
    FourLanesTask, InstructionSet, LaneTask, Lanes, Mask, MissingInstructions, Pair, Point, Power,
    Quaternion, Real, RealSpace, Sites, State, StorageOver, TaskOver, UnfusedStorage, UnfusedTask,
    UnfusedWorkspace, Vector, VectorSpace, Width, constant_times, constant_transpose_times, cross,
    derivative_part, differential, dispatch, dispatch_four, dispatch_unfused, dot, euclidean_norm,
    larger, map_coordinates, nearest_power_of_two, seed, solve_linear, squaring_scale,
    state_of_parts, transposed_tangent, vector_operators,
};

pub use algebras::algebra::{LieAlgebra, Momentum};
pub use algebras::group::{AlgebraElement, GroupMomentum, LieGroup};
pub use algebras::product::{PowerAlgebra, PowerGroup, ProductAlgebra, ProductGroup};
pub use algebras::structure_constants::StructureConstants;
pub use algebras::structure_table::{StructureEntry, StructureError, StructureTable};
pub use groups::sl2::{SL2, Sl2};
pub use groups::so2::{SO2, So2};
pub use groups::so3::{SO3, So3};
pub use groups::su2::{SU2, Su2};
pub use groups::unitary::{SkewHermitian, UnitaryAlgebra, UnitaryGroup};

pub use cayley::Cayley;
pub use representations::cocycle::{Cocycle, CocycleError};
pub use representations::derived::{
    Adjoint, CocycleExtension, Contragredient, Diagonal, ExtendedAdjoint, ExtendedCoadjoint,
    InfinitesimalAdjoint, Inherited, Sum,
};
pub use representations::euclidean::{SE2, SE3, Se2, Se3, Se3Dual};
pub use representations::odd_powers::{odd_power_defect, odd_power_defect_of};
pub use representations::real_matrices::{SL2OnR2, SO2OnR2, SO3OnR3};
pub use representations::representation::{
    GroupRepresentation, Representation, RepresentedElement,
};
pub use representations::semidirect::{SemidirectAlgebra, SemidirectGroup};
pub use representations::sp1::{QuaternionSpace, SP1, SP1OnQuaternions};
pub use representations::unitary_matrices::{SU2OnC2, UnitaryOnComplexSpace};

pub use brackets::casimirs::Casimirs;
pub use brackets::hamiltonian::{
    Automatic, Closure, Closures, Energy, Hamiltonian, from_closure, from_closures,
    hessian_by_dual_numbers,
};
pub use brackets::poisson::{LiePoisson, PoissonSpace, Sign};
pub use brackets::product_space::{PowerSpace, ProductSpace, from_parts, parts};
pub use brackets::sites_hamiltonian::SitesHamiltonian;
pub use dissipation::dissipation_error::DissipationError;
pub use dissipation::double_bracket::DoubleBracket;
pub use dissipation::gilbert_damping::{
    GilbertDamping, GilbertDampingError, SpaceOfSpins, gilbert_element,
};
pub use dissipation::noise::{IsotropicNoise, Noise, thermal_strength};
pub use orbits::breakpoints::{BreakpointError, WithBreakpoints, nearest_break};
pub use orbits::control::{Controlled, Inputs, InputsError};
pub use orbits::inner_product::{InnerProduct, InnerProductError};
pub use orbits::input_table::{InputTable, InputTableError};
pub use orbits::interpolation::{Interpolation, UnknownInterpolation};
pub use orbits::orbit_field::{Autonomous, OrbitField, TimeDependent};
pub use orbits::path_axis::{PathAxis, PathNumber};
pub use orbits::time_axis::{InTime, Time, TimeAxis};

pub use generic_scalars;
pub use nalgebra;
pub use num_complex;
pub use num_traits;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
