//! The names that a program with these systems usually needs, from this crate and from those below it.
//!
//! `use lie_poisson_systems::prelude::*;` replaces one `use` line per crate. All other names are at the roots of the
//! crates, which [`lie_poisson_systems`](crate) re-exports.
//!
//! # Example
//! A chain of spins without a field conserves its total spin:
//! ```
//! use lie_poisson_systems::prelude::*;
//!
//! let chain = HeisenbergChain::<4>::new(1.0, Vector3::zeros())?;
//! let start = Covector(Power([Vector3::x(), Vector3::y(), Vector3::z(), -Vector3::y()]));
//! let map = PowerMap::<_, 4>(QuadraticMomentumMap::new(So3OnC2, Side::Left));
//! let midpoint = Collective::new(RungeKutta::implicit_midpoint(), map, chain);
//! let total = |s: &Spins<4>| s.0.0.iter().sum::<Vector3<f64>>();
//! let end = midpoint.after(&start, 0.1, 100)?.momentum;
//! assert!((total(&end) - total(&start)).norm() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "isospectral")]
pub use crate::{
    GeneralisedRigidBody, HarmonicNoise, StochasticFluid, ViscousForcing, VorticityCoefficients,
    Zeitlin,
};
pub use crate::{
    Gyrostat, HeisenbergChain, HeisenbergLattice, KeplerOrbit, KidaVortex, Kirchhoff,
    LatticeMidpoint, ManyVortices, MovableBaseTop, PointVortices, ReactionWheels, Satellite,
    SatelliteAlgebra, SatelliteDual, SatelliteOnEllipse, So21, SpinLattice, SpinLatticeSpace,
    SpinSpace, Spins, SystemError, WheelMomenta,
};
pub use collective_integrators::{
    BrownianPaths, Collective, Integrator, LiftFree, RungeKutta, SphericalMidpoint, Start, Torqued,
};
#[cfg(feature = "isospectral")]
pub use isospectral_flows::{ExponentialMidpoint, GaussMagnus};
pub use lie_poisson::{
    Automatic, Covector, Hamiltonian, LiePoisson, Pair, PoissonSpace, Power, RealSpace, Se3Dual,
};
pub use momentum_map::{
    Cotangent, CotangentBundle, DualQuaternions, HOPF, Identity, PowerMap, PowerMultipliers,
    ProductMap, QuadraticMomentumMap, Quaternions, Side, So3OnC2, TWO_FIELDS,
};
pub use nalgebra::{Matrix3, Vector3};
