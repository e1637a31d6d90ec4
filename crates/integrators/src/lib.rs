//! Lie–Poisson integrators: one-step schemes for vector fields, and collective integrators, which turn symplectic
//! Runge–Kutta schemes into Poisson integrators on 𝔤∗.
//!
//! ```toml
//! [dependencies]
//! collective-integrators = "0.1"
//! lie-poisson = "0.1"
//! momentum-map = "0.1"
//! ```
//!
//! This example integrates the free rigid body by the Gauss method of order 4, applied collectively through the Hopf
//! map. The Casimir |Π|² is conserved to round-off:
//!
//! ```
//! use collective_integrators::{Collective, RungeKutta, Start};
//! use lie_poisson::{Covector, LiePoisson, So3, from_closure, nalgebra::Vector3};
//! use momentum_map::HOPF;
//!
//! // h(Π) = ½Π₁² + Π₂²
//! let h = from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y);
//! let gauss = Collective::new(RungeKutta::gauss(2)?, HOPF, h);
//! let start = Covector(Vector3::new(0.6, 0.0, 0.8));
//! for sample in gauss.trajectory(&start, 0.1)?.take(1000) {
//!     assert!((sample?.momentum.0.norm() - 1.0).abs() < 1e-13);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | a Poisson integrator on 𝔤∗ from a realisation M: P → 𝔤∗ | [`Collective`] |
//! | an integrator that conserves the Casimirs, for a field that depends on time, or loses energy on its orbit | [`Driven`]; [`DrivenField`] on the equations |
//! | the same with noise, at a temperature for example | [`Noisy`], or faster [`NoisyReduced`], with [`BrownianPaths`] |
//! | the same with torques that change the Casimirs | [`Torqued`] by a [`TorqueFlow`]: [`ConstantTorque`], [`ViscousTorque`], [`ViscousMatrix`], [`TabulatedTorque`] |
//! | the same for N copies of M, with N known when the program runs | [`CollectiveSites`]; [`LiftFreeSites`] without a lift |
//! | a collective integrator that computes on 𝔤∗ itself | [`LiftFree`] |
//! | a scheme applied directly to the equations | [`Direct`] |
//! | a Runge–Kutta method | [`RungeKutta`], such as [`RungeKutta::gauss`] |
//! | a Runge–Kutta method with coefficients of your own | [`Tableau`] |
//! | a partitioned method, such as Störmer–Verlet | [`PartitionedRungeKutta`], with a [`Polarisation`] |
//! | a higher order by composition | [`Composition`], with [`Substeps`] |
//! | a splitting into exact flows | [`Splitting`] of [`ExactFlows`], [`AlternatingSubsteps`] |
//! | an explicit method for a Hamiltonian that does not separate | [`TaoFlows`] |
//! | the semiexplicit method for such a Hamiltonian | [`Tableau::semiexplicit`] |
//! | a method for spins on spheres | [`SphericalMidpoint`] |
//! | a step in place, for states of any size | [`Integrator::step_in_place`], [`Scheme::step_in_place`] |
//! | many steps in place, without samples | [`Integrator::advance`] |
//! | the vector field of a closure, or of a Hamiltonian | [`from_fn`], [`HamiltonianField`] |
//! | a vector field over every scalar, or on points stored on the heap | [`VectorField`] |
//! | storage for the evaluations of such a field | [`StoragePool`] |
//! | to count the evaluations of a field, or to watch the steps of a scheme or an integrator | [`Observed`] |
//! | a scheme or an integrator of your own | [`Scheme`], [`Equivariant`]; [`Integrator`], [`StateIsMomentum`] |
//! | other settings for the stage equations | [`StageSolver`] |
//! | smaller rounding errors in long runs | [`Compensated`] |
//! | a trajectory, or its end alone | [`Start::trajectory`], [`Start::after`] |
//! | every n-th sample of a trajectory | [`Trajectory::every`] |
//! | to resume a run | [`Integrator::trajectory_resumed`] |
//! | states between the samples | [`DenseOutput`] |
//! | Poincaré sections and other events | [`Events`]; [`EventSearch`] for several along one run |
//! | many trajectories, in SIMD lanes (several trajectories in one register) and on all threads | [`Laned`], run by an [`Ensemble`] |
//! | one trajectory of a method with several stages, faster | [`StagesInLanes`] |
//! | a kernel of your own for many trajectories | [`LaneKernel`], [`BatchIntegrator`] |
//! | tangent vectors and Lyapunov exponents | [`VariationalFlow`], [`TangentFrame`], [`LyapunovExponents`] |
//! | fast indicators of chaos: MEGNO and SALI | [`Megno`], [`smaller_alignment_index`] |
//! | initial tangent vectors for these | [`generic_tangents`] |
//! | the order or a defect of a method, measured | the module [`diagnostics`] |
//! | tests of your own types against the laws | the module `laws` (feature `laws`) |
//!
//! # Conventions
//!
//! * A step Φ_h advances dz/dt = X(z) by the time h, which may be negative. Sample n of a trajectory lies at t = nh.
//! * The collective vector field is that of H = h∘M: its value at z is generator(dh(M(z)), z).
//! * On 𝔤∗ the signs are those of [`lie_poisson`]: dμ/dt = +`ad*_ξ μ` for the minus bracket, where ξ = dh(μ).
//! * A Runge–Kutta method has the stages k_i = X(z + h Σ_j a_ij k_j) and the result z + h Σ_i b_i k_i.
//! * Times are in the units of the vector field, and exponents are per unit of time.
//! * A failed step is a typed error. Every further item of the trajectory is the same error.
//! * At every multiple of [`CHECKPOINT`] a trajectory forgets the earlier steps, so that it can be resumed there bit
//!   for bit.
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The feature `laws` adds the module `laws`, whose suites return a residual for each law. The feature `serde`
//! serialises states, samples and drifts. The oldest supported compiler is Rust 1.89.
//!
//! # Related crates
//!
//! [`lie_poisson`] holds Lie algebras, Poisson brackets and Hamiltonians, and [`momentum_map`] holds actions, momentum
//! maps and realisations. Both are re-exported. `heavytop` adds heavy tops, and `lie-poisson-systems` adds other
//! Lie–Poisson systems.

