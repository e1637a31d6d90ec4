//! The names that a program with heavy tops usually needs, from this crate and from those below it.
//!
//! `use heavytop::prelude::*;` replaces one `use` line per crate. All other items are at the roots of the crates, which
//! [`heavytop`](crate) re-exports.
//!
//! | for | names |
//! |---|---|
//! | a point of se(3)∗ and a vector of R³ | [`Se3Dual`], [`Covector`], [`Pair`], [`Vector3`] |
//! | the top | [`HeavyTop`], [`Body`], [`Invariant`] |
//! | another Hamiltonian on se(3)∗ | [`Hamiltonian`], [`from_closure`], [`HeavyTopSpace`] |
//! | a scheme | [`RungeKutta`], [`Substeps`], [`AlternatingSubsteps`] |
//! | an integrator of one top | [`Collective`] with [`SpinorRealisation`], [`LiftFree`] with [`DualQuaternions`], [`Direct`], [`ReducedMidpoint`] |
//! | the fast paths of one top | [`CollectiveGauss`], [`TopMidpoint`], [`SymmetricTopSplitting`] |
//! | trajectories and their samples | [`Start`], [`Integrator`], [`Sample`], [`Events`] |
//! | many tops at once | [`Ensemble`] of [`GaussBatch`], [`SymmetricTopBatch`], [`MidpointBatch`] |
//! | the attitude of the body | [`WithAttitude`] |
//!
//! # Example
//! A heavy top with given parameters, integrated by the collective midpoint rule:
//! ```
//! use heavytop::prelude::*;
//!
//! let top = HeavyTop::new(&Body {
//!     inertia: Vector3::new(1.0, 1.5, 2.0),
//!     mass: 1.0,
//!     gravity: 9.81,
//!     length: 0.1,
//!     center_of_mass: Vector3::z(),
//! })?;
//! let start = Se3Dual::new(Vector3::new(0.0, 0.3, 4.0), Vector3::new(0.6, 0.0, 0.8));
//! let midpoint = Collective::new(RungeKutta::implicit_midpoint(), SpinorRealisation, top);
//! let end = midpoint.after(&start, 0.01, 1000)?.momentum;
//! let change = |f: Invariant| (f.value(&top, &end) - f.value(&top, &start)).abs();
//! assert!(change(Invariant::VerticalMomentum) < 1e-12); // Π·Γ, a Casimir
//! assert!(change(Invariant::Energy) < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use crate::{
    Body, CollectiveGauss, GaussBatch, HeavyTop, HeavyTopSpace, Invariant, MidpointBatch,
    ReducedMidpoint, SpinorRealisation, SymmetricTopBatch, SymmetricTopSplitting, TopError,
    TopMidpoint, WithAttitude,
};
pub use collective_integrators::{
    AlternatingSubsteps, Collective, Direct, Ensemble, Events, Integrator, LiftFree, RungeKutta,
    Sample, Start, Substeps,
};
pub use lie_poisson::{Covector, Hamiltonian, Pair, Se3Dual, from_closure};
pub use momentum_map::DualQuaternions;
pub use nalgebra::Vector3;
