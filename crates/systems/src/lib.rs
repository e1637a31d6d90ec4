//! Lie–Poisson systems other than the heavy top: gyrostat, satellite, body in a fluid, point vortices, spin chain, spin lattice,
//! elliptical vortex and top on a movable base, each a Hamiltonian for the integrators of `collective-integrators`;
//! rigid bodies in N dimensions and fluids on the sphere, for those of `isospectral-flows`.
//!
//! ```toml
//! [dependencies]
//! lie-poisson-systems = "0.1"
//! ```
//!
//! The example has four vortices on the sphere. The collective Gauss method conserves the moment of vorticity Σ k_i x_i
//! to round-off, and the vortices stay on the sphere.
//!
//! ```
//! use lie_poisson_systems::prelude::*;
//!
//! let vortices = PointVortices::new([1.0, -0.7, 1.5, 0.4])?;
//! let positions = [Vector3::x(), Vector3::y(), -Vector3::x(), Vector3::z()];
//! let start = vortices.momentum(&positions);
//! let gauss = Collective::new(RungeKutta::gauss(3)?, PowerMap::<_, 4>(HOPF), vortices);
//! let moment = |m: &Spins<4>| m.0.0.iter().sum::<Vector3<f64>>();
//! for sample in gauss.trajectory(&start, 0.1)?.take(200) {
//!     let m = sample?.momentum;
//!     assert!((moment(&m) - moment(&start)).norm() < 1e-12);
//!     assert!(vortices.positions(&m).iter().all(|x| (x.norm() - 1.0).abs() < 1e-12));
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a heavy body with a spinning rotor, on se(3)∗ | [`Gyrostat`] |
//! | a satellite in the gradient of gravity, on a circular orbit, on (so(3) ⋉ (R³)²)∗ | [`Satellite`], [`SatelliteAlgebra`] |
//! | the same on an elliptic orbit, with the time | [`SatelliteOnEllipse`], [`KeplerOrbit`] |
//! | a body whose motors turn reaction wheels, on so(3)∗ with the time | [`ReactionWheels`], [`WheelMomenta`] |
//! | a rigid body in an ideal fluid, on se(3)∗ | [`Kirchhoff`] |
//! | point vortices on the sphere, on (so(3)∗)ᴺ | [`PointVortices`] |
//! | point vortices whose number is known only at run time | [`ManyVortices`] |
//! | classical spins in a row, on (so(3)∗)ᴺ | [`HeisenbergChain`] |
//! | classical spins on a lattice of any size, in one to three dimensions | [`HeisenbergLattice`] |
//! | the same lattice advanced on SIMD lanes and all threads | [`LatticeMidpoint`] |
//! | spins in any number at a temperature, on rings, chains and lattices | [`LangevinSpins`], [`SpinDamping`] |
//! | spins on atoms in motion, on (so(3)∗)ᴺ × T∗Rᴺ | [`SpinLattice`], wrapped in [`Automatic`](lie_poisson::Automatic) |
//! | an elliptical vortex in a strain, on so(2, 1)∗ | [`KidaVortex`], [`So21`] |
//! | a heavy top on a movable base, on (se(3) ⋉ R³)∗ | [`MovableBaseTop`], [`MovableBaseAlgebra`] |
//! | a free rigid body in N dimensions, on so(N)∗ | [`GeneralisedRigidBody`] |
//! | an ideal fluid on the sphere, on u(N)∗ | [`Zeitlin`], with [`VorticityCoefficients`]; [`ZeitlinCoordinates`] for tangent vectors |
//! | the same fluid with viscosity, drag and a force | [`ViscousForcing`], in [`Torqued`](collective_integrators::Torqued) |
//! | the same fluid with transport noise, and with forces that are white in time | [`StochasticFluid`], with [`HarmonicNoise`] |
//! | the Laplace operator of the sphere on matrices | [`QuantisedLaplacian`] |
//! | the type of these phase spaces and of their points | [`SpinSpace`], [`Spins`], [`SpinLatticeSpace`] |
//! | the reason why parameters are rejected | [`SystemError`] |
//! | the usual names in one line | [`prelude`] |
//!
//! The map and the bracket that go with a system:
//!
//! | system | bracket | collective, by | without a lift, by |
//! |---|---|---|---|
//! | [`Gyrostat`], [`Kirchhoff`] | minus | `heavytop::SpinorRealisation` | [`DualQuaternions`](momentum_map::DualQuaternions) |
//! | [`PointVortices`] | minus | `PowerMap(HOPF)` | `PowerMultipliers(Quaternions)` |
//! | [`HeisenbergChain`] | plus | `PowerMap(QuadraticMomentumMap::new(So3OnC2, Side::Left))` | |
//! | [`KidaVortex`] | plus | [`clebsch_realisation`](momentum_map::clebsch_realisation) on T∗so(2, 1) | |
//! | [`MovableBaseTop`] | minus | [`clebsch_realisation`](momentum_map::clebsch_realisation) on T∗(se(3) ⋉ R³) | |
//! | [`Satellite`], [`SatelliteOnEllipse`] | minus | [`TWO_FIELDS`](momentum_map::TWO_FIELDS) | |
//! | [`ReactionWheels`] | minus | `HOPF` | |
//! | [`SpinLattice`] | plus | `ProductMap` of that map and `Identity` of T∗Rᴺ | |
//!
//! # Conventions
//!
//! * [`GeneralisedRigidBody`] and [`Zeitlin`] are [`IsospectralField`](isospectral_flows::IsospectralField)s. They are
//!   integrated by the methods of [`isospectral_flows`].
//! * On se(3)∗ the frame is that of the body, and the bracket is the minus bracket.
//! * Bodies are in SI units. Spins and their constants are numbers without units.
//! * The bracket of the spins is the plus bracket: h = −B·s gives ds/dt = s × B.
//! * The signs on 𝔤∗ are those of [`lie_poisson`], and the sides of actions are those of [`momentum_map`].
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The feature `isospectral`, which is on by default, has the systems on large matrices: [`GeneralisedRigidBody`],
//! [`Zeitlin`] and what belongs to them. Without it the crate depends on half as many crates. The oldest supported
//! compiler is Rust 1.89.
//!
//! # Related crates
//!
//! [`lie_poisson`] holds the brackets, [`momentum_map`] the Poisson maps, and [`collective_integrators`] the
//! integrators, trajectories and diagnostics. These and [`nalgebra`] appear in the public interface and are
//! re-exported. The crate `heavytop` holds the tops.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod error;
mod spaces;
mod gyrostat;
mod satellite;
mod body_in_fluid;
mod vortices;
mod spin_chain;
mod spin_lattice;
mod spins_at_temperature;
mod kida_vortex;
mod movable_base;
#[cfg(feature = "isospectral")]
mod rigid_body;
#[cfg(feature = "isospectral")]
mod matrix_hydrodynamics;
#[cfg(feature = "isospectral")]
mod open_fluids;
pub mod prelude;

