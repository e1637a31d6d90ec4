//! Collective heavy top dynamics: the system of T. Ohsawa, *Collective Heavy Top Dynamics*,
//! SIGMA 15 (2019) 083.
//!
//! By subject, each row building on those above it:
//!
//! | object | item |
//! |---|---|
//! | SU(2) ⋉ C² acting on C², and L, derived from it | [`SpinorMotions`], [`SpinorMomentum`] |
//! | ϖ, by the Hopf map | [`Varpi`] |
//! | M = ϖ∘L: T∗C² → se(3)∗, its lifts and fibres | [`SpinorRealisation`] |
//! | the heavy top: general, free, Lagrange, Kovalevskaya, Goryachev–Chaplygin | [`HeavyTop`], [`Body`], [`RigidBody`] |
//! | h, f₁, f₂, f₃, K, G | [`Invariant`] |
//! | collective Gauss methods of one top, in the registers of the processor | [`CollectiveGauss`] |
//! | the rotation of the body in a step | [`Turning`], [`TurningFlows`] |
//! | splittings of tops into exact rotations and kicks | [`RotorSplitting`], [`SymmetricTopSplitting`] |
//! | many tops at once: symmetric ones by splitting, any by Gauss methods | [`SymmetricTopBatch`], [`GaussBatch`] |
//! | the midpoint rule on se(3)∗ in closed form: of a top, of any Hamiltonian | [`TopMidpoint`], [`ReducedMidpoint`] |
//! | the same for many tops at once | [`TopMidpoint`], [`MidpointBatch`] |
//! | these on all threads | [`Ensemble`](collective_integrators::Ensemble) of any of them |
//! | the attitude, in every formulation that has one | [`WithAttitude`] |
//! | Poincaré sections: the energy level, the surface, the starts, the returns | [`EnergyLevel`], [`Coordinate`], [`Surface`], [`Section`] |
//! | nutation of any top: amplitude, rotation number | [`Nutation`] |
//! | closed forms: Euler's and Lagrange's tops | [`EulerSolution`], [`LagrangeNutation`], [`JacobiElliptic`], [`jacobi_elliptic`] |
//!
//! # Which integrator
//!
//! | to integrate | take |
//! |---|---|
//! | one [`HeavyTop`], accurately | [`HeavyTop::gauss`]: a [`CollectiveGauss`] with up to 8 stages |
//! | one [`HeavyTop`], by the midpoint rule | [`HeavyTop::midpoint`]: a [`TopMidpoint`] |
//! | many states of one top | an [`Ensemble`](collective_integrators::Ensemble) of the [`TopMidpoint`] |
//! | many tops, with separate parameters per top | an [`Ensemble`](collective_integrators::Ensemble) of a [`GaussBatch`] or a [`MidpointBatch`]; of symmetric tops, a [`SymmetricTopBatch`] |
//! | any other Hamiltonian h(Π, Γ) | [`Collective`](collective_integrators::Collective) with [`RungeKutta::gauss`](collective_integrators::RungeKutta::gauss) and [`SpinorRealisation`], or [`ReducedMidpoint`] |
//! | many states of that | [`Laned`](collective_integrators::Laned) of the [`ReducedMidpoint`] |
//! | the attitude along one trajectory | [`WithAttitude`] of its integrator |
//! | tangent vectors, Lyapunov exponents | [`ReducedMidpoint`] or [`Collective`](collective_integrators::Collective), which work over dual numbers |
//!
//! The usual names of these and of the lower crates are in the [`prelude`]. The lower crates, [`nalgebra`] and
//! [`num_complex`] are re-exported. Gyrostats, bodies in a fluid, point vortices and spins are in the crate
//! `lie-poisson-systems`.
//!
//! # Example
//! The paper's experiment, over 200 steps:
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

mod error;
mod tops;
mod paper;
mod attitude;
mod splittings;
mod kernels;
mod closed_forms;
mod analysis;
pub mod prelude;

pub use analysis::nutation::Nutation;
pub use analysis::section::{Section, Surface};
pub use analysis::section_error::SectionError;
pub use attitude::step_rotation::{TurnedStep, Turning, TurningFlows};
pub use attitude::with_attitude::{WithAttitude, attitude_of_vertical};
pub use closed_forms::elliptic::{JacobiElliptic, jacobi_elliptic};
pub use closed_forms::euler_top::EulerSolution;
pub use closed_forms::lagrange_nutation::LagrangeNutation;
pub use error::{TopError, UNIT_TOLERANCE, require_unit};
pub use kernels::gauss_many::gauss_batch::GaussBatch;
pub use kernels::gauss_one::collective_gauss::{CollectiveGauss, CollectiveGaussSpace};
pub use kernels::midpoint::midpoint_batch::MidpointBatch;
pub use kernels::midpoint::reduced_midpoint::{ReducedMidpoint, ReducedMidpointSpace};
pub use kernels::midpoint::top_midpoint::{TopMidpoint, TopMidpointSpace};
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
pub use tops::rigid_body::RigidBody;
pub use tops::top::{Body, HeavyTop, HeavyTopSpace};

pub use collective_integrators;
pub use lie_poisson;
pub use momentum_map;
pub use nalgebra;
pub use num_complex;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
