//! Heavy tops by collective Lie–Poisson integrators, after T. Ohsawa, *Collective Heavy Top Dynamics*, SIGMA
//! 15 (2019) 083, with their invariants, attitude, Poincaré sections and closed-form solutions.
//!
//! ```toml
//! [dependencies]
//! heavytop = "0.1"
//! ```
//!
//! This is the paper's experiment, over 200 steps. The collective midpoint rule conserves the two Casimirs |Γ|² and Π·Γ
//! to round-off, and the energy to 1e-3.
//!
//! ```
//! use heavytop::prelude::*;
//!
//! let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
//! let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
//! let midpoint = Collective::new(RungeKutta::implicit_midpoint(), SpinorRealisation, top);
//! for sample in midpoint.trajectory(&start, 0.02)?.take(200) {
//!     let mu = sample?.momentum;
//!     let deviation = |i: Invariant| (i.value(&top, &mu) - i.value(&top, &start)).abs();
//!     assert!(deviation(Invariant::Energy) < 1e-3);
//!     assert!(deviation(Invariant::VerticalSquared) < 1e-13);
//!     assert!(deviation(Invariant::VerticalMomentum) < 1e-13);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a top from its parameters, or one of the integrable tops | [`HeavyTop`], with [`Body`] |
//! | the free rigid body on so(3)∗ | [`RigidBody`] |
//! | the conserved quantities h, f₁, f₂, f₃, K, G and C | [`Invariant`] |
//! | one top, accurately | [`HeavyTop::gauss`], which makes a [`CollectiveGauss`] with up to 8 stages |
//! | one top, by the midpoint rule | [`HeavyTop::midpoint`], which makes a [`TopMidpoint`] |
//! | another Hamiltonian h(Π, Γ), with any scheme | [`SpinorRealisation`] in a [`Collective`](collective_integrators::Collective) |
//! | another Hamiltonian h(Π, Γ), by the midpoint rule | [`ReducedMidpoint`] |
//! | an explicit method | [`RotorSplitting`]; [`SymmetricTopSplitting`] if I₁ = I₂ |
//! | many states of one top | an [`Ensemble`](collective_integrators::Ensemble) of the [`TopMidpoint`] |
//! | many states, another Hamiltonian | [`Laned`](collective_integrators::Laned) with the [`ReducedMidpoint`] |
//! | many tops, with separate parameters per top | an [`Ensemble`](collective_integrators::Ensemble) of a [`GaussBatch`] or a [`MidpointBatch`] |
//! | many symmetric tops, with separate parameters per top | an [`Ensemble`](collective_integrators::Ensemble) of a [`SymmetricTopBatch`] |
//! | the attitude of the body along one trajectory | [`WithAttitude`], around an integrator that is [`Turning`] |
//! | tangent vectors and Lyapunov exponents | [`ReducedMidpoint`] or [`Collective`](collective_integrators::Collective), which work over dual numbers |
//! | a Poincaré section: its energy level, surface, starts and returns | [`EnergyLevel`], [`Surface`], [`Section`] |
//! | one of the six coordinates of (Π, Γ) | [`Coordinate`] |
//! | what a surface fixes: a coordinate, or the angle of Γ about an axis | [`SurfaceVariable`] |
//! | the nutation of any top: amplitude and rotation number | [`Nutation`] |
//! | an integrator by the names of a formulation and a scheme | [`Method`](methods::Method), of the module [`methods`] |
//! | the motion in closed form | [`EulerSolution`], [`LagrangeNutation`] |
//! | Jacobi's elliptic functions | [`JacobiElliptic`], [`jacobi_elliptic`] |
//! | the paper's maps L, ϖ and M = ϖ∘L | [`SpinorMomentum`], [`Varpi`], [`SpinorRealisation`] |
//! | the paper's action of SU(2) ⋉ C² on C² | [`SpinorMotions`], [`SPINOR_MOTIONS`] |
//! | the reason why parameters are rejected | [`TopError`], [`SectionError`] |
//! | the usual names in one line | [`prelude`] |
//!
//! # Conventions
//!
//! * The state is (Π, Γ) ∈ se(3)∗ in the body frame, with the minus bracket: [`HeavyTopSpace`].
//! * Π is the angular momentum, and Γ = R⁻¹e₃ is the upward vertical seen from the body.
//! * The equations of motion are dΠ/dt = Π × Ω + m g l Γ × c and dΓ/dt = Γ × Ω.
//! * The attitude R maps the body frame to the spatial frame.
//! * Parameters are in SI units, and angles in radians.
//! * The signs on 𝔤∗ are those of [`lie_poisson`], and the sides of actions are those of [`momentum_map`].
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The feature `serde` serialises states, samples and tops; a top is checked when it is read. The SIMD lanes of the
//! processor (several trajectories in one register) are detected at run time. The oldest supported compiler is Rust 1.89.
//!
//! # Related crates
//!
//! [`lie_poisson`] holds Lie algebras and Hamiltonians, [`momentum_map`] the Poisson maps, and
//! [`collective_integrators`] the integrators, trajectories and diagnostics. These, [`nalgebra`] and
//! [`num_complex`] appear in the public interface and are re-exported. The crate `lie-poisson-systems` holds
//! gyrostats, bodies in a fluid, point vortices and spins, and `heavytop-cli` the program `heavytop`.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod error;
mod tops;
mod paper;
mod attitude;
mod splittings;
mod kernels;
mod closed_forms;
mod analysis;
pub mod methods;
pub mod prelude;

pub use analysis::nutation::Nutation;
pub use analysis::section::Section;
pub use analysis::section_error::SectionError;
pub use analysis::surface::{Surface, SurfaceVariable};
pub use attitude::euler_angles::EulerAngles;
pub use attitude::step_rotation::{TurnedStep, Turning, TurningFlows};
pub use attitude::with_attitude::{WithAttitude, attitude_of_vertical};
pub use closed_forms::elliptic::{JacobiElliptic, jacobi_elliptic};
pub use closed_forms::euler_top::EulerSolution;
pub use closed_forms::lagrange_nutation::LagrangeNutation;
pub use error::{TopError, UNIT_TOLERANCE, require_unit};
pub use kernels::gauss_many::gauss_batch::GaussBatch;
pub use kernels::gauss_one::collective_gauss::{CollectiveGauss, CollectiveGaussWorkspace};
pub use kernels::midpoint::midpoint_batch::MidpointBatch;
pub use kernels::midpoint::reduced_midpoint::{ReducedMidpoint, ReducedMidpointWorkspace};
pub use kernels::midpoint::top_midpoint::{TopMidpoint, TopMidpointWorkspace};
pub use kernels::symmetric::symmetric_batch::SymmetricTopBatch;
pub use paper::spinor_motions::{
    SPINOR_MOTIONS, SpinorAlgebra, SpinorGroup, SpinorMomentum, SpinorMotions,
};
pub use paper::spinor_realisation::{SpinorPoint, SpinorRealisation};
pub use paper::varpi::Varpi;
pub use splittings::rotors::RotorSplitting;
pub use splittings::symmetric_top::SymmetricTopSplitting;
pub use tops::coordinate::Coordinate;
pub use tops::energy_level::EnergyLevel;
pub use tops::invariants::Invariant;
pub use tops::parallel_axis::{point_inertia, require_possible_body};
pub use tops::principal_axes::PrincipalAxes;
pub use tops::rigid_body::RigidBody;
pub use tops::top::{Body, HeavyTop, HeavyTopSpace};

pub use collective_integrators;
pub use lie_poisson;
pub use momentum_map;
pub use nalgebra;
pub use num_complex;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