#![cfg_attr(docsrs, feature(doc_cfg))]

mod error;
mod stage_frame;
mod storage_pool;
mod rooted_trees;
mod step_fractions;
mod tableaux;
mod sums;
mod iteration;
mod vector_field;
mod natural_scales;
mod stages;
mod schemes;
mod integrators;
mod open_systems;
mod observed;
mod splittings;
mod runs;
mod batch;
mod chaos;
mod erased;
pub mod diagnostics;

#[cfg(feature = "laws")]
pub mod laws;

pub use batch::batch_integrator::BatchIntegrator;
pub use batch::ensemble::{Chunk, Ensemble, MemberError};
pub use batch::group_engine::MOST_LANES;
pub use batch::lane_kernel::{LaneKernel, LaneResults, Registers};
pub use batch::laned::{Laned, LanedWorkspace};
pub use chaos::generic_tangents::generic_tangents;
pub use chaos::lyapunov::{Exponents, LyapunovExponents, MaximalLyapunovExponent};
pub use chaos::megno::Megno;
pub use chaos::smaller_alignment::smaller_alignment_index;
pub use chaos::tangent_integrator::{TangentIntegrator, VariationalError};
pub use chaos::tangents::tangent_frame::TangentFrame;
pub use chaos::tangents::variational_flow::VariationalFlow;
pub use diagnostics::{OrderFitError, fitted_order};
pub use erased::{
    AnyIntegrator, AnyStart, AnyState, AnySteps, AnyTangents, AnyWorkspace, ByPointer,
};
pub use error::{IntegrationError, RunError, SchemeError, StepError};
pub use integrators::collective::{Collective, CollectiveWorkspace};
pub use integrators::compensated::{Compensated, Increments, compensated_sum};
pub use integrators::direct::Direct;
pub use integrators::lanes::field_in_lanes::FieldInLanes;
pub use integrators::lanes::stages_in_lanes::StagesInLanes;
pub use integrators::lift_free::{LiftFree, MultiplierWorkspace, WithMultiplier};
pub use integrators::sites::collective_sites::{CollectiveSites, CollectiveSitesWorkspace};
pub use integrators::sites::lift_free_sites::{LiftFreeSites, LiftFreeSitesWorkspace};
pub use integrators::sites::spherical_midpoint::{
    OnSpheres, SphericalMidpoint, SphericalWorkspace,
};
pub use integrators::state_is_momentum::StateIsMomentum;
pub use integrators::trajectories::integrator::{Integrator, SampleOf, Trajectory};
pub use integrators::trajectories::sample::Sample;
pub use integrators::trajectories::start::Start;
pub use observed::Observed;
pub use open_systems::affine_flow::affine_flow;
pub use open_systems::driven::Driven;
pub use open_systems::driven_field::DrivenField;
pub use open_systems::noise_rule::{NoisePart, NoiseRule};
pub use open_systems::noisy::{Noisy, PathAndTime};
pub use open_systems::noisy_reduced::NoisyReduced;
pub use open_systems::paths::brownian_paths::{BrownianError, BrownianPaths};
pub use open_systems::smooth_pieces::Window;
pub use open_systems::step_parts::StepParts;
pub use open_systems::torqued::{TorqueFlow, Torqued};
pub use open_systems::torques::constant_torque::ConstantTorque;
pub use open_systems::torques::tabulated_torque::TabulatedTorque;
pub use open_systems::torques::torque_error::TorqueError;
pub use open_systems::torques::viscous_matrix::ViscousMatrix;
pub use open_systems::torques::viscous_torque::ViscousTorque;
pub use runs::crossing::Direction;
pub use runs::dense_output::{DenseOutput, DenseOutputError};
pub use runs::event_search::EventSearch;
pub use runs::event_values::EventError;
pub use runs::events::Events;

pub use iteration::lane_problem::{LaneProblem, Outcome};
pub use iteration::stage_solver::{StageSolver, Unconverged};
pub use schemes::partitioned::{PartitionedRungeKutta, PartitionedWorkspace};
pub use schemes::polarisation::{Alternating, FirstHalf, Polarisation};
pub use schemes::runge_kutta::{RungeKutta, StageWorkspace};
pub use schemes::scheme::{Equivariant, Increment, Scheme, Step};
pub use splittings::composition::Composition;
pub use splittings::exact_flows::ExactFlows;
pub use splittings::flow_sequence::{FlowSequence, LieTrotter, Strang};
pub use splittings::splitting::Splitting;
pub use splittings::tao::TaoFlows;
pub use stage_frame::StageFrame;
pub use stages::checkpoints::CHECKPOINT;
pub use stages::extrapolation::lagrange_polynomial;
pub use stages::lane_field::LaneField;
pub use stages::stage_memory::StageMemory;
pub use step_fractions::alternating_substeps::AlternatingSubsteps;
pub use step_fractions::substeps::Substeps;
pub use storage_pool::StoragePool;
pub use tableaux::tableau::Tableau;
pub use vector_field::{FromFn, HamiltonianField, VectorField, from_fn};

pub use lie_poisson;
pub use momentum_map;

/// Runs the examples of the README as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