pub use body_in_fluid::kirchhoff::Kirchhoff;
pub use error::SystemError;
pub use gyrostat::heavy_gyrostat::Gyrostat;
pub use kida_vortex::elliptical_patch::KidaVortex;
pub use kida_vortex::lorentz_algebra::So21;
pub use movable_base::top_on_base::{
    MovableBaseAlgebra, MovableBaseDual, MovableBaseElement, MovableBaseTop,
};
pub use satellite::gravity_gradient::{SatelliteAlgebra, SatelliteDual, SatelliteElement};
pub use satellite::kepler_orbit::KeplerOrbit;
pub use satellite::on_circle::Satellite;
pub use satellite::on_ellipse::SatelliteOnEllipse;
pub use satellite::reaction_wheels::{ReactionWheels, WheelMomenta};
pub use spaces::spin_space::{SpinSpace, Spins};
pub use spin_chain::heisenberg_chain::HeisenbergChain;
pub use spin_lattice::heisenberg_lattice::HeisenbergLattice;
pub use spin_lattice::lattice_midpoint::{LatticeMidpoint, LatticeWorkspace};
pub use spin_lattice::vibrating_lattice::{SpinLattice, SpinLatticeSpace};
pub use spins_at_temperature::field_in_time::FieldInTime;
pub use spins_at_temperature::langevin_spins::{LangevinSpins, LangevinWorkspace};
pub use spins_at_temperature::site_rotation::SpinDamping;
pub use vortices::many_vortices::ManyVortices;
pub use vortices::point_vortices::PointVortices;

#[cfg(feature = "isospectral")]
pub use matrix_hydrodynamics::{
    quantised_laplacian::QuantisedLaplacian, spherical_harmonic::associated_legendre,
    vorticity_coefficients::VorticityCoefficients, zeitlin::Zeitlin,
    zeitlin_coordinates::ZeitlinCoordinates,
};
#[cfg(feature = "isospectral")]
pub use open_fluids::{
    harmonic_noise::HarmonicNoise,
    stochastic_fluid::{StochasticFluid, StochasticFluidWorkspace},
    viscous_forcing::ViscousForcing,
};
#[cfg(feature = "isospectral")]
pub use rigid_body::generalised_rigid_body::GeneralisedRigidBody;

pub use collective_integrators;
#[cfg(feature = "isospectral")]
pub use isospectral_flows::{self, num_complex};
pub use lie_poisson;
pub use momentum_map;
pub use nalgebra;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
