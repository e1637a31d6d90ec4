//! Collective heavy top dynamics: the system of T. Ohsawa, *Collective Heavy Top Dynamics*,
//! SIGMA 15 (2019) 083.
//!
//! The modules in dependency order:
//!
//! | object | item |
//! |---|---|
//! | SU(2) ⋉ C² acting on C², and L, derived from it | [`SpinorMotions`], [`SpinorMomentum`] |
//! | ϖ, by the Hopf map | [`Varpi`] |
//! | M = ϖ∘L: T∗C² → se(3)∗, its lifts and fibres | [`SpinorRealisation`] |
//! | the heavy top: general, free, Lagrange, Kovalevskaya, Goryachev–Chaplygin | [`HeavyTop`], [`Body`], [`RigidBody`] |
//! | h, f₁, f₂, f₃, K, G | [`Invariant`] |
//! | collective Gauss methods of one top, by the registers of the processor | [`CollectiveGauss`] |
//! | the rotation of the body in a step | [`Turning`], [`TurningFlows`] |
//! | splittings of tops into exact rotations and kicks | [`RotorSplitting`], [`SymmetricTopSplitting`] |
//! | many tops at once: symmetric ones by splitting, any by Gauss methods | [`SymmetricTopEnsemble`], [`GaussEnsemble`] |
//! | the midpoint rule on se(3)∗ in closed form | [`ReducedMidpoint`] |
//! | the same for many tops at once | [`ReducedMidpoint`], [`MidpointSweep`] |
//! | these on all threads | [`Ensemble`](collective_integrators::Ensemble) of any of them |
//! | the attitude, in every formulation that has one | [`WithAttitude`] |
//! | other systems on se(3)∗: gyrostat, body in a fluid | [`Gyrostat`], [`Kirchhoff`] |
//! | systems on (so(3)∗)ᴺ: vortices, spins, spins on a lattice | [`PointVortices`], [`HeisenbergChain`], [`SpinLattice`] |
//! | Poincaré sections: the energy level, the surface, the starts, the returns | [`EnergyLevel`], [`Coordinate`], [`Surface`], [`Section`] |
//! | nutation of any top: amplitude, rotation number | [`Nutation`] |
//! | closed forms: Euler's and Lagrange's tops | [`EulerSolution`], [`LagrangeNutation`], [`JacobiElliptic`], [`jacobi_elliptic`] |
//!
//! # Example
//! The paper's experiment, over 200 steps:
//! ```
//! use collective_integrators::{Collective, RungeKutta, Start};
//! use heavytop::{HeavyTop, Invariant, SpinorRealisation};
//! use lie_poisson::Se3Dual;
//! use nalgebra::Vector3;
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

mod coordinate;
mod error;
mod spinor_motions;
mod varpi;
mod spinor_realisation;
mod top;
mod rigid_body;
mod invariants;
mod collective_gauss;
mod turning;
mod rotor_splitting;
mod symmetric_splitting;
mod midpoint_kernel;
mod ensemble_path;
mod meridian_axes;
mod stumpff_polynomials;
mod symmetric_flows;
mod symmetric_kernel;
mod symmetric_ensemble;
mod spinor_field;
mod spinor_kernel;
mod gauss_ensemble;
mod reduced_midpoint;
mod midpoint_ensemble;
mod attitude;
mod gyrostat;
mod kirchhoff;
mod point_vortices;
mod spin_chain;
mod spin_lattice;
mod energy_level;
mod section_level;
mod section;
mod nutation;
mod power_of_two;
mod elliptic;
mod euler_top;
mod nutation_cubic;
mod lagrange_nutation;

pub use attitude::{WithAttitude, attitude_of_vertical};
pub use collective_gauss::{CollectiveGauss, CollectiveGaussSpace};
pub use coordinate::Coordinate;
pub use elliptic::{JacobiElliptic, jacobi_elliptic};
pub use energy_level::EnergyLevel;
pub use error::{SectionError, TopError, UNIT_TOLERANCE, require_unit};
pub use euler_top::EulerSolution;
pub use gauss_ensemble::GaussEnsemble;
pub use gyrostat::Gyrostat;
pub use invariants::Invariant;
pub use kirchhoff::Kirchhoff;
pub use lagrange_nutation::LagrangeNutation;
pub use midpoint_ensemble::MidpointSweep;
pub use nutation::Nutation;
pub use point_vortices::{PointVortices, SpinSpace, Spins};
pub use reduced_midpoint::{ReducedMidpoint, ReducedMidpointSpace, VelocitySpace};
pub use rigid_body::RigidBody;
pub use rotor_splitting::RotorSplitting;
pub use section::{Section, Surface};
pub use spin_chain::HeisenbergChain;
pub use spin_lattice::{SpinLattice, SpinLatticeSpace};
pub use spinor_motions::{
    SPINOR_MOTIONS, SpinorAlgebra, SpinorGroup, SpinorMomentum, SpinorMotions,
};
pub use spinor_realisation::{SpinorPoint, SpinorRealisation};
pub use symmetric_ensemble::SymmetricTopEnsemble;
pub use symmetric_splitting::SymmetricTopSplitting;
pub use top::{Body, HeavyTop, HeavyTopSpace};
pub use turning::{Turned, Turning, TurningFlows};
pub use varpi::Varpi;

pub use collective_integrators;
pub use lie_poisson;
pub use momentum_map;

/// The examples of the README run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
